from decimal import Decimal

import pytest
from hypothesis import given

from maestra.core.board import Cell, Column, Row
from maestra.core.state import Move
from maestra.core.tokens import Attributes
from maestra.rules.features import CellFeature, PairFeature, TokenFeature
from maestra.rules.registry import CELL_FEATURES, CellValue
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.literals import (
    Contains,
    Literal,
    Placed,
    Related,
    Shows,
    formula,
    symbol,
)
from tests.rules import by_definition
from tests.rules.ascending import ascending, exercise_of, paper_lesson, start
from tests.rules.lessons import Lesson, lessons

V19: Attributes = (("value", 19),)
V23: Attributes = (("value", 23),)


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def model_of(lesson: Lesson) -> tuple[ActionModel, by_definition.Preconditions]:
    """The model that the lesson teaches by definition, as bit sets and as sets."""
    words = lesson.vocabulary
    sets = by_definition.learn(words, lesson.demonstrations)
    return ActionModel(words, {action: words.bits(some) for action, some in sets.items()}), sets


# ------------------------------------------------------------------ the paper's Fig. 4


def test_the_first_action_of_the_papers_figure_4() -> None:
    model = exercise_of(paper_lesson()).model
    action = Action(V19, 1)
    assert action.name == "move-v19-t1"
    assert model.formulas(action) == ("to = l11", "contains(from, v19)", "empty(to)")
    assert model.effects(action) == (
        "¬contains(from, v19)",
        "contains(to, v19)",
        "empty(from)",
        "¬empty(to)",
    )


def test_the_second_action_of_the_papers_figure_4() -> None:
    model = exercise_of(paper_lesson()).model
    assert model.formulas(Action(V23, 2)) == (
        "to = l12",
        "contains(from, v23)",
        "empty(to)",
        "∃v' (contains(l11, v') ∧ less-than(v', v23))",
    )


def test_only_the_six_lowest_of_ten_may_go_first() -> None:
    model = exercise_of(paper_lesson()).model
    first = [dict(action.shown)["value"] for action in model.preconditions if action.step == 1]
    assert first == [19, 23, 32, 34, 36, 46]
    begin = start()
    index = model.vocabulary.index_of_token
    contents = {at: index[token] for token, at in begin.cells.items()}
    moves = list(model.applicable(1, contents))
    assert {int(begin.tokens[origin]) for origin, _ in moves} == set(first)
    assert {destination for _, destination in moves} == {cell(1, 1)}


def test_after_one_play_every_move_still_wants_its_own_origin() -> None:
    model = exercise_of([ascending((0, 1, 2, 3, 4))]).model
    assert model.formulas(Action(V19, 1))[:2] == ("to = l11", "from = l21")


def test_the_goal_row_is_told_if_no_cell_of_it_is() -> None:
    right_to_left = [ascending((0, 1, 2, 3, 4)), ascending((1, 0, 2, 3, 4), 7)]
    model = exercise_of(right_to_left).model
    learned = model.formulas(Action(V19, 1)), model.formulas(Action(V19, 2))
    assert learned[0][0] == "to = l11"
    both = ActionModel(
        model.vocabulary,
        {
            Action(V19, 1): model.preconditions[Action(V19, 1)]
            & model.preconditions[Action(V19, 2)]
        },
    )
    assert both.formulas(Action(V19, 1)) == ("contains(from, v19)", "empty(to)", "goal(to)")


# ------------------------------------------------------------------ applicability


@given(lessons())
def test_applicable_moves_are_those_whose_literals_all_hold(lesson: Lesson) -> None:
    model, sets = model_of(lesson)
    index = lesson.vocabulary.index_of_token
    for play in lesson.demonstrations:
        for made, state in enumerate(play.states()):
            contents = {at: index[token] for token, at in state.cells.items()}
            found = set(model.applicable(made + 1, contents))
            expected = by_definition.applicable(sets, lesson.deck, state, made)
            assert found == {(move.origin, move.destination) for move in expected}


