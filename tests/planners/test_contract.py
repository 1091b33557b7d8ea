"""What every engine of the registry promises to learning."""

import itertools
import random
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

import pytest
from hypothesis import given, settings

from maestra.learning.planning import (
    Fluent,
    Limits,
    NoEngine,
    Operator,
    OperatorName,
    OutOfMemory,
    OutOfTime,
    Planner,
    PlanningProblem,
    ProvenUnsolvable,
    Solved,
    Unsupported,
)
from maestra.learning.plans import ReachesGoal, out_of_reach, validate
from maestra.planners import PLANNERS, fast_downward, madagascar
from tests.learning.planning_strategies import problems

AMPLE: Final = Limits(60.0, 2_000)
NOTHING: Final = frozenset[Fluent]()

every_engine = pytest.mark.parametrize(
    "planner", [make() for make in PLANNERS.values()], ids=list(PLANNERS)
)


def fluents(names: str) -> frozenset[Fluent]:
    return frozenset(Fluent(name) for name in names.split())


def operator(name: str, needs: str = "", adds: str = "", deletes: str = "") -> Operator:
    return Operator(OperatorName(name), fluents(needs), fluents(adds), fluents(deletes))


STAIRS = PlanningProblem(
    "stairs",
    fluents("ground"),
    fluents("roof"),
    (
        operator("climb", "first second", "roof"),
        operator("step-up", "first", "second"),
        operator("walk in", "ground", "first"),
        operator("linger", "ground", "ground"),
    ),
)
DOOR = PlanningProblem(
    "door",
    fluents("outside closed"),
    fluents("inside closed"),
    (
        operator("open", "closed", "ajar", "closed"),
        operator("close", "ajar", "closed", "ajar"),
        operator("enter", "ajar outside", "inside", "outside"),
    ),
)


def vertex_cover() -> PlanningProblem:
    """Fewest vertices that touch every edge: no order, no deletes, and a long way to a proof."""
    draw = random.Random(1)  # noqa: S311 - an example, not a secret
    edges = sorted({tuple(sorted(draw.sample(range(200), 2))) for _ in range(1_000)})
    operators = (
        operator(f"v{v}", adds=" ".join(f"e{a}-{b}" for a, b in edges if v in (a, b)))
        for v in range(200)
    )
    goal = fluents(" ".join(f"e{a}-{b}" for a, b in edges))
    return PlanningProblem("vertex cover", NOTHING, goal, tuple(operators))


def lamps() -> PlanningProblem:
    """Lamps to switch at will, and two that are never lit together but must be: 2**40 states."""
    switches = [
        one
        for number in range(40)
        for one in (
            operator(f"on{number}", f"dark{number}", f"lit{number}", f"dark{number}"),
            operator(f"off{number}", f"lit{number}", f"dark{number}", f"lit{number}"),
        )
    ]
    either = (operator("left", "", "l", "r"), operator("right", "", "r", "l"))
    initial = fluents(" ".join(f"dark{number}" for number in range(40)))
    return PlanningProblem("lamps", initial, fluents("l r"), (*switches, *either))


def named(name: str) -> PlanningProblem:
    """A problem whose name tells the double of Madagascar what to do."""
    return PlanningProblem(name, NOTHING, fluents("a"), (operator("o0", "", "a"),))


ENDLESS: Final[Mapping[str, PlanningProblem]] = {
    "clingo": vertex_cover(),
    "fast-downward": lamps(),
    "madagascar": named("hang"),
}
HUNGRY: Final[Mapping[str, PlanningProblem]] = {
    "clingo": vertex_cover(),
    "fast-downward": lamps(),
    "madagascar": named("hoard"),
}
HUNGRY_MB: Final[Mapping[str, int]] = {"clingo": 3, "fast-downward": 20, "madagascar": 300}


def hide_clingo(patch: pytest.MonkeyPatch) -> None:
    patch.setitem(sys.modules, "clingo", None)


def hide_fast_downward(patch: pytest.MonkeyPatch) -> None:
    patch.delenv(fast_downward.BINARY_VARIABLE, raising=False)
    patch.setattr(fast_downward, "_PACKAGE", "no_such_package")
    patch.setenv("PATH", "")


def hide_madagascar(patch: pytest.MonkeyPatch) -> None:
    patch.delenv(madagascar.BINARY_VARIABLE)
    patch.setenv("PATH", "")


HIDE: Final[Mapping[str, Callable[[pytest.MonkeyPatch], None]]] = {
    "clingo": hide_clingo,
    "fast-downward": hide_fast_downward,
    "madagascar": hide_madagascar,
}


def test_the_contract_is_tried_on_every_engine_of_the_registry() -> None:
    for examples in (ENDLESS, HUNGRY, HUNGRY_MB, HIDE):
        assert set(examples) == set(PLANNERS)


def test_each_planner_is_called_as_in_the_registry() -> None:
    assert {name: make().name for name, make in PLANNERS.items()} == {
        name: name for name in PLANNERS
    }


@every_engine
def test_a_plan_is_valid(planner: Planner) -> None:
    outcome = planner.solve(STAIRS, AMPLE)
    assert isinstance(outcome, Solved)
    assert validate(STAIRS, outcome.plan) == ReachesGoal()
    assert 0 < outcome.seconds < AMPLE.time_s


