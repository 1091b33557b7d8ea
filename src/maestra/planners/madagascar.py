"""Jussi Rintanen's Madagascar, the planner of the paper: `Mp`, `MpC` or `M`, given PDDL.

A SAT planner: it asks for plans of more and more steps, each of which may hold several
operators. No registry carries it and it has no licence file, so nobody but the user can bring
it; this adapter is written from its source (output in `fprintplan`, options in `main`, grammar
in `parser.y`), and tested with a double that behaves so.

It cannot prove that there is no plan. Where the goal is out of reach even without deletes,
which decides all problems of `learning.compiled`, this adapter proves it before asking.
"""

from __future__ import annotations

import os
import re
import shutil
import signal
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Final

from maestra.learning.planning import (
    NoEngine,
    OperatorName,
    OutOfMemory,
    ProvenUnsolvable,
    Solved,
    Unsupported,
)
from maestra.learning.planning_pddl import grounded_pddl
from maestra.learning.plans import out_of_reach
from maestra.planners.engine_process import (
    Ended,
    checked,
    engine_folder,
    last_line,
    run,
    without_answer,
)

if TYPE_CHECKING:
    from maestra.learning.planning import Limits, Outcome, PlanningProblem

ENGINE: Final = "Madagascar"
BINARY_VARIABLE: Final = "MAESTRA_MADAGASCAR"
"""Environment variable that may name the program: a path, or a name on the PATH."""
VARIANTS: Final = ("Mp", "MpC", "M")
"""Its programs, in the order in which they are looked for on the PATH."""
_PLAN_FILE: Final = "plan"
_NOT_FOUND: Final = "PLAN NOT FOUND"
# MpC says so when no further horizon fits in its memory limit.
_NO_MEMORY: Final = "Was not allowed to increase horizon length"
# It does not look at what malloc returns (`statmalloc`), so a refusal shows as one of these.
_DEATHS_BY_MEMORY: Final = (-signal.SIGSEGV, -signal.SIGBUS, -signal.SIGABRT)
_PLAN_LINE: Final = re.compile(r"\d+ : \((?P<action>[^ )]+)[^)]*\)")
"""A line of a plan in its IPC format; operators of one step share the number."""


class MadagascarPlanner:
    """Solves STRIPS problems by SAT; its plans may hold much that is not needed (M most)."""

    def __init__(self, binary: Path | None = None) -> None:
        """Use `binary`, or look for one at each call.

        Looked for: what `MAESTRA_MADAGASCAR` names, and only that if it is set; else `Mp`,
        `MpC` and `M` on the PATH.
        """
        self._binary = binary

    @property
    def name(self) -> str:
        """What users call it."""
        return "madagascar"

    @property
    def prefers_whole(self) -> bool:
        """As the paper poses it."""
        return True

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        """A plan for `problem`; see `Planner`."""
        binary = self._binary or find_binary()
        if binary is None:
            names = ", ".join(VARIANTS)
            why = f"none of {names} is on the PATH, and {BINARY_VARIABLE} names none"
            return NoEngine(ENGINE, why)
        engine = f"{ENGINE} {binary.name}"
        if out_of_reach(problem):
            return ProvenUnsolvable(engine, 0.0)
        if problem.goal <= problem.initial:
            return Solved((), engine, 0.0)
        return _ask(binary, engine, problem, limits)


def find_binary() -> Path | None:
    """Where one of its programs is, if one is anywhere."""
    named = os.environ.get(BINARY_VARIABLE)
    for candidate in (named,) if named else VARIANTS:
        if found := shutil.which(candidate):
            return Path(found)
    return None


def _ask(binary: Path, engine: str, problem: PlanningProblem, limits: Limits) -> Outcome:
    text = grounded_pddl(problem)
    with engine_folder() as folder:
        (folder / "domain.pddl").write_text(text.domain, encoding="utf-8")
        (folder / "problem.pddl").write_text(text.problem, encoding="utf-8")
        options = ["-Q", "-o", _PLAN_FILE, "-m", str(limits.memory_mb)]
        ran = run([str(binary), *options, "domain.pddl", "problem.pddl"], folder, limits)
        if not isinstance(ran, Ended):
            return without_answer(ran, engine)
        plan_file = folder / _PLAN_FILE
        if plan_file.is_file():
            plan = tuple(_read_plan(plan_file.read_text(encoding="utf-8"), text.operators))
            return checked(problem, plan, engine, ran.seconds)
        return _no_plan(ran, engine)


def _no_plan(ended: Ended, engine: str) -> Outcome:
    if _NOT_FOUND in ended.output:
        return Unsupported(engine, "found no plan of its longest length, which proves nothing")
    if _NO_MEMORY in ended.output or ended.code in _DEATHS_BY_MEMORY:
        return OutOfMemory(engine, ended.seconds)
    return NoEngine(engine, f"ended with code {ended.code}: {last_line(ended.output)}")


def _read_plan(text: str, operators: Mapping[str, OperatorName]) -> Iterator[OperatorName]:
    for line in _PLAN_LINE.finditer(text):
        action = line["action"]
        yield operators.get(action, OperatorName(action))
