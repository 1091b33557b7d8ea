"""What is said of a rule: from each form of the rule language to a phrase."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Board, Cell, Column, Row
from maestra.language.keys import Key, Predicate
from maestra.language.of_pairs import Two
from maestra.language.of_tokens import Tokens, board_row
from maestra.language.phrases import (
    Adjective,
    AttributeNamed,
    Count,
    Degree,
    Does,
    Foreign,
    InRow,
    Joint,
    Listing,
    Nth,
    Numeral,
    Phrase,
    Place,
    Say,
    Several,
    ValueNamed,
    does,
    say,
)
from maestra.rules.fields import Position
from maestra.rules.forms.base import LAST, MIDDLE, Direction
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import (
    CompareCounts,
    Equation,
    Kinds,
    Operation,
    Total,
)
from maestra.rules.forms.counting import Count as Counted
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import Compare, Relation
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import Anything, Comparison, Extreme, Has, Not, TokenTest

_FILLINGS: Final = MappingProxyType(
    {
        Filling.LEFT_TO_RIGHT: Key.LEFT_TO_RIGHT,
        Filling.RIGHT_TO_LEFT: Key.RIGHT_TO_LEFT,
        Filling.ENDS_FIRST: Key.ENDS_FIRST,
        Filling.MIDDLE_FIRST: Key.MIDDLE_FIRST,
    }
)
_AMOUNTS: Final = MappingProxyType(
    {
        Comparison.EQUAL: Key.EXACTLY,
        Comparison.AT_LEAST: Key.AT_LEAST,
        Comparison.AT_MOST: Key.AT_MOST,
        Comparison.MORE: Key.MORE_THAN,
        Comparison.LESS: Key.FEWER_THAN,
        Comparison.DIFFERENT: Key.NOT_EXACTLY,
    }
)
_COUNTS: Final = MappingProxyType(
    {
        Comparison.EQUAL: Key.HAS_AS_MANY_AS,
        Comparison.AT_LEAST: Key.HAS_AT_LEAST_AS_MANY_AS,
        Comparison.AT_MOST: Key.HAS_AT_MOST_AS_MANY_AS,
        Comparison.MORE: Key.HAS_MORE_THAN,
        Comparison.LESS: Key.HAS_FEWER_THAN,
        Comparison.DIFFERENT: Key.HAS_NOT_AS_MANY_AS,
    }
)
_MODELS: Final = MappingProxyType(
    {
        Reading.COPIED: Key.MODEL_COPIED,
        Reading.MIRRORED: Key.MODEL_MIRRORED,
        Reading.REVERSED: Key.MODEL_REVERSED,
    }
)
_OTHERS: Final = MappingProxyType(
    {
        (Pairs.NEIGHBOURS, Line.ROW): (Key.EACH_TOKEN, Key.THE_ONE_ON_ITS_LEFT),
        (Pairs.NEIGHBOURS, Line.TIME): (Key.EACH_TOKEN, Key.THE_ONE_BEFORE_IT),
        (Pairs.ALL, Line.ROW): (Key.EACH_TOKEN, Key.EVERY_ONE_ON_ITS_LEFT),
        (Pairs.ALL, Line.TIME): (Key.EACH_TOKEN, Key.EVERY_ONE_BEFORE_IT),
        (Pairs.TWO_BY_TWO, Line.ROW): (Key.IN_EACH_PAIR, Key.THE_ONE_ON_ITS_LEFT),
        (Pairs.TWO_BY_TWO, Line.TIME): (Key.IN_EACH_PAIR, Key.THE_ONE_BEFORE_IT),
        (Pairs.MIRRORED, Line.ROW): (Key.IN_RIGHT_HALF, Key.THE_OPPOSITE_ONE),
        (Pairs.MIRRORED, Line.TIME): (Key.IN_RIGHT_HALF, Key.THE_OPPOSITE_ONE),
    }
)


@dataclass(frozen=True, slots=True)
class Rules:
    """Says rules about one deck and board."""

    tokens: Tokens

    @property
    def board(self) -> Board:
        """The board they are said about."""
        return self.tokens.board

    def says(self, rule: Rule) -> Say:  # noqa: C901, PLR0912 - one case for each form
        """The rule as a sentence."""
        match rule:
            case EveryToken(test):
                return self._every_token(test)
            case AllOfThem(test):
                return self._all_of_them(test)
            case Ordered():
                return self._ordered(rule)
            case CyclicOrdered(attribute, direction, line):
                rising = direction is Direction.RISING
                key = Key.CYCLE_RISING if rising else Key.CYCLE_FALLING
                return say(key, along=_along(line), attribute=AttributeNamed(attribute))
            case RiseAndFall(attribute, direction, line):
                rising = direction is Direction.RISING
                key = Key.RISE_AND_FALL if rising else Key.FALL_AND_RISE
                return say(key, along=_along(line), attribute=AttributeNamed(attribute))
            case Zigzag(attribute, line):
                return say(Key.ZIGZAG, along=_along(line), attribute=AttributeNamed(attribute))
            case EqualSteps(attribute, ratio, line):
                key = Key.EQUAL_RATIOS if ratio else Key.EQUAL_STEPS
                return say(key, along=_along(line), attribute=AttributeNamed(attribute))
            case ExtremeAt():
                return self._extreme_at(rule)
            case EachPair():
                return self._each_pair(rule)
            case TwoPlaces(first, second, relation):
                subject = _at(second, Line.ROW)
                said = Two(self.tokens, subject, _at(first, Line.ROW)).stands(relation)
                return say(Key.SUBJECT_MUST, subject=subject, does=said)
            case Pattern():
                return self._pattern(rule)
            case Template(attribute, letters, repeat, line):
                key = Key.TEMPLATE_REPEATED if repeat else Key.TEMPLATE
                return say(
                    key,
                    along=_along(line),
                    attribute=AttributeNamed(attribute),
                    pattern=Listing(tuple(map(Foreign, letters)), Joint.COMMA),
                )
            case Blocks(attribute, line):
                return say(Key.BLOCKS, along=_along(line), attribute=AttributeNamed(attribute))
            case Counted(test, comparison, number):
                return self._counts(test, comparison, number)
            case CompareCounts():
                return self._compares_counts(rule)
            case Kinds(attribute, comparison, number):
                amount = _amount(comparison, Numeral(number))
                return say(Key.KINDS, amount=amount, attribute=AttributeNamed(attribute))
            case Total(attribute, comparison, number):
                return say(
                    Key.TOTAL,
                    amount=_amount(comparison, Numeral(number)),
                    attribute=AttributeNamed(attribute),
                )
            case Equation():
                return _equation(rule)
            case At(position, test, line):
                subject = _at(position, line)
                return say(Key.SUBJECT_MUST, subject=subject, does=self.does(test, subject))
            case IfThen(condition, consequence):
                return say(
                    Key.IF_THEN,
                    condition=self._condition(condition),
                    consequence=self._condition(consequence),
                )
            case Word(_, relation, value):
                if relation is None or value is None:
                    return say(Key.WORD)
                return say(Key.WORD_WITH, relation=Foreign(relation), value=Foreign(value))
            case StraightUp(mirrored):
                return say(Key.MIRRORED_COLUMN if mirrored else Key.SAME_COLUMN)
            case TakeExtreme():
                return self._take(rule)
            case FillOrder(filling):
                return self.placing(filling, None)
            case Before(first, second, line):
                key = Key.ALL_BEFORE if line is Line.TIME else Key.ALL_LEFT_OF
                return say(key, first=self.does(first), second=self.does(second))
            case Follows():
                return self._follows(rule)
            case ModelRow(row, reading, relation):
                said = Two(self.tokens, None, say(Key.ITS_MODEL)).stands(relation)
                return say(_MODELS[reading], row=board_row(self.board, row), does=said)
            case Cue(row, column, relation):
                said = Two(self.tokens, None, say(Key.THIS_ONE)).stands(relation)
                cell = Cell(Row(board_row(self.board, row).row), Column(column))
                return say(Key.CUE, place=Place(cell), does=said)
            case FullRow():
                return say(Key.FILL_ROW, row=InRow(self.board.goal_row))
            case UntilTotal(attribute, number):
                named = AttributeNamed(attribute)
                return say(Key.UNTIL_TOTAL, k=Numeral(number), attribute=named)
            case _:
                assert_never(rule)

    def placing(self, filling: Filling | None, counts: tuple[int, ...] | None) -> Say:
        """Into which row the tokens go, how many (None: as many as fit), and in which order."""
        order = Key.ANY_ORDER if filling is None else _FILLINGS[filling]
        return self.placing_in(say(order), counts)

    def placing_in(self, order: Say, counts: tuple[int, ...] | None) -> Say:
        """As `placing`, in an order that is said already."""
        tokens = say(Key.THE_TOKENS)
        if counts is not None:
            many = Listing(tuple(Count(number) for number in counts), Joint.OR)
            tokens = say(Key.SO_MANY_TOKENS, count=many)
        return say(Key.PLACE, tokens=tokens, row=InRow(self.board.goal_row), order=order)

    def does(self, test: TokenTest, subject: Phrase | None = None) -> Does | Several:
        """That a token passes a test."""
        said = self.tokens.passes(test, subject)
        return does(Predicate.ANYTHING, subject) if said is None else said

    def _every_token(self, test: TokenTest) -> Say:
        positive = test.of if isinstance(test, Not) else test
        if isinstance(positive, Has):
            source = self._source(positive, negated=positive is not test)
            if source is not None:
                return source
        kind = self.tokens.kind(positive)
        if kind is not None:
            return say(Key.ONLY if positive is test else Key.NONE, kind=kind)
        return say(Key.ONLY_THAT, does=self.does(test))

    def _source(self, test: Has, *, negated: bool) -> Say | None:
        """From which row or column tokens come, if the test asks that."""
        said = self.tokens.has(test.feature)
        if said.predicate is Predicate.FROM_ROW:
            return Say(Key.NOT_FROM_ROW if negated else Key.FROM_ROW, said.parts)
        if said.predicate is Predicate.FROM_COLUMN:
            return Say(Key.NOT_FROM_COLUMN if negated else Key.FROM_COLUMN, said.parts)
        return None

    def _all_of_them(self, test: TokenTest) -> Say:
        kind = self.tokens.kind(test)
        if kind is not None:
            return say(Key.USE_ALL, kind=kind)
        if isinstance(test, Anything):
            return say(Key.USE_ALL_TOKENS)
        return say(Key.USE_ALL_THAT, does=self.does(test))

    def _ordered(self, rule: Ordered) -> Say:
        return self._each_pair(EachPair(Pairs.NEIGHBOURS, relation_of(rule), rule.line))

    def _each_pair(self, rule: EachPair) -> Say:
        if rule.pairs is Pairs.FIRST_WITH_REST:
            key, other = Key.EACH_TOKEN, _at(Position(1), rule.line)
        else:
            key, other_key = _OTHERS[rule.pairs, rule.line]
            other = say(other_key)
        return say(key, does=Two(self.tokens, None, other).stands(rule.relation))

    def _extreme_at(self, rule: ExtremeAt) -> Say:
        subject = _at(rule.position, Line.ROW)
        highest = rule.extreme is Extreme.HIGHEST
        said = does(
            Predicate.MOST if highest else Predicate.LEAST,
            subject,
            adjective=Adjective(rule.attribute, Degree.MOST if highest else Degree.LEAST),
            attribute=AttributeNamed(rule.attribute),
        )
        said = Does(said.predicate, said.parts, subject, rule.negated)
        return say(Key.SUBJECT_MUST, subject=subject, does=said)

    def _pattern(self, rule: Pattern) -> Say:
        values = [self.value_of(test) for test in rule.tests]
        known = tuple(value for value in values if value is not None)
        if len(known) == len(values) and rule.line is Line.ROW and not rule.repeat:
            return say(Key.THIS_ROW, tokens=Listing(known, Joint.COMMA))
        steps: list[Phrase] = []
        for number, test in enumerate(rule.tests, start=1):
            said = self.tokens.passes(test)
            if said is None:
                steps.append(say(Key.NTH_FREE, nth=Nth(number)))
            else:
                steps.append(say(Key.NTH_DOES, nth=Nth(number), does=said))
        key = Key.PATTERN_REPEATED if rule.repeat else Key.PATTERN
        return say(key, along=_along(rule.line), steps=Listing(tuple(steps), Joint.COMMA))

    def value_of(self, test: TokenTest) -> Phrase | None:
        """The value that a test asks for, if it is just one and not about the origin."""
        if not isinstance(test, Has):
            return None
        value = self.tokens.has(test.feature).parts.get("value")
        return value if isinstance(value, ValueNamed) else None

    def _counts(self, test: TokenTest, comparison: Comparison, number: int) -> Say:
        amount = _amount(comparison, Count(number))
        said = self.tokens.passes(test)
        if said is None:
            return say(Key.PLACE_SO_MANY, amount=amount, count=Count(number))
        key = Key.HAS_ONE_THAT if number == 1 else Key.HAS_MANY_THAT
        return say(key, amount=amount, does=said)

    def _compares_counts(self, rule: CompareCounts) -> Say:
        first, second = self.does(rule.first), self.does(rule.second)
        return say(_COUNTS[rule.comparison], first=first, second=second)

    def _condition(self, condition: At | Counted) -> Say:
        match condition:
            case At(position, test, line):
                subject = _at(position, line)
                return say(Key.SUBJECT_DOES, subject=subject, does=self.does(test, subject))
            case Counted(test, comparison, number):
                amount = _amount(comparison, Count(number))
                key = Key.ROW_HAS_ONE_THAT if number == 1 else Key.ROW_HAS_MANY_THAT
                return say(key, amount=amount, does=self.does(test))
            case _:
                assert_never(condition)

    def _take(self, rule: TakeExtreme) -> Say:
        highest = rule.extreme is Extreme.HIGHEST
        subject = say(Key.THE_ONE_TO_TAKE)
        said: Does
        if rule.attribute in {ORIGIN_COLUMN, ORIGIN_ROW}:
            across = rule.attribute == ORIGIN_COLUMN
            predicate = {
                (True, False): Predicate.LEFTMOST,
                (True, True): Predicate.RIGHTMOST,
                (False, False): Predicate.TOPMOST,
                (False, True): Predicate.BOTTOMMOST,
            }[across, highest]
            said = does(predicate, subject)
        else:
            said = does(
                Predicate.MOST_LEFT if highest else Predicate.LEAST_LEFT,
                subject,
                adjective=Adjective(rule.attribute, Degree.MOST if highest else Degree.LEAST),
                attribute=AttributeNamed(rule.attribute),
            )
        among = self.tokens.passes(rule.among)
        if among is None:
            return say(Key.TAKE, does=said)
        return say(Key.TAKE_OF_THOSE, among=among, does=said)

    def _follows(self, rule: Follows) -> Say:
        key = {
            (Line.TIME, True): Key.NEXT_AFTER,
            (Line.TIME, False): Key.LATER_AFTER,
            (Line.ROW, True): Key.NEXT_RIGHT_OF,
            (Line.ROW, False): Key.LATER_RIGHT_OF,
        }[rule.line, rule.immediately]
        return say(key, first=self.does(rule.test), second=self.does(rule.follower))


def relation_of(rule: Ordered | EachPair) -> Relation:
    """What the left, or earlier, of two tokens must be to the other."""
    if isinstance(rule, EachPair):
        return rule.relation
    comparison = {
        (Direction.RISING, True): Comparison.LESS,
        (Direction.RISING, False): Comparison.AT_MOST,
        (Direction.FALLING, True): Comparison.MORE,
        (Direction.FALLING, False): Comparison.AT_LEAST,
    }[rule.direction, rule.strict]
    return Compare(rule.attribute, comparison)


def _along(line: Line) -> Say:
    return say(Key.ALONG_THE_ROW if line is Line.ROW else Key.IN_TIME)


def _amount(comparison: Comparison, number: Phrase) -> Say:
    return say(_AMOUNTS[comparison], k=number)


def _at(position: Position, line: Line) -> Say:
    """The token at a place of the line."""
    if position == MIDDLE:
        return say(Key.MIDDLE_OF_ROW)
    if position == LAST:
        return say(Key.LAST_OF_ROW if line is Line.ROW else Key.LAST_PLACED)
    if line is Line.TIME:
        return say(Key.NTH_PLACED, nth=Nth(position))
    if position < 0:
        return say(Key.NTH_FROM_RIGHT, nth=Nth(-position))
    return say(Key.NTH_FROM_LEFT, nth=Nth(position))


def _equation(rule: Equation) -> Say:
    product = rule.operation is Operation.PRODUCT
    joint = Joint.TIMES if product else Joint.PLUS
    left = Listing(tuple(_at(place, Line.ROW) for place in rule.left), joint)
    terms: list[Phrase] = [_at(place, Line.ROW) for place in rule.right]
    if not terms or rule.constant != (1 if product else 0):
        terms.append(Numeral(rule.constant))
    return say(
        Key.EQUATION,
        left=left,
        right=Listing(tuple(terms), joint),
        attribute=AttributeNamed(rule.attribute),
    )
