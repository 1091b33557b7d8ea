"""Random exercises over the rule language, on decks of invented attributes and random boards.

Everything is a pure function of its seed. The families are those of the language, not a list of
exercises; their shares are our judgement of what a caregiver may think of.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise, permutations
from random import Random
from typing import Final

import numpy as np

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import LETTER, Deck, Scale, Token, TokenId, Value
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.conditions import At
from maestra.rules.forms.context import ModelRow, Reading
from maestra.rules.forms.counting import Count, Equation, Kinds, Total
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
from maestra.rules.pairs import AddUp, Apart, Step, different, same
from maestra.rules.plays import Truth
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, Line, Setting
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

SYLLABLES: Final = ("ba", "de", "ki", "lo", "mu", "ne", "po", "ra", "si", "tu")
HIDDEN: Final = "hidden"
"""An attribute that only the truth knows: what cannot be seen cannot be learned."""
MOST: Final = 0.5
"""An exercise that allows more of all rows is none."""
FEWEST: Final = 3
ROUNDED: Final = 10
"""From here on people say multiples of five."""


class Person(Enum):
    """How somebody shows an exercise."""

    UNIFORM = "uniform"
    """Any right play, often from the left, sometimes anyhow."""
    LAZY = "lazy"
    """Often the same row again."""
    LEFT_HANDER = "left-hander"
    """From right to left."""
    NEAR_SIGHTED = "near-sighted"
    """Tokens that lie near their goal cell."""
    SLIPPING = "slipping"
    """Uniform, with one mistake in one of the demonstrations."""


@dataclass(frozen=True, slots=True)
class Kind:
    """An attribute as a deck may have it."""

    name: str
    scale: Scale
    values: tuple[Value, ...]
    unique: bool


@dataclass(frozen=True, slots=True)
class Sample:
    """An exercise, and who shows it."""

    seed: int
    family: str
    kinds: tuple[Kind, ...]
    deck: Deck
    board: Board
    truth: tuple[Rule, ...]
    person: Person
    moves_tokens: bool
    """Whether each demonstration begins with the tokens elsewhere."""


def word(rng: Random) -> str:
    """A name nobody knows."""
    return "".join(rng.sample(SYLLABLES, 2))


def chance(rng: Random, share: float) -> bool:
    """Whether something happens that happens so often."""
    return rng.random() < share


def kinds(rng: Random) -> tuple[Kind, ...]:
    """Two to four attributes; at least one with an order and one with shared values."""
    names = [word(rng) + str(k) for k in range(4)]
    few = tuple(dict.fromkeys(word(rng) for _ in range(rng.choice((2, 3, 3, 4)))))
    low = rng.choice((0, 1, 10))
    high = low + rng.choice((15, 30, 90))
    found = [
        Kind(names[0], Scale.NUMBER, tuple(range(low, high)), unique=chance(rng, 0.8)),
        Kind(names[1], Scale.NOMINAL, few if len(few) > 1 else ("ka", "ko"), unique=False),
    ]
    more = rng.choices(("letter", "order", "cycle", "none"), (6, 4, 3, 7))[0]
    if more == "letter":
        found.append(Kind(LETTER, Scale.LETTER, tuple("ABCDEFGHIJKLMNOPRSTU"), unique=True))
    elif more == "order":
        sizes = tuple(f"{word(rng)}{k}" for k in range(rng.choice((3, 4, 5))))
        found.append(Kind(names[2], Scale.ORDER, sizes, unique=False))
    elif more == "cycle":
        days = tuple(f"{word(rng)}{k}" for k in range(rng.choice((5, 7))))
        found.append(Kind(names[2], Scale.CYCLE, days, unique=False))
    if chance(rng, 0.3):
        found.append(Kind(names[3], Scale.NOMINAL, ("bobo", "didi"), unique=False))
    return tuple(found)


def deck_of(of: Sequence[Kind], count: int, rng: Random) -> Deck:
    """A deck whose tokens show these attributes."""
    columns: dict[str, list[Value]] = {}
    for kind in of:
        if kind.unique:
            columns[kind.name] = rng.sample(kind.values, count)
        else:
            # Each value once before any again: a deck is made for exercises.
            once = rng.sample(kind.values, min(count, len(kind.values)))
            columns[kind.name] = once + rng.choices(kind.values, k=count - len(once))
            rng.shuffle(columns[kind.name])
    return Deck(
        tuple(
            Token(TokenId(f"t{k}"), tuple((name, shown[k]) for name, shown in columns.items()))
            for k in range(count)
        ),
        {k.name: tuple(map(str, k.values)) for k in of if k.scale is Scale.ORDER},
        {k.name: tuple(map(str, k.values)) for k in of if k.scale is Scale.CYCLE},
    )


def start_of(deck: Deck, board: Board, rng: Random) -> State:
    """The tokens anywhere in storage."""
    cells = rng.sample(board.storage_cells, len(deck.tokens))
    return State(board, {t.id: cell for t, cell in zip(deck.tokens, cells, strict=True)})


# ------------------------------------------------------------------ exercises
@dataclass(frozen=True, slots=True)
class Maker:
    """Draws rules for one deck and board."""

    kinds: tuple[Kind, ...]
    deck: Deck
    board: Board
    rng: Random

    def nominal(self) -> Kind:
        """An attribute with shared values."""
        return self.rng.choice([k for k in self.kinds if not k.unique])

    def ordinal(self) -> Kind:
        """An attribute with an order."""
        return self.rng.choice([k for k in self.kinds if k.scale is not Scale.NOMINAL])

    def number(self) -> Kind:
        """A number."""
        return next(k for k in self.kinds if k.scale is Scale.NUMBER)

    def shown(self, kind: Kind) -> list[Value]:
        """What the deck's tokens show."""
        found = {v for t in self.deck.tokens if (v := t.value(kind.name)) is not None}
        return sorted(found, key=kind.values.index)

    def named(self) -> TokenTest:
        """A value of an attribute that tokens share."""
        kind = self.nominal()
        return has(f"is-{self.rng.choice(self.shown(kind))}", kind.name)

    def feature(self) -> TokenTest:
        """A feature of a number or letter."""
        kind = self.ordinal()
        if kind.scale is Scale.NUMBER:
            return has(self.rng.choice(("odd", "even", "multiple-of-3", "digits-1")), kind.name)
        if kind.scale is Scale.LETTER:
            return has(self.rng.choice(("vowel", "consonant")), kind.name)
        return self.named()

    def simple(self) -> TokenTest:
        """A value or a feature."""
        return self.named() if chance(self.rng, 0.6) else self.feature()

    def two(self) -> tuple[TokenTest, TokenTest]:
        """Two values of one attribute."""
        kind = self.nominal()
        one, two = self.rng.sample(self.shown(kind), 2)
        return has(f"is-{one}", kind.name), has(f"is-{two}", kind.name)

    def selecting(self) -> TokenTest:
        """A test that selects."""
        kind, rng = self.ordinal(), self.rng
        ways = ("simple", "not", "either", "extreme", "threshold")
        way = rng.choices(ways, (9, 3, 3, 2, 3))[0]
        if way == "simple":
            return self.simple()
        if way == "not":
            return Not(self.simple())
        if way == "either":
            return Either(self.simple(), self.simple())
        if way == "extreme" and kind.scale is not Scale.CYCLE:
            return Among(kind.name, rng.choice(list(Extreme)))
        if kind.scale is Scale.CYCLE:
            return self.simple()
        value = rng.choice(self.shown(kind)[1:])
        if isinstance(value, int) and value > ROUNDED:
            value -= value % 5
        return Compared(kind.name, rng.choice((Comparison.AT_MOST, Comparison.AT_LEAST)), value)

    def order(self) -> Rule:
        """An order or a shape."""
        kind, rng = self.ordinal(), self.rng
        way = rng.choice(list(Direction))
        if kind.scale is Scale.CYCLE:
            return CyclicOrdered(kind.name, way)
        choices: list[Rule] = [
            Ordered(kind.name, way, kind.unique or chance(rng, 0.3)),
            Ordered(kind.name, way, kind.unique or chance(rng, 0.3)),
            Ordered(kind.name, way, kind.unique or chance(rng, 0.3)),
            RiseAndFall(kind.name, way),
            Zigzag(kind.name),
            ExtremeAt(kind.name, rng.choice(list(Extreme)), rng.choice((FIRST, MIDDLE, LAST))),
        ]
        return rng.choice(choices)

    def grouping(self) -> Rule:
        """Categories along the row."""
        name, rng = self.nominal().name, self.rng
        choices: list[Rule] = [
            Blocks(name),
            EachPair(Pairs.NEIGHBOURS, different(name)),
            EachPair(Pairs.MIRRORED, same(name)),
            EachPair(Pairs.ALL, same(name)),
            Template(name, rng.choice(("AB", "AABB", "ABB")), repeat=True),
            Pattern(self.two(), repeat=True),
            Template(name, rng.choice(("AABBA", "ABBAA", "AAAAB", "ABBBA"))),
            TwoPlaces(FIRST, LAST, rng.choice((same(name), different(name)))),
        ]
        return rng.choice(choices)

    def counting(self) -> Rule:
        """Counts and places."""
        rng = self.rng
        choices: list[Rule] = [
            Count(self.simple(), Comparison.EQUAL, rng.choice((1, 2, 3))),
            Count(self.simple(), Comparison.AT_LEAST, rng.choice((1, 2))),
            Kinds(self.nominal().name, Comparison.EQUAL, rng.choice((2, 3))),
            At(rng.choice((FIRST, LAST, MIDDLE)), self.simple()),
        ]
        return rng.choice(choices)

    def arithmetic(self) -> Rule:
        """Steps, sums, equations."""
        name, rng = self.number().name, self.rng
        values = [v for v in self.shown(self.number()) if isinstance(v, int)]
        total = sum(rng.sample(values, min(len(values), self.board.columns)))
        choices: list[Rule] = [
            EqualSteps(name),
            EachPair(Pairs.NEIGHBOURS, Step(name, rng.choice((1, 2, 5)))),
            EachPair(Pairs.NEIGHBOURS, Apart(name, rng.choice((1, 2, 3)))),
            EachPair(Pairs.TWO_BY_TWO, AddUp(name, sum(rng.sample(values, 2)))),
            Total(name, Comparison.EQUAL, total),
            Total(name, Comparison.AT_MOST, total - total % 10),
            Equation(name, (Position(1), Position(2)), (Position(3),)),
        ]
        return rng.choice(choices)

    def source(self) -> Rule:
        """Where tokens come from."""
        rng = self.rng
        choices: list[Rule] = [
            from_row(rng.randrange(1, self.board.rows)),
            StraightUp(),
            StraightUp(mirrored=True),
            Ordered(ORIGIN_COLUMN, Direction.RISING, strict=False),
            EachPair(Pairs.ALL, different(ORIGIN_COLUMN)),
            TakeExtreme(ORIGIN_COLUMN, Extreme.LOWEST),
            TakeExtreme(self.number().name, rng.choice(list(Extreme))),
        ]
        return rng.choice(choices)

    def timing(self) -> Rule:
        """When tokens are placed."""
        one, two = self.two()
        choices: list[Rule] = [
            FillOrder(self.rng.choice(list(Filling)[1:])),
            Ordered(self.number().name, self.rng.choice(list(Direction)), line=Line.TIME),
            Before(one, two),
            Follows(one, two),
        ]
        return self.rng.choice(choices)

    def context(self) -> Rule:
        """A model row that stays and is followed; the first token's kind."""
        name = self.nominal().name
        return ModelRow(
            self.rng.randrange(1, self.board.rows), self.rng.choice(list(Reading)[:2]), same(name)
        )

    def given(self) -> Rule:
        """The same row every time."""
        kind = self.ordinal()
        tokens = self.rng.sample(self.deck.tokens, self.board.columns)
        return given_row(kind.name, tuple(token.value(kind.name) for token in tokens))


