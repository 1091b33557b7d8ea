"""All rows that could have been played from one start, and which of them a rule allows.

Where there are at most `MAX_ROWS` they are listed, so counts are exact; see `sampled` beyond.
Sets of rows are packed, 64 to a word: the rows that two rules share are counted at one word a
nanosecond or so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import perm
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from maestra.rules.forms.base import EachSlot, Pairwise
from maestra.rules.forms.context import Cue, ModelRow
from maestra.rules.forms.sources import StraightUp
from maestra.rules.looks import lines_of, sights_of
from maestra.rules.plays import NOBODY, Plays, Tokens, Truth, as_matrix, as_table
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Mask, Play, Setting, bits
from maestra.rules.token_tests import Among, Both, Compared, Either, Has, Not, TokenTest

MAX_ROWS: Final = 200_000
"""More are sampled: 10 tokens on 5 cells make 30,240, 12 on 5 make 95,040."""

Words: TypeAlias = NDArray[np.uint64]
"""Packed sets of rows: sets x words."""
Order: TypeAlias = tuple[int, ...]
"""All goal cells in the order of placement."""


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows of tokens over the goal cells, and what many rules need to know of them."""

    row: Tokens
    """rows x goal cells."""
    weight: NDArray[np.float64] | None
    """How many rows each stands for, the same for all 64 of a packed word, 0 for what only fills
    a word up; None: each for itself."""

    @cached_property
    def real(self) -> Truth:
        """Which of them are rows, and do not only fill a word up."""
        return np.ones(len(self.row), np.bool_) if self.weight is None else self.weight > 0

    @cached_property
    def everything(self) -> Words:
        """All rows as a packed set."""
        return pack(self.real)

    @cached_property
    def columns(self) -> NDArray[np.intp]:
        """What lies on each goal cell, row by row: goal cells x rows, for `take`."""
        return np.ascontiguousarray(self.row.T)

    @cached_property
    def sets(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """One row for each set of tokens that occurs, and for each row its set."""
        ordered = np.sort(self.row, axis=1)
        keys = np.zeros(len(ordered), np.int64)
        base = int(ordered.max(initial=0)) + 2
        for column in ordered.T:
            keys = keys * base + (column + 1)
        _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
        return first, inverse

    def some(self, number: int) -> Rows:
        """About `number` of listed rows, the same object each time; of sampled rows all."""
        if self.weight is not None:
            return self
        if number not in self._some:
            # A golden-ratio walk: even steps would meet the same token in the same cell.
            places = np.unique((np.arange(number) * 0.6180339887498949 % 1) * len(self.row))
            some = np.asfortranarray(self.row[places.astype(np.intp)])
            self._some[number] = Rows(some, None)
        return self._some[number]

    @cached_property
    def _some(self) -> dict[int, Rows]:
        return {}

    @cached_property
    def full(self) -> bool:
        """Whether no row has a gap."""
        return bool((self.row != NOBODY).all())

    @cached_property
    def word_weight(self) -> NDArray[np.float64] | None:
        """How many rows each row of a packed word stands for; None: each for itself."""
        # A word begins with a row; what fills it up comes after.
        return None if self.weight is None else self.weight[::64]

    @cached_property
    def size(self) -> float:
        """How many rows there are."""
        return float(len(self.row)) if self.weight is None else float(self.weight.sum())


def how_many(setting: Setting, *, full: bool) -> int:
    """How many rows can be played from the start."""
    free, tokens = setting.given.count(None), setting.movable.bit_count()
    if full:
        return perm(tokens, free)
    return sum(perm(tokens, k) for k in range(free + 1))


def rows_of(setting: Setting, order: Order, *, full: bool) -> Rows:
    """The rows that can be played from a start; only those without gaps if `full`.

    Otherwise those that fill the free goal cells one after the other in `order`: people leave
    no gap on the way, and a rule that means some is beyond what anybody teaches.
    """
    return listed(setting.given, setting.movable, None if full else order)


@lru_cache(maxsize=16)
def listed(given: tuple[int | None, ...], movable: Mask, order: Order | None) -> Rows:
    """Every row that fills all free cells, or with an `order` also every shorter one."""
    free = [k for k, token in enumerate(given) if token is None]
    tokens = np.array(list(bits(movable)), np.intp)
    start = np.array([NOBODY if token is None else token for token in given], np.intp)
    parts: list[Tokens] = []
    for count in (len(free),) if order is None else range(len(free), -1, -1):
        choices = _arrangements(len(tokens), count)
        cells = free if order is None else [k for k in order if k in free][:count]
        rows = np.repeat(start[None], len(choices), axis=0)
        rows[:, cells] = tokens[choices]
        parts.append(rows)
    return Rows(np.asfortranarray(np.concatenate(parts)), None)


def _arrangements(tokens: int, places: int) -> NDArray[np.intp]:
    """All ways to put different tokens on places, one a line."""
    found = np.zeros((1, 0), np.intp)
    for _ in range(places):
        longer = np.repeat(found, tokens, axis=0)
        new = np.tile(np.arange(tokens), len(found))
        fresh = (longer != new[:, None]).all(axis=1)
        found = np.column_stack([longer[fresh], new[fresh]])
    return found


@dataclass(frozen=True, eq=False)
class Context:
    """The rows that could have been played from a start, placed in one order."""

    setting: Setting
    order: Order
    rows: Rows

    def some(self, number: int) -> Context:
        """The same with only `number` of the rows, spread evenly; the same object each time."""
        if number not in self._some:
            self._some[number] = Context(self.setting, self.order, self.rows.some(number))
        return self._some[number]

    @cached_property
    def _some(self) -> dict[int, Context]:
        return {}

    @cached_property
    def plays(self) -> Plays:
        """The rows as plays."""
        return Plays.layouts(self.setting, self.rows.row, self.order)

    @cached_property
    def _some_of_each(self) -> Plays:
        """One play for each set of tokens."""
        first, _ = self.rows.sets
        return Plays.layouts(self.setting, self.rows.row[first], self.order)

    def place(self, line: Line, slot: int) -> NDArray[np.intp]:
        """What lies in a slot of the line, row by row; of full rows."""
        column: NDArray[np.intp] = self.rows.columns[
            slot if line is Line.ROW else self.order[slot]
        ]
        return column

    def truth(self, rule: Rule) -> Truth:
        """Which rows are right as far as `rule` says; nothing that only fills a word up."""
        return self._truth(rule) & self.rows.real

    def _truth(self, rule: Rule) -> Truth:
        """The same as the rule's own `mask`, but faster."""
        if not lines_of(rule):
            _, inverse = self.rows.sets
            return rule.mask(self._some_of_each).take(inverse)
        if self.rows.full and self._all_placed:
            if isinstance(rule, EachSlot):
                return self._by_slot(rule)
            if isinstance(rule, Pairwise):
                return self._by_pair(rule)
        return rule.mask(self.plays)

    @cached_property
    def _all_placed(self) -> bool:
        """Whether the time line has a slot for each goal cell."""
        return all(token is None for token in self.setting.given)

    def _by_slot(self, rule: EachSlot) -> Truth:
        right = np.ones(len(self.rows.row), np.bool_)
        for slot, mask in enumerate(rule.allowed(self.setting)):
            if self.setting.movable & ~mask:
                table = as_table(self.setting, mask, nobody=True)
                right &= table.take(self.place(rule.along(), slot))
        return right

    def _by_pair(self, rule: Pairwise) -> Truth:
        right: NDArray[np.intp] | None = None
        links = sorted(rule.links(self.setting), key=lambda link: abs(link[0] - link[1]))
        tokens = len(self.setting.deck.tokens) + 1
        for i, j, masks in links:
            flat = as_matrix(self.setting, masks).ravel()
            one, two = self.place(rule.along(), i), self.place(rule.along(), j)
            if right is not None:
                one, two = one.take(right), two.take(right)
            good = flat.take(one * tokens + two)
            # Only rows that are right so far are looked at again: few are, soon.
            right = np.flatnonzero(good) if right is None else right[good]
        truth = np.zeros(len(self.rows.row), np.bool_)
        truth[slice(None) if right is None else right] = True
        return truth

    def nearness(self, strength: float) -> NDArray[np.float64]:
        """How likely people who take what is near are to lay each row; not normalised."""
        start, goal = self.setting.start, self.setting.start.board.goal_cells
        far = np.array(
            [
                *(
                    [
                        abs(start.cells[t.id].row - to.row)
                        + abs(start.cells[t.id].column - to.column)
                        for to in goal
                    ]
                    for t in self.setting.deck.tokens
                ),
                [0] * len(goal),
            ],
            np.float64,
        )
        distance = sum(far[self.rows.row[:, k], k] for k in range(len(goal)))
        weight = np.exp2(-strength * np.asarray(distance, np.float64))
        return weight if self.rows.weight is None else weight * self.rows.weight


def looks_at_start(rule: Rule) -> bool:
    """Whether it matters to `rule` where tokens lie at the start."""
    if isinstance(rule, StraightUp | ModelRow | Cue):
        return True
    return any(_of_start(sight) for sight in sights_of(rule))


def _of_start(sight: str | TokenTest) -> bool:
    match sight:
        case str():
            return sight in (ORIGIN_ROW, ORIGIN_COLUMN)
        case Has(feature):
            return feature.attribute in (ORIGIN_ROW, ORIGIN_COLUMN)
        case Compared(attribute) | Among(attribute):
            return attribute in (ORIGIN_ROW, ORIGIN_COLUMN)
        case Not(of):
            return _of_start(of)
        case Either(first, second) | Both(first, second):
            return _of_start(first) or _of_start(second)
        case _:
            return False


def pack(truth: Truth) -> Words:
    """Sets of rows, one a line, as words."""
    packed = np.packbits(truth, axis=-1)
    padded = np.zeros((*packed.shape[:-1], -(-packed.shape[-1] // 8) * 8), np.uint8)
    padded[..., : packed.shape[-1]] = packed
    return padded.view(np.uint64)


def unpack(words: Words, rows: int) -> Truth:
    """The sets that `pack` packed."""
    return np.unpackbits(words.view(np.uint8), axis=-1, count=rows).astype(np.bool_)


def shared(one: Words, others: Words, weight: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """How many rows one set shares with each of others; `weight` is that of each word's rows."""
    bits_ = np.bitwise_count(one & others)
    if weight is None:
        return np.asarray(bits_.sum(axis=-1, dtype=np.int64), np.float64)
    return np.asarray(bits_ @ weight, np.float64)


def size_of(words: Words, rows: Rows) -> float:
    """How many rows a set holds, or about."""
    return float(shared(words, words[None], rows.word_weight)[0])


def follows(words: Sequence[Words], others: Sequence[Words]) -> bool:
    """Whether the rows of `words` are among those of `others` in each context."""
    return all(not (w & ~t).any() for w, t in zip(words, others, strict=True))


def row_number(rows: Rows, play: Play) -> int:
    """Where the row of `play` stands among all."""
    wanted = np.array([NOBODY if token is None else token for token in play.row], np.intp)
    return int(np.flatnonzero((rows.row == wanted).all(axis=1))[0])


def same_tokens(settings: Sequence[Setting]) -> bool:
    """Whether the same tokens of the same deck lie in storage at each start."""
    first = settings[0]
    return all(
        one.deck == first.deck and one.movable == first.movable and one.given == first.given
        for one in settings
    )
