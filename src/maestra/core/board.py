"""The grid that tokens lie on: a goal row, and storage rows."""

from dataclasses import dataclass
from functools import cached_property
from typing import Final, NewType

from maestra.core.faults import Fault, refuse

Row = NewType("Row", int)
Column = NewType("Column", int)

MAX_SIDE: Final = 100
"""Rows or columns at most: far above any table, low enough that a typing error is caught."""
_LAST_DIGIT: Final = 9


@dataclass(frozen=True, slots=True, order=True)
class Cell:
    """One place for a token; (1, 1) is the goal row's left end as the patient sits."""

    row: Row
    column: Column

    @property
    def name(self) -> str:
        """The paper's name, ``l12``; with a hyphen once a number has two digits, ``l1-12``."""
        wide = self.row > _LAST_DIGIT or self.column > _LAST_DIGIT
        return f"l{self.row}-{self.column}" if wide else f"l{self.row}{self.column}"


@dataclass(frozen=True)
class Board:
    """A grid of cells, one row of which is the goal row; the paper's own by default.

    Raises:
        InvalidError: a side outside 1..100, or a goal row that is not on the board.
    """

    rows: int = 4
    columns: int = 5
    goal_row: Row = Row(1)

    def __post_init__(self) -> None:
        """Refuse a board that cannot exist, naming every fault."""
        faults = [
            Fault(name, str(side), f"1 to {MAX_SIDE}")
            for name, side in (("rows", self.rows), ("columns", self.columns))
            if not 1 <= side <= MAX_SIDE
        ]
        if not 1 <= self.goal_row <= self.rows:
            expected = f"a row of the board, 1 to {self.rows}"
            faults.append(Fault("goal_row", str(self.goal_row), expected))
        refuse(faults)

    def __contains__(self, cell: object) -> bool:
        """Whether `cell` is one of this board's."""
        return (
            isinstance(cell, Cell)
            and 1 <= cell.row <= self.rows
            and 1 <= cell.column <= self.columns
        )

    @cached_property
    def cells(self) -> tuple[Cell, ...]:
        """All cells, row by row, each row from the left."""
        return tuple(
            Cell(Row(row), Column(column))
            for row in range(1, self.rows + 1)
            for column in range(1, self.columns + 1)
        )

    @cached_property
    def goal_cells(self) -> tuple[Cell, ...]:
        """The goal row's cells from left to right."""
        return tuple(cell for cell in self.cells if cell.row == self.goal_row)

    @cached_property
    def storage_cells(self) -> tuple[Cell, ...]:
        """All cells outside the goal row, row by row, each row from the left."""
        return tuple(cell for cell in self.cells if cell.row != self.goal_row)
