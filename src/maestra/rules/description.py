"""How long it takes to say a rule, in bits: the prior of the learner that compares rules.

A rule costs what its form costs (`FORMS`: rarer kinds of exercise cost more) and, for each
parameter, the logarithm of how many choices this deck and board leave (`_Speaker`). A choice
that people make much more often than the others is cheaper than that (`_likely`). So 2^-bits
sums to at most about one over all rules of a deck, and a rule that names many values, such as a
given row, pays for each of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from enum import Enum
from math import log2
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.tokens import LETTER
from maestra.rules.forms.base import Direction, Form
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Operation, Total
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
from maestra.rules.pairs import AddUp, Apart, Compare, Named, Relation, Step, Times
from maestra.rules.registry import PARAMETER_FEATURES, TOKEN_FEATURES
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Setting
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Extreme,
    Has,
    Not,
    TokenTest,
)

FORMS: Final[Mapping[type[Form], float]] = MappingProxyType(
    {
        FullRow: 1.0,
        FillOrder: 2.0,
        Ordered: 2.0,
        EveryToken: 2.0,
        Pattern: 4.0,
        StraightUp: 4.0,
        EachPair: 4.0,
        AllOfThem: 4.0,
        Template: 5.0,
        Count: 5.0,
        Blocks: 5.0,
        Total: 5.0,
        Word: 5.0,
        Before: 6.0,
        At: 6.0,
        ModelRow: 6.0,
        TakeExtreme: 6.0,
        Zigzag: 6.0,
        ExtremeAt: 6.0,
        CyclicOrdered: 6.0,
        EqualSteps: 7.0,
        RiseAndFall: 7.0,
        TwoPlaces: 7.0,
        Follows: 7.0,
        Kinds: 7.0,
        CompareCounts: 7.0,
        Equation: 7.0,
        IfThen: 7.0,
        UntilTotal: 7.0,
        Cue: 8.0,
    }
)
"""Bits for the form alone: the eleven families of the exercises that therapists want, weighed by
how early a caregiver would think of them; our judgement, not a measurement."""

OTHER: Final = 3.0
"""Bits for a choice that is not the usual one, such as the order in time instead of the row's:
one rule in eight."""


def description_length(rule: Rule, setting: Setting) -> float:
    """Bits it takes to say `rule` to somebody who sees the start of the play."""
    return _Speaker(setting).rule(rule)


def _likely(choice: Enum, usual: Enum) -> float:
    """Bits of a choice of which one outcome is usual."""
    if choice is usual:
        return -log2(1 - 2**-OTHER)
    return OTHER + log2(len(type(choice)) - 1)


def _flag(*, unusual: bool) -> float:
    """Bits of a choice of two, of which one is usual."""
    return OTHER if unusual else -log2(1 - 2**-OTHER)


def _among(choice: Enum) -> float:
    """Bits of one of several equal choices."""
    return log2(len(type(choice)))


def _amount(number: int | Decimal) -> float:
    """Bits of a number nobody expects: Elias' gamma code, with a sign, halves cost more."""
    whole = number == int(number)
    return 2 * log2(abs(float(number)) + 1) + (1 if whole else 1 + OTHER)


