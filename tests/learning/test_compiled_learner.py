from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.compiled_learner import CompiledLesson, learn_compiled, state
from maestra.learning.grounded import learn_grounded
from maestra.learning.planning import Limits, NoEngine, Outcome, PlanningProblem, Solved
from maestra.learning.plans import in_order_of_need
from maestra.rules.strips.literals import formula
from maestra.rules.strips.vocabulary import Level
from tests.learning.play_strategies import demonstrations, levels, selections

AMPLE = Limits(10.0, 1_000)


class WastefulPlanner:
    """Does everything that can be done, and counts its calls."""

    name = "wasteful"

    def __init__(self, *, prefers_whole: bool = True) -> None:
        self.prefers_whole = prefers_whole
        self.calls = 0

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        assert limits.time_s > 0
        self.calls += 1
        plan = in_order_of_need(problem.initial, problem.operators)
        return Solved(tuple(operator.name for operator in plan), self.name, 0.0)


class NoPlanner:
    """An engine that is not there."""

    name = "none"
    prefers_whole = True

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        return NoEngine(self.name, f"{problem.name}, {limits.memory_mb} MB")


@given(demonstrations(), levels, selections, st.booleans())
def test_the_exercise_is_the_one_that_direct_deletion_finds(
    shown: Sequence[Demonstration],
    level: Level,
    features: Sequence[str] | None,
    whole: bool,  # noqa: FBT001 - Hypothesis draws it by position
) -> None:
    lesson = learn_compiled(shown, WastefulPlanner(), AMPLE, level, features, whole=whole)
    assert isinstance(lesson, CompiledLesson)
    assert lesson.exercise == learn_grounded(shown, level, features)


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def two_plays(first: Token, second: Token) -> list[Demonstration]:
    board, deck = Board(2, 2), Deck((first, second))
    start = State(board, {first.id: cell(2, 1), second.id: cell(2, 2)})
    turned = State(board, {first.id: cell(2, 2), second.id: cell(2, 1)})
    return [
        Demonstration(
            deck,
            begin,
            (
                Move(first.id, begin.cells[first.id], cell(1, 1)),
                Move(second.id, begin.cells[second.id], cell(1, 2)),
            ),
        )
        for begin in (start, turned)
    ]


NUMBERS = two_plays(Token(TokenId("a"), (("value", 19),)), Token(TokenId("b"), (("value", 23),)))


def test_actions_and_literals_are_named_as_in_the_paper() -> None:
    statement = state(NUMBERS, features=["destination", "less-than"])
    assert list(statement.actions.values()) == ["move-v19-t1", "move-v23-t2"]
    assert set(statement.task.whole) == {"move-v19-t1", "move-v23-t2"}
    named = statement.literals[statement.actions[1, 2]]
    assert [
        formula(one, statement.vocabulary.shown[1]) for one in statement.vocabulary.literals
    ] == list(named)
    assert "to = l11" in named
    assert "∃v' (contains(l11, v') ∧ less-than(v', v23))" in named


def test_actions_that_look_alike_in_formulas_are_told_apart() -> None:
    alike = two_plays(
        Token(TokenId("a"), (("colour", "dark red"),)),
        Token(TokenId("b"), (("colour", "dark-red"),)),
    )
    swapped = [
        Demonstration(play.deck, play.start, (play.moves[1], play.moves[0])) for play in alike
    ]
    names = list(state([*alike, *swapped]).actions.values())
    assert names == [
        "move-dark-red-t1",
        "move-dark-red-t1'",
        "move-dark-red-t2",
        "move-dark-red-t2'",
    ]


@pytest.mark.parametrize(
    ("prefers_whole", "whole", "calls"),
    [(True, None, 1), (False, None, 2), (True, False, 2), (False, True, 1)],
)
def test_the_planner_chooses_how_many_problems_unless_told(
    *, prefers_whole: bool, whole: bool | None, calls: int
) -> None:
    planner = WastefulPlanner(prefers_whole=prefers_whole)
    lesson = learn_compiled(NUMBERS, planner, AMPLE, whole=whole)
    assert isinstance(lesson, CompiledLesson)
    assert planner.calls == lesson.report.problems == calls


def test_what_an_engine_cannot_do_is_handed_on() -> None:
    assert learn_compiled(NUMBERS, NoPlanner(), AMPLE) == NoEngine("none", "compiled, 1000 MB")
