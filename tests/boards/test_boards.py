"""One contract for all boards, and what the simulated one refuses."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from maestra.boards.replay import ReplayBoard
from maestra.boards.simulated import SimulatedBoard
from maestra.coaching.events import (
    BoardBack,
    BoardLost,
    Event,
    TimedEvent,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import Board
from maestra.core.board import Board as Grid
from maestra.core.board import Cell, Column, Row
from maestra.core.faults import InvalidError
from maestra.core.state import State
from maestra.core.tokens import TokenId

CELLS = {TokenId("a"): Cell(Row(2), Column(1)), TokenId("b"): Cell(Row(2), Column(2))}
GOAL = Cell(Row(1), Column(1))


def simulated() -> Board:
    board = SimulatedBoard(State(Grid(), CELLS))
    board.move(TokenId("a"), GOAL)
    board.move(TokenId("b"), CELLS[TokenId("b")])
    board.lose()
    board.find()
    return board


TOLD: list[Event] = [
    TokenLifted(TokenId("a")),
    TokenPlaced(TokenId("a"), GOAL),
    TokenLifted(TokenId("b")),
    TokenPutBack(TokenId("b")),
    BoardLost(),
    BoardBack({**CELLS, TokenId("a"): GOAL}),
]


def replayed() -> Board:
    return ReplayBoard(TimedEvent(Milliseconds(0), what) for what in TOLD)


boards = pytest.mark.parametrize("make", [simulated, replayed])


def drained(board: Board) -> list[Event]:
    told: list[Event] = []
    while more := board.events():
        told += more
    return told


@boards
def test_each_event_is_told_once_and_in_order(make: Callable[[], Board]) -> None:
    board = make()
    assert drained(board) == TOLD
    assert board.events() == []


@boards
def test_a_closed_board_tells_nothing(make: Callable[[], Board]) -> None:
    board = make()
    board.close()
    assert list(board.events()) == []


def test_a_closed_simulation_can_still_be_touched_but_does_not_tell() -> None:
    board = simulated()
    assert isinstance(board, SimulatedBoard)
    board.close()
    board.lose()
    assert board.events() == []


@pytest.mark.parametrize(
    ("token", "cell"),
    [("z", GOAL), ("a", CELLS[TokenId("b")]), ("a", Cell(Row(9), Column(9)))],
)
def test_what_no_hand_could_do_is_refused(token: str, cell: Cell) -> None:
    board = SimulatedBoard(State(Grid(), CELLS))
    with pytest.raises(InvalidError):
        board.move(TokenId(token), cell)
    assert board.cells == CELLS
