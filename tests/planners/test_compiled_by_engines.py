"""Learning by planning gives the same with every engine: what the definition says."""

import pytest
from hypothesis import given, settings

from maestra.learning.compiled import CompiledReport, DeletionTask, solve_compiled
from maestra.learning.planning import Limits, Planner
from maestra.planners import PLANNERS
from tests.learning.planning_strategies import deleted_directly, deletion_tasks

AMPLE = Limits(60.0, 2_000)

every_engine = pytest.mark.parametrize(
    "planner", [make() for make in PLANNERS.values()], ids=list(PLANNERS)
)


@pytest.mark.parametrize("whole", [True, False], ids=["whole", "by action"])
@given(task=deletion_tasks())
@settings(max_examples=25)
@every_engine
def test_every_engine_deletes_what_was_false_before_some_move(
    planner: Planner, task: DeletionTask, *, whole: bool
) -> None:
    report = solve_compiled(task, planner, AMPLE, whole=whole)
    assert isinstance(report, CompiledReport)
    assert report.deletions == deleted_directly(task)
