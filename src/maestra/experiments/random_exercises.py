"""Random exercises over the rule language, on decks of invented attributes and random boards.

Everything is a pure function of its seed. A caregiver who has an exercise in mind takes a deck
that suits it, so the family is drawn first and the deck after it; see `exercise_families` for
the rules.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise, permutations
from random import Random
from typing import Final

import numpy as np

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import LETTER, Deck, Scale, Token, TokenId, Value
from maestra.experiments.exercise_families import (
    FAMILIES,
    NAME,
    PARTNER,
    Maker,
    NothingToSayError,
    rules_of,
)
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.forms.context import ModelRow
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.plays import Truth
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting

SYLLABLES: Final = ("ba", "de", "ki", "lo", "mu", "ne", "po", "ra", "si", "tu")
HIDDEN: Final = "hidden"
"""An attribute that only the truth knows: what cannot be seen cannot be learned."""
MOST: Final = 0.25
"""A rule that lets more than a quarter of all rows pass is hardly an exercise: and a play that
keeps it by chance tells less than two bits."""
FEWEST: Final = 3
"""Right rows there must be; of a given row there is one."""
MATTERS: Final = 2.0
"""Without any one of its rules an exercise would allow so many times as many rows: a rule that
makes less of a difference nobody would give."""
WORDS: Final = 60
"""In a lexicon."""


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
class Make:
    """What decks of an exercise have in common."""

    kinds: tuple[Kind, ...]
    tokens: int
    partners: tuple[tuple[str, str], ...] = ()
    lexicon: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Sample:
    """An exercise, and who shows it."""

    seed: int
    family: str
    make: Make
    deck: Deck
    board: Board
    truth: tuple[Rule, ...]
    person: Person
    moves_tokens: bool
    """Whether each demonstration begins with the tokens elsewhere."""
    filled: int | None = None
    """A storage row, from 1, that is full at every start; otherwise a model is."""

    def start(self, deck: Deck, rng: Random) -> State:
        """Where the tokens of a deck may lie at the start."""
        return start_of(deck, self.board, rng, self.filled or model_row(self.truth))

    @property
    def full(self) -> bool:
        """Whether every goal cell must be filled."""
        return FullRow() in self.truth


def word(rng: Random) -> str:
    """A name nobody knows."""
    return "".join(rng.sample(SYLLABLES, 2))


# ------------------------------------------------------------------ decks
def numbers(name: str, family: str, rng: Random) -> Kind:
    """Numbers: any, a run, doubles, or a few that repeat, as money does."""
    ways = ("run", "run", "doubles", "any") if family == "arithmetic" else ("any",) * 4 + ("few",)
    low = rng.choice((0, 1, 10))
    match rng.choice(ways):
        case "run":
            return Kind(name, Scale.NUMBER, tuple(range(low, low + 12)), unique=True)
        case "doubles":
            return Kind(name, Scale.NUMBER, tuple(2**k for k in range(11)), unique=True)
        case "few":
            return Kind(name, Scale.NUMBER, (1, 2, 5, 10, 20), unique=False)
        case _:
            high = low + rng.choice((15, 30, 90))
            return Kind(name, Scale.NUMBER, tuple(range(low, high)), unique=True)


def make(family: str, rng: Random, columns: int) -> Make:
    """A deck's attributes: a number, a kind, and what else suits the family or happens to be."""
    names = [word(rng) + str(k) for k in range(4)]
    few = tuple(dict.fromkeys(word(rng) for _ in range(rng.choice((2, 3, 3, 4)))))
    found = [
        numbers(names[0], family, rng),
        Kind(names[1], Scale.NOMINAL, few if len(few) > 1 else ("ka", "ko"), unique=False),
    ]
    tokens = rng.randrange(8, 11)
    if family == "memory":
        tokens = rng.randrange(2 * columns, 2 * columns + 2)
    more = {"spelling": ("letter",), "routine": ("cycle", "cycle", "order", "name")}.get(
        family, ("letter", "letter", "order", "cycle", "partner", "none", "none", "none")
    )
    partners: tuple[tuple[str, str], ...] = ()
    lexicon: tuple[str, ...] = ()
    match rng.choice(more):
        case "letter":
            letters = tuple("ABCDEFGHIJKLMNOPRSTU")
            found.append(Kind(LETTER, Scale.LETTER, letters, unique=True))
            if family == "spelling":
                few_letters = rng.sample(letters, 11)
                found[-1] = Kind(LETTER, Scale.LETTER, tuple(few_letters), unique=True)
                drawn = ("".join(rng.sample(few_letters, columns)) for _ in range(WORDS))
                lexicon = tuple(dict.fromkeys(drawn))
        case "order":
            sizes = tuple(f"{word(rng)}{k}" for k in range(rng.choice((4, 5, 6))))
            found.append(Kind(names[2], Scale.ORDER, sizes, unique=False))
        case "cycle":
            days = tuple(f"{word(rng)}{k}" for k in range(rng.choice((5, 7))))
            found.append(Kind(names[2], Scale.CYCLE, days, unique=False))
        case "name":
            tokens = columns + rng.choice((0, 1))
            found.append(Kind(NAME, Scale.NOMINAL, _names(rng, tokens), unique=True))
        case "partner":
            tokens -= tokens % 2
            called = _names(rng, tokens)
            found.append(Kind(NAME, Scale.NOMINAL, called, unique=True))
            partners = tuple(zip(called[::2], called[1::2], strict=True))
        case _:
            pass
    if rng.random() < 0.3:  # noqa: PLR2004 - our judgement
        found.append(Kind(names[3], Scale.NOMINAL, ("bobo", "didi"), unique=False))
    return Make(tuple(found), tokens, partners, lexicon)


