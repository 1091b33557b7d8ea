from math import comb

import pytest

from maestra.core.faults import InvalidError
from maestra.experiments.curve import (
    Choice,
    CurveRun,
    CurveSettings,
    actions_that_occur,
    chosen_demonstrations,
    curve_points,
    run_curve,
)
from maestra.learning.grounded import learn_grounded
from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.strips.vocabulary import Level


def ascending(demonstrations: int, level: Level = Level.A) -> CurveSettings:
    return CurveSettings("ascending", level, demonstrations, seed=7)


def expected_exact(demonstrations: int) -> float:
    """Actions of `ascending` that so many random plays teach exactly, on average, vocabulary A.

    An action that a play shows with probability p is exact once it was seen from two of the 15
    storage cells: not if it never was, nor if it came from the same cell each time.
    """
    total = 0.0
    for rank in range(1, 11):
        for step in range(1, 6):
            p = comb(rank - 1, step - 1) * comb(10 - rank, 5 - step) / comb(10, 5)
            if p:
                never = (1 - p) ** demonstrations
                total += 1 - never - 15 * ((1 - p + p / 15) ** demonstrations - never)
    return total


def test_random_demonstrations_teach_as_many_actions_as_chance_lets_expect() -> None:
    runs = [run_curve(ascending(100), Choice.RANDOM, number) for number in range(1, 31)]
    for shown in (12, 30, 100):
        mean = sum(run.exact[shown - 1] for run in runs) / len(runs)
        assert mean == pytest.approx(expected_exact(shown), abs=1.2)


def test_the_expectation_is_that_of_earlier_measurements() -> None:
    assert expected_exact(12) == pytest.approx(14.6, abs=0.5)
    assert expected_exact(100) == pytest.approx(26.2, abs=0.5)


@pytest.mark.parametrize(("level", "exact"), [(Level.A, 30), (Level.B, 10), (Level.C, 0)])
def test_twelve_chosen_demonstrations_teach_so_many_actions_of_thirty(
    level: Level, exact: int
) -> None:
    exercise = PAPER_EXERCISES["ascending"]
    truth = ground_truth(exercise.plays(), exercise.vocabulary(level)).preconditions
    shown = chosen_demonstrations("ascending", Level.A)
    learned = learn_grounded(shown, level).model.preconditions
    assert len(shown) == 12
    assert sum(learned[action] == bits for action, bits in truth.items()) == exact


def test_chosen_demonstrations_end_with_everything_learned() -> None:
    run = run_curve(ascending(100), Choice.CHOSEN, 1)
    assert len(run.exact) == 12
    assert run.exact[-1] == actions_that_occur(ascending(100)) == 30


def test_no_more_chosen_demonstrations_are_shown_than_asked_for() -> None:
    assert len(run_curve(ascending(5), Choice.CHOSEN, 1).exact) == 5


@pytest.mark.parametrize("choice", Choice)
def test_a_run_comes_out_the_same_again_and_another_does_not(choice: Choice) -> None:
    settings = ascending(12)
    assert run_curve(settings, choice, 1) == run_curve(settings, choice, 1)
    assert run_curve(settings, choice, 1).exact != run_curve(settings, choice, 2).exact


def test_more_demonstrations_never_make_fewer_actions_exact() -> None:
    exact = run_curve(ascending(60, Level.B), Choice.RANDOM, 3).exact
    assert list(exact) == sorted(exact)


def test_a_point_is_the_mean_and_spread_of_its_runs() -> None:
    runs = [CurveRun(Choice.RANDOM, number, (number * 3,)) for number in range(1, 11)]
    (point,) = curve_points(ascending(1), runs)
    assert (point.choice, point.demonstrations, point.runs) == (Choice.RANDOM, 1, 10)
    assert point.mean == pytest.approx(55.0)
    assert (point.low, point.high) == (10.0, 90.0)
    assert point.deviation == pytest.approx(30.277, abs=0.001)


def test_a_single_run_has_no_deviation() -> None:
    (point,) = curve_points(ascending(1), [CurveRun(Choice.CHOSEN, 1, (15,))])
    assert (point.mean, point.deviation, point.low, point.high) == (50.0, 0.0, 50.0, 50.0)


def test_an_unknown_exercise_and_no_demonstration_are_refused_together() -> None:
    with pytest.raises(InvalidError, match=r"exercise: sorting, expected one of .*; demonstr"):
        CurveSettings("sorting", Level.A, 0, 1)
