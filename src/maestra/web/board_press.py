"""What a form of the board sends, and what it means: a token taken up, put down, or moved.

Without script each press sends the pressed cell, and the server keeps which token is held. With
script a whole move is sent at once: the token and the cell. Both come to the same outcomes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, TypeAlias

from fastapi import Form

from maestra.core.board import Cell, Column, Row
from maestra.core.state import Move, State
from maestra.core.tokens import TokenId


@dataclass(frozen=True, slots=True)
class Held:
    """This token is in the hand from now on."""

    token: TokenId


@dataclass(frozen=True, slots=True)
class Released:
    """The hand is empty again; nothing was moved."""


@dataclass(frozen=True, slots=True)
class Moved:
    """This move was made, and the hand is empty."""

    move: Move


@dataclass(frozen=True, slots=True)
class Nothing:
    """No board could do this: an empty cell pressed with an empty hand, or a taken one."""


Outcome: TypeAlias = Held | Released | Moved | Nothing

CellText = Annotated[str, Form(pattern=r"^\d{1,3},\d{1,3}$")]
"""The field `cell` of the form: ``2,3``."""
TokenText = Annotated[str, Form(max_length=300)]
"""The field `token` of the form: empty unless a whole move is sent at once."""


def cell_of(text: CellText) -> Cell:
    """The cell that the form names; perhaps none of the board's."""
    row, column = (int(part) for part in text.split(","))
    return Cell(Row(row), Column(column))


def outcome(state: State, held: TokenId | None, cell: Cell, token: str = "") -> Outcome:
    """What a press on `cell` does.

    Args:
        state: what lies where; a held token still lies on its cell.
        held: the token in the hand, if any.
        cell: the one pressed.
        token: the token to be moved there, if the browser sends whole moves.
    """
    if cell not in state.board:
        return Nothing()
    there = state.tokens.get(cell)
    carried = TokenId(token) if token else held
    if carried is None or carried not in state.cells:
        return Nothing() if there is None else Held(there)
    if there == carried:
        return Released()
    if there is None:
        return Moved(Move(carried, state.cells[carried], cell))
    # Another token in the same hand: people change their mind. A whole move onto a taken cell
    # was a drop that missed.
    return Nothing() if token else Held(there)
