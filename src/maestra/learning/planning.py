"""Classical planning as learning needs it: problems, named outcomes, the Planner port.

A problem is propositional STRIPS: a state is the set of fluents that are true; an operator
needs fluents, deletes fluents and adds fluents; a plan is a sequence of operators that leads
from the initial state to one where the goal holds. Who solves it is behind the `Planner` port;
`maestra.planners` has the engines. What a plan is worth is decided in `plans`, not by engines.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, NewType, Protocol, TypeAlias

from maestra.core.faults import Fault, refuse

if TYPE_CHECKING:
    from collections.abc import Iterator

Fluent = NewType("Fluent", str)
OperatorName = NewType("OperatorName", str)


@dataclass(frozen=True, slots=True)
class Operator:
    """One step a plan may take, at cost 1; it may be taken any number of times."""

    name: OperatorName
    needs: frozenset[Fluent]
    """What must be true before it."""
    adds: frozenset[Fluent]
    """What is true after it."""
    deletes: frozenset[Fluent] = frozenset()
    """What is false after it; shares nothing with `adds`."""


@dataclass(frozen=True, slots=True)
class PlanningProblem:
    """From `initial`, reach a state in which every fluent of `goal` is true.

    Raises:
        InvalidError: an operator has no name or another's, adds what it deletes, or a fluent
            has no name; with every fault.
    """

    name: str
    initial: frozenset[Fluent]
    goal: frozenset[Fluent]
    operators: tuple[Operator, ...]

    def __post_init__(self) -> None:
        """Refuse a problem whose plans could be read in two ways."""
        refuse([*self._operator_faults(), *self._fluent_faults()])

    @property
    def fluents(self) -> tuple[Fluent, ...]:
        """Every fluent spoken of, each once: the initial ones, the goal's, the operators'."""
        seen: dict[Fluent, None] = dict.fromkeys(sorted(self.initial))
        seen.update(dict.fromkeys(sorted(self.goal)))
        for operator in self.operators:
            for part in (operator.needs, operator.adds, operator.deletes):
                seen.update(dict.fromkeys(sorted(part)))
        return tuple(seen)

    @property
    def deletes_nothing(self) -> bool:
        """Whether what is true once stays true, so that order hardly matters."""
        return not any(operator.deletes for operator in self.operators)

    def _operator_faults(self) -> Iterator[Fault]:
        counts = Counter(operator.name for operator in self.operators)
        for name, count in counts.items():
            if count > 1:
                yield Fault("operators", f"{count} operators named {name!r}", "different names")
        for operator in self.operators:
            where = f"operators[{operator.name!r}]"
            if not operator.name.strip():
                yield Fault(where, "no name", "a name that is not blank")
            for fluent in sorted(operator.adds & operator.deletes):
                yield Fault(where, f"{fluent!r} both added and deleted", "one of the two")

    def _fluent_faults(self) -> Iterator[Fault]:
        mentioned = set(self.initial | self.goal)
        for operator in self.operators:
            mentioned.update(operator.needs, operator.adds, operator.deletes)
        for fluent in sorted(name for name in mentioned if not name.strip()):
            yield Fault("fluents", f"{fluent!r}", "a name that is not blank")


@dataclass(frozen=True, slots=True)
class Limits:
    """How long and how much an engine may take for one call.

    Raises:
        InvalidError: not a positive finite time, or less than a megabyte.
    """

    time_s: float
    """Wall-clock time."""
    memory_mb: int
    """What the engine may allocate, in units of 2**20 bytes."""

    def __post_init__(self) -> None:
        """Refuse limits nothing can keep."""
        faults: list[Fault] = []
        if not (math.isfinite(self.time_s) and self.time_s > 0):
            faults.append(Fault("time_s", f"{self.time_s}", "a positive, finite number"))
        if self.memory_mb < 1:
            faults.append(Fault("memory_mb", f"{self.memory_mb}", "at least 1"))
        refuse(faults)


@dataclass(frozen=True, slots=True)
class Solved:
    """There is a plan, and here is one."""

    plan: tuple[OperatorName, ...]
    engine: str
    seconds: float


@dataclass(frozen=True, slots=True)
class ProvenUnsolvable:
    """The engine proved that there is no plan; giving up is `OutOfTime` or `Unsupported`."""

    engine: str
    seconds: float


@dataclass(frozen=True, slots=True)
class OutOfTime:
    """The time limit passed before an answer."""

    engine: str
    seconds: float


@dataclass(frozen=True, slots=True)
class OutOfMemory:
    """The memory limit was reached before an answer."""

    engine: str
    seconds: float


@dataclass(frozen=True, slots=True)
class Unsupported:
    """The engine is sound and present, but not made for this problem."""

    engine: str
    why: str


@dataclass(frozen=True, slots=True)
class NoEngine:
    """No working engine: not installed, not startable, or it broke down; `why` says which."""

    engine: str
    why: str


Unsolved: TypeAlias = ProvenUnsolvable | OutOfTime | OutOfMemory | Unsupported | NoEngine
Outcome: TypeAlias = Solved | Unsolved


class Planner(Protocol):
    """Port: finds plans. Adapters run one contract suite (tests/planners/test_contract.py)."""

    @property
    def name(self) -> str:
        """What users call this planner, for example `clingo`."""
        ...

    @property
    def prefers_whole(self) -> bool:
        """Whether one large problem suits it better than the small ones it falls into."""
        ...

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        """A plan for `problem`, or the named reason why there is none.

        The plan is valid (`plans.validate`), not necessarily short. When the call returns or
        raises, no process, thread or file of the engine is left.
        """
        ...
