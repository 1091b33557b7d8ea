"""Counts, comparisons of counts, sums, and equations over places of the row."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction
from itertools import permutations
from math import prod
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from maestra.rules.fields import Amount, Name, Number, Place
from maestra.rules.forms.base import Form, demand, place_of
from maestra.rules.forms.numbers import (
    can_add_up,
    compare,
    largest_gain,
    least_gain,
    scale_of,
    whole_numbers,
)
from maestra.rules.forms.ranks import all_ranked, few_of_each
from maestra.rules.forms.values import value_numbers
from maestra.rules.plays import NOBODY, Plays, Truth, as_table
from maestra.rules.setting import Index, Line, Play, Rank, bits
from maestra.rules.token_tests import Comparison, TokenTest, passing

MAX_PLACES: Final = 4
"""In an equation: nobody says more in one sentence, and each one multiplies the cases."""


def _some(comparison: Comparison, least: int, most: int, number: int) -> bool:
    """Whether some whole number from `least` to `most` compares so to `number`."""
    if comparison is Comparison.EQUAL:
        return least <= number <= most
    return comparison.holds(least, number) or comparison.holds(most, number)


class Counted(Form):
    """An amount of the row compares so to a number; on the way it passes every whole number."""

    __slots__ = ()

    @abstractmethod
    def amount(self, play: Play) -> int:
        """The amount of the row as it is."""

    @abstractmethod
    def reach(self, play: Play, more: int = 0) -> tuple[int, int]:
        """The least and the most it can come to by `more` moves at least."""

    @abstractmethod
    def amounts(self, plays: Plays) -> NDArray[np.int64]:
        """The amounts of many rows."""

    @abstractmethod
    def against(self) -> tuple[Comparison, int]:
        """How the amount must compare, and to what."""

    def holds(self, play: Play) -> bool:
        """As the class says."""
        comparison, number = self.against()
        return comparison.holds(self.amount(play), number)

    def possible(self, play: Play) -> bool:
        """Whether an amount that can be reached compares so."""
        comparison, number = self.against()
        return _some(comparison, *self.reach(play), number)

    def possible_with(self, play: Play, more: int) -> bool:
        """As the base says."""
        comparison, number = self.against()
        return _some(comparison, *self.reach(play, more), number)

    def certain(self, play: Play) -> bool:
        """Whether every amount that can be reached compares so."""
        comparison, number = self.against()
        return not _some(comparison.opposite, *self.reach(play), number)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        comparison, number = self.against()
        return compare(comparison, self.amounts(plays), number)


@dataclass(frozen=True, slots=True)
class Count(Counted):
    """So many tokens of the row pass `test`: exactly two red, at least one vowel, three in all."""

    test: TokenTest
    comparison: Comparison
    number: Amount
    form: Literal["count"] = field(default="count", kw_only=True, repr=False)

    def against(self) -> tuple[Comparison, int]:
        """The number of the rule."""
        return self.comparison, self.number

    def amount(self, play: Play) -> int:
        """How many pass."""
        return play.count(passing(play.setting, self.test))

    def reach(self, play: Play, more: int = 0) -> tuple[int, int]:
        """As few as the others allow, or as many as there are and find room."""
        left = (play.left & passing(play.setting, self.test)).bit_count()
        others = play.left.bit_count() - left
        now = self.amount(play)
        return now + max(0, more - others), now + min(left, play.room)

    def amounts(self, plays: Plays) -> NDArray[np.int64]:
        """How many pass."""
        table = as_table(plays.setting, passing(plays.setting, self.test), nobody=False)
        return np.asarray(table[plays.row].sum(axis=1))


@dataclass(frozen=True, slots=True)
class CompareCounts(Counted):
    """The tokens that pass `first` are more, fewer or as many as those that pass `second`."""

    first: TokenTest
    comparison: Comparison
    second: TokenTest
    form: Literal["compare-counts"] = field(default="compare-counts", kw_only=True, repr=False)

    def against(self) -> tuple[Comparison, int]:
        """The difference is compared to nothing."""
        return self.comparison, 0

    def amount(self, play: Play) -> int:
        """How many more pass `first`."""
        one, two = (passing(play.setting, test) for test in (self.first, self.second))
        return play.count(one) - play.count(two)

    def reach(self, play: Play, more: int = 0) -> tuple[int, int]:
        """Only tokens that pass one of the two change it."""
        one, two = (passing(play.setting, test) & play.left for test in (self.first, self.second))
        now = self.amount(play)
        down, up = (two & ~one).bit_count(), (one & ~two).bit_count()
        neutral = play.left.bit_count() - down - up
        least = max(0, more - neutral - down) - min(down, play.room)
        most = min(up, play.room) - max(0, more - neutral - up)
        return now + least, now + most

    def amounts(self, plays: Plays) -> NDArray[np.int64]:
        """How many more pass `first`."""
        one, two = (
            as_table(plays.setting, passing(plays.setting, test), nobody=False)[plays.row]
            for test in (self.first, self.second)
        )
        return np.asarray(one.sum(axis=1) - two.sum(axis=1))


@dataclass(frozen=True, slots=True)
class Kinds(Counted):
    """The row shows so many different values of `attribute`: exactly two colours."""

    attribute: Name
    comparison: Comparison
    number: Amount
    form: Literal["kinds"] = field(default="kinds", kw_only=True, repr=False)

    def against(self) -> tuple[Comparison, int]:
        """The number of the rule."""
        return self.comparison, self.number

    def amount(self, play: Play) -> int:
        """How many different values."""
        values = play.setting.values(self.attribute)
        return len({values[token] for token in play.tokens} - {None})

    def reach(self, play: Play, more: int = 0) -> tuple[int, int]:  # noqa: ARG002 - they may repeat
        """None more, or each new value that is left, once."""
        values = play.setting.values(self.attribute)
        seen = {values[token] for token in play.tokens} | {None}
        new = {values[token] for token in bits(play.left)} - seen
        now = self.amount(play)
        return now, now + min(len(new), play.room)

    def amounts(self, plays: Plays) -> NDArray[np.int64]:
        """How many different values."""
        numbers = value_numbers(plays.setting, self.attribute)
        values = np.sort(numbers[plays.row], axis=1)
        new = (np.diff(values, axis=1, prepend=NOBODY) != 0) & (values >= 0)
        return np.asarray(new.sum(axis=1))


@dataclass(frozen=True, slots=True)
class Total(Form):
    """What the tokens of the row show adds up to a number that compares so to `number`.

    Every token of the row has a rank; the sum of none is 0.
    """

    attribute: Name
    comparison: Comparison
    number: Number
    form: Literal["total"] = field(default="total", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        total = total_of(play, self.attribute)
        return total is not None and self.comparison.holds(total, Fraction(self.number))

    def possible(self, play: Play) -> bool:
        """Whether a sum that can be reached compares so."""
        total = total_of(play, self.attribute)
        return total is not None and self._some(self.comparison, play, total)

    def possible_with(self, play: Play, more: int) -> bool:
        """As the base says."""
        total = total_of(play, self.attribute)
        return total is not None and self._some(self.comparison, play, total, more)

    def certain(self, play: Play) -> bool:
        """Whether every sum that can be reached compares so, and each token left has a rank."""
        total = total_of(play, self.attribute)
        ranks = play.setting.ranks(self.attribute)
        if total is None or (play.room and any(ranks[k] is None for k in bits(play.left))):
            return False
        return not self._some(self.comparison.opposite, play, total)

    def _some(self, comparison: Comparison, play: Play, total: Rank, more: int = 0) -> bool:
        left = ranks_left(play, self.attribute)
        wanted = Fraction(self.number) - total
        if len(left) < more:
            return False
        if comparison is Comparison.EQUAL:
            return can_add_up(left, range(more, play.room + 1), wanted)
        ends = least_gain(left, play.room, more), largest_gain(left, play.room, more)
        return any(comparison.holds(end, wanted) for end in ends)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        scale = scale_of(plays.setting, self.attribute, self.number)
        numbers = whole_numbers(plays.setting, self.attribute, scale)
        totals = numbers[plays.row].sum(axis=1)
        right = compare(self.comparison, totals, int(self.number * scale))
        return right & all_ranked(plays, Line.ROW, self.attribute)


def total_of(play: Play, attribute: str) -> Rank | None:
    """The sum over the row; None if a token has no rank."""
    known = play.setting.ranks(attribute)
    ranks = [known[token] for token in play.tokens]
    return None if None in ranks else sum(rank for rank in ranks if rank is not None)


def ranks_left(play: Play, attribute: str) -> list[Rank]:
    """The ranks of the tokens left in storage that have one."""
    known = play.setting.ranks(attribute)
    return [rank for token in bits(play.left) if (rank := known[token]) is not None]


class Operation(Enum):
    """How the numbers of one side of an equation go together."""

    SUM = "sum"
    PRODUCT = "product"


@dataclass(frozen=True, slots=True)
class Equation(Form):
    """The numbers at the places `left` make as much as those at `right` and `constant` together.

    Sums: x1 + x2 = x3 + constant; products: x1 · x2 = x3 · constant. All places are there and
    filled, and their tokens have ranks.
    """

    attribute: Name
    left: tuple[Place, ...]
    right: tuple[Place, ...] = ()
    constant: Number = 0
    operation: Operation = Operation.SUM
    form: Literal["equation"] = field(default="equation", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse an equation over no place or over too many."""
        demand(bool(self.left), "left", "no place", "at least one")
        places = len(self.left) + len(self.right)
        demand(places <= MAX_PLACES, "right", f"{places} places", f"{MAX_PLACES} in all at most")

    def holds(self, play: Play) -> bool:
        """As the class says."""
        places = self._places(play.setting.length)
        return places is not None and self._is_true(play, [play.row[place] for place in places])

    def possible(self, play: Play) -> bool:
        """Whether tokens that are left can fill the empty places so."""
        places = self._places(play.setting.length)
        if places is None:
            return False
        empty = list(dict.fromkeys(place for place in places if play.row[place] is None))
        if len(empty) > play.room:
            return False
        ranks = play.setting.ranks(self.attribute)
        left = few_of_each(bits(play.left), lambda token: ranks[token], len(empty))
        return any(
            self._is_true(play, [lies.get(place, play.row[place]) for place in places])
            for tokens in permutations(left, len(empty))
            for lies in (dict(zip(empty, tokens, strict=True)),)
        )

    def certain(self, play: Play) -> bool:
        """What is placed stays placed."""
        return self.holds(play)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        setting = plays.setting
        places = self._places(setting.length)
        if places is None:
            return np.zeros(len(plays), np.bool_)
        scale = scale_of(setting, self.attribute, self.constant)
        factors = len(places) + 1 if self.operation is Operation.PRODUCT else 1
        numbers = whole_numbers(setting, self.attribute, scale, 2 * factors)
        sides = numbers[plays.row[:, places]]
        left, right = sides[:, : len(self.left)], sides[:, len(self.left) :]
        constant = int(self.constant * scale)
        if self.operation is Operation.SUM:
            equal = left.sum(axis=1) == right.sum(axis=1) + constant
        else:
            # Each number carries the scale once: the side with fewer is multiplied by the rest.
            more = len(self.left) - len(self.right) - 1
            one, two = scale ** max(0, -more), constant * scale ** max(0, more)
            equal = left.prod(axis=1) * one == right.prod(axis=1, initial=1) * two
        ranks = setting.ranks(self.attribute)
        ranked = setting.mask(lambda k: ranks[k] is not None)
        table = as_table(setting, ranked, nobody=False)
        return np.asarray(equal, np.bool_) & table[plays.row[:, places]].all(axis=1)

    def _places(self, length: int) -> list[Index] | None:
        """The cells of `left` and `right`; None if the row lacks one."""
        places = [place_of(position, length) for position in (*self.left, *self.right)]
        cells = [place for place in places if place is not None]
        return cells if len(cells) == len(places) else None

    def _is_true(self, play: Play, tokens: list[Index | None]) -> bool:
        known = play.setting.ranks(self.attribute)
        ranks = [rank for k in tokens if k is not None and (rank := known[k]) is not None]
        if len(ranks) < len(tokens):
            return False
        left, right = ranks[: len(self.left)], ranks[len(self.left) :]
        constant = Fraction(self.constant)
        if self.operation is Operation.SUM:
            return sum(left) == sum(right) + constant
        return prod(left) == prod(right) * constant
