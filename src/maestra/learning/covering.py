"""A smallest choice of sets that together hold everything: exact, until it takes too long.

Iterative deepening: for each size from the bound up, a depth-first search that branches on the
element that the fewest sets have, and gives up where the largest sets could not make up for what
is left. Sets are bits of an integer. Exponential at worst, hence the limit on nodes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Final

MAX_COMPARED: Final = 2_000
"""Sets beyond which none is left out for being part of another: that takes their square."""


@dataclass(frozen=True, slots=True)
class Cover:
    """A smallest choice, or how many sets it takes at least."""

    chosen: tuple[int, ...] | None
    """Which of the sets, as indices; None if the search gave up."""
    lower_bound: int


def union(sets: Iterable[int]) -> int:
    """Everything that is in some set."""
    whole = 0
    for one in sets:
        whole |= one
    return whole


def without_needless(sets: Sequence[int]) -> tuple[int, ...]:
    """Which sets, as indices, are left when from the last on those go that the others make up."""
    kept = list(range(len(sets)))
    for index in reversed(kept):
        others = [other for other in kept if other != index]
        if union(sets[other] for other in others) == union(sets):
            kept = others
    return tuple(kept)


def smallest_cover(
    sets: Sequence[int], max_nodes: int, at_least: int = 0, below: int | None = None
) -> Cover:
    """A smallest choice of `sets` with the same union as all of them.

    Args:
        sets: bit sets, not all empty unless there is none.
        max_nodes: steps of the search after which it gives up.
        at_least: a known lower bound.
        below: give up at this size, for a choice as small is known.
    """
    search = _Search(_not_part_of_another(sets), max_nodes)
    universe = union(sets)
    size = at_least
    while below is None or size < below:
        chosen = search.choose(universe, size)
        if chosen is not None:
            return Cover(tuple(sets.index(one) for one in chosen), size)
        if search.nodes_left <= 0:
            return Cover(None, size)
        size += 1
    return Cover(None, size)


@dataclass(slots=True)
class _Search:
    sets: list[int]
    nodes_left: int
    having: dict[int, list[int]] = field(init=False)
    """For each element (its bit) the sets that have it, elements with the fewest first."""

    def __post_init__(self) -> None:
        having: dict[int, list[int]] = {}
        for one in self.sets:
            rest = one
            while rest:
                element = rest & -rest
                having.setdefault(element, []).append(one)
                rest ^= element
        self.having = dict(sorted(having.items(), key=lambda item: len(item[1])))

    def choose(self, left: int, size: int) -> list[int] | None:
        """Up to `size` sets that have all of `left`; None if there are none or nodes run out."""
        if not left:
            return []
        self.nodes_left -= 1
        # The sets are sorted: the first is the largest.
        if self.nodes_left < 0 or size * self.sets[0].bit_count() < left.bit_count():
            return None
        rarest = next(element for element in self.having if element & left)
        for one in self.having[rarest]:
            chosen = self.choose(left & ~one, size - 1)
            if chosen is not None:
                return [one, *chosen]
        return None


def _not_part_of_another(sets: Sequence[int]) -> list[int]:
    """The different sets from the largest, without those that another holds."""
    ordered = sorted(set(sets), key=int.bit_count, reverse=True)
    if len(ordered) > MAX_COMPARED:
        return ordered
    kept: list[int] = []
    for one in ordered:
        if not any(one & ~other == 0 for other in kept):
            kept.append(one)
    return kept
