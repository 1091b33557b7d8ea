import pytest

from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import LETTER_DECK, NUMBER_DECK, NUMBERS, PAPER_EXERCISES


@pytest.mark.parametrize(
    ("key", "sequences", "actions"),
    [
        ("odd-ascending", 1, 5),
        ("ascending", 252, 30),
        ("descending", 252, 30),
        ("first-row", 30_240, 50),
        ("curie", 1, 5),
        ("letters", 252, 30),
    ],
)
def test_each_exercise_has_as_many_right_sequences_and_actions(
    key: str, sequences: int, actions: int
) -> None:
    exercise = PAPER_EXERCISES[key]
    assert sum(len(group.tokens) for group in exercise.plays().groups) == sequences
    truth = ground_truth(exercise.plays(), exercise.vocabulary())
    assert len(truth.preconditions) == actions


def test_the_exercises_are_the_papers_six_in_its_order() -> None:
    assert [one.number for one in PAPER_EXERCISES.values()] == ["i", "ii", "iii", "iv", "v", "vi"]
    assert [one.fewest for one in PAPER_EXERCISES.values()] == [2, 12, 12, 10, 2, 12]


def test_just_five_of_the_ten_numbers_are_odd() -> None:
    assert sum(number % 2 for number in NUMBERS) == 5
    assert len(NUMBER_DECK.tokens) == len(LETTER_DECK.tokens) == 10


def test_the_preconditions_of_ascending_are_those_of_the_papers_figure_4() -> None:
    exercise = PAPER_EXERCISES["ascending"]
    truth = ground_truth(exercise.plays(), exercise.vocabulary())
    formulas = {action.name: truth.formulas(action) for action in truth.preconditions}
    assert formulas["move-v19-t1"] == ("to = l11", "contains(from, v19)", "empty(to)")
    assert formulas["move-v23-t2"] == (
        "to = l12",
        "contains(from, v23)",
        "empty(to)",
        "∃v' (contains(l11, v') ∧ less-than(v', v23))",
    )


def test_the_origin_is_part_of_the_rule_in_the_first_row_exercise_alone() -> None:
    exercise = PAPER_EXERCISES["first-row"]
    truth = ground_truth(exercise.plays(), exercise.vocabulary())
    action = next(iter(truth.preconditions))
    assert truth.formulas(action) == (
        "to = l11",
        "from = l21",
        "contains(from, v19)",
        "empty(to)",
    )


@pytest.mark.parametrize("key", PAPER_EXERCISES)
def test_every_play_fills_the_goal_row_from_left_to_right(key: str) -> None:
    plays = PAPER_EXERCISES[key].plays()
    for play in (plays.play(0), plays.play(plays.count - 1)):
        assert [move.destination.column for move in play.moves] == [1, 2, 3, 4, 5]