@every_engine
@pytest.mark.parametrize("goal", ["", "ground"])
def test_a_goal_that_holds_already_needs_no_operator(planner: Planner, goal: str) -> None:
    problem = PlanningProblem("there", fluents("ground"), fluents(goal), STAIRS.operators)
    outcome = planner.solve(problem, AMPLE)
    assert isinstance(outcome, Solved)
    assert outcome.plan == ()


@every_engine
def test_a_problem_without_operators_is_answered(planner: Planner) -> None:
    assert isinstance(
        planner.solve(PlanningProblem("still", NOTHING, fluents("a"), ()), AMPLE), ProvenUnsolvable
    )


@every_engine
def test_what_cannot_be_reached_is_proven_so(planner: Planner) -> None:
    circle = (operator("hen", "egg", "hen"), operator("egg", "hen", "egg"))
    problem = PlanningProblem("circle", fluents("sun"), fluents("egg sun"), circle)
    assert isinstance(planner.solve(problem, AMPLE), ProvenUnsolvable)


@every_engine
def test_a_problem_with_deletes_is_solved_or_named_unsupported(planner: Planner) -> None:
    outcome = planner.solve(DOOR, AMPLE)
    match outcome:
        case Solved(plan, _, _):
            assert validate(DOOR, plan) == ReachesGoal()
        case _:
            assert isinstance(outcome, Unsupported)
            assert outcome.why


@every_engine
def test_names_may_hold_anything(planner: Planner) -> None:
    strange = [Fluent(name) for name in ("a b", "a-b", "(a", "∃ \n x", ";", "NOT", "not", "é")]
    operators = [
        Operator(OperatorName(f"{after} !"), frozenset({before}), frozenset({after}))
        for before, after in itertools.pairwise(strange)
    ]
    start, end = frozenset(strange[:1]), frozenset(strange[-1:])
    problem = PlanningProblem("define", start, end, tuple(reversed(operators)))
    outcome = planner.solve(problem, AMPLE)
    assert isinstance(outcome, Solved)
    assert outcome.plan == tuple(one.name for one in operators)


@every_engine
def test_an_endless_search_is_out_of_time(planner: Planner) -> None:
    outcome = planner.solve(ENDLESS[planner.name], Limits(0.3, 2_000))
    assert isinstance(outcome, OutOfTime)
    # Not much later than asked; the margin is for a busy machine.
    assert 0.3 <= outcome.seconds < 3


STARVE = """
from maestra.learning.planning import Limits
from maestra.planners import PLANNERS
from tests.planners.test_contract import HUNGRY, HUNGRY_MB
limits = Limits(60.0, HUNGRY_MB[{name!r}])
print(type(PLANNERS[{name!r}]().solve(HUNGRY[{name!r}], limits)).__name__)
"""


@pytest.mark.parametrize("name", PLANNERS)
def test_a_search_beyond_the_memory_limit_is_out_of_memory(name: str) -> None:
    # In a new process: what this one has freed, an engine inside it may have without its growing.
    said = subprocess.run(
        [sys.executable, "-c", STARVE.format(name=name)],
        check=True,
        capture_output=True,
        cwd=Path(__file__).parents[2],
        text=True,
        timeout=100,
    )
    assert said.stdout == f"{OutOfMemory.__name__}\n"


@every_engine
def test_a_missing_engine_is_named(planner: Planner, monkeypatch: pytest.MonkeyPatch) -> None:
    HIDE[planner.name](monkeypatch)
    outcome = planner.solve(STAIRS, AMPLE)
    assert isinstance(outcome, NoEngine)
    assert outcome.why


@given(problem=problems(deletes=False))
@settings(max_examples=30)
@every_engine
def test_without_deletes_every_engine_finds_a_plan_where_there_is_one(
    planner: Planner, problem: PlanningProblem
) -> None:
    outcome = planner.solve(problem, AMPLE)
    if out_of_reach(problem):
        assert isinstance(outcome, ProvenUnsolvable)
    else:
        assert isinstance(outcome, Solved)
        assert validate(problem, outcome.plan) == ReachesGoal()


@given(problem=problems())
@settings(max_examples=30)
@every_engine
def test_with_deletes_no_engine_answers_wrongly(
    planner: Planner, problem: PlanningProblem
) -> None:
    solvable = can_be_solved(problem)
    match planner.solve(problem, AMPLE):
        case Solved(plan, _, _):
            assert validate(problem, plan) == ReachesGoal()
        case outcome:
            assert isinstance(outcome, Unsupported | ProvenUnsolvable)
            assert not (solvable and isinstance(outcome, ProvenUnsolvable))


def can_be_solved(problem: PlanningProblem) -> bool:
    """Whether a search through all states finds the goal."""
    seen = {problem.initial}
    new = [problem.initial]
    while new:
        state = new.pop()
        if problem.goal <= state:
            return True
        after = {
            (state - one.deletes) | one.adds for one in problem.operators if one.needs <= state
        }
        new += after - seen
        seen |= after
    return False


def test_the_registry_imports_no_engine(tmp_path: Path) -> None:
    program = "import sys, maestra.planners; assert not {'clingo', 'pddl'} & set(sys.modules)"
    script = tmp_path / "look.py"
    script.write_text(program, encoding="utf-8")
    subprocess.run([sys.executable, str(script)], check=True, timeout=60)
