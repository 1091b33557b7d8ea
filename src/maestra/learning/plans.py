"""What a plan is worth: replaying it, and dropping the operators that its goal does not need.

Engines are trusted with neither. `validate` replays a plan from the definition alone;
`minimise` leaves a plan of which no single operator can be dropped. That is not always a
shortest plan, but it is on the problems of `compiled`, where each fluent has one adder.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict, deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from maestra.learning.planning import Fluent, Operator, OperatorName, PlanningProblem


@dataclass(frozen=True, slots=True)
class ReachesGoal:
    """Every step can be taken, and the goal holds at the end."""


@dataclass(frozen=True, slots=True)
class UnknownStep:
    """Step `step` (from 1) is no operator of the problem."""

    step: int
    operator: OperatorName


@dataclass(frozen=True, slots=True)
class ImpossibleStep:
    """Step `step` (from 1) needs what is not true there."""

    step: int
    operator: OperatorName
    missing: frozenset[Fluent]


@dataclass(frozen=True, slots=True)
class MissesGoal:
    """Every step can be taken, but the goal does not hold at the end."""

    missing: frozenset[Fluent]


PlanVerdict: TypeAlias = ReachesGoal | UnknownStep | ImpossibleStep | MissesGoal


class InvalidPlanError(ValueError):
    """A plan that was taken for a valid one and is not."""

    def __init__(self, verdict: PlanVerdict) -> None:
        """Say what is wrong with the plan."""
        super().__init__(str(verdict))
        self.verdict = verdict


def validate(problem: PlanningProblem, plan: Sequence[OperatorName]) -> PlanVerdict:
    """Replay `plan` from the initial state and say where it fails first, if it does."""
    operators = {operator.name: operator for operator in problem.operators}
    state = set(problem.initial)
    for step, name in enumerate(plan, start=1):
        operator = operators.get(name)
        if operator is None:
            return UnknownStep(step, name)
        if not operator.needs <= state:
            return ImpossibleStep(step, name, operator.needs - state)
        state -= operator.deletes
        state |= operator.adds
    return ReachesGoal() if problem.goal <= state else MissesGoal(problem.goal - state)


def in_order_of_need(
    initial: frozenset[Fluent], operators: Sequence[Operator]
) -> Iterator[Operator]:
    """Those of `operators` that can be taken if nothing is deleted, each after what it needs.

    Linear in the fluents mentioned.
    """
    missing = {operator.name: set(operator.needs - initial) for operator in operators}
    waiting: dict[Fluent, list[Operator]] = {}
    for operator in operators:
        for fluent in missing[operator.name]:
            waiting.setdefault(fluent, []).append(operator)
    ready = deque(operator for operator in operators if not missing[operator.name])
    while ready:
        operator = ready.popleft()
        yield operator
        for fluent in operator.adds:
            for other in waiting.pop(fluent, ()):
                missing[other.name].discard(fluent)
                if not missing[other.name]:
                    ready.append(other)


def out_of_reach(problem: PlanningProblem) -> frozenset[Fluent]:
    """What of the goal no plan reaches, even if operators deleted nothing.

    Not empty: there is no plan. Empty: there is one if no operator deletes anything.
    """
    reached = set(problem.initial)
    for operator in in_order_of_need(problem.initial, problem.operators):
        reached |= operator.adds
    return problem.goal - reached


@dataclass(frozen=True, slots=True)
class Minimised:
    """A plan without superfluous operators, and how many were dropped."""

    plan: tuple[OperatorName, ...]
    superfluous: int


def minimise(problem: PlanningProblem, plan: Sequence[OperatorName]) -> Minimised:
    """Drop operators from a valid `plan`, keeping its order, until none can be dropped alone.

    Last operators first, so that what only served a dropped one goes too. Without deletes one
    pass finds them all; with deletes passes repeat until one drops nothing. A pass costs
    O(S log S) for a plan of S fluents mentioned.

    Raises:
        InvalidPlanError: `plan` is not a plan of `problem`.
    """
    verdict = validate(problem, plan)
    if not isinstance(verdict, ReachesGoal):
        raise InvalidPlanError(verdict)
    operators = {operator.name: operator for operator in problem.operators}
    history = _History(problem, [operators[name] for name in plan])
    kept = list(range(len(plan)))
    while True:
        dropped = {position for position in reversed(kept) if history.drop(position)}
        if not dropped:
            break
        kept = [position for position in kept if position not in dropped]
    return Minimised(tuple(plan[position] for position in kept), len(plan) - len(kept))


@dataclass(slots=True)
class _Story:
    """What happens to one fluent, as sorted positions in the plan; -1 is the initial state."""

    changes: list[int] = field(default_factory=list[int])
    """Where it is added or deleted."""
    adders: set[int] = field(default_factory=set[int])
    """Which of the changes add it."""
    uses: list[int] = field(default_factory=list[int])
    """Where it is needed; the goal needs it after the last operator."""


class _History:
    """A valid plan seen from its fluents, from which operators are dropped one by one."""

    def __init__(self, problem: PlanningProblem, steps: Sequence[Operator]) -> None:
        self._steps = steps
        self._stories: defaultdict[Fluent, _Story] = defaultdict(_Story)
        for fluent in problem.initial:
            self._change(fluent, -1, adds=True)
        for position, operator in enumerate(steps):
            for fluent in operator.adds:
                self._change(fluent, position, adds=True)
            for fluent in operator.deletes:
                self._change(fluent, position, adds=False)
            for fluent in operator.needs:
                self._stories[fluent].uses.append(position)
        for fluent in problem.goal:
            self._stories[fluent].uses.append(len(steps))

    def drop(self, position: int) -> bool:
        """Drop the operator at `position` if the plan stays valid; say whether it did."""
        operator = self._steps[position]
        if any(self._is_needed(fluent, position) for fluent in operator.adds):
            return False
        for fluent in operator.adds | operator.deletes:
            story = self._stories[fluent]
            del story.changes[bisect_left(story.changes, position)]
            story.adders.discard(position)
        for fluent in operator.needs:
            uses = self._stories[fluent].uses
            del uses[bisect_left(uses, position)]
        return True

    def _is_needed(self, fluent: Fluent, position: int) -> bool:
        """Whether something needs `fluent` after `position` and only this adder gives it."""
        story = self._stories[fluent]
        place = bisect_left(story.changes, position)
        if place > 0 and story.changes[place - 1] in story.adders:
            return False
        use = bisect_right(story.uses, position)
        if use == len(story.uses):
            return False
        # A use at the very next change counts: an operator needs before it changes.
        is_last = place + 1 == len(story.changes)
        return is_last or story.uses[use] <= story.changes[place + 1]

    def _change(self, fluent: Fluent, position: int, *, adds: bool) -> None:
        story = self._stories[fluent]
        story.changes.append(position)
        if adds:
            story.adders.add(position)
