"""What a few simple rules allow, taken apart: each move's cells, and what may lie where.

The rules that a grounded exercise can be summarised in; an outline is all that the comparison
with preconditions needs to know of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from maestra.core.board import Board, Cell
from maestra.rules.right_rows import RightRows, TooManyRowsError
from maestra.rules.setting import Index, Mask


@dataclass(frozen=True)
class Outline:
    """All plays that fill `lengths` of the goal cells level by level, each as the fields say."""

    board: Board
    levels: tuple[tuple[Index, ...], ...]
    """The goal cells, from 0, in the order they are filled; those of one level in any order."""
    lengths: frozenset[int]
    """After how many moves a play may end."""
    domains: tuple[Mask, ...]
    """For each goal cell the tokens that may lie there."""
    by_step: Mapping[int, Mask] | None = None
    """For each step, from 1, the tokens that may come then; None: any."""
    before: tuple[Mask, ...] | None = None
    """For each token those that may lie on its left; only if every level is one cell."""
    storage_row: int | None = None
    """The row of the board that all tokens come from; None: any."""
    same_column: bool = False
    """Whether each token stays in its column."""

    @cached_property
    def level_of(self) -> tuple[int, ...]:
        """For each step, from 0, the level its cell is of."""
        return tuple(number for number, level in enumerate(self.levels) for _ in level)

    @cached_property
    def first_step_of(self) -> tuple[int, ...]:
        """For each level the step, from 0, that begins it."""
        return tuple(self.level_of.index(number) for number in range(len(self.levels)))

    def cells_at(self, step: int) -> tuple[Index, ...]:
        """The goal cells that may be filled at `step`, from 1."""
        return self.levels[self.level_of[step - 1]]

    def filled_before(self, step: int, going_to: Index, cell: Index) -> bool | None:
        """Whether `cell` is filled when the move of `step` goes to `going_to`; None: it may be."""
        if cell == going_to:
            return False
        level = self.level_of[step - 1]
        if cell not in self.levels[level]:
            return any(cell in earlier for earlier in self.levels[:level])
        done = step - 1 - self.first_step_of[level]
        if done == 0:
            return False
        return True if done == len(self.levels[level]) - 1 else None

    def origins(self, going_to: Index) -> frozenset[Cell]:
        """The storage cells that the token for a goal cell may come from."""
        return frozenset(
            cell
            for cell in self.board.storage_cells
            if self.storage_row in {None, cell.row}
            and not (self.same_column and cell.column != going_to + 1)
        )

    def rows(self, length: int) -> Rows:
        """The rows with `length` tokens.

        Raises:
            TooManyRowsError: what may come depends on the step, and the step not on the cell.
        """
        last = self.level_of[length - 1]
        cells = tuple(sorted(cell for level in self.levels[: last + 1] for cell in level))
        domains = [self.domains[cell] for cell in cells]
        if self.by_step is not None:
            for step in range(1, length + 1):
                (cell, *others) = self.cells_at(step)
                if others:
                    raise TooManyRowsError
                domains[cells.index(cell)] &= self.by_step[step]
        partial = len(cells) > length
        if partial and len(set(domains)) > 1:
            raise TooManyRowsError
        counted = tuple(domains[:length]) if partial else tuple(domains)
        places = {cell: place % len(counted) for place, cell in enumerate(cells)}
        return Rows(RightRows(counted, self.before), places)


@dataclass(frozen=True)
class Rows:
    """Rows by goal cell."""

    right: RightRows
    places: Mapping[Index, Index]

    def possible(self, cell: Index) -> Mask:
        """The tokens that lie on `cell` in some row."""
        return self.right.possible(self.places[cell])

    def together(self, cell: Index, token: Index, other: Index) -> Mask:
        """The tokens that lie on `other` in some row with `token` on `cell`."""
        return self.right.together(self.places[cell], token, self.places[other])
