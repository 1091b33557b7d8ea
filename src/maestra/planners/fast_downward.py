"""Fast Downward as a planner: its search program, given SAS+ written directly.

The translator is left out: starting it for each action would cost more than the search. Each
fluent becomes a variable with two values. The search is lazy greedy with the FF heuristic:
any plan, soon; `plans.minimise` is there for what is too much.

Fast Downward: https://www.fast-downward.org; the exit codes are those of its
driver/returncodes.py.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

from maestra.learning.planning import (
    NoEngine,
    OperatorName,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Solved,
)
from maestra.planners.engine_process import (
    Ended,
    checked,
    engine_folder,
    last_line,
    run,
    without_answer,
)

if TYPE_CHECKING:
    from maestra.learning.planning import Fluent, Limits, Operator, Outcome, PlanningProblem

ENGINE: Final = "Fast Downward"
BINARY_VARIABLE: Final = "MAESTRA_FAST_DOWNWARD"
"""Environment variable that may name the program."""
_PACKAGE: Final = "up_fast_downward"
_IN_PACKAGE: Final = "downward/builds/release/bin/downward"
_ON_PATH: Final = "downward"
# The heuristic finds dead ends for certain on tasks without axioms, so a search that has seen
# everything proves that there is no plan. The heuristic is written out twice because releases
# differ in how one is named for use in several places.
_SEARCH: Final = "lazy_greedy([ff()],preferred=[ff()])"
_PLAN_FILE: Final = "plan"

# From its driver/returncodes.py.
_SOLVED: Final = 0
_UNSOLVABLE: Final = 11
_UNSOLVED_INCOMPLETE: Final = 12
_OUT_OF_MEMORY: Final = 22
_OUT_OF_TIME: Final = 23
_OUT_OF_MEMORY_AND_TIME: Final = 24
_SAW_EVERYTHING: Final = "Completely explored state space -- no solution!"
"""What older releases say, with code 12, when the search has proven it."""

_TRUE: Final = 0
_FALSE: Final = 1


class FastDownwardPlanner:
    """Solves every STRIPS problem in reach of a greedy search; plans may be longer than needed."""

    def __init__(self, binary: Path | None = None) -> None:
        """Use `binary`, or look for one at each call.

        Looked for: what `MAESTRA_FAST_DOWNWARD` names; the one in the installed package
        up-fast-downward; `downward` on the PATH.
        """
        self._binary = binary

    @property
    def name(self) -> str:
        """What users call it."""
        return "fast-downward"

    @property
    def prefers_whole(self) -> bool:
        """Its heuristic is worked out anew at each step: half a second by action, 4 s whole."""
        return False

    def solve(self, problem: PlanningProblem, limits: Limits) -> Outcome:
        """A plan for `problem`; see `Planner`."""
        binary = self._binary or find_binary()
        if binary is None:
            why = f"not found; install maestra[planning] or name it in {BINARY_VARIABLE}"
            return NoEngine(ENGINE, why)
        if problem.goal <= problem.initial:
            return Solved((), ENGINE, 0.0)  # it refuses a problem without a goal
        with engine_folder() as folder:
            command = [str(binary), "--internal-plan-file", _PLAN_FILE, "--search", _SEARCH]
            ran = run(command, folder, limits, given=sas(problem))
            if isinstance(ran, Ended):
                return _outcome(problem, ran, folder / _PLAN_FILE)
            return without_answer(ran, ENGINE)


def find_binary() -> Path | None:
    """Where the search program is, if it is anywhere."""
    if named := os.environ.get(BINARY_VARIABLE):
        return Path(named)
    # find_spec does not import the package, which would pull in unified-planning.
    spec = importlib.util.find_spec(_PACKAGE)
    for folder in (spec.submodule_search_locations or ()) if spec else ():
        if (packaged := Path(folder, _IN_PACKAGE)).is_file():
            return packaged
    on_path = shutil.which(_ON_PATH)
    return Path(on_path) if on_path else None


def sas(problem: PlanningProblem) -> str:
    """`problem` in SAS+, format version 3; operator number n is called `n`."""
    variables = {fluent: number for number, fluent in enumerate(problem.fluents)}
    operators = [
        block
        for number, operator in enumerate(problem.operators)
        if (block := _operator_block(number, operator, variables))
    ]
    lines = ["begin_version", "3", "end_version", "begin_metric", "0", "end_metric"]
    lines.append(str(len(variables)))
    for number in variables.values():
        lines += ["begin_variable", f"v{number}", "-1", "2", f"Atom v{number}()"]
        lines += [f"NegatedAtom v{number}()", "end_variable"]
    state = [_TRUE if fluent in problem.initial else _FALSE for fluent in variables]
    lines += ["0", "begin_state", *map(str, state), "end_state"]
    goal = sorted(variables[fluent] for fluent in problem.goal)
    lines += ["begin_goal", str(len(goal)), *(f"{v} {_TRUE}" for v in goal), "end_goal"]
    lines.append(str(len(operators)))
    for block in operators:
        lines += block
    return "\n".join([*lines, "0", ""])


def _operator_block(
    number: int, operator: Operator, variables: dict[Fluent, int]
) -> list[str] | None:
    """The operator's lines; None if it changes nothing, which the format does not allow."""
    prevails = [variables[fluent] for fluent in operator.needs - operator.deletes]
    effects = [
        # In order: no conditions, which variable, value before (-1: any), value after.
        *(f"0 {variables[fluent]} -1 {_TRUE}" for fluent in operator.adds - operator.needs),
        *(f"0 {variables[fluent]} -1 {_FALSE}" for fluent in operator.deletes - operator.needs),
        *(
            f"0 {variables[fluent]} {_TRUE} {_FALSE}"
            for fluent in operator.deletes & operator.needs
        ),
    ]
    if not effects:
        return None
    return [
        "begin_operator",
        str(number),
        str(len(prevails)),
        *(f"{variable} {_TRUE}" for variable in sorted(prevails)),
        str(len(effects)),
        *sorted(effects),
        "1",
        "end_operator",
    ]


def _outcome(problem: PlanningProblem, ended: Ended, plan_file: Path) -> Outcome:
    if ended.code == _SOLVED and plan_file.is_file():
        text = plan_file.read_text(encoding="ascii", errors="replace")
        return checked(problem, tuple(_read_plan(problem, text)), ENGINE, ended.seconds)
    proven = ended.code == _UNSOLVED_INCOMPLETE and _SAW_EVERYTHING in ended.output
    if ended.code == _UNSOLVABLE or proven:
        return ProvenUnsolvable(ENGINE, ended.seconds)
    if ended.code == _OUT_OF_MEMORY:
        return OutOfMemory(ENGINE, ended.seconds)
    if ended.code in (_OUT_OF_TIME, _OUT_OF_MEMORY_AND_TIME):
        return OutOfTime(ENGINE, ended.seconds)
    return NoEngine(ENGINE, f"ended with code {ended.code}: {last_line(ended.output)}")


def _read_plan(problem: PlanningProblem, text: str) -> Iterator[OperatorName]:
    """The operators of a plan file: a name in parentheses on each line, `;` before a remark."""
    for line in text.splitlines():
        word = line.strip().strip("()").strip()
        if not word or word.startswith(";"):
            continue
        known = word.isdecimal() and int(word) < len(problem.operators)
        yield problem.operators[int(word)].name if known else OperatorName(word)
