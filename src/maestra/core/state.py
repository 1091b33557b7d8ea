"""Which token lies where, and how a move changes it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TypeVar, cast

from maestra.core.board import Board, Cell
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.tokens import TokenId

_Key = TypeVar("_Key")
_Item = TypeVar("_Item")


@dataclass(frozen=True, slots=True)
class Move:
    """One pick-and-place: `token` from `origin` to `destination`."""

    token: TokenId
    origin: Cell
    destination: Cell


class IllegalMoveError(InvalidError):
    """A move that no board could make; a move against the rules is a verdict instead."""


@dataclass(frozen=True, slots=True)
class State:
    """Which token is on which cell; immutable and hashable.

    Raises:
        InvalidError: two tokens on a cell, or a cell that is not on the board.
    """

    board: Board
    cells: Mapping[TokenId, Cell]
    """Where each token lies."""
    tokens: Mapping[Cell, TokenId] = field(init=False, compare=False, repr=False)
    """What lies on each cell that is not empty."""

    def __post_init__(self) -> None:
        """Freeze the mapping and refuse a state that cannot be, naming every fault."""
        tokens: dict[Cell, TokenId] = {}
        faults: list[Fault] = []
        for token, cell in self.cells.items():
            if cell not in self.board:
                faults.append(off_board(str(token), cell, self.board))
            elif (other := tokens.setdefault(cell, token)) != token:
                expected = f"a cell of its own ({other} lies there)"
                faults.append(Fault(str(token), f"{_place(cell)} is taken", expected))
        refuse(faults)
        object.__setattr__(self, "cells", MappingProxyType(dict(self.cells)))
        object.__setattr__(self, "tokens", MappingProxyType(tokens))

    def __hash__(self) -> int:
        """By what lies where."""
        return hash(frozenset(self.cells.items()))

    def __reduce__(self) -> tuple[type["State"], tuple[Board, dict[TokenId, Cell]]]:
        """Pickled by its parts, for a frozen mapping cannot be."""
        return State, (self.board, dict(self.cells))

    def after(self, move: Move) -> "State":
        """The state once `move` is made.

        Raises:
            IllegalMoveError: the token is not there, or the destination is taken or off the
                board; with every fault.
        """
        token, destination = move.token, move.destination
        origin = self.cells.get(token)
        if origin != move.origin or destination in self.tokens or destination not in self.board:
            raise IllegalMoveError(self._faults_of(move))
        cells, tokens = _thaw(self.cells), _thaw(self.tokens)
        cells[token] = destination
        del tokens[move.origin]
        tokens[destination] = token
        return _trusted(self.board, cells, tokens)

    def _faults_of(self, move: Move) -> list[Fault]:
        faults: list[Fault] = []
        actual = self.cells.get(move.token)
        if actual is None:
            faults.append(Fault("token", f"unknown token {move.token}", "a token of the deck"))
        elif actual != move.origin:
            found = f"{move.token} is not on {_place(move.origin)}"
            faults.append(Fault("origin", found, f"{_place(actual)}, where it lies"))
        if move.destination not in self.board:
            faults.append(off_board("destination", move.destination, self.board))
        elif move.destination in self.tokens:
            found = f"{_place(move.destination)} is taken by {self.tokens[move.destination]}"
            faults.append(Fault("destination", found, "an empty cell"))
        return faults


def _trusted(board: Board, cells: dict[TokenId, Cell], tokens: dict[Cell, TokenId]) -> State:
    """A state known to be valid, unchecked: a lesson of 100,000 demonstrations makes 600,000."""
    state = object.__new__(State)
    object.__setattr__(state, "board", board)
    object.__setattr__(state, "cells", MappingProxyType(cells))
    object.__setattr__(state, "tokens", MappingProxyType(tokens))
    return state


def _thaw(mapping: Mapping[_Key, _Item]) -> dict[_Key, _Item]:
    """A copy; the proxy's own method copies hashes too, where dict() would compute each anew."""
    return cast("MappingProxyType[_Key, _Item]", mapping).copy()


def _place(cell: Cell) -> str:
    return f"[{cell.row}, {cell.column}]"


def off_board(where: str, cell: Cell, board: Board) -> Fault:
    """That `cell` is none of the board's."""
    expected = f"row 1 to {board.rows} and column 1 to {board.columns}"
    return Fault(where, f"{_place(cell)} is off the board", expected)
