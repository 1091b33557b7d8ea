"""Learning by planning gives the same with every engine: what the definition says."""

from collections.abc import Sequence

import pytest
from hypothesis import given, settings

from maestra.core.demonstration import Demonstration
from maestra.learning.compiled import CompiledReport, DeletionTask, solve_compiled
from maestra.learning.compiled_learner import CompiledLesson, learn_compiled
from maestra.learning.grounded import learn_grounded
from maestra.learning.planning import Limits, Planner
from maestra.planners import PLANNERS
from maestra.rules.strips.vocabulary import Level
from tests.learning.planning_strategies import deleted_directly, deletion_tasks
from tests.learning.play_strategies import demonstrations, levels, selections

AMPLE = Limits(60.0, 2_000)

every_engine = pytest.mark.parametrize(
    "planner", [make() for make in PLANNERS.values()], ids=list(PLANNERS)
)
each_way = pytest.mark.parametrize("whole", [True, False], ids=["whole", "by action"])


@each_way
@every_engine
@given(task=deletion_tasks())
@settings(max_examples=20)
def test_every_engine_deletes_what_was_false_before_some_move(
    planner: Planner, task: DeletionTask, *, whole: bool
) -> None:
    report = solve_compiled(task, planner, AMPLE, whole=whole)
    assert isinstance(report, CompiledReport)
    assert report.deletions == deleted_directly(task)


@every_engine
@given(shown=demonstrations(), level=levels, features=selections)
@settings(max_examples=20)
def test_with_every_engine_both_learners_find_the_same_exercise(
    planner: Planner,
    shown: Sequence[Demonstration],
    level: Level,
    features: Sequence[str] | None,
) -> None:
    lesson = learn_compiled(shown, planner, AMPLE, level, features)
    assert isinstance(lesson, CompiledLesson)
    assert lesson.exercise == learn_grounded(shown, level, features)