def _names(rng: Random, count: int) -> tuple[str, ...]:
    found: dict[str, None] = {}
    while len(found) < count:
        found[word(rng)] = None
    return tuple(found)


def deck_of(of: Make, rng: Random) -> Deck:
    """A deck whose tokens show these attributes."""
    count = of.tokens
    columns: dict[str, list[Value]] = {}
    for kind in of.kinds:
        if kind.name == NAME:
            columns[kind.name] = list(kind.values)
        elif kind.unique:
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
        {k.name: tuple(map(str, k.values)) for k in of.kinds if k.scale is Scale.ORDER},
        {k.name: tuple(map(str, k.values)) for k in of.kinds if k.scale is Scale.CYCLE},
        {PARTNER: frozenset(of.partners)} if of.partners else {},
        of.lexicon,
    )


def start_of(deck: Deck, board: Board, rng: Random, model: int | None = None) -> State:
    """The tokens anywhere in storage; if there is a `model`, that storage row is full."""
    rows = sorted({cell.row for cell in board.storage_cells})
    first = [] if model is None else [c for c in board.storage_cells if c.row == rows[model - 1]]
    others = [cell for cell in board.storage_cells if cell not in first]
    cells = [*first, *rng.sample(others, len(deck.tokens) - len(first))]
    rng.shuffle(cells)
    return State(board, {t.id: cell for t, cell in zip(deck.tokens, cells, strict=True)})


# ------------------------------------------------------------------ exercises
def sample_of(seed: int, *, outside: bool = False, person: Person | None = None) -> Sample:
    """The exercise of a seed.

    Args:
        seed: any number.
        outside: make one over an attribute that the learner is not shown.
        person: who shows it; any if not said.
    """
    rng = Random(seed)  # noqa: S311 - what is drawn is no secret
    drawn = rng.choice(list(Person))
    while True:
        # Drawn anew each time: a family that seldom suits a deck would else seldom come.
        family = list(FAMILIES)[seed % len(FAMILIES)]
        if outside:
            family = ("ordering", "grouping", "shape", "counting")[seed % 4]
        board = Board(rng.choice((4, 4, 5)), rng.choice((4, 5, 5)))
        of = make(family, rng, board.columns)
        if outside:
            of = Make((*_hidden(rng), *of.kinds), of.tokens, of.partners)
        deck = deck_of(of, rng)
        seen = Deck(_only(deck, HIDDEN), {}, {}) if outside else deck
        try:
            truth = rules_of(family, Maker(seen, board, rng))
        except NothingToSayError:
            continue
        if is_exercise(truth, deck, board, rng):
            moves = rng.random() < 1 / 2 or family in ("source", "memory")
            return Sample(seed, family, of, deck, board, truth, person or drawn, moves)


def _hidden(rng: Random) -> tuple[Kind, ...]:
    return (
        Kind(f"{HIDDEN}-number", Scale.NUMBER, tuple(range(40)), unique=True),
        Kind(f"{HIDDEN}-kind", Scale.NOMINAL, ("x", "y", "z")[: rng.choice((2, 3))], unique=False),
    )


def _only(deck: Deck, prefix: str) -> tuple[Token, ...]:
    return tuple(
        Token(t.id, tuple((k, v) for k, v in t.attributes if k.startswith(prefix)))
        for t in deck.tokens
    )


def model_row(truth: Sequence[Rule]) -> int | None:
    """The storage row that is a model, if one is."""
    return next((rule.row for rule in truth if isinstance(rule, ModelRow)), None)


def is_exercise(truth: Sequence[Rule], deck: Deck, board: Board, rng: Random) -> bool:
    """Whether it allows some plays but not many, from several starts, and no rule is idle."""
    given = any(rule.form == "pattern" for rule in truth)
    fewest = 1 if given else FEWEST
    full = FullRow() in truth
    for _ in range(2):
        setting = Setting(deck, start_of(deck, board, rng, model_row(truth)))
        orders = orders_for(truth, setting)
        if any(isinstance(rule, FillOrder) for rule in truth):
            return len(truth) == 2 or len(orders) > 0  # noqa: PLR2004 - the length and the order
        order = rng.choice(orders)
        context = Context(setting, order, rows_of(setting, order, full=full))
        right = truths(truth, context)
        if not fewest <= right.sum() <= MOST * len(right):
            return False
        for k in range(1, len(truth)):
            others = truths((*truth[:k], *truth[k + 1 :]), context)
            if others.sum() < MATTERS * right.sum():
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
    found = list(permutations(range(setting.length)))
    for rule in truth:
        if isinstance(rule, FillOrder):
            keys = rule.keys(setting.length)
            found = [o for o in found if all(keys[a] <= keys[b] for a, b in pairwise(o))]
    return found
