import itertools
import subprocess
import sys
from collections.abc import Callable, Iterable

import pytest
from hypothesis import given

from maestra.learning.compiled import DeletionTask, compile_problem
from maestra.learning.planning import (
    Fluent,
    Limits,
    Operator,
    OperatorName,
    OutOfMemory,
    OutOfTime,
    PlanningProblem,
    Solved,
    Unsupported,
)
from maestra.learning.plans import ReachesGoal, in_order_of_need, minimise, validate
from maestra.planners import clingo_planner
from maestra.planners.clingo_planner import ClingoPlanner
from tests.learning.planning_strategies import deletion_tasks, problems
from tests.planners.test_contract import DOOR, vertex_cover

AMPLE = Limits(60.0, 2_000)
NOTHING: frozenset[Fluent] = frozenset()


def shortest(problem: PlanningProblem) -> int | None:
    """The length of a shortest plan, found by trying all sets of operators, smallest first."""
    for length in range(len(problem.operators) + 1):
        for chosen in itertools.combinations(problem.operators, length):
            plan = [one.name for one in in_order_of_need(problem.initial, chosen)]
            if validate(problem, plan) == ReachesGoal():
                return length
    return None


@given(problems(deletes=False))
def test_a_plan_has_the_fewest_operators(problem: PlanningProblem) -> None:
    outcome = ClingoPlanner().solve(problem, AMPLE)
    found = len(outcome.plan) if isinstance(outcome, Solved) else None
    assert found == shortest(problem)


@given(deletion_tasks())
def test_of_a_compiled_problem_any_minimised_plan_is_a_shortest(task: DeletionTask) -> None:
    problem = compile_problem(task)
    wasteful = [one.name for one in in_order_of_need(problem.initial, problem.operators)]
    outcome = ClingoPlanner().solve(problem, AMPLE)
    assert isinstance(outcome, Solved)
    assert len(minimise(problem, wasteful).plan) == len(outcome.plan)


def test_a_problem_with_deletes_is_unsupported_with_the_reason() -> None:
    outcome = ClingoPlanner().solve(DOOR, AMPLE)
    assert isinstance(outcome, Unsupported)
    assert "deletes" in outcome.why


def many(operators: int) -> PlanningProblem:
    """Much to state, nothing to search."""
    steps = [
        Operator(OperatorName(f"o{n}"), NOTHING, frozenset({Fluent(f"f{n}")}))
        for n in range(operators)
    ]
    return PlanningProblem("many", NOTHING, frozenset({Fluent("f0")}), tuple(steps))


def test_time_is_watched_while_the_rules_are_stated() -> None:
    outcome = ClingoPlanner().solve(many(50_000), Limits(0.05, 2_000))
    assert isinstance(outcome, OutOfTime)
    assert 0.05 <= outcome.seconds < 1


def resident(readings: Iterable[int]) -> Callable[[], int]:
    """What this process shall seem to hold in memory, one look after another."""
    rest = iter(readings)
    return lambda: next(rest)


def test_memory_is_watched_while_clingo_searches(monkeypatch: pytest.MonkeyPatch) -> None:
    looks = itertools.chain([0] * 20, itertools.repeat(101 * 2**20))
    monkeypatch.setattr(clingo_planner, "resident_bytes", resident(looks))
    assert isinstance(ClingoPlanner().solve(vertex_cover(), Limits(60.0, 100)), OutOfMemory)


def test_a_problem_that_will_not_fit_is_not_prepared(monkeypatch: pytest.MonkeyPatch) -> None:
    # At first; when the rules are stated. A third of the limit is taken, and preparing takes
    # three times that.
    monkeypatch.setattr(clingo_planner, "resident_bytes", resident([0, 34 * 2**20]))
    assert isinstance(ClingoPlanner().solve(many(10), Limits(60.0, 100)), OutOfMemory)
    monkeypatch.setattr(clingo_planner, "resident_bytes", resident([0] + [33 * 2**20] * 100))
    assert isinstance(ClingoPlanner().solve(many(10), Limits(60.0, 100)), Solved)


MEASURE = """
from maestra.planners import clingo_planner
from maestra.learning.planning import Fluent, Limits, Operator, OperatorName, PlanningProblem
NOTHING = frozenset()
steps = tuple(
    Operator(OperatorName(f"o{n}"), NOTHING, frozenset({Fluent(f"f{n}")})) for n in range(30_000)
)
problem = PlanningProblem("many", NOTHING, frozenset({Fluent("f0")}), steps)
readings = []
def note(real=clingo_planner.resident_bytes):
    readings.append(real())
    return readings[-1]
clingo_planner.resident_bytes = note
clingo_planner.ClingoPlanner().solve(problem, Limits(60.0, 2_000))
stated = len(steps) // clingo_planner.WATCH_OPERATORS + 1
status = dict(line.split(":") for line in open("/proc/self/status"))
most = int(status["VmHWM"].split()[0]) * 1024  # getrusage would count our parent's before exec
print(readings[stated] - readings[0], most - readings[0])
"""


def test_preparing_takes_no_more_memory_than_is_foreseen() -> None:
    """The factor that decides whether to begin is a measurement; this repeats it."""
    # In a new process, whose memory holds nothing that was freed and can be had again.
    said = subprocess.run(
        [sys.executable, "-c", MEASURE], check=True, capture_output=True, text=True, timeout=100
    )
    stated, most = map(int, said.stdout.split())
    assert stated > 0
    assert most <= clingo_planner.PREPARED_TO_STATED * stated


def test_an_interrupt_cancels_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    # Where Python would raise it while the search is watched; a real signal may strike a callback
    # of the interpreter, which swallows it.
    look = clingo_planner.Watch.check
    looked: list[int] = []

    def interrupted(watch: clingo_planner.Watch, memory_factor: int = 1) -> None:
        looked.append(memory_factor)
        if len(looked) == 5:
            raise KeyboardInterrupt
        look(watch, memory_factor)

    monkeypatch.setattr(clingo_planner.Watch, "check", interrupted)
    with pytest.raises(KeyboardInterrupt):
        ClingoPlanner().solve(vertex_cover(), AMPLE)
    assert looked[-1] == 1, "interrupted while searching, not while preparing"
    # That no thread is left is looked at after every test here.
