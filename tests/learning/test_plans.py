from collections.abc import Sequence

import pytest
from hypothesis import given

from maestra.learning.planning import Fluent, Operator, OperatorName, PlanningProblem
from maestra.learning.plans import (
    ImpossibleStep,
    InvalidPlanError,
    Minimised,
    MissesGoal,
    PlanVerdict,
    ReachesGoal,
    UnknownStep,
    in_order_of_need,
    minimise,
    out_of_reach,
    validate,
)
from tests.learning.planning_strategies import plans, problems


def fluents(names: str) -> frozenset[Fluent]:
    return frozenset(Fluent(name) for name in names.split())


def named(names: str) -> tuple[OperatorName, ...]:
    return tuple(OperatorName(name) for name in names.split())


def operator(name: str, needs: str = "", adds: str = "", deletes: str = "") -> Operator:
    return Operator(OperatorName(name), fluents(needs), fluents(adds), fluents(deletes))


DOOR = PlanningProblem(
    "door",
    fluents("outside closed"),
    fluents("inside closed"),
    (
        operator("open", "closed", "ajar", "closed"),
        operator("close", "ajar", "closed", "ajar"),
        operator("enter", "ajar outside", "inside", "outside"),
        operator("leave", "ajar inside", "outside", "inside"),
        operator("ring", "", "heard"),
    ),
)


@pytest.mark.parametrize(
    ("plan", "verdict"),
    [
        ("open enter close", ReachesGoal()),
        ("ring open enter close", ReachesGoal()),
        ("open enter", MissesGoal(fluents("closed"))),
        ("", MissesGoal(fluents("inside"))),
        ("open close enter", ImpossibleStep(3, OperatorName("enter"), fluents("ajar"))),
        ("open knock", UnknownStep(2, OperatorName("knock"))),
    ],
)
def test_a_plan_is_replayed_from_the_definition(plan: str, verdict: PlanVerdict) -> None:
    assert validate(DOOR, named(plan)) == verdict


@pytest.mark.parametrize(
    ("plan", "kept"),
    [
        ("open enter close", "open enter close"),
        ("ring open ring enter close ring", "open enter close"),
        # Detours of which no operator can go alone: one leads away, the other back.
        ("open enter close open close", "open enter close open close"),
        ("open enter leave enter close", "open enter leave enter close"),
    ],
)
def test_superfluous_operators_are_dropped_and_counted(plan: str, kept: str) -> None:
    expected = Minimised(named(kept), len(plan.split()) - len(kept.split()))
    assert minimise(DOOR, named(plan)) == expected


def test_what_only_served_a_superfluous_operator_goes_with_it() -> None:
    chain = PlanningProblem(
        "chain",
        frozenset(),
        fluents("goal"),
        (operator("a", "", "x"), operator("b", "x", "y"), operator("c", "", "goal")),
    )
    assert minimise(chain, named("a b c")) == Minimised(named("c"), 2)


def test_what_only_repairs_a_superfluous_operator_goes_with_it() -> None:
    repair = PlanningProblem(
        "repair",
        fluents("whole"),
        fluents("whole"),
        (operator("break", "", "noise", "whole"), operator("mend", "", "whole")),
    )
    assert minimise(repair, named("break mend")) == Minimised((), 2)


def test_an_invalid_plan_is_not_minimised() -> None:
    with pytest.raises(InvalidPlanError, match="MissesGoal"):
        minimise(DOOR, named("open"))


def test_thousands_of_operators_are_minimised_in_one_go() -> None:
    length = 5_000
    steps = [operator(f"go{i}", f"at{i}", f"at{i + 1}", f"at{i}") for i in range(length)]
    idle = [operator(f"idle{i}", f"at{i}", f"seen{i}") for i in range(length)]
    problem = PlanningProblem("walk", fluents("at0"), fluents(f"at{length}"), (*steps, *idle))
    plan = [one.name for pair in zip(idle, steps, strict=True) for one in pair]
    assert minimise(problem, plan) == Minimised(tuple(step.name for step in steps), length)


def is_subsequence(part: Sequence[OperatorName], whole: Sequence[OperatorName]) -> bool:
    rest = iter(whole)
    return all(one in rest for one in part)


@given(plans())
def test_a_minimised_plan_is_valid_and_no_operator_can_be_dropped(
    example: tuple[PlanningProblem, tuple[OperatorName, ...]],
) -> None:
    problem, plan = example
    minimised = minimise(problem, plan)
    kept = minimised.plan
    assert validate(problem, kept) == ReachesGoal()
    assert is_subsequence(kept, plan)
    assert minimised.superfluous == len(plan) - len(kept)
    for place in range(len(kept)):
        shorter = kept[:place] + kept[place + 1 :]
        assert validate(problem, shorter) != ReachesGoal()


@given(problems(deletes=False))
def test_without_deletes_a_goal_within_reach_is_reached_in_order_of_need(
    problem: PlanningProblem,
) -> None:
    plan = [one.name for one in in_order_of_need(problem.initial, problem.operators)]
    missed = out_of_reach(problem)
    assert validate(problem, plan) == (MissesGoal(missed) if missed else ReachesGoal())


@given(plans())
def test_what_a_plan_reaches_is_not_out_of_reach(
    example: tuple[PlanningProblem, tuple[OperatorName, ...]],
) -> None:
    problem, _ = example
    assert out_of_reach(problem) == frozenset()
