"""Learned exercises as PDDL: foreign readers accept it, and its plans are right plays."""

import shutil
import subprocess
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import IllegalMoveError, Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import learn_grounded
from maestra.learning.model_pddl import ExercisePddl, exercise_pddl, plan_moves
from maestra.planners.fast_downward import find_binary
from maestra.rules.exercise import GroundedExercise
from maestra.rules.judging import Judge
from maestra.rules.strips.vocabulary import Level
from tests.strategies import demonstrations

# Neither library says its types in full.
PDDL: Any = import_module("pddl")
UNIFIED_PLANNING: Any = import_module("unified_planning.io")

VALUES = (19, 23, 32, 34, 36, 46, 51, 57, 62, 75)


def deck_of(values: Sequence[int | str], attribute: str = "value") -> Deck:
    return Deck(
        tuple(
            Token(TokenId(f"T{number}"), ((attribute, value),))
            for number, value in enumerate(values)
        )
    )


def play(
    deck: Deck, order: Sequence[int], shift: int = 0, board: Board | None = None
) -> Demonstration:
    """The tokens `order` to the goal row from left to right; `shift` rearranges storage."""
    board = board or Board()
    room = board.storage_cells
    start = State(
        board,
        {
            token.id: room[(number * 7 + shift) % len(room)]
            for number, token in enumerate(deck.tokens)
        },
    )
    moves = tuple(
        Move(deck.tokens[token].id, start.cells[deck.tokens[token].id], goal)
        for token, goal in zip(order, board.goal_cells, strict=False)
    )
    return Demonstration(deck, start, moves)


def ascending(level: Level = Level.A) -> GroundedExercise:
    deck = deck_of(VALUES)
    windows = [range(first, first + 5) for first in range(6)]
    shown = [play(deck, tuple(window), shift) for window in windows for shift in (0, 1)]
    return learn_grounded(shown, level)


def plan_by_fast_downward(texts: ExercisePddl, folder: Path) -> list[list[str]]:
    """The plan that Fast Downward finds for the two texts, read by its own translator."""
    binary = find_binary()
    assert binary is not None
    driver = next(p for p in binary.parents if p.name == "downward") / "fast-downward.py"
    folder.mkdir()
    (folder / "domain.pddl").write_text(texts.domain, encoding="utf-8")
    (folder / "problem.pddl").write_text(texts.problem, encoding="utf-8")
    files = ["--plan-file", "plan", "domain.pddl", "problem.pddl"]
    subprocess.run(
        [sys.executable, str(driver), *files, "--search", "lazy_greedy([ff()])"],
        check=True,
        capture_output=True,
        cwd=folder,
        timeout=60,
    )
    lines = (folder / "plan").read_text().splitlines()
    shutil.rmtree(folder)
    return [line.strip("()").split() for line in lines if not line.startswith(";")]


def test_an_action_stands_there_as_in_the_papers_figure() -> None:
    domain = exercise_pddl(ascending()).domain
    assert (
        "(:action move-v23-t2\n"
        "        :parameters (?from - cell ?to - cell)\n"
        "        :precondition (and (now t2) (contains ?from v23) (empty ?to) (storage ?from) "
        "(goal ?to) (= ?to l12) "
        "(exists (?other - token) (and (contains l11 ?other) (less-than-value ?other v23))))\n"
        "        :effect (and (not (contains ?from v23)) (contains ?to v23) (empty ?from) "
        "(not (empty ?to)) (not (now t2)) (now t3))"
    ) in domain


@pytest.mark.parametrize("level", Level)
def test_the_plan_of_a_foreign_planner_is_a_right_play(level: Level, tmp_path: Path) -> None:
    exercise = ascending(level)
    position = play(exercise.deck, (1, 3, 4, 6, 8)).until(1)
    if level is not Level.A:
        # These levels accept next to nothing but what was shown.
        position = play(exercise.deck, (0, 1, 2, 3, 4)).until(1)
    texts = exercise_pddl(exercise, position)
    plan = plan_by_fast_downward(texts, tmp_path / "plan")
    moves = plan_moves(texts, position.end, plan)
    assert [texts.actions[step[0]].step for step in plan] == [2, 3, 4, 5]
    judged = Judge(exercise, position.deck).judge(position.start, (*position.moves, *moves))
    assert not any(one.is_refused for one in judged)
    assert len(judged) == 5


@pytest.mark.parametrize("features", [["cells"], ["origin-row", "same-column", "destination"]])
def test_a_whole_play_is_planned_from_the_tokens_dealt_row_by_row(
    features: list[str], tmp_path: Path
) -> None:
    deck = deck_of("CURIEAGB", "letter")
    board = Board(3, 4)
    start = State(
        board,
        {token.id: cell for token, cell in zip(deck.tokens, board.storage_cells, strict=True)},
    )
    moves = tuple(
        Move(start.tokens[Cell(Row(2), Column(column))], Cell(Row(2), Column(column)), goal)
        for column, goal in enumerate(board.goal_cells, start=1)
    )
    exercise = learn_grounded([Demonstration(deck, start, moves)], features=features)
    texts = exercise_pddl(exercise)
    plan = plan_by_fast_downward(texts, tmp_path / "plan")
    assert plan_moves(texts, start, plan) == moves


