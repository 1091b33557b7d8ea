"""Random rules by the families of exercises that therapists use, for a deck and a board.

Each family draws its rules from the attributes the deck happens to have; a family that finds
nothing to say about a deck says so by `NothingToSayError`, and another deck is drawn. Families
are about as broad as what they stand for: within one each shape of rule is about as likely.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Final, TypeAlias

from maestra.core.board import Board
from maestra.core.tokens import Deck, Scale, Value
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template, given_row
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme, from_row
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Apart, Named, Step, Times, different, same
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import (
    Among,
    Compared,
    Comparison,
    Either,
    Extreme,
    Not,
    TokenTest,
    has,
)

ROUNDED: Final = 10
"""From here on people say multiples of five."""
NAME: Final = "name"
PARTNER: Final = "partner"
FIVE: Final = 5


class NothingToSayError(Exception):
    """The family has nothing to say about this deck and board."""


Rules: TypeAlias = tuple[Rule, ...]


@dataclass(frozen=True, slots=True)
class Maker:
    """Draws rules for one deck and board."""

    deck: Deck
    board: Board
    rng: Random

    # -------------------------------------------------------------- what the deck has
    def attributes(self, *scales: Scale, shared: bool | None = None) -> list[str]:
        """The attributes of these scales, all of them if none is named."""
        return [
            name
            for name, scale in self.deck.scales.items()
            if (not scales or scale in scales)
            and name != NAME
            and shared in (None, len(self.values(name)) < len(self.deck.tokens))
        ]

    def one(self, found: list[str]) -> str:
        """One of them."""
        if not found:
            raise NothingToSayError
        return self.rng.choice(found)

    def nominal(self) -> str:
        """An attribute that names kinds of tokens."""
        return self.one(self.attributes(Scale.NOMINAL, shared=True))

    def ordinal(self) -> str:
        """An attribute with an order."""
        return self.one(self.attributes(Scale.NUMBER, Scale.LETTER, Scale.ORDER))

    def number(self) -> str:
        """An attribute that is a number."""
        return self.one(self.attributes(Scale.NUMBER))

    def values(self, name: str) -> list[Value]:
        """What the tokens show, in order where there is one."""
        found = {v for t in self.deck.tokens if (v := t.value(name)) is not None}
        if self.deck.scales[name] is Scale.NOMINAL:
            return sorted(found, key=str)
        return sorted(found, key=lambda value: self.deck.rank(name, value))

    def is_unique(self, name: str) -> bool:
        """Whether no two tokens show the same."""
        return len(self.values(name)) == len(self.deck.tokens)

    # -------------------------------------------------------------- tests
    def kind(self) -> TokenTest:
        """A named kind: red, fruit."""
        name = self.nominal()
        return has(f"is-{self.rng.choice(self.values(name))}", name)

    def feature(self) -> TokenTest:
        """A feature of a number or a letter."""
        name = self.one(self.attributes(Scale.NUMBER, Scale.LETTER))
        if self.deck.scales[name] is Scale.LETTER:
            return has(self.rng.choice(("vowel", "consonant")), name)
        return has(self.rng.choice(("odd", "even", "odd", "even", "multiple-of-3")), name)

    def simple(self) -> TokenTest:
        """A named kind or a feature."""
        return self.rng.choice((self.kind, self.feature))()

    def threshold(self) -> TokenTest:
        """More or less than a value."""
        name, rng = self.ordinal(), self.rng
        value = rng.choice(self.values(name)[1:])
        if isinstance(value, int) and value > ROUNDED:
            value -= value % 5
        return Compared(name, rng.choice((Comparison.AT_MOST, Comparison.AT_LEAST)), value)

    def extreme(self) -> TokenTest:
        """The smallest or largest of the board."""
        return Among(self.ordinal(), self.rng.choice(list(Extreme)))

    def two_kinds(self) -> tuple[TokenTest, TokenTest]:
        """Two values of one attribute."""
        name = self.nominal()
        one, two = self.rng.sample(self.values(name), 2)
        return has(f"is-{one}", name), has(f"is-{two}", name)

    def selecting(self) -> TokenTest:
        """A test that selects tokens."""
        ways: tuple[Callable[[], TokenTest], ...] = (
            self.kind,
            self.feature,
            self.threshold,
            self.extreme,
            lambda: Not(self.simple()),
            lambda: Either(self.simple(), self.simple()),
        )
        return self.rng.choices(ways, (4, 4, 3, 2, 2, 2))[0]()

    # -------------------------------------------------------------- families
    def ordered(self, line: Line = Line.ROW) -> Rule:
        """From small to large or the other way; ties where there are."""
        name = self.ordinal()
        return Ordered(name, self.rng.choice(list(Direction)), self.is_unique(name), line)

    def ordering(self) -> Rules:
        """A. Ordering by one attribute."""
        return (self.ordered(),)

    def selection(self) -> Rules:
        """B. Choosing tokens, in any order or in order; all there are of a kind."""
        way = self.rng.choice(("only", "only", "ordered", "ordered", "all", "all"))
        if way == "all":
            test = self.simple()
            there = (self.ordered(),) if self.rng.random() < 1 / 2 else ()
            return (EveryToken(test), AllOfThem(test), *there)
        chosen = EveryToken(self.selecting())
        return (chosen,) if way == "only" else (chosen, self.ordered())

    def grouping(self) -> Rules:
        """C. Kinds together, kinds apart, partners, so many of each."""
        rng, name = self.rng, self.nominal()
        one, two = self.two_kinds()
        ways: list[Rules] = [
            (Blocks(name),),
            (EachPair(Pairs.NEIGHBOURS, different(name)),),
            (Template(name, "A" * (self.board.columns - 1) + "B"),),
            (EachPair(Pairs.ALL, same(name)),),
            (
                Count(one, Comparison.EQUAL, 2),
                Count(two, Comparison.EQUAL, self.board.columns - 2),
            ),
            (Kinds(name, Comparison.EQUAL, rng.choice((2, 3))),),
        ]
        if self.deck.relations:
            ways += [(EachPair(Pairs.TWO_BY_TWO, Named(PARTNER)),)] * 3
        return rng.choice(ways)

    def shape(self) -> Rules:
        """D. Alternation, repetition, symmetry, shapes."""
        rng, name, length = self.rng, self.nominal(), self.board.columns
        place = rng.choice((FIRST, LAST, MIDDLE if length % 2 else LAST))
        letters = rng.choice(("AABBA", "ABBAA", "ABBBA", "AABAA", "ABBAB"))[:length]
        ways: list[Callable[[], Rule]] = [
            lambda: Template(name, "AB", repeat=True),
            lambda: Pattern(self.two_kinds(), repeat=True),
            lambda: Template(name, letters),
            lambda: Zigzag(self.ordinal()),
            lambda: RiseAndFall(self.ordinal(), rng.choice(list(Direction))),
            lambda: ExtremeAt(self.ordinal(), rng.choice(list(Extreme)), place),
            lambda: EachPair(Pairs.MIRRORED, same(name)),
            lambda: TwoPlaces(FIRST, LAST, same(name)),
        ]
        return (rng.choice(ways)(),)

    def arithmetic(self) -> Rules:
        """E. Steps, doubling, sums, equations."""
        name, rng = self.number(), self.rng
        values = [v for v in self.values(name) if isinstance(v, int)]
        total = sum(rng.sample(values, min(len(values), self.board.columns)))
        ways: list[Callable[[], Rule]] = [
            lambda: EachPair(Pairs.NEIGHBOURS, Step(name, rng.choice((1, 2, 3, 5)))),
            lambda: EachPair(Pairs.NEIGHBOURS, Times(name, 2)),
            lambda: EqualSteps(name),
            lambda: EachPair(Pairs.NEIGHBOURS, Apart(name, rng.choice((1, 2, 3)))),
            lambda: EachPair(Pairs.NEIGHBOURS, AddUp(name, sum(rng.sample(values, 2)))),
            lambda: EachPair(Pairs.TWO_BY_TWO, AddUp(name, sum(rng.sample(values, 2)))),
            lambda: Total(name, Comparison.EQUAL, total),
            lambda: Total(name, Comparison.AT_MOST, total - total % 10),
            lambda: Equation(name, (Position(1), Position(2)), (Position(3),)),
        ]
        return (rng.choice(ways)(),)

    def spelling(self) -> Rules:
        """F. The same row every time; any word of a lexicon."""
        if bool(self.deck.lexicon) and self.rng.choice((True, False)):
            return (Word(),)
        name = self.one(self.attributes(shared=False))
        tokens = self.rng.sample(self.deck.tokens, self.board.columns)
        return (given_row(name, tuple(token.value(name) for token in tokens)),)

    def routine(self) -> Rules:
        """G. Days and months in order, starting anywhere; one named thing before another."""
        rng = self.rng
        cycles, orders = self.attributes(Scale.CYCLE), self.attributes(Scale.ORDER)
        ways: list[Rules] = []
        if cycles:
            name = rng.choice(cycles)
            ways = [
                (EachPair(Pairs.NEIGHBOURS, Step(name, 1)),),
                (CyclicOrdered(name, rng.choice(list(Direction))),),
            ]
        elif orders:
            ways = [(EachPair(Pairs.NEIGHBOURS, Step(rng.choice(orders), 1)),)]
        if NAME in self.deck.scales and len(self.deck.tokens) <= self.board.columns + 2:
            names = rng.sample(self.values(NAME), 3)
            one, two, three = (has(f"is-{each}", NAME) for each in names)
            ways.append((Before(one, two), Before(two, three)))
        if not ways:
            raise NothingToSayError
        return rng.choice(ways)

    def source(self) -> Rules:
        """H. Where tokens come from."""
        rng = self.rng
        rows = self.board.rows - 1
        first, second = rng.sample(range(1, rows + 1), 2)
        ways: list[Rule] = [
            from_row(rng.randrange(1, rows + 1)),
            StraightUp(),
            StraightUp(mirrored=True),
            Pattern(
                (has(f"is-{first}", ORIGIN_ROW), has(f"is-{second}", ORIGIN_ROW)), repeat=True
            ),
            TakeExtreme(ORIGIN_COLUMN, Extreme.LOWEST),
            Ordered(ORIGIN_COLUMN, Direction.RISING, strict=False),
            EachPair(Pairs.ALL, different(ORIGIN_COLUMN)),
        ]
        ordered = (self.ordered(),) if rng.random() < 1 / 5 else ()
        return (rng.choice(ways), *ordered)

    def timing(self) -> Rules:
        """I. When tokens are placed."""
        one, two = self.two_kinds()
        ways: list[Rule] = [
            FillOrder(self.rng.choice(list(Filling)[1:])),
            self.ordered(Line.TIME),
            Before(one, two, Line.TIME),
            Follows(one, two, line=Line.TIME),
            TakeExtreme(self.ordinal(), self.rng.choice(list(Extreme))),
        ]
        return (self.rng.choice(ways),)

    def counting(self) -> Rules:
        """J. Counts and conditions, with and without an order."""
        one, two = self.two_kinds()
        ways: list[Callable[[], Rules]] = [
            lambda: (Count(self.simple(), Comparison.EQUAL, self.rng.choice((1, 2, 3))),),
            lambda: (Count(one, Comparison.EQUAL, self.rng.choice((1, 2, 3))), self.ordered()),
            lambda: (Count(one, Comparison.AT_LEAST, self.rng.choice((1, 2, 3))),),
            lambda: (CompareCounts(one, Comparison.MORE, two),),
            lambda: (IfThen(At(FIRST, one), At(LAST, two)),),
            lambda: (At(self.rng.choice((FIRST, LAST)), self.simple()),),
        ]
        return self.rng.choice(ways)()

    def memory(self) -> Rules:
        """K. A model row, or one token, that stays and is followed."""
        name, row = self.nominal(), self.rng.randrange(1, self.board.rows)
        if self.rng.random() < 1 / FIVE:
            return (Cue(row, self.rng.randrange(1, self.board.columns + 1), same(name)),)
        return (ModelRow(row, self.rng.choice(list(Reading)), same(name)),)


FAMILIES: Final[dict[str, Callable[[Maker], Rules]]] = {
    "ordering": Maker.ordering,
    "selection": Maker.selection,
    "grouping": Maker.grouping,
    "shape": Maker.shape,
    "arithmetic": Maker.arithmetic,
    "spelling": Maker.spelling,
    "routine": Maker.routine,
    "source": Maker.source,
    "timing": Maker.timing,
    "counting": Maker.counting,
    "memory": Maker.memory,
}
"""What exercises are made of; each as likely as any other."""

WITH_SELECTION: Final = 0.15
"""How many exercises of the families `MAY_SELECT` also say which tokens to use."""
MAY_SELECT: Final = ("grouping", "shape", "source", "timing")


def rules_of(family: str, maker: Maker) -> Rules:
    """The rules of a random exercise of a family, with its length.

    Raises:
        NothingToSayError: the deck or the board has nothing for it.
    """
    try:
        rules = FAMILIES[family](maker)
        if family in MAY_SELECT and maker.rng.random() < WITH_SELECTION:
            rules = (*rules, EveryToken(maker.selecting()))
    except (IndexError, ValueError):
        raise NothingToSayError from None
    if any(isinstance(rule, AllOfThem) for rule in rules):
        return rules
    if any(isinstance(rule, Word) for rule in rules):
        return rules
    return (FullRow(), *rules)
