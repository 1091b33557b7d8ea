"""What a few simple rules allow, taken apart: each move's cells, and what may lie where.

The rules that a grounded exercise can be summarised in; an outline is all that the comparison
with preconditions needs to know of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from maestra.core.board import Board, Cell
from maestra.rules.setting import Index, Mask
from maestra.rules.summaries.right_rows import RightRows, UndecidedError


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
            UndecidedError: which goal cells are left empty decides which tokens may come.
        """
        if self.by_step is not None:
            domains = [self.by_step[step] for step in range(1, length + 1)]
            return Rows(self, RightRows(tuple(domains)), {})
        last = self.level_of[length - 1]
        cells = sorted(cell for level in self.levels[: last + 1] for cell in level)
        domains = [self.domains[cell] for cell in cells]
        if len(cells) > length:
            if len(set(domains)) > 1:
                raise UndecidedError
            domains = domains[:length]
        places = {cell: place % length for place, cell in enumerate(cells)}
        return Rows(self, RightRows(tuple(domains), self.before), places)


@dataclass(frozen=True)
class Rows:
    """What lies where in right rows: each place of `right` a goal cell, or else a step."""

    outline: Outline
    right: RightRows
    places: Mapping[Index, Index]
    """For each goal cell its place; empty if the places are steps."""

    def possible(self, step: int, cell: Index) -> Mask:
        """The tokens that some right play places on `cell` at `step`."""
        return self.right.possible(self.places[cell] if self.places else step - 1)

    def together(self, move: RightMove, other: Index, *, earlier: bool) -> Mask:
        """The tokens that lie on `other` in the end of some right play with `move` in it.

        `earlier`: those that were placed there before the move; else those placed after it.
        """
        if self.places:
            places = self.places
            return self.right.together(places[move.cell], move.token, places[other])
        level = next(k for k, cells in enumerate(self.outline.levels) if other in cells)
        tokens = 0
        for step, other_level in enumerate(self.outline.level_of[: len(self.right.domains)], 1):
            if other_level == level and step != move.step and (step < move.step) == earlier:
                tokens |= self.right.together(move.step - 1, move.token, step - 1)
        return tokens


@dataclass(frozen=True, slots=True)
class RightMove:
    """A move of some right play."""

    step: int
    """From 1."""
    cell: Index
    """The goal cell it fills."""
    token: Index
