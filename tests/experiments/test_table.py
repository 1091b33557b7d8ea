from itertools import count

import pytest

from maestra.experiments import table
from maestra.experiments.table import GROUNDED, LEARNERS, explain, measure
from maestra.learning.grounded import learn_grounded
from maestra.learning.planning import (
    NoEngine,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Unsolved,
    Unsupported,
)
from maestra.learning.teaching_sets import TeachingSet
from maestra.rules.paper import PAPER_EXERCISES


@pytest.mark.parametrize("exercise", PAPER_EXERCISES)
def test_the_grounded_learner_learns_each_exercise_exactly(exercise: str) -> None:
    ticks = count()
    row = measure(exercise, GROUNDED, 1, lambda: next(ticks) / 2)
    assert row.outcome == "exact"
    assert row.demonstrations == row.lower_bound == row.fewest_in_paper
    assert (row.learn_s, row.explain_s) == (0.5, 0.5)


def test_a_time_is_the_median_of_its_repetitions() -> None:
    clock = iter([0, 1, 0, 5, 0, 2, 0, 1, 0, 1, 0, 7])
    row = measure("curie", GROUNDED, 3, lambda: float(next(clock)))
    assert (row.learn_s, row.explain_s) == (2.0, 1.0)


def test_learning_by_planning_with_clingo_is_exact_too() -> None:
    row = measure("curie", "compiled, clingo", 1, lambda: 0.0)
    assert row.outcome == "exact"


@pytest.mark.parametrize(
    ("unsolved", "said"),
    [
        (NoEngine("x", "not installed"), "no engine"),
        (OutOfTime("x", 1.0), "out of time"),
        (OutOfMemory("x", 1.0), "out of memory"),
        (Unsupported("x", "why"), "unsupported"),
        (ProvenUnsolvable("x", 1.0), "unsolvable"),
    ],
)
def test_a_planner_that_finds_nothing_is_named_with_its_reason(
    unsolved: Unsolved, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def give_up(*_arguments: object, **_options: object) -> Unsolved:
        return unsolved

    monkeypatch.setattr(table, "learn_compiled", give_up)
    row = measure("curie", LEARNERS[-1], 1, lambda: 0.0)
    assert row.outcome == said
    assert row.learn_s is row.explain_s is None


def test_what_is_learned_from_too_little_is_not_called_exact(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    plays = PAPER_EXERCISES["curie"].plays()

    def teach_too_little(_exercise: str) -> TeachingSet:
        return TeachingSet((plays.play(0),), 2)

    monkeypatch.setattr(table, "_taught", teach_too_little)
    assert measure("curie", GROUNDED, 1, lambda: 0.0).outcome == "not exact"


def test_everything_learned_is_explained_in_sentences() -> None:
    plays = PAPER_EXERCISES["curie"].plays()
    said = explain(learn_grounded([plays.play(0), plays.play(plays.count - 1)]))
    assert len(said) > 5
    assert all(sentence.endswith(".") for sentence in said)