@dataclass(frozen=True)
class _Speaker:
    """Somebody who sees the start of a play, and whose choices it limits."""

    setting: Setting

    def attribute(self, attribute: str) -> float:
        """Where a token came from is thought of less often than what it shows."""
        shown = len(self.setting.deck.scales)
        return log2(shown or 1) if attribute not in (ORIGIN_ROW, ORIGIN_COLUMN) else OTHER + 1

    def value(self, attribute: str) -> float:
        """One of the values that the tokens show."""
        return log2(len({v for v in self.setting.values(attribute) if v is not None}) or 1)

    def position(self) -> float:
        """A place from the left, from the right, or the middle."""
        return log2(2 * self.setting.length + 1)

    def line(self, line: Line) -> float:
        """Most rules are about the row."""
        return _likely(line, Line.ROW)

    def test(self, test: TokenTest) -> float:
        """The kind of test, then what it says."""
        match test:
            case Anything():
                return OTHER
            case Has(feature):
                return (
                    1
                    + self.attribute(feature.attribute)
                    + self.feature(feature.name, feature.attribute)
                )
            case Compared(attribute, comparison, _):
                return 2 + self.attribute(attribute) + _among(comparison) + self.value(attribute)
            case Among(attribute, extreme, number):
                some = _amount(number) if number is not None else 1
                return OTHER + self.attribute(attribute) + _among(extreme) + some
            case Not(of):
                return 2 + self.test(of)
            case Either(first, second) | Both(first, second):
                return OTHER + self.test(first) + self.test(second)
            case _:
                assert_never(test)

    def feature(self, name: str, attribute: str) -> float:
        """Which feature, and its parameter: for ``is`` one of the values, else a number."""
        which = log2(len(TOKEN_FEATURES) + len(PARAMETER_FEATURES))
        if name in TOKEN_FEATURES:
            return which
        if name.startswith("is-"):
            return 1 + self.value(attribute)
        family = next(known for known in PARAMETER_FEATURES if name.startswith(f"{known}-"))
        return which + _amount(Decimal(name.removeprefix(f"{family}-")))

    def relation(self, relation: Relation) -> float:
        """The kind of relation, then what it says."""
        kind = log2(6)
        match relation:
            case Compare(attribute, comparison, other):
                usual = 0.0 if other is None else OTHER + self.attribute(other)
                return 1 + self.attribute(attribute) + _among(comparison) + usual
            case Named(_, directed):
                return kind + log2(len(self.setting.deck.relations) or 1) + _flag(unusual=directed)
            case (
                Step(attribute, amount)
                | Apart(attribute, amount)
                | Times(attribute, amount)
                | AddUp(attribute, amount)
            ):
                return kind + self.attribute(attribute) + _amount(amount)
            case _:
                assert_never(relation)

    def rule(self, rule: Rule) -> float:
        """The form and all of its parameters."""
        return FORMS[type(rule)] + sum(self._parameters(rule))

    def _parameters(self, rule: Rule) -> Iterable[float]:  # noqa: C901, PLR0912, PLR0915 - one case for each form
        match rule:
            case EveryToken(test) | AllOfThem(test):
                yield self.test(test)
            case Ordered(attribute, direction, strict, line):
                yield from (self.attribute(attribute), _likely(direction, Direction.RISING))
                yield from (_flag(unusual=not strict), self.line(line))
            case CyclicOrdered(attribute, direction, line) | RiseAndFall(
                attribute, direction, line
            ):
                yield from (self.attribute(attribute), _likely(direction, Direction.RISING))
                yield self.line(line)
            case Zigzag(attribute, line) | Blocks(attribute, line):
                yield from (self.attribute(attribute), self.line(line))
            case EqualSteps(attribute, ratio, line):
                yield from (self.attribute(attribute), _flag(unusual=ratio), self.line(line))
            case ExtremeAt(attribute, extreme, _, negated):
                yield from (self.attribute(attribute), _likely(extreme, Extreme.HIGHEST))
                yield from (self.position(), _flag(unusual=negated))
            case EachPair(pairs, relation, line):
                yield from (_likely(pairs, Pairs.NEIGHBOURS), self.relation(relation))
                yield self.line(line)
            case TwoPlaces(_, _, relation):
                yield from (2 * self.position(), self.relation(relation))
            case Pattern(tests, repeat, line):
                yield from map(self.test, tests)
                yield from (_amount(len(tests)), _flag(unusual=repeat), self.line(line))
            case Template(attribute, letters, repeat, line):
                yield from (self.attribute(attribute), len(letters) * log2(len(set(letters)) + 1))
                yield from (_amount(len(letters)), _flag(unusual=not repeat), self.line(line))
            case Count(test, comparison, number):
                yield from (
                    self.test(test),
                    _likely(comparison, Comparison.EQUAL),
                    _amount(number),
                )
            case CompareCounts(first, comparison, second):
                yield from (self.test(first), _among(comparison), self.test(second))
            case Kinds(attribute, comparison, number) | Total(attribute, comparison, number):
                yield from (self.attribute(attribute), _likely(comparison, Comparison.EQUAL))
                yield _amount(number)
            case Equation(attribute, left, right, constant, operation):
                yield from (self.attribute(attribute), _likely(operation, Operation.SUM))
                yield from (self.position() * (len(left) + len(right)), _amount(constant))
            case At(_, test, line):
                yield from (self.position(), self.test(test), self.line(line))
            case IfThen(condition, consequence):
                yield from (self.rule(condition), self.rule(consequence))
            case Word(attribute, relation_name, _):
                yield 0.0 if attribute == LETTER else OTHER + self.attribute(attribute)
                yield 0.0 if relation_name is None else OTHER
            case StraightUp(mirrored):
                yield _flag(unusual=mirrored)
            case TakeExtreme(attribute, extreme, among):
                yield from (self.attribute(attribute), _among(extreme))
                yield 0.0 if isinstance(among, Anything) else OTHER + self.test(among)
            case FillOrder(filling):
                yield _likely(filling, Filling.LEFT_TO_RIGHT)
            case Before(first, second, line):
                yield from (self.test(first), self.test(second), _likely(line, Line.TIME))
            case Follows(test, follower, immediately, line):
                yield from (self.test(test), self.test(follower), _flag(unusual=not immediately))
                yield _likely(line, Line.TIME)
            case ModelRow(_, reading, relation):
                yield from (log2(self.setting.start.board.rows), _likely(reading, Reading.COPIED))
                yield self.relation(relation)
            case Cue(_, _, relation):
                yield from (log2(len(self.setting.start.board.cells)), self.relation(relation))
            case FullRow():
                yield 0.0
            case UntilTotal(attribute, number):
                yield from (self.attribute(attribute), _amount(number))
            case _:
                assert_never(rule)