Family = Callable[[Maker], tuple[Rule, ...]]

FAMILIES: Final[dict[str, Family]] = {
    "order": lambda m: (m.order(),),
    "selection": lambda m: (EveryToken(m.selecting()),),
    "selection and order": lambda m: (EveryToken(m.selecting()), m.order()),
    "exhaustive": lambda m: (AllOfThem(m.simple()), m.order()),
    "grouping": lambda m: (m.grouping(),),
    "grouping and selection": lambda m: (m.grouping(), EveryToken(m.selecting())),
    "counting": lambda m: (m.counting(), m.rng.choice((m.order, m.counting, m.grouping))()),
    "arithmetic": lambda m: (m.arithmetic(),),
    "given row": lambda m: (m.given(),),
    "source": lambda m: (m.source(),),
    "source and order": lambda m: (m.source(), m.rng.choice((m.order, m.grouping))()),
    "timing": lambda m: (m.timing(),),
    "context": lambda m: (m.context(),),
}
"""What exercises are made of; each as likely as any other."""


def sample_of(seed: int, *, outside: bool = False) -> Sample:
    """The exercise of a seed.

    Args:
        seed: any number.
        outside: make one over an attribute that the learner is not shown.
    """
    rng = Random(seed)  # noqa: S311 - what is drawn is no secret
    while True:
        found = kinds(rng)
        if outside:
            hidden = rng.choice(
                (
                    Kind(HIDDEN, Scale.NUMBER, tuple(range(40)), unique=True),
                    Kind(HIDDEN, Scale.NOMINAL, ("x", "y", "z"), unique=False),
                )
            )
            found = (hidden, found[1], found[0])
        board = Board(rng.choice((4, 4, 5)), rng.choice((4, 5, 5)))
        deck = deck_of(found, rng.randrange(8, 11), rng)
        maker = Maker(found[:1] if outside else found, deck, board, rng)
        family = rng.choice(["order", "grouping"] if outside else list(FAMILIES))
        try:
            rules = FAMILIES[family](maker)
        except (IndexError, ValueError, StopIteration):
            continue
        truth = (FullRow(), *rules)
        if is_exercise(truth, deck, board, family, rng):
            return Sample(
                seed,
                family,
                found,
                deck,
                board,
                truth,
                rng.choice(list(Person)),
                chance(rng, 0.5) or family.startswith(("source", "context")),
            )


