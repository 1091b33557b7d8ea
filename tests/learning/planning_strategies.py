"""Random planning problems and deletion tasks, and the slow, obvious way to solve the latter."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from maestra.learning.compiled import ActionName, DeletionTask, LiteralName, Transition
from maestra.learning.planning import Fluent, Operator, OperatorName, PlanningProblem

FLUENTS: Final = tuple(Fluent(name) for name in ("p", "q (x, 'y')", "r≠s", "t", "u", "w"))
LITERALS: Final = tuple(LiteralName(f"to = l1{column}") for column in range(1, 6))
ACTIONS: Final = tuple(ActionName(f"move-v{value}-t1") for value in (19, 23, 32))

fluent_sets = st.frozensets(st.sampled_from(FLUENTS), max_size=3)


@st.composite
def problems(draw: st.DrawFn, *, deletes: bool = True) -> PlanningProblem:
    """A small problem, solvable or not, with or without operators that delete."""
    operators: list[Operator] = []
    for number in range(draw(st.integers(0, 7))):
        adds = draw(fluent_sets)
        removed = draw(fluent_sets) - adds if deletes else frozenset[Fluent]()
        operators.append(Operator(OperatorName(f"o{number}"), draw(fluent_sets), adds, removed))
    return PlanningProblem("random", draw(fluent_sets), draw(fluent_sets), tuple(operators))


@st.composite
def plans(draw: st.DrawFn) -> tuple[PlanningProblem, tuple[OperatorName, ...]]:
    """A problem, and a plan of it that wanders: any operators that can be taken."""
    problem = draw(problems())
    state = set(problem.initial)
    plan: list[OperatorName] = []
    for _ in range(draw(st.integers(0, 12))):
        able = [operator for operator in problem.operators if operator.needs <= state]
        if not able:
            break
        operator = draw(st.sampled_from(able))
        state = (state - operator.deletes) | operator.adds
        plan.append(operator.name)
    goal = draw(st.frozensets(st.sampled_from(sorted(state)))) if state else frozenset[Fluent]()
    return PlanningProblem("walk", problem.initial, goal, problem.operators), tuple(plan)


@st.composite
def deletion_tasks(draw: st.DrawFn) -> DeletionTask:
    """Demonstrations of up to three actions over up to five literals."""
    whole = {action: draw(st.frozensets(st.sampled_from(LITERALS))) for action in ACTIONS}
    moves = [
        Transition(action, draw(st.frozensets(st.sampled_from(sorted(whole[action])))))
        if whole[action]
        else Transition(action, frozenset())
        for action in draw(st.lists(st.sampled_from(ACTIONS), max_size=8))
    ]
    cuts = sorted(draw(st.lists(st.integers(0, len(moves)), max_size=3)))
    bounds = zip([0, *cuts], [*cuts, len(moves)], strict=True)
    return DeletionTask(whole, tuple(tuple(moves[begin:end]) for begin, end in bounds))


def deleted_directly(task: DeletionTask) -> Mapping[ActionName, frozenset[LiteralName]]:
    """What the definition says without any planning: what was false before some move shown."""
    deleted = dict.fromkeys(task.whole, frozenset[LiteralName]())
    for demonstration in task.demonstrations:
        for move in demonstration:
            deleted[move.action] |= move.broken
    return deleted
