import pickle
from collections.abc import MutableMapping
from dataclasses import FrozenInstanceError
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import IllegalMoveError, Move, State
from maestra.core.tokens import TokenId
from tests.strategies import boards, cells, demonstrations

T1, T2, T3 = TokenId("T1"), TokenId("T2"), TokenId("T3")


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def state() -> State:
    return State(Board(), {T1: cell(2, 1), T2: cell(3, 4)})


def faults_of(move: Move) -> tuple[Fault, ...]:
    with pytest.raises(IllegalMoveError) as caught:
        state().after(move)
    return caught.value.faults


def test_two_tokens_on_a_cell_are_refused() -> None:
    with pytest.raises(InvalidError) as caught:
        State(Board(), {T1: cell(2, 1), T2: cell(2, 1)})
    fault = Fault("T2", "[2, 1] is taken", "a cell of its own (T1 lies there)")
    assert caught.value.faults == (fault,)


def test_every_fault_of_a_state_is_named_at_once() -> None:
    with pytest.raises(InvalidError) as caught:
        State(Board(), {T1: cell(5, 1), T2: cell(2, 6), T3: cell(0, 1)})
    expected = "row 1 to 4 and column 1 to 5"
    assert caught.value.faults == (
        Fault("T1", "[5, 1] is off the board", expected),
        Fault("T2", "[2, 6] is off the board", expected),
        Fault("T3", "[0, 1] is off the board", expected),
    )


def test_a_token_moved_from_where_it_is_not_is_refused() -> None:
    found = faults_of(Move(T1, cell(2, 2), cell(1, 1)))
    assert found == (Fault("origin", "T1 is not on [2, 2]", "[2, 1], where it lies"),)


def test_a_move_to_an_occupied_cell_is_refused() -> None:
    found = faults_of(Move(T1, cell(2, 1), cell(3, 4)))
    assert found == (Fault("destination", "[3, 4] is taken by T2", "an empty cell"),)


def test_a_move_to_where_the_token_lies_already_is_refused() -> None:
    found = faults_of(Move(T1, cell(2, 1), cell(2, 1)))
    assert found == (Fault("destination", "[2, 1] is taken by T1", "an empty cell"),)


def test_a_move_of_an_unknown_token_off_the_board_has_both_faults() -> None:
    assert faults_of(Move(T3, cell(2, 1), cell(1, 6))) == (
        Fault("token", "unknown token T3", "a token of the deck"),
        Fault("destination", "[1, 6] is off the board", "row 1 to 4 and column 1 to 5"),
    )


def test_a_state_cannot_be_changed() -> None:
    one = state()
    with pytest.raises(FrozenInstanceError):
        one.board = Board(3)  # type: ignore[misc]  # what mypy forbids must also fail at run time
    for frozen in (one.cells, one.tokens):
        with pytest.raises(TypeError):
            cast("MutableMapping[object, object]", frozen)[T3] = cell(4, 4)


def test_a_state_does_not_follow_the_mapping_it_was_built_from() -> None:
    places = {T1: cell(2, 1)}
    one = State(Board(), places)
    places[T1] = cell(4, 4)
    assert one.cells[T1] == cell(2, 1)


@given(demonstrations())
def test_the_state_after_a_move_is_the_one_built_anew(shown: Demonstration) -> None:
    for before, move, after in zip(
        shown.states(), shown.moves, list(shown.states())[1:], strict=False
    ):
        anew = State(before.board, {**before.cells, move.token: move.destination})
        assert after == anew
        assert hash(after) == hash(anew)
        assert after.tokens == anew.tokens == {at: token for token, at in after.cells.items()}
        assert before != after


@given(demonstrations())
def test_taking_all_moves_back_leads_to_the_start(shown: Demonstration) -> None:
    state = shown.end
    for move in reversed(shown.moves):
        state = state.after(Move(move.token, move.destination, move.origin))
    assert state == shown.start


@given(demonstrations(), st.data())
def test_a_move_is_refused_exactly_when_a_fault_is_there(
    shown: Demonstration, data: st.DataObject
) -> None:
    board = shown.board
    token = data.draw(st.sampled_from([*shown.start.cells, TokenId("\U0001f9e9unknown")]))
    around = cells(Board(board.rows, board.columns)) | st.just(cell(0, 0))
    move = Move(token, data.draw(around), data.draw(around))
    possible = (
        shown.start.cells.get(token) == move.origin
        and move.destination in board
        and move.destination not in shown.start.tokens
    )
    if possible:
        assert shown.start.after(move).cells[token] == move.destination
    else:
        with pytest.raises(IllegalMoveError) as caught:
            shown.start.after(move)
        assert caught.value.faults


@given(demonstrations())
def test_a_state_survives_pickling(shown: Demonstration) -> None:
    twin = pickle.loads(pickle.dumps(shown.end))  # noqa: S301 - pickled in this line
    assert twin == shown.end
    assert twin.tokens == shown.end.tokens


@given(boards())
def test_states_on_different_boards_differ(board: Board) -> None:
    other = Board(board.rows + 1, board.columns, board.goal_row)
    assert State(board, {T1: cell(1, 1)}) != State(other, {T1: cell(1, 1)})
