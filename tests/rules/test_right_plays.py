from collections import Counter

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.right_plays import (
    Placement,
    Placements,
    RightPlays,
    TooManyPlaysError,
    plays_like,
)
from tests.rules.small_exercises import every_play, small_exercises


def deck_of(count: int) -> Deck:
    return Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in range(count)))


def from_left(placements: Placements) -> bool:
    return all(one.destination.column == step for step, one in enumerate(placements, start=1))


@given(small_exercises())
def test_the_numbered_plays_are_all_right_plays_each_once(plays: RightPlays) -> None:
    expected = Counter(every_play(plays))
    assume(sum(expected.values()) <= 2_000)
    assert Counter(plays.play(number) for number in range(plays.count)) == expected


@given(small_exercises())
def test_the_count_of_plays_is_that_of_listing_them(plays: RightPlays) -> None:
    assert plays.count == sum(1 for _ in every_play(plays))


def test_a_number_beyond_the_last_play_is_refused() -> None:
    plays = RightPlays(Board(2, 2), deck_of(2))
    with pytest.raises(IndexError, match="no play 8 of 8"):
        plays.play(8)
    with pytest.raises(IndexError):
        plays.play(-1)


def test_ten_tokens_from_left_to_right_have_30_240_sequences() -> None:
    plays = RightPlays(Board(), deck_of(10), may_begin=from_left)
    assert [len(group.tokens) for group in plays.groups] == [30_240]
    assert plays.count == 30_240 * 15 * 14 * 13 * 12 * 11 * 10 * 9 * 8 * 7 * 6


def test_a_play_ends_when_the_goal_row_is_full_if_nobody_says_otherwise() -> None:
    assert RightPlays(Board(2, 3), deck_of(3)).lengths == {3}


def test_more_tokens_than_storage_cells_are_refused() -> None:
    with pytest.raises(InvalidError, match="tokens: 3, expected at most 2 storage cells"):
        RightPlays(Board(2, 2), deck_of(3))


def test_more_sequences_than_can_be_kept_are_refused_not_cut() -> None:
    plays = RightPlays(Board(2, 2), deck_of(2), max_sequences=3)
    with pytest.raises(TooManyPlaysError, match="more than 3 sequences"):
        plays.groups  # noqa: B018 - enumerated when first asked for


def test_origins_that_cannot_all_be_kept_leave_no_play() -> None:
    corner = frozenset({Cell(Row(2), Column(1))})
    plays = RightPlays(Board(2, 2), deck_of(2), origins=lambda _step, _one: corner)
    assert plays.count == 0


def demonstration(moves: list[tuple[str, Cell, Cell]], start: dict[str, Cell]) -> Demonstration:
    state = State(Board(3, 2), {TokenId(token): cell for token, cell in start.items()})
    return Demonstration(deck_of(2), state, tuple(Move(TokenId(t), o, d) for t, o, d in moves))


def at(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def test_plays_like_a_shown_one_begin_anywhere_in_storage() -> None:
    start = {"t0": at(2, 1), "t1": at(3, 2)}
    shown = demonstration([("t0", at(2, 1), at(1, 2))], start)
    plays = plays_like([shown])
    assert plays.count == 4 * 3
    assert {play.moves[0].destination for play in map(plays.play, range(12))} == {at(1, 2)}
    assert shown.start in {plays.play(number).start for number in range(12)}


def test_a_play_that_moves_within_storage_has_no_plays_like_it() -> None:
    start = {"t0": at(2, 1), "t1": at(3, 2)}
    inside = demonstration([("t0", at(2, 1), at(3, 1))], start)
    twice = demonstration([("t0", at(2, 1), at(1, 1)), ("t0", at(1, 1), at(1, 2))], start)
    from_goal = demonstration([("t1", at(3, 2), at(1, 1))], {"t0": at(1, 2), "t1": at(3, 2)})
    assert plays_like([inside]).count == 0
    assert plays_like([twice]).count == 0
    assert plays_like([from_goal]).count == 0


@given(small_exercises(), st.data())
def test_each_play_keeps_the_origins_its_step_allows(
    plays: RightPlays, data: st.DataObject
) -> None:
    assume(plays.count)
    play = plays.play(data.draw(st.integers(0, plays.count - 1)))
    for step, move in enumerate(play.moves, start=1):
        allowed = plays.origins(step, Placement(move.token, move.destination))
        assert allowed is None or move.origin in allowed
