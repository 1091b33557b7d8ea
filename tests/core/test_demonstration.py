import pickle
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import MAX_MOVES, MAX_TIME_MS, Demonstration, Source
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from tests.strategies import demonstrations

T1, T2, T3 = TokenId("T1"), TokenId("T2"), TokenId("T3")
DECK = Deck((Token(T1, (("value", 19),)), Token(T2, (("value", 23),))))


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


START = State(Board(), {T1: cell(2, 1), T2: cell(3, 4)})
MOVES = (Move(T1, cell(2, 1), cell(1, 1)), Move(T2, cell(3, 4), cell(1, 2)))


def faults_of(
    start: State = START,
    moves: tuple[Move, ...] = MOVES,
    *,
    label: str | None = None,
    times_ms: tuple[int, ...] | None = None,
    source: str | None = None,
) -> tuple[Fault, ...]:
    with pytest.raises(InvalidError) as caught:
        Demonstration(DECK, start, moves, label, times_ms, cast("Source", source))
    return caught.value.faults


def test_a_demonstration_has_one_state_more_than_moves() -> None:
    shown = Demonstration(DECK, START, MOVES)
    first, second, third = shown.states()
    assert first == START
    assert second.cells == {T1: cell(1, 1), T2: cell(3, 4)}
    assert third.cells == {T1: cell(1, 1), T2: cell(1, 2)}
    assert shown.end == third
    assert shown.board == Board()


def test_a_start_that_lacks_a_token_or_has_one_more_is_refused() -> None:
    assert faults_of(State(Board(), {T3: cell(2, 1), T2: cell(3, 4)}), ()) == (
        Fault("start.T1", "missing", "a cell for each token"),
        Fault("start.T3", "unknown token", "a token of the deck"),
    )


def test_every_impossible_move_is_named_with_its_place() -> None:
    moves = (
        Move(T3, cell(2, 1), cell(1, 1)),
        MOVES[0],
        Move(T2, cell(2, 2), cell(1, 1)),
    )
    assert faults_of(moves=moves) == (
        Fault("moves[0].token", "unknown token T3", "a token of the deck"),
        Fault("moves[2].origin", "T2 is not on [2, 2]", "[3, 4], where it lies"),
        Fault("moves[2].destination", "[1, 1] is taken by T1", "an empty cell"),
    )


def test_more_moves_than_a_working_day_has_are_refused() -> None:
    there, back = MOVES[0], Move(T1, cell(1, 1), cell(2, 1))
    moves = (there, back) * (MAX_MOVES // 2)
    assert len(Demonstration(DECK, START, moves).moves) == MAX_MOVES
    assert faults_of(moves=(*moves, there)) == (Fault("moves", "10001 moves", "at most 10000"),)


def test_times_that_do_not_fit_the_moves_are_refused() -> None:
    fault = Fault("times_ms", "length 1", "2, one for each move")
    assert faults_of(times_ms=(5,)) == (fault,)


@pytest.mark.parametrize("times_ms", [(2, 1), (-1, 1), (0, MAX_TIME_MS + 1)])
def test_times_that_run_backwards_or_too_far_are_refused(times_ms: tuple[int, int]) -> None:
    expected = "times that rise from 0, up to 10^15"
    found = "times that run backwards or too far"
    assert faults_of(times_ms=times_ms) == (Fault("times_ms", found, expected),)
    Demonstration(DECK, START, MOVES, times_ms=(0, MAX_TIME_MS))


def test_every_fault_of_a_demonstration_is_named_at_once() -> None:
    found = faults_of(moves=MOVES[1:] * 2, label="\x1b[31m", times_ms=(), source="dream")
    assert [fault.where for fault in found] == [
        "moves[1].origin",
        "moves[1].destination",
        "times_ms",
        "label",
        "source",
    ]
    assert found[-1] == Fault("source", '"dream"', "one of board, file, simulated")


@given(demonstrations(), st.data())
def test_a_position_ends_in_the_state_after_so_many_moves(
    shown: Demonstration, data: st.DataObject
) -> None:
    count = data.draw(st.integers(0, len(shown.moves)))
    position = shown.until(count)
    assert position.end == list(shown.states())[count]
    assert position.moves == shown.moves[:count]
    assert (position.times_ms is None) == (shown.times_ms is None)
    assert (position.deck, position.label, position.source) == (
        shown.deck,
        shown.label,
        shown.source,
    )


@pytest.mark.parametrize("count", [-1, 3])
def test_a_position_beyond_the_moves_is_refused(count: int) -> None:
    with pytest.raises(ValueError, match=f"{count} of 2 moves"):
        Demonstration(DECK, START, MOVES).until(count)


@given(demonstrations())
def test_a_demonstration_is_hashable_and_survives_pickling(shown: Demonstration) -> None:
    twin = pickle.loads(pickle.dumps(shown))  # noqa: S301 - pickled in this line
    assert len({shown, twin}) == 1