def test_a_play_may_end_after_each_length_that_was_shown(tmp_path: Path) -> None:
    deck = deck_of(VALUES)
    exercise = learn_grounded([play(deck, (0, 1)), play(deck, (0, 1, 2))])
    texts = exercise_pddl(exercise, play(deck, (0, 1)).until(1))
    assert "(:goal (or (now t3) (now t4)))" in texts.problem
    assert ":disjunctive-preconditions" in texts.domain
    assert len(plan_by_fast_downward(texts, tmp_path / "plan")) in {1, 2}


@settings(max_examples=8)
@given(
    shown=st.lists(demonstrations(board=Board(3, 4)), min_size=1, max_size=1),
    level=st.sampled_from(Level),
)
def test_whatever_is_learned_is_read_and_written_alike_by_the_library(
    shown: list[Demonstration], level: Level, tmp_path_factory: pytest.TempPathFactory
) -> None:
    exercise = learn_grounded(shown, level)
    texts = exercise_pddl(exercise, shown[0].until(0))
    folder = tmp_path_factory.mktemp("texts")
    (folder / "domain.pddl").write_text(texts.domain, encoding="utf-8")
    (folder / "problem.pddl").write_text(texts.problem, encoding="utf-8")
    domain = PDDL.parse_domain(str(folder / "domain.pddl"))
    problem = PDDL.parse_problem(str(folder / "problem.pddl"))
    assert {action.name for action in domain.actions} == set(texts.actions)
    assert len(texts.actions) == len(exercise.model.preconditions)
    assert f"{domain}\n" == texts.domain
    assert f"{problem}\n" == texts.problem
    shutil.rmtree(folder)


@pytest.mark.parametrize("level", Level)
def test_unified_planning_reads_the_texts(level: Level) -> None:
    deck = deck_of(("Cup", "cup", "c up", "token", "T1", "now"), "name")
    texts = exercise_pddl(learn_grounded([play(deck, (0, 1, 3, 4, 5))], level))
    foreign = UNIFIED_PLANNING.PDDLReader().parse_problem_string(texts.domain, texts.problem)
    assert {action.name for action in foreign.actions} == set(texts.actions)


def test_tokens_whose_names_differ_only_in_case_or_signs_stay_apart() -> None:
    deck = deck_of(("Cup", "cup", "c up", "l11", "T1"), "name")
    exercise = learn_grounded([play(deck, (0, 1, 2, 3, 4))])
    texts = exercise_pddl(exercise)
    assert len(texts.actions) == 5
    assert len({*texts.cells, *(name.split("-t")[0] for name in texts.actions)}) == 20 + 5


def test_tokens_that_show_the_same_are_one_object(tmp_path: Path) -> None:
    deck = deck_of((5, 5, 7, 9), "value")
    exercise = learn_grounded(
        [play(deck, (0, 1, 2)), play(deck, (0, 1, 2), 1)], features=["cells"]
    )
    position = play(deck, (1, 0, 2), 2).until(0)
    texts = exercise_pddl(exercise, position)
    moves = plan_moves(texts, position.start, plan_by_fast_downward(texts, tmp_path / "plan"))
    assert [deck.by_id[move.token].value("value") for move in moves] == [5, 5, 7]


def test_a_position_on_another_board_is_refused() -> None:
    with pytest.raises(InvalidError, match="another board"):
        exercise_pddl(ascending(), play(deck_of(VALUES), (0, 1), board=Board(5, 5)))


def test_a_position_with_more_moves_than_a_play_is_refused() -> None:
    exercise = learn_grounded([play(deck_of(VALUES), (0, 1))])
    with pytest.raises(InvalidError, match="at most 2 moves"):
        exercise_pddl(exercise, play(exercise.deck, (0, 1, 2)))


def test_a_deck_without_room_in_storage_asks_for_a_play() -> None:
    board = Board(2, 3)
    deck = deck_of((1, 2, 3, 4))
    start = State(
        board, {token.id: cell for token, cell in zip(deck.tokens, board.cells[2:], strict=True)}
    )
    move = Move(deck.tokens[1].id, Cell(Row(2), Column(1)), Cell(Row(1), Column(1)))
    exercise = learn_grounded([Demonstration(deck, start, (move,))])
    with pytest.raises(InvalidError, match="4 tokens, expected a play, or at most 3"):
        exercise_pddl(exercise)


@pytest.mark.parametrize(
    ("step", "message"),
    [
        (("move-v19-t1", "l21"), "step 1: move-v19-t1 l21, expected an action"),
        (("move-v19-t1", "l21", "l99"), "step 1"),
        (("move-v19-t1", "l11", "l12"), "step 1"),
    ],
)
def test_a_plan_that_is_none_is_refused(step: tuple[str, ...], message: str) -> None:
    texts = exercise_pddl(ascending())
    with pytest.raises(InvalidError, match=message):
        plan_moves(texts, play(deck_of(VALUES), (0,)).start, [step])


def test_a_plan_that_no_board_could_follow_is_refused() -> None:
    texts = exercise_pddl(ascending())
    start = play(deck_of(VALUES), (0,)).start
    taken = sorted(cell.name for cell in start.tokens)
    with pytest.raises(IllegalMoveError):
        plan_moves(texts, start, [("move-v19-t1", taken[0], taken[1])])
