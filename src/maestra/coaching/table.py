"""What lies on the board in truth, right or wrong, and what is in somebody's hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from maestra.core.board import Cell
from maestra.core.state import State
from maestra.core.tokens import TokenId


@dataclass(frozen=True, slots=True)
class Table:
    """What the board has told so far."""

    cells: Mapping[TokenId, Cell]
    """Where each token lies that is not in the air."""
    air: Mapping[TokenId, Cell] = field(default_factory=dict[TokenId, Cell])
    """Lifted tokens, each with the cell it left; the one lifted last comes last."""

    @classmethod
    def of(cls, state: State) -> Table:
        """Everything lies where `state` says."""
        return cls(dict(state.cells))

    @classmethod
    def seen(cls, cells: Mapping[TokenId, Cell], expected: State) -> Table:
        """What a board says that lies there; tokens of `expected` that are missing are in the air.

        Of two tokens on one cell the first is taken off it.
        """
        known = {cell: token for token, cell in cells.items() if token in expected.cells}
        lying = {token: cell for cell, token in known.items()}
        missing = {t: cell for t, cell in expected.cells.items() if t not in lying}
        return cls(lying, missing)

    def lifted(self, token: TokenId) -> Table:
        """Once `token` has left its cell."""
        cells = dict(self.cells)
        origin = cells.pop(token)
        return Table(cells, {**self.air, token: origin})

    def placed(self, token: TokenId, cell: Cell) -> Table:
        """Once `token` lies on `cell`; what we thought to lie there must be in the air."""
        table = self
        for other in [t for t, where in self.cells.items() if where == cell and t != token]:
            table = table.lifted(other)
        air = {t: origin for t, origin in table.air.items() if t != token}
        return Table({**table.cells, token: cell}, air)

    def astray(self, expected: State) -> tuple[TokenId, ...]:
        """The tokens that lie elsewhere than they should, or were just lifted from there."""
        should = expected.cells
        return tuple(
            token
            for token, cell in (*self.cells.items(), *self.air.items())
            if should[token] != cell
        )
