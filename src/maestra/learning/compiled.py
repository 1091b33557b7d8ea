"""Most specific preconditions by planning: the paper's own way to learn [1].

At first each action's precondition holds every literal of the vocabulary. One operator for each
of these literals deletes it; one operator for each move shown validates that move, once the
moves before it are validated and its action's precondition no longer holds a literal that was
false before the move. The goal is that every demonstration is validated. A plan therefore tells
which literals to delete, and what is left explains everything that was shown.

Where we depart from [1], which is brief here and refers to Aineto et al. for the details:

- *Positive encoding.* A fluent says that a literal is deleted, none that it is still there, so
  no operator deletes a fluent, a plan always exists, and heuristics that ignore deletes see
  the problem as it is.
- *Nothing superfluous.* A planner may delete literals that no move asks for, which would allow
  what was never shown. `solve_compiled` drops these deletions and counts them.
- *One problem for each action*, if asked. Preconditions of different actions share nothing.

With every state observed, a move asks for exactly the literals that were false before it, so
what is left after minimising is the same for every planner and every plan: all literals that
held each time, which is what `grounded` finds without a planner.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019,
    section 3.3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, NewType, TypeAlias

from maestra.core.faults import Fault, refuse
from maestra.learning.planning import (
    Fluent,
    Limits,
    Operator,
    OperatorName,
    OutOfTime,
    Planner,
    PlanningProblem,
    Solved,
    Unsolved,
)
from maestra.learning.plans import minimise

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

ActionName = NewType("ActionName", str)
LiteralName = NewType("LiteralName", str)


@dataclass(frozen=True, slots=True)
class Transition:
    """One move shown: its action, and the literals that were false before it."""

    action: ActionName
    broken: frozenset[LiteralName]


ShownMoves: TypeAlias = tuple[Transition, ...]


@dataclass(frozen=True, slots=True)
class DeletionTask:
    """What is to be explained, and the preconditions to begin with.

    Raises:
        InvalidError: a move's action has no precondition, or the precondition lacks a literal
            that the move breaks; with every fault.
    """

    whole: Mapping[ActionName, frozenset[LiteralName]]
    """Each action's precondition before anything is deleted."""
    demonstrations: tuple[ShownMoves, ...]

    def __post_init__(self) -> None:
        """Freeze the mapping and refuse moves that no deletion could explain."""
        refuse(list(self._faults()))
        object.__setattr__(self, "whole", MappingProxyType(dict(self.whole)))

    def _faults(self) -> Iterator[Fault]:
        for number, moves in enumerate(self.demonstrations, start=1):
            for count, move in enumerate(moves, start=1):
                where = f"demonstrations[{number}].moves[{count}]"
                literals = self.whole.get(move.action)
                if literals is None:
                    yield Fault(where, f"unknown action {move.action!r}", "an action of `whole`")
                    continue
                for literal in sorted(move.broken - literals):
                    yield Fault(where, f"unknown literal {literal!r}", f"one of {move.action!r}")


def delete_operator(action: ActionName, literal: LiteralName) -> OperatorName:
    """The operator that deletes `literal` from the precondition of `action`."""
    # repr keeps two names apart whatever is in them.
    return OperatorName(f"delete({action!r}, {literal!r})")


def validate_operator(demonstration: int, move: int) -> OperatorName:
    """The operator that validates a move; both count from 1."""
    return OperatorName(f"validate({demonstration}, {move})")


def _deleted(action: ActionName, literal: LiteralName) -> Fluent:
    return Fluent(f"deleted({action!r}, {literal!r})")


def _validated(demonstration: int, move: int) -> Fluent:
    return Fluent(f"validated({demonstration}, {move})")


def compile_problem(task: DeletionTask) -> PlanningProblem:
    """The whole task as one problem: demonstrations in the order shown, move after move."""
    operators = [
        operator
        for action, literals in task.whole.items()
        for operator in _delete_operators(action, literals)
    ]
    goal: list[Fluent] = []
    before: frozenset[Fluent] = frozenset()
    for number, moves in enumerate(task.demonstrations, start=1):
        for count, move in enumerate(moves, start=1):
            operators.append(_validation(number, count, move, before))
            before = frozenset({_validated(number, count)})
        goal += before if moves else ()
    return PlanningProblem("compiled", frozenset(), frozenset(goal), tuple(operators))


