"""In how many ways, and how, the moved tokens of a play can lie in storage before it begins.

Each moved token needs an origin among those its step allows, no two the same one: a system of
distinct representatives. Cells that the same steps allow are interchangeable, so ways are
counted over how many cells of each kind are left: one kind if every step allows any cell, and
as many kinds as steps if each has its own; never over sets of cells.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import perm
from typing import TypeAlias

from maestra.core.board import Cell

Left: TypeAlias = tuple[int, ...]
"""How many cells of each kind are not taken."""


@dataclass(frozen=True)
class Arrangements:
    """The ways to choose an origin for each step, and cells for the tokens that are never moved.

    There must be at least as many storage cells as tokens.
    """

    storage: tuple[Cell, ...]
    origins: tuple[frozenset[Cell] | None, ...]
    """For each step the cells its token may come from; None: any storage cell."""
    unmoved: int
    """How many tokens are never moved; they lie anywhere else in storage."""

    @cached_property
    def of_origins(self) -> int:
        """How many ways there are to choose the origins."""
        return self._ways(0, self._sizes, None)

    @cached_property
    def of_unmoved(self) -> int:
        """How many ways there are for the other tokens, whatever the origins are."""
        return perm(len(self.storage) - len(self.origins), self.unmoved)

    @cached_property
    def count(self) -> int:
        """How many ways there are for all tokens together."""
        return self.of_origins * self.of_unmoved

    @property
    def has_spare_cells(self) -> bool:
        """Whether some storage cell is empty at the start."""
        return len(self.storage) > len(self.origins) + self.unmoved

    def may_begin_at(self, step: int, cell: Cell) -> bool:
        """Whether the token of `step` (from 0) lies on `cell` in some arrangement."""
        return self._beginnings[step][self._kind[cell]]

    def may_be_spared(self, cell: Cell) -> bool:
        """Whether in some arrangement no moved token begins on `cell`."""
        return self._ways(0, self._without(self._sizes, self._kind[cell]), None) > 0

    def nth_origins(self, number: int) -> tuple[Cell, ...]:
        """The way to choose the origins that has this number, from 0 to below `of_origins`."""
        left, taken = self._sizes, list[Cell]()
        for step in range(len(self.origins)):
            cells = (c for c in self.storage if c not in taken and self._allows(step, c))
            cell = next(cells)
            # It ends: the number is below the sum of all cells' ways.
            while number >= (ways := self._ways_after(step, left, cell)):
                number -= ways
                cell = next(cells)
            left = self._without(left, self._kind[cell])
            taken.append(cell)
        return tuple(taken)

    def nth_unmoved(self, origins: tuple[Cell, ...], number: int) -> tuple[Cell, ...]:
        """Cells for the other tokens, by a number from 0 to below `of_unmoved`."""
        free = [cell for cell in self.storage if cell not in origins]
        chosen: list[Cell] = []
        for _ in range(self.unmoved):
            number, index = divmod(number, len(free))
            chosen.append(free.pop(index))
        return tuple(chosen)

    @cached_property
    def _beginnings(self) -> tuple[tuple[bool, ...], ...]:
        """For each step and kind of cell, whether the step's token may begin on such a cell."""
        return tuple(
            tuple(
                steps[step] and self._ways(0, self._without(self._sizes, kind), step) > 0
                for kind, steps in enumerate(self._kinds)
            )
            for step in range(len(self.origins))
        )

    def _allows(self, step: int, cell: Cell) -> bool:
        allowed = self.origins[step]
        return allowed is None or cell in allowed

    @cached_property
    def _signatures(self) -> Mapping[Cell, tuple[bool, ...]]:
        steps = range(len(self.origins))
        return {cell: tuple(self._allows(step, cell) for step in steps) for cell in self.storage}

    @cached_property
    def _kinds(self) -> tuple[tuple[bool, ...], ...]:
        return tuple(dict.fromkeys(self._signatures.values()))

    @cached_property
    def _kind(self) -> Mapping[Cell, int]:
        return {cell: self._kinds.index(steps) for cell, steps in self._signatures.items()}

    @cached_property
    def _sizes(self) -> Left:
        kinds = list(self._kind.values())
        return tuple(kinds.count(kind) for kind in range(len(self._kinds)))

    @staticmethod
    def _without(left: Left, kind: int) -> Left:
        return (*left[:kind], left[kind] - 1, *left[kind + 1 :])

    def _ways_after(self, step: int, left: Left, cell: Cell) -> int:
        """Ways to choose the origins of the steps after `step`, which chooses `cell`."""
        return self._ways(step + 1, self._without(left, self._kind[cell]), None)

    def _ways(self, step: int, left: Left, skipped: int | None) -> int:
        """Ways to choose the origins of `step` and later; `skipped` has chosen already."""
        if step == len(self.origins):
            return 1
        if step == skipped:
            return self._ways(step + 1, left, skipped)
        key = (step, left, skipped)
        if key not in self._memo:
            self._memo[key] = sum(
                left[kind] * self._ways(step + 1, self._without(left, kind), skipped)
                for kind, steps in enumerate(self._kinds)
                if steps[step] and left[kind]
            )
        return self._memo[key]

    @cached_property
    def _memo(self) -> dict[tuple[int, Left, int | None], int]:
        return {}
