from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from maestra.core.faults import InvalidError
from maestra.learning.compiled import (
    ActionName,
    CompiledReport,
    DeletionTask,
    LiteralName,
    Transition,
    compile_by_action,
    compile_problem,
    delete_operator,
    solve_compiled,
    validate_operator,
)
from maestra.learning.planning import (
    Limits,
    NoEngine,
    OperatorName,
    Outcome,
    OutOfMemory,
    OutOfTime,
    PlanningProblem,
    ProvenUnsolvable,
    Solved,
    Unsolved,
    Unsupported,
)
from maestra.learning.plans import InvalidPlanError, ReachesGoal, in_order_of_need, validate
from tests.learning.planning_strategies import deleted_directly, deletion_tasks

AMPLE = Limits(10.0, 1_000)
M19, M23 = ActionName("move-v19-t1"), ActionName("move-v23-t1")
L11, L12, ODD = LiteralName("to = l11"), LiteralName("to = l12"), LiteralName("odd(v)")


def broken(*literals: LiteralName) -> frozenset[LiteralName]:
    return frozenset(literals)


TASK = DeletionTask(
    {M19: broken(L11, L12, ODD), M23: broken(L11, L12)},
    (
        (Transition(M19, broken(L12)), Transition(M23, broken(L11))),
        (),
        (Transition(M19, broken(L12, ODD)),),
    ),
)


@dataclass
class ScriptedPlanner:
    """A planner that answers what it is told to, and notes what it was asked."""

    answer: Callable[[PlanningProblem], Outcome]
    asked: list[tuple[PlanningProblem, Limits]] = field(
        default_factory=list[tuple[PlanningProblem, Limits]]
    )
    name: str = "scripted"
    prefers_whole: bool = False

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        self.asked.append((problem, limits))
        return self.answer(problem)


def wastefully(problem: PlanningProblem) -> Outcome:
    """A plan with everything that can be done in it, as Madagascar's M makes them."""
    plan = in_order_of_need(problem.initial, problem.operators)
    return Solved(tuple(operator.name for operator in plan), "wasteful", 0.25)


def test_every_literal_of_every_action_can_be_deleted() -> None:
    names = {operator.name for operator in compile_problem(TASK).operators}
    deletable = {
        delete_operator(a, literal) for a, whole in TASK.whole.items() for literal in whole
    }
    assert names == deletable | {validate_operator(d, m) for d, m in ((1, 1), (1, 2), (3, 1))}


def test_a_move_waits_for_the_one_before_it_and_for_its_literals() -> None:
    problem = compile_problem(TASK)
    by_name = {operator.name: operator for operator in problem.operators}
    assert by_name[validate_operator(1, 2)].needs == {
        "validated(1, 1)",
        "deleted('move-v23-t1', 'to = l11')",
    }
    assert by_name[validate_operator(3, 1)].needs == {
        "validated(1, 2)",
        "deleted('move-v19-t1', 'to = l12')",
        "deleted('move-v19-t1', 'odd(v)')",
    }
    assert problem.goal == {"validated(1, 2)", "validated(3, 1)"}
    assert problem.initial == frozenset()


def test_by_action_there_is_one_problem_for_each_action_shown() -> None:
    shown_once = DeletionTask(TASK.whole, TASK.demonstrations[2:])
    assert [problem.name for problem in compile_by_action(TASK)] == [
        "compiled move-v19-t1",
        "compiled move-v23-t1",
    ]
    assert [problem.name for problem in compile_by_action(shown_once)] == ["compiled move-v19-t1"]


@given(st.text(), st.text(), st.text(), st.text())
@example("a", "b', 'c", "a', 'b", "c")
def test_different_deletions_have_different_names(a: str, b: str, c: str, d: str) -> None:
    one = delete_operator(ActionName(a), LiteralName(b))
    other = delete_operator(ActionName(c), LiteralName(d))
    assert (one == other) == ((a, b) == (c, d))


