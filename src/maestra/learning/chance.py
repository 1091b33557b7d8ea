"""Choices that look random and are not: hashes of the numbers that name them.

The same numbers make the same choice, on every machine and in any order of asking.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from maestra.core.mixing import GOLDEN, MASK, mixed

_Item = TypeVar("_Item")


def hashed(*numbers: int) -> int:
    """A number from 0 to below 2^64 that any change of `numbers` changes all over."""
    state = 0
    for number in numbers:
        state = mixed((state + number + GOLDEN) & MASK)
    return state


def shuffled(items: Sequence[_Item], *numbers: int) -> list[_Item]:
    """The items in an order of their own for each `numbers`."""
    order = sorted(range(len(items)), key=lambda k: hashed(*numbers, k))
    return [items[k] for k in order]
