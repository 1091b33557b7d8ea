"""Choices that look random and are not: hashes of the numbers that name them.

The same numbers make the same choice, on every machine and in any order of asking.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, TypeVar

_MASK: Final = 2**64 - 1
_GOLDEN: Final = 0x9E3779B97F4A7C15
_ROUNDS: Final = ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB))
"""Shifts and factors of splitmix64."""

_Item = TypeVar("_Item")


def hashed(*numbers: int) -> int:
    """A number from 0 to below 2^64 that any change of `numbers` changes all over."""
    state = 0
    for number in numbers:
        state = (state + number % 2**64 + _GOLDEN) & _MASK
        for shift, factor in _ROUNDS:
            state = ((state ^ (state >> shift)) * factor) & _MASK
        state ^= state >> 31
    return state


def shuffled(items: Sequence[_Item], *numbers: int) -> list[_Item]:
    """The items in an order of their own for each `numbers`."""
    order = sorted(range(len(items)), key=lambda k: hashed(*numbers, k))
    return [items[k] for k in order]
