"""Exact sums: of the tokens of a row, of many rows at once, and of what can still be reached."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from maestra.rules.fields import Number
from maestra.rules.plays import Truth
from maestra.rules.setting import Rank, Setting
from maestra.rules.token_tests import Comparison

Whole: TypeAlias = NDArray[Any]
"""Whole numbers: 64 bits where they are enough, else Python's own."""

BIT_SET_LIMIT: Final = 2**22
"""Bits in a set of sums; half a megabyte. Beyond it the sums are listed."""


def compare(comparison: Comparison, amounts: Whole, number: int) -> Truth:
    """`Comparison.holds` for many amounts."""
    return np.asarray(_COMPARES[comparison](amounts, number), np.bool_)


_COMPARES: Final[dict[Comparison, Callable[[Whole, int], Whole]]] = {
    Comparison.LESS: lambda amounts, number: amounts < number,
    Comparison.AT_MOST: lambda amounts, number: amounts <= number,
    Comparison.EQUAL: lambda amounts, number: amounts == number,
    Comparison.DIFFERENT: lambda amounts, number: amounts != number,
    Comparison.AT_LEAST: lambda amounts, number: amounts >= number,
    Comparison.MORE: lambda amounts, number: amounts > number,
}


def scale_of(setting: Setting, attribute: str, *others: Number) -> int:
    """What to multiply by to make all ranks of `attribute` and `others` whole."""
    ranks = [rank for rank in setting.ranks(attribute) if rank is not None]
    return lcm(*(Fraction(number).denominator for number in (*ranks, *others)))


def whole_numbers(setting: Setting, attribute: str, scale: int, degree: int = 1) -> Whole:
    """Each token's rank times `scale`; 0 where there is none.

    Args:
        setting: the start.
        attribute: what the tokens show.
        scale: makes all of them whole.
        degree: how many will be multiplied with each other; decides whether 64 bits will do.
    """
    ranks = setting.ranks(attribute)
    numbers = [0 if rank is None else int(rank * scale) for rank in ranks]
    largest = max(map(abs, numbers), default=0) * max(setting.length, scale)
    small = largest**degree < np.iinfo(np.int64).max
    return np.array([*numbers, 0], np.int64 if small else np.object_)


def least_gain(ranks: Iterable[Rank], room: int, more: int = 0) -> Rank:
    """The least that `more` to `room` of `ranks` add up to; 0 for none."""
    rising = sorted(ranks)
    return sum(rising[:more]) + sum(rank for rank in rising[more:room] if rank < 0)


def largest_gain(ranks: Iterable[Rank], room: int, more: int = 0) -> Rank:
    """The most that `more` to `room` of `ranks` add up to; 0 for none."""
    return -least_gain([-rank for rank in ranks], room, more)


def can_add_up(ranks: Sequence[Rank], counts: range, wanted: Rank) -> bool:
    """Whether some of `ranks`, as many as `counts` allows, add up to `wanted`.

    At most ranks x counts shifts of a bit set.
    """
    if wanted == 0 and 0 in counts:
        return True
    more, room = counts.start, min(counts.stop - 1, len(ranks))
    ends = least_gain(ranks, room, more), largest_gain(ranks, room, more)
    if not room or not ends[0] <= wanted <= ends[1]:
        return False
    scale = lcm(*(Fraction(number).denominator for number in (*ranks, wanted)))
    numbers, target = [int(rank * scale) for rank in ranks], int(wanted * scale)
    least = min(numbers)
    if room * (max(numbers) - least) > BIT_SET_LIMIT:
        return _is_listed(numbers, range(more, room + 1), target)
    # reached[c]: the sums of c numbers, each number less `least`, so that no bit is negative.
    reached = [1] + [0] * room
    for number in numbers:
        for count in range(room, 0, -1):
            reached[count] |= reached[count - 1] << (number - least)
    return any(
        (bit := target - count * least) >= 0 and reached[count] >> bit & 1
        for count in range(more, room + 1)
    )


def _is_listed(numbers: list[int], counts: range, target: int) -> bool:
    room = counts.stop - 1
    reached: list[set[int]] = [{0}, *(set[int]() for _ in range(room))]
    for number in numbers:
        for count in range(room, 0, -1):
            reached[count] |= {total + number for total in reached[count - 1]}
    return any(target in reached[count] for count in counts)
