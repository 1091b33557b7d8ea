"""A board that exists in memory: moves are made by calls, and told as a real board tells them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from maestra.coaching.events import (
    BoardBack,
    BoardLost,
    Event,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)
from maestra.core.board import Cell
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import State
from maestra.core.tokens import TokenId


class SimulatedBoard:
    """Tokens on cells; refuses what no hand could do."""

    def __init__(self, start: State) -> None:
        """Lay the tokens as `start` says."""
        self._board = start.board
        self._cells = dict(start.cells)
        self._told: list[Event] = []
        self._is_open = True

    @property
    def cells(self) -> Mapping[TokenId, Cell]:
        """What lies where."""
        return dict(self._cells)

    def move(self, token: TokenId, destination: Cell) -> None:
        """Lift a token and put it on an empty cell, or back on its own.

        Raises:
            InvalidError: there is no such token, or the cell is taken or off the board.
        """
        if token not in self._cells:
            raise InvalidError([Fault("token", token, "a token that lies on the board")])
        on_it = next((t for t, cell in self._cells.items() if cell == destination), token)
        if destination not in self._board or on_it != token:
            raise InvalidError([Fault("destination", destination.name, "an empty cell")])
        self._tell(TokenLifted(token))
        if self._cells[token] == destination:
            self._tell(TokenPutBack(token))
        else:
            self._cells[token] = destination
            self._tell(TokenPlaced(token, destination))

    def lose(self) -> None:
        """Stop answering, until `find`."""
        self._tell(BoardLost())

    def find(self) -> None:
        """Answer again."""
        self._tell(BoardBack(dict(self._cells)))

    def events(self) -> Sequence[Event]:
        """What has happened since the last call, in order."""
        told, self._told = self._told, []
        return told

    def close(self) -> None:
        """Tell nothing more."""
        self._is_open = False
        self._told = []

    def _tell(self, event: Event) -> None:
        if self._is_open:
            self._told.append(event)
