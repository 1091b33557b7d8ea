"""What is said of a move that an exercise made of rules refuses."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.language import Language, reason, rule_sentences
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.forms.base import Direction
from maestra.rules.forms.counting import Total
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern, given_row
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.judging import Judge
from maestra.rules.pairs import same
from maestra.rules.position import Position
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, bits
from maestra.rules.token_tests import Comparison, Not, has
from maestra.rules.verdicts import JudgedMove
from tests.rules.exercise_strategies import ruled_exercises
from tests.rules.rule_strategies import plays_from, settings_with
from tests.rules.told_exercises import FULL, ODD, RISING, deck_of, in_storage, told

DECK = deck_of("value", (1, 2, 3, 4, 6, 8))
BOARD = Board(4, 3)


def judged(
    exercise: RuledExercise, *placed: tuple[int, int], row: int = 1, start: State | None = None
) -> JudgedMove:
    """The last of some moves, each a value and the goal cell it goes to, judged."""
    judge = Judge(exercise, exercise.deck)
    position = Position.begin(start or in_storage(DECK, BOARD))
    *before, last = [(TokenId(str(value)), column) for value, column in placed]
    for token, column in before:
        to = Cell(Row(1), Column(column))
        position = position.after(Move(token, position.now.cells[token], to))
    token, column = last
    move = Move(token, position.now.cells[token], Cell(Row(row), Column(column)))
    return JudgedMove(position.now, move, judge.verdict(position, move))


def goal(column: int) -> Cell:
    return Cell(Row(1), Column(column))


def why(exercise: RuledExercise, *placed: tuple[int, int], row: int = 1) -> str:
    return reason(judged(exercise, *placed, row=row), exercise, DECK, Language.EN)


def exercise(*rules: Rule) -> RuledExercise:
    return told(*rules, deck=DECK, board=BOARD)


@pytest.mark.parametrize(
    ("rules", "placed", "text"),
    [
        ((ODD,), [(2, 1)], "2 is not odd."),
        ((EveryToken(Not(has("odd", "value"))),), [(1, 1)], "1 is odd."),
        ((RISING,), [(3, 1), (2, 2)], "2 is not larger than 3 on its left."),
        ((RISING,), [(3, 3), (4, 1)], "3 is not larger than 4 on its left."),
        ((given_row("value", (3, 1, 2)),), [(1, 1)], "3 goes to row 1, column 1."),
        ((StraightUp(),), [(1, 2)], "1 stays in its own column."),
        ((FillOrder(Filling.LEFT_TO_RIGHT),), [(1, 2)], "The next token goes to row 1, column 1."),
        ((RISING, FULL), [(8, 1)], "Then the row can no longer come out right."),
        (
            (Ordered("value", Direction.RISING, line=Line.TIME),),
            [(3, 1), (2, 2)],
            "Each token must be larger than the one placed before it.",
        ),
        (
            (Pattern((has("odd", "value"),), repeat=True, line=Line.TIME),),
            [(2, 1)],
            "This token does not go here now.",
        ),
        ((from_row(1),), [(4, 1)], "Take the tokens only from row 2."),
        (
            (StraightUp(mirrored=True),),
            [(1, 2)],
            "Move each token to the opposite column, as in a mirror.",
        ),
        (
            (EachPair(Pairs.MIRRORED, same("value")),),
            [(1, 1), (2, 3)],
            "2 does not have the same number as 1 on its left.",
        ),
        (
            (Total("value", Comparison.AT_MOST, 5),),
            [(6, 1)],
            "The numbers of the row must make at most 5 together.",
        ),
    ],
)
def test_a_refusal_says_what_is_wrong_or_the_rule(
    rules: tuple[Rule, ...], placed: list[tuple[int, int]], text: str
) -> None:
    assert why(exercise(*rules), *placed) == text


def test_a_rule_too_long_to_be_heard_is_not_said() -> None:
    pattern = Pattern(tuple(has(name, "value") for name in ("even", "odd", "even")))
    said = why(exercise(pattern), (1, 1))
    assert said == "This token does not go here now."


def test_only_moves_to_the_goal_row_are_moves_of_the_exercise() -> None:
    assert why(exercise(ODD), (1, 3), row=4) == "The tokens go to the top row."


def test_an_allowed_move_needs_no_reason() -> None:
    assert why(exercise(ODD), (1, 1)) == ""


def test_after_the_end_there_is_nothing_to_move() -> None:
    one = judged(exercise(FULL), (1, 1), (2, 2), (3, 3), (4, 3), row=4)
    assert reason(one, exercise(FULL), DECK, Language.EN) == "The row is finished."


def test_what_is_not_known_is_to_be_asked() -> None:
    unknown = told(FULL, deck=DECK, board=BOARD, status=LearnStatus.OUTSIDE, safe=(ODD,))
    texts = {
        reason(judged(unknown, (2, 1)), unknown, DECK, language).split(":")[0]
        for language in Language
    }
    assert len(texts) == 3
    assert "I have not seen this yet" in texts


def test_what_lay_wrong_from_the_start_is_not_the_moved_tokens_fault() -> None:
    given = State(BOARD, {**in_storage(DECK, BOARD).cells, TokenId("2"): Cell(Row(1), Column(1))})
    one = judged(exercise(ODD), (3, 2), start=given)
    assert reason(one, exercise(ODD), DECK, Language.EN) == "Use only odd numbers."
    cells = {**in_storage(DECK, BOARD).cells, TokenId("4"): goal(1), TokenId("2"): goal(2)}
    one = judged(exercise(RISING), (8, 3), start=State(BOARD, cells))
    text = "Each token must be larger than the one on its left."
    assert reason(one, exercise(RISING), DECK, Language.EN) == text


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.data())
def test_every_refusal_has_a_short_reason_in_each_language(data: st.DataObject) -> None:
    taught = data.draw(ruled_exercises())
    deck: Deck = taught.deck
    setting = data.draw(settings_with(deck, taught.board.columns))
    play = data.draw(plays_from(setting, ways=100))
    if setting.start.board != taught.board or not play.room:
        return
    position = Position.begin(setting.start)
    for move in play.moves():
        position = position.after(move)
    token = data.draw(st.sampled_from(list(bits(play.left))))
    move = play.after(token, data.draw(st.sampled_from(play.free))).moves()[-1]
    one = JudgedMove(position.now, move, Judge(taught, deck).verdict(position, move))
    for language in Language:
        said = reason(one, taught, deck, language)
        assert bool(said) == one.is_refused
        assert len(said.split()) <= 12
        ids = [sentence.id for sentence in rule_sentences(taught, language)]
        assert ids == [rule.id for rule in taught.rules]