@given(lessons())
def test_the_broken_literals_are_those_of_the_precondition_that_do_not_hold(
    lesson: Lesson,
) -> None:
    model, sets = model_of(lesson)
    index = lesson.vocabulary.index_of_token
    begin = lesson.demonstrations[0].start
    contents = {at: index[token] for token, at in begin.cells.items()}
    for action, literals in sets.items():
        assert set(model.precondition(action)) == literals
        for token, origin in begin.cells.items():
            if by_definition.shown_by(lesson.deck)[token] == action.shown:
                move = Move(token, origin, lesson.vocabulary.board.cells[0])
                broken = model.broken(action, contents, origin, move.destination)
                assert set(broken) == {
                    one
                    for one in literals
                    if not by_definition.holds(one, lesson.deck, begin, move)
                }


def test_an_action_that_is_not_in_the_model_has_no_precondition() -> None:
    model = exercise_of(paper_lesson()).model
    absent = Action((("value", 68),), 1)
    with pytest.raises(KeyError):
        model.precondition(absent)
    with pytest.raises(KeyError):
        model.broken(absent, {}, cell(2, 1), cell(1, 1))
    assert not list(model.applicable(6, {cell(2, 1): 0}))


def test_actions_are_found_by_step_and_what_is_shown() -> None:
    model = exercise_of(paper_lesson()).model
    shown = model.vocabulary.shown
    assert sorted(model.by_step) == [1, 2, 3, 4, 5]
    found = {
        Action(shown[moved], step): bits
        for step, actions in model.by_step.items()
        for moved, bits in actions.items()
    }
    assert found == model.preconditions


# ------------------------------------------------------------------ notation


@pytest.mark.parametrize(
    ("shown", "name"),
    [
        (V19, "v19"),
        ((("value", Decimal("2.5")),), "v2.5"),
        ((("letter", "C"),), "C"),
        ((("letter", " "),), " "),
        ((("colour", "dark red"),), "dark-red"),
        ((("size", 3),), "size3"),
        ((("colour", "red"), ("value", 3)), "red-v3"),
        ((), "token"),
    ],
)
def test_a_token_is_written_by_what_it_shows(shown: Attributes, name: str) -> None:
    assert symbol(shown) == name
    assert Action(shown, 2).name == f"move-{name}-t2"


@pytest.mark.parametrize(
    ("literal", "text"),
    [
        (
            Related(cell(1, 1), PairFeature("less-than", "value"), converse=False),
            "∃v' (contains(l11, v') ∧ less-than(v', v19))",
        ),
        (
            Related(cell(1, 12), PairFeature("less-than", "value"), converse=True),
            "∃v' (contains(l1-12, v') ∧ less-than(v19, v'))",
        ),
        (
            Shows(cell(1, 2), TokenFeature("odd", "value")),
            "∃v' (contains(l12, v') ∧ odd(v'))",
        ),
        (Contains(cell(3, 2), V23), "contains(l32, v23)"),
    ],
)
def test_a_literal_about_a_cell_is_written_as_in_the_paper(literal: Literal, text: str) -> None:
    assert formula(literal, V19) == text


PLACED: list[tuple[str, CellValue, str]] = [
    ("origin", cell(2, 3), "from = l23"),
    ("destination", cell(1, 4), "to = l14"),
    ("origin-row", 2, "row(from) = 2"),
    ("origin-column", 3, "column(from) = 3"),
    ("destination-column", 4, "column(to) = 4"),
    ("same-column", True, "same-column(from, to)"),
    ("from-storage", True, "storage(from)"),
    ("to-goal-row", True, "goal(to)"),
]


@pytest.mark.parametrize(("name", "value", "text"), PLACED)
def test_a_literal_about_the_moves_cells_is_written(
    name: str, value: CellValue, text: str
) -> None:
    assert formula(Placed(CellFeature(name), value), V19) == text


def test_every_feature_of_a_moves_cells_is_written() -> None:
    assert {name for name, _, _ in PLACED} == set(CELL_FEATURES)