def compile_by_action(task: DeletionTask) -> tuple[PlanningProblem, ...]:
    """One problem for each action that was shown, in the order of `task.whole`.

    The plans of these problems, one after another, are a plan of the whole but for the order in
    which moves are validated: deletions of one action make no fluent that another action's
    moves need, a validated move only waits for the one before it, and nothing is ever undone,
    so all deletions may come first and the validations after them as shown. Conversely the
    whole's plan, cut down to one action, solves that action's problem. So the fewest deletions
    of the whole are the fewest of each action together.
    """
    moves: dict[ActionName, list[tuple[int, int, Transition]]] = {}
    for number, demonstration in enumerate(task.demonstrations, start=1):
        for count, move in enumerate(demonstration, start=1):
            moves.setdefault(move.action, []).append((number, count, move))
    return tuple(
        PlanningProblem(
            name=f"compiled {action}",
            initial=frozenset(),
            goal=frozenset(_validated(number, count) for number, count, _ in moves[action]),
            operators=(
                *_delete_operators(action, literals),
                *(_validation(*shown, before=frozenset()) for shown in moves[action]),
            ),
        )
        for action, literals in task.whole.items()
        if action in moves
    )


def _delete_operators(action: ActionName, literals: Iterable[LiteralName]) -> Iterator[Operator]:
    for literal in sorted(literals):
        added = frozenset({_deleted(action, literal)})
        yield Operator(delete_operator(action, literal), frozenset(), added)


def _validation(number: int, count: int, move: Transition, before: frozenset[Fluent]) -> Operator:
    return Operator(
        validate_operator(number, count),
        before | {_deleted(move.action, literal) for literal in move.broken},
        frozenset({_validated(number, count)}),
    )


@dataclass(frozen=True, slots=True)
class CompiledReport:
    """What a planner's plans delete, once nothing superfluous is in them."""

    deletions: Mapping[ActionName, frozenset[LiteralName]]
    """For each action of the task, the literals to take from its precondition."""
    superfluous: int
    """How many deletions the plans held that no validation needs."""
    problems: int
    """How many planning problems were solved."""
    engine: str
    seconds: float
    """What the engine took for all of them, by its adapter's clock."""


def solve_compiled(
    task: DeletionTask, planner: Planner, limits: Limits, *, whole: bool
) -> CompiledReport | Unsolved:
    """The fewest deletions that explain `task`, found by `planner`.

    `limits` are for the call: with several problems each may take the time that is left.

    Args:
        task: what was shown.
        planner: who solves the problems.
        limits: time for all problems together, memory for each.
        whole: one problem for everything, instead of one for each action shown.

    Returns:
        The report, or the first outcome that is not a plan.

    Raises:
        InvalidPlanError: the planner broke its contract.
    """
    problems = (compile_problem(task),) if whole else compile_by_action(task)
    outcomes = _solve_in_turn(problems, planner, limits)
    if not isinstance(outcomes, list):
        return outcomes
    needed: set[OperatorName] = set()
    superfluous = 0
    for problem, outcome in zip(problems, outcomes, strict=True):
        minimised = minimise(problem, outcome.plan)
        needed.update(minimised.plan)
        superfluous += minimised.superfluous
    return CompiledReport(
        deletions=_deletions(task, needed),
        superfluous=superfluous,
        problems=len(problems),
        engine=outcomes[0].engine if outcomes else planner.name,
        seconds=sum(outcome.seconds for outcome in outcomes),
    )


def _solve_in_turn(
    problems: Sequence[PlanningProblem], planner: Planner, limits: Limits
) -> list[Solved] | Unsolved:
    outcomes: list[Solved] = []
    spent_s = 0.0
    for problem in problems:
        if spent_s >= limits.time_s:
            return OutOfTime(planner.name, spent_s)
        outcome = planner.solve(problem, Limits(limits.time_s - spent_s, limits.memory_mb))
        if not isinstance(outcome, Solved):
            return outcome
        spent_s += outcome.seconds
        outcomes.append(outcome)
    return outcomes


def _deletions(
    task: DeletionTask, needed: set[OperatorName]
) -> Mapping[ActionName, frozenset[LiteralName]]:
    return MappingProxyType(
        {
            action: frozenset(
                literal for literal in literals if delete_operator(action, literal) in needed
            )
            for action, literals in task.whole.items()
        }
    )
