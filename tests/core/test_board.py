import pickle

import pytest
from hypothesis import given

from maestra.core.board import MAX_SIDE, Board, Cell, Column, Row
from maestra.core.faults import Fault, InvalidError
from tests.strategies import boards


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def test_the_papers_board_is_the_default() -> None:
    board = Board()
    assert (board.rows, board.columns, board.goal_row) == (4, 5, 1)
    assert [one.name for one in board.goal_cells] == ["l11", "l12", "l13", "l14", "l15"]
    assert len(board.storage_cells) == 15


def test_a_wide_boards_cells_have_unambiguous_names() -> None:
    assert cell(1, 11).name == "l1-11"
    assert cell(11, 1).name == "l11-1"
    assert cell(9, 9).name == "l99"


@given(boards())
def test_goal_row_and_storage_rows_make_up_the_board(board: Board) -> None:
    assert sorted(board.goal_cells + board.storage_cells) == list(board.cells)
    assert {one.row for one in board.goal_cells} == {board.goal_row}
    assert len(set(board.cells)) == board.rows * board.columns


@given(boards())
def test_a_board_holds_its_cells_and_no_others(board: Board) -> None:
    assert all(one in board for one in board.cells)
    beside = [(0, 1), (1, 0), (board.rows + 1, 1), (1, board.columns + 1), (-1, -1)]
    assert not any(cell(*place) in board for place in beside)
    assert (1, 1) not in board


@given(boards())
def test_a_board_survives_pickling_and_is_equal_by_its_sides(board: Board) -> None:
    assert pickle.loads(pickle.dumps(board)) == board  # noqa: S301 - pickled in this line
    assert len({board, Board(board.rows, board.columns, board.goal_row)}) == 1


def test_every_fault_of_a_board_is_named_at_once() -> None:
    with pytest.raises(InvalidError) as caught:
        Board(0, MAX_SIDE + 1, Row(3))
    assert caught.value.faults == (
        Fault("rows", "0", "1 to 100"),
        Fault("columns", "101", "1 to 100"),
        Fault("goal_row", "3", "a row of the board, 1 to 0"),
    )


@pytest.mark.parametrize("goal_row", [-1, 0, 5])
def test_a_goal_row_off_the_board_is_refused(goal_row: int) -> None:
    with pytest.raises(InvalidError, match=r"goal_row: .*, expected a row of the board, 1 to 4"):
        Board(goal_row=Row(goal_row))
