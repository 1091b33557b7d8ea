"""clingo as the embedded planner: a plan of fewest operators for problems without deletes.

Without deletes, order follows from need alone: a plan is a set of operators each of which gets
what it needs from the initial state or from others of the set, without going round in circles.
That is what a stable model of these rules is, for each operator o and fluent f:

    {o} :- what o needs.    f :- o, for each o that adds f.    :- not g, for each g of the goal.

and the model of fewest operators is asked for. Finding it is NP-hard in general; on the
problems of `learning.compiled` propagation alone finds it.

clingo works inside this process. We measured what the alternative costs: a process of its own
needs 70 ms to start Python and clingo, three times what the paper's largest lesson takes to be
solved. So the limits are kept from outside the solver's loop: it runs in a thread of clingo's,
while we look every few milliseconds at the clock and at the memory of this process, and cancel
it, which takes clingo less than 50 ms. Two consequences:

- The memory limit is on how much this process grows. What other threads allocate meanwhile
  counts as clingo's; what was freed before, and is used again, does not count.
- The step in which clingo prepares the rules cannot be cancelled. It takes a third of the time
  we need to state them, and is not begun if the memory it will need, by measure, is not there.

clingo: https://potassco.org/clingo
"""

from __future__ import annotations

import resource
import time
from pathlib import Path
from typing import TYPE_CHECKING, Final

from maestra.learning.planning import (
    NoEngine,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Solved,
    Unsupported,
)
from maestra.learning.plans import in_order_of_need

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable

    from clingo.backend import Backend
    from clingo.control import Control

    from maestra.learning.planning import (
        Fluent,
        Limits,
        Operator,
        Outcome,
        PlanningProblem,
    )

ENGINE: Final = "clingo"
_WATCH_S: Final = 0.01
"""How often we look at the limits while clingo works; an answer ends the wait at once."""
WATCH_OPERATORS: Final = 500
"""How often we look at them while stating the rules: every ten or twenty milliseconds."""
PREPARED_TO_STATED: Final = 3
"""Memory once clingo has prepared the rules against memory once they are stated; measured 1.6
with 100,000 rules, 2.7 with 3,000,000."""
_QUIET: Final = ("--warn=none",)
_STATM: Final = Path("/proc/self/statm")
_PAGE: Final = resource.getpagesize()


class _LimitReachedError(Exception):
    """Leaves clingo's loops with the outcome."""

    def __init__(self, outcome: OutOfTime | OutOfMemory) -> None:
        super().__init__(outcome)
        self.outcome = outcome


class ClingoPlanner:
    """Solves problems without deletes, with as few operators as possible, in this process."""

    @property
    def name(self) -> str:
        """What users call it."""
        return "clingo"

    @property
    def prefers_whole(self) -> bool:
        """Each call costs it a millisecond, the size of a problem little."""
        return True

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        """A shortest plan for `problem`; see `Planner`."""
        try:
            import clingo  # before the watch begins, so that loading it does not count
        except ImportError as error:
            return NoEngine(ENGINE, f"its Python package cannot be imported: {error}")
        if not problem.deletes_nothing:
            return Unsupported(ENGINE, "an operator deletes a fluent; this encoding has no order")
        watch = Watch(limits)
        try:
            control = clingo.Control(_QUIET)
            chosen = _fewest(control, _state_rules(control, problem, watch), watch)
        except _LimitReachedError as reached:
            return reached.outcome
        if chosen is None:
            return ProvenUnsolvable(ENGINE, watch.seconds)
        plan = in_order_of_need(problem.initial, chosen)
        return Solved(tuple(operator.name for operator in plan), ENGINE, watch.seconds)


class Watch:
    """The limits of one call, measured from when it is made."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._started = time.perf_counter()
        self._memory_at_start = resident_bytes()

    @property
    def seconds(self) -> float:
        """How long the call has taken."""
        return time.perf_counter() - self._started

    def check(self, memory_factor: int = 1) -> None:
        """Raise when a limit is reached, for memory by `memory_factor` times what was taken."""
        seconds = self.seconds
        if seconds >= self._limits.time_s:
            raise _LimitReachedError(OutOfTime(ENGINE, seconds))
        taken = resident_bytes() - self._memory_at_start
        if taken * memory_factor > self._limits.memory_mb * 2**20:
            raise _LimitReachedError(OutOfMemory(ENGINE, seconds))


def resident_bytes() -> int:
    """What this process holds in memory."""
    # The second number is the pages in memory now; getrusage only tells the most there ever were.
    return int(_STATM.read_bytes().split()[1]) * _PAGE


def _state_rules(control: Control, problem: PlanningProblem, watch: Watch) -> dict[int, Operator]:
    """Tell clingo the rules; returns the operators by their atoms."""
    with control.backend() as backend:
        rules = _Rules(backend, problem.initial)
        for count, operator in enumerate(problem.operators, start=1):
            rules.choose(operator)
            if count % WATCH_OPERATORS == 0:
                watch.check()
        for fluent in problem.goal - problem.initial:
            backend.add_rule([], [-rules.atom(fluent)])
        backend.add_minimize(0, [(atom, 1) for atom in rules.operators])
    watch.check(PREPARED_TO_STATED)
    return rules.operators


class _Rules:
    """The rules as clingo's atoms: positive integers, negated when false is meant."""

    def __init__(self, backend: Backend, initial: Collection[Fluent]) -> None:
        self._backend = backend
        self._initial = initial
        self._atoms: dict[Fluent, int] = {}
        self.operators: dict[int, Operator] = {}

    def atom(self, fluent: Fluent) -> int:
        if fluent not in self._atoms:
            self._atoms[fluent] = self._backend.add_atom()
        return self._atoms[fluent]

    def choose(self, operator: Operator) -> None:
        atom = self._backend.add_atom()
        self.operators[atom] = operator
        self._backend.add_rule([atom], self._new(operator.needs), choice=True)
        for added in self._new(operator.adds):
            self._backend.add_rule([added], [atom])

    def _new(self, fluents: Iterable[Fluent]) -> list[int]:
        return [self.atom(fluent) for fluent in fluents if fluent not in self._initial]


def _fewest(
    control: Control, operators: dict[int, Operator], watch: Watch
) -> list[Operator] | None:
    """The operators of an optimal model; None if there is no model."""
    chosen: list[Operator] | None = None
    # Leaving the handle cancels the search and waits for clingo's thread.
    with control.solve(yield_=True, async_=True) as handle:
        while True:
            watch.check()
            handle.resume()
            while not handle.wait(_WATCH_S):
                watch.check()
            model = handle.model()
            if model is None:
                return chosen
            chosen = [operator for atom, operator in operators.items() if model.is_true(atom)]
