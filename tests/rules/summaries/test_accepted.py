from dataclasses import replace

import pytest

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import learn_grounded
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.right_plays import RightPlays
from maestra.rules.summaries.accepted import accepted_plays
from maestra.rules.summaries.summary import Step, Summary, summarise

SMALL = ("odd-ascending", "ascending", "descending", "curie", "letters")


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def summary_of(*demonstrations: Demonstration) -> Summary:
    return summarise(learn_grounded(demonstrations))


def accepted(summary: Summary, max_tried: int = 100_000) -> RightPlays:
    plays = accepted_plays(summary, max_tried)
    assert plays is not None
    return plays


def rows(plays: RightPlays) -> set[tuple[tuple[str, int], ...]]:
    """Every sequence as tokens and columns."""
    return {
        tuple((one.token, int(one.destination.column)) for one in plays.placements(group, row))
        for group in plays.groups
        for row in range(len(group.sequences))
    }


def tiny(*moves: tuple[str, Cell, Cell], rows: int = 3) -> Demonstration:
    """Moves of three numbers on a board of two goal cells."""
    deck = Deck(tuple(Token(TokenId(t), (("value", k),)) for k, t in enumerate("abc", start=1)))
    start = State(
        Board(rows, 2),
        {TokenId("a"): cell(2, 1), TokenId("b"): cell(2, 2), TokenId("c"): cell(3, 1)},
    )
    return Demonstration(deck, start, tuple(Move(TokenId(t), *where) for t, *where in moves))


@pytest.mark.parametrize("key", SMALL)
def test_what_the_rules_of_an_exercise_accept_is_what_is_right(key: str) -> None:
    exercise = PAPER_EXERCISES[key]
    right = exercise.plays()
    some = range(0, right.count, max(1, right.count // 200))
    shown = [right.play(number) for number in some]
    plays = accepted(summarise(learn_grounded(shown, features=exercise.features)))
    assert rows(plays) == rows(right)
    assert plays.count == right.count


def test_tokens_come_from_where_the_rules_say() -> None:
    up = tiny(("a", cell(2, 1), cell(1, 1)), ("b", cell(2, 2), cell(1, 2)))
    summary = summary_of(up)
    plays = accepted(summary)
    starts = {
        tuple((move.origin.row, move.origin.column) for move in plays.play(number).moves)
        for number in range(plays.count)
    }
    assert starts == {((2, 1), (2, 2))}, summary.rules


def test_steps_say_what_comes_when_no_rule_does() -> None:
    summary = summary_of(tiny(("a", cell(2, 1), cell(1, 1)), ("b", cell(2, 2), cell(1, 2))))
    shown = {token.id: token.attributes for token in summary.deck.tokens}
    steps = (
        Step(1, (shown[TokenId("b")],), cell(1, 2)),
        Step(2, (shown[TokenId("a")], shown[TokenId("c")]), None),
    )
    plays = accepted(replace(summary, rules=(), steps=steps))
    assert rows(plays) == {(("b", 2), ("a", 1)), (("b", 2), ("c", 1))}


def test_a_play_may_end_after_each_length() -> None:
    summary = summary_of(tiny(("a", cell(2, 1), cell(1, 1)), ("b", cell(2, 2), cell(1, 2))))
    plays = accepted(replace(summary, rules=(), steps=(), lengths=frozenset({1, 2})))
    assert {len(row) for row in rows(plays)} == {1, 2}
    assert len(rows(plays)) == 3 * 2 + 3 * 2 * 2


def test_moves_that_are_no_placements_are_not_listed() -> None:
    sideways = tiny(("a", cell(2, 1), cell(3, 2)))
    assert accepted_plays(summary_of(sideways)) is None


def test_tokens_that_have_no_room_in_storage_are_not_listed() -> None:
    deck = Deck(tuple(Token(TokenId(t), (("value", k),)) for k, t in enumerate("abc", start=1)))
    cells = {TokenId("a"): cell(2, 1), TokenId("b"): cell(2, 2), TokenId("c"): cell(1, 1)}
    move = Move(TokenId("b"), cell(2, 2), cell(1, 2))
    shown = Demonstration(deck, State(Board(2, 2), cells), (move,))
    assert accepted_plays(replace(summary_of(shown), places=True)) is None


def test_too_many_plays_are_not_listed() -> None:
    summary = replace(
        summary_of(tiny(("a", cell(2, 1), cell(1, 1)), ("b", cell(2, 2), cell(1, 2)))), rules=()
    )
    assert accepted_plays(summary, max_tried=5) is None
