"""A rule as a picture, in terms of the board: data for whoever draws it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from enum import Enum
from types import MappingProxyType
from typing import Final, TypeAlias, assert_never

from maestra.core.board import Cell
from maestra.core.tokens import TokenId
from maestra.rules.forms.base import Direction, Position, place_of
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Operation, Total
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
    order_of,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Apart, Compare, Named, Relation, Step, Times
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Line, Mask, Rank, Setting, bits
from maestra.rules.token_tests import Anything, Comparison, Extreme, TokenTest, passing


@dataclass(frozen=True, slots=True)
class Turn:
    """The moment when the `number`-th token is placed, from 1; -1 is the last one."""

    number: int


Place: TypeAlias = Cell | Turn
"""Where something is drawn: on a cell of the board, or on the line of time beside it."""


class Sign(Enum):
    """What stands on an arrow, from its start to its end."""

    LESS = "<"
    AT_MOST = "≤"
    SAME = "="
    DIFFERENT = "≠"
    AT_LEAST = "≥"
    MORE = ">"
    PLUS = "+"
    APART = "±"
    TIMES = "×"
    ADD_UP = "Σ"
    NAMED = "~"
    MOVES = "→"
    """A token goes this way."""


@dataclass(frozen=True, slots=True)
class Arrow:
    """From one place to another, with a sign, the attribute or name it is about, an amount."""

    start: Place
    end: Place
    sign: Sign
    about: str = ""
    amount: int | Decimal | None = None


@dataclass(frozen=True, slots=True)
class Choice:
    """The tokens that may be at a place."""

    place: Place
    tokens: tuple[TokenId, ...]


@dataclass(frozen=True, slots=True)
class Selection:
    """Tokens to be marked where they lie: those that belong in the row."""

    tokens: tuple[TokenId, ...]


@dataclass(frozen=True, slots=True)
class Succession:
    """Sets of tokens, one after the other."""

    sets: tuple[tuple[TokenId, ...], ...]
    line: Line


class Measure(Enum):
    """What is counted or added up."""

    TOKENS = "tokens"
    KINDS = "kinds"
    SUM = "sum"


@dataclass(frozen=True, slots=True)
class Tally:
    """An amount beside the row, and what it must be."""

    measure: Measure
    about: str
    """The attribute of kinds and sums."""
    tokens: tuple[TokenId, ...]
    """Which ones count."""
    comparison: Comparison
    number: int | Decimal


@dataclass(frozen=True, slots=True)
class Balance:
    """Two sets of tokens, and which the row must have more of."""

    first: tuple[TokenId, ...]
    comparison: Comparison
    second: tuple[TokenId, ...]


@dataclass(frozen=True, slots=True)
class Badge:
    """A short text on a place: a letter of a template, a turn, the sign of an extreme."""

    place: Place
    text: str


@dataclass(frozen=True, slots=True)
class Implication:
    """If the first is as drawn, so is the second."""

    condition: tuple[Stroke, ...]
    consequence: tuple[Stroke, ...]


Stroke: TypeAlias = Arrow | Choice | Selection | Succession | Tally | Balance | Badge | Implication

_SIGNS: Final[Mapping[Comparison, Sign]] = MappingProxyType(
    {
        Comparison.LESS: Sign.LESS,
        Comparison.AT_MOST: Sign.AT_MOST,
        Comparison.EQUAL: Sign.SAME,
        Comparison.DIFFERENT: Sign.DIFFERENT,
        Comparison.AT_LEAST: Sign.AT_LEAST,
        Comparison.MORE: Sign.MORE,
    }
)
_EXTREMES: Final = MappingProxyType({Extreme.HIGHEST: "▲", Extreme.LOWEST: "▼"})
_NOT: Final = "¬"
_ANY_LETTER: Final = "?"
_FILLED: Final = "■"
_OPERATIONS: Final = MappingProxyType({Operation.SUM: "+", Operation.PRODUCT: "×"})


def picture(rule: Rule, setting: Setting) -> tuple[Stroke, ...]:
    """What to draw for `rule` on this board with these tokens."""
    return tuple(_Artist(setting).draw(rule))


@dataclass(frozen=True, slots=True)
class _Artist:
    """Knows where things are on one board."""

    setting: Setting

    def draw(self, rule: Rule) -> Iterable[Stroke]:  # noqa: C901, PLR0912 - one case for each form
        match rule:
            case EveryToken(test):
                return [Selection(self.stored(test))]
            case AllOfThem(test):
                wanted = self.stored(test)
                return [Tally(Measure.TOKENS, "", wanted, Comparison.EQUAL, len(wanted))]
            case Pattern():
                return self.choices(rule)
            case At(position, test, line):
                return self.at(position, test, line)
            case StraightUp(mirrored):
                return self.straight(mirrored=mirrored)
            case ModelRow(_, _, relation):
                models = enumerate(rule.models(self.setting))
                return [
                    self.relate(self.lies(token), self.goal(k), relation)
                    for k, token in models
                    if token is not None
                ]
            case Cue(_, _, relation):
                cue = rule.cue(self.setting)
                cells = () if cue is None else range(self.setting.length)
                return [self.relate(self.lies(cue or 0), self.goal(k), relation) for k in cells]
            case EachPair(_, relation) | TwoPlaces(_, _, relation):
                return [
                    self.relate(self.place(rule.along(), i), self.place(rule.along(), j), relation)
                    for i, j, _ in rule.links(self.setting)
                ]
            case Ordered() | CyclicOrdered() | RiseAndFall() | Zigzag() | EqualSteps():
                return self.shape(rule)
            case ExtremeAt(_, extreme, position, negated):
                text = (_NOT if negated else "") + _EXTREMES[extreme]
                return self.badges(Line.ROW, [position], text)
            case Template(_, letters, repeat, line):
                reach = self.setting.length if repeat else min(self.setting.length, len(letters))
                return [
                    Badge(self.place(line, k), letters[k % len(letters)]) for k in range(reach)
                ]
            case Blocks(_, line):
                length = self.setting.length
                return [
                    Badge(self.place(line, k), "A" if k < length / 2 else "B")
                    for k in range(length)
                ]
            case Count(test, comparison, number):
                return [Tally(Measure.TOKENS, "", self.stored(test), comparison, number)]
            case CompareCounts(first, comparison, second):
                return [Balance(self.stored(first), comparison, self.stored(second))]
            case Kinds(attribute, comparison, number):
                return [self.tally(Measure.KINDS, attribute, comparison, number)]
            case Total(attribute, comparison, number):
                return [self.tally(Measure.SUM, attribute, comparison, number)]
            case UntilTotal(attribute, number):
                return [self.tally(Measure.SUM, attribute, Comparison.AT_LEAST, number)]
            case Equation(attribute, left, right, constant, operation):
                sign = _OPERATIONS[operation]
                sides = (self.badges(Line.ROW, left, sign), self.badges(Line.ROW, right, "="))
                rest = self.tally(Measure.SUM, attribute, Comparison.EQUAL, constant)
                return [*sides[0], *sides[1], rest]
            case IfThen(condition, consequence):
                return [Implication(tuple(self.draw(condition)), tuple(self.draw(consequence)))]
            case Word():
                return [Badge(self.goal(k), _ANY_LETTER) for k in range(self.setting.length)]
            case FullRow():
                return [Badge(self.goal(k), _FILLED) for k in range(self.setting.length)]
            case FillOrder():
                return self.filling(rule)
            case TakeExtreme():
                return [Succession(self.taking(rule), Line.TIME)]
            case Before(first, second, line) | Follows(first, second, _, line):
                return [Succession((self.stored(first), self.stored(second)), line)]
            case _:
                assert_never(rule)

    def goal(self, k: Index) -> Cell:
        """The k-th goal cell, from 0."""
        return self.setting.start.board.goal_cells[k]

    def place(self, line: Line, k: Index) -> Place:
        """The k-th slot of a line, from 0."""
        return self.goal(k) if line is Line.ROW else Turn(k + 1)

    def lies(self, token: Index) -> Cell:
        """Where a token lies at the start."""
        return self.setting.start.cells[self.setting.deck.tokens[token].id]

    def ids(self, mask: Mask) -> tuple[TokenId, ...]:
        """The ids of a set."""
        return tuple(self.setting.deck.tokens[k].id for k in bits(mask))

    def stored(self, test: TokenTest) -> tuple[TokenId, ...]:
        """The tokens in storage that pass."""
        return self.ids(passing(self.setting, test) & self.setting.movable)

    def choices(self, rule: Pattern) -> list[Stroke]:
        """For each slot that is not free the tokens that may be there."""
        masks, movable = rule.allowed(self.setting), self.setting.movable
        return [
            Choice(self.place(rule.line, k), self.ids(mask & movable))
            for k, mask in enumerate(masks)
            if movable & ~mask
        ]

    def at(self, position: Position, test: TokenTest, line: Line) -> list[Stroke]:
        """The tokens that may be at one place; none, if the row has no such place."""
        if line is Line.TIME:
            return [Choice(Turn(position), self.stored(test))]
        place = place_of(position, self.setting.length)
        return [] if place is None else [Choice(self.goal(place), self.stored(test))]

    def badges(self, line: Line, positions: Sequence[Position], text: str) -> list[Stroke]:
        """The same text on several places, those that the row has."""
        places = [place_of(position, self.setting.length) for position in positions]
        return [Badge(self.place(line, k), text) for k in places if k is not None]

    def straight(self, *, mirrored: bool) -> list[Stroke]:
        """From the storage cell of each column up to its goal cell."""
        below = self.setting.start.board.storage_cells[-self.setting.length :]
        ends = [self.goal(k) for k in range(self.setting.length)]
        return [
            Arrow(start, end, Sign.MOVES)
            for start, end in zip(below, ends[::-1] if mirrored else ends, strict=False)
        ]

    def tally(
        self, measure: Measure, attribute: str, comparison: Comparison, number: int | Decimal
    ) -> Tally:
        """An amount of the whole row."""
        return Tally(measure, attribute, self.stored(Anything()), comparison, number)

    def shape(
        self, rule: Ordered | CyclicOrdered | RiseAndFall | Zigzag | EqualSteps
    ) -> list[Stroke]:
        """An arrow from each slot to the next one."""
        last = self.setting.length - 1
        places = [self.place(rule.line, k) for k in range(last + 1)]
        arrows: list[Stroke] = [
            Arrow(places[k], places[k + 1], self.sign(rule, k), rule.attribute)
            for k in range(last)
        ]
        if isinstance(rule, CyclicOrdered) and last:
            arrows.append(Arrow(places[last], places[0], self.sign(rule, last), rule.attribute))
        return arrows

    def sign(
        self, rule: Ordered | CyclicOrdered | RiseAndFall | Zigzag | EqualSteps, k: Index
    ) -> Sign:
        """How slot k compares to the next one."""
        match rule:
            case Ordered(_, direction, strict):
                return _SIGNS[order_of(direction, strict=strict)]
            case CyclicOrdered(_, direction):
                return _SIGNS[order_of(direction, strict=True)]
            case RiseAndFall(_, direction):
                rises = (direction is Direction.RISING) is (k + 1 <= self.setting.length // 2)
                return Sign.LESS if rises else Sign.MORE
            case Zigzag():
                return Sign.MORE if k % 2 else Sign.LESS
            case EqualSteps(_, ratio):
                return Sign.TIMES if ratio else Sign.PLUS
            case _:
                assert_never(rule)

    def relate(self, start: Place, end: Place, relation: Relation) -> Arrow:
        """An arrow that says how what is at its ends must relate."""
        match relation:
            case Compare(attribute, comparison, other):
                about = attribute if other is None else f"{attribute}, {other}"
                return Arrow(start, end, _SIGNS[comparison], about)
            case Step(attribute, amount):
                return Arrow(start, end, Sign.PLUS, attribute, amount)
            case Apart(attribute, amount):
                return Arrow(start, end, Sign.APART, attribute, amount)
            case Times(attribute, amount):
                return Arrow(start, end, Sign.TIMES, attribute, amount)
            case AddUp(attribute, amount):
                return Arrow(start, end, Sign.ADD_UP, attribute, amount)
            case Named(name):
                return Arrow(start, end, Sign.NAMED, name)
            case _:
                assert_never(relation)

    def filling(self, rule: FillOrder) -> list[Stroke]:
        """On each goal cell as the how-manieth it is filled, equals alike."""
        keys = rule.keys(self.setting.length)
        turns = {key: turn for turn, key in enumerate(sorted(set(keys)), start=1)}
        return [Badge(self.goal(k), str(turns[key])) for k, key in enumerate(keys)]

    def taking(self, rule: TakeExtreme) -> tuple[tuple[TokenId, ...], ...]:
        """The tokens looked at, in the order in which they are taken, equals together."""
        ranks = self.setting.ranks(rule.attribute)
        looked_at = passing(self.setting, rule.among) & self.setting.movable
        groups: dict[Rank, Mask] = {}
        for token in bits(looked_at):
            if (rank := ranks[token]) is not None:
                groups[rank] = groups.get(rank, 0) | 1 << token
        order = sorted(groups, reverse=rule.extreme is Extreme.HIGHEST)
        return tuple(self.ids(groups[rank]) for rank in order)