@given(deletion_tasks(), st.booleans())
def test_what_is_left_is_what_always_held_and_nothing_superfluous_is_deleted(
    task: DeletionTask,
    whole: bool,  # noqa: FBT001 - Hypothesis passes it by keyword
) -> None:
    report = solve_compiled(task, ScriptedPlanner(wastefully), AMPLE, whole=whole)
    assert isinstance(report, CompiledReport)
    assert report.deletions == deleted_directly(task)
    shown = {move.action for moves in task.demonstrations for move in moves}
    could = task.whole if whole else {action: task.whole[action] for action in shown}
    deleted = sum(map(len, report.deletions.values()))
    # Validations without which the goal is reached cannot be: each leads to the next.
    assert report.superfluous == sum(map(len, could.values())) - deleted


@given(deletion_tasks())
def test_the_plans_by_action_one_after_another_are_a_plan_of_the_whole(
    task: DeletionTask,
) -> None:
    deletions: list[OperatorName] = []
    for problem in compile_by_action(task):
        plan = in_order_of_need(problem.initial, problem.operators)
        deletions += [one.name for one in plan if one.name.startswith("delete(")]
    validations = [
        validate_operator(number, count)
        for number, moves in enumerate(task.demonstrations, start=1)
        for count in range(1, len(moves) + 1)
    ]
    assert validate(compile_problem(task), [*deletions, *validations]) == ReachesGoal()


def test_the_report_counts_problems_and_adds_up_the_engines_time() -> None:
    report = solve_compiled(TASK, ScriptedPlanner(wastefully), AMPLE, whole=False)
    assert report == CompiledReport(
        deletions={M19: broken(L12, ODD), M23: broken(L11)},
        superfluous=2,
        problems=2,
        engine="wasteful",
        seconds=0.5,
    )


def test_nothing_shown_is_nothing_to_solve() -> None:
    nothing = DeletionTask(TASK.whole, ())
    planner = ScriptedPlanner(wastefully)
    report = solve_compiled(nothing, planner, AMPLE, whole=False)
    assert report == CompiledReport({M19: broken(), M23: broken()}, 0, 0, "scripted", 0.0)
    assert planner.asked == []


def test_each_problem_gets_the_time_that_is_left() -> None:
    planner = ScriptedPlanner(wastefully)
    solve_compiled(TASK, planner, Limits(1.0, 7), whole=False)
    assert [limits for _, limits in planner.asked] == [Limits(1.0, 7), Limits(0.75, 7)]


def test_no_time_left_is_out_of_time_without_asking() -> None:
    planner = ScriptedPlanner(wastefully)
    outcome = solve_compiled(TASK, planner, Limits(0.25, 7), whole=False)
    assert outcome == OutOfTime("scripted", 0.25)
    assert len(planner.asked) == 1


UNSOLVED: Sequence[Unsolved] = (
    ProvenUnsolvable("e", 1.0),
    OutOfTime("e", 1.0),
    OutOfMemory("e", 1.0),
    Unsupported("e", "why"),
    NoEngine("e", "why"),
)


@pytest.mark.parametrize("outcome", UNSOLVED)
@pytest.mark.parametrize("whole", [True, False])
def test_an_outcome_that_is_not_a_plan_is_handed_on(outcome: Unsolved, *, whole: bool) -> None:
    planner = ScriptedPlanner(lambda _: outcome)
    assert solve_compiled(TASK, planner, AMPLE, whole=whole) is outcome


def test_a_planner_that_breaks_its_contract_is_found_out() -> None:
    lying = ScriptedPlanner(lambda _: Solved((), "lying", 0.0))
    with pytest.raises(InvalidPlanError):
        solve_compiled(TASK, lying, AMPLE, whole=True)


def test_every_move_that_no_deletion_could_explain_is_reported_at_once() -> None:
    demonstration = (Transition(M23, broken(ODD, L11)), Transition(M19, broken()))
    with pytest.raises(InvalidError) as refused:
        DeletionTask({M23: broken(L11)}, ((), demonstration))
    assert [str(fault) for fault in refused.value.faults] == [
        "demonstrations[2].moves[1]: unknown literal 'odd(v)', expected one of 'move-v23-t1'",
        "demonstrations[2].moves[2]: unknown action 'move-v19-t1', expected an action of `whole`",
    ]