def is_exercise(truth: Sequence[Rule], deck: Deck, board: Board, family: str, rng: Random) -> bool:
    """Whether it allows some plays but not most, from several starts, and no rule is idle."""
    for _ in range(2):
        setting = Setting(deck, start_of(deck, board, rng))
        order = tuple(range(setting.length))
        if any(isinstance(rule, FillOrder) for rule in truth):
            return len(orders_for(truth, setting)) > 0
        context = Context(setting, order, rows_of(setting, full=True))
        right = truths(truth, context)
        fewest = 1 if family == "given row" else FEWEST
        if not fewest <= right.sum() <= MOST * len(right):
            return False
        for k in range(1, len(truth)):
            others = truths((*truth[:k], *truth[k + 1 :]), context)
            if others.sum() == right.sum():
                return False
    return True


def truths(rules: Sequence[Rule], context: Context) -> Truth:
    """Which rows are right under all rules."""
    right = np.ones(len(context.rows.row), np.bool_)
    for rule in rules:
        right &= context.truth(rule)
    return right


def orders_for(truth: Sequence[Rule], setting: Setting) -> list[Order]:
    """Orders of placement that the rules allow, whatever is placed."""
    cells = list(permutations(range(setting.length)))
    found = cells
    for rule in truth:
        if isinstance(rule, FillOrder):
            keys = rule.keys(setting.length)
            found = [o for o in found if all(keys[a] <= keys[b] for a, b in pairwise(o))]
    return found
