import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from maestra.learning.compiled import ActionName, DeletionTask, LiteralName, Transition
from maestra.learning.compiled import compile_problem as compile_whole
from maestra.learning.planning import (
    Fluent,
    Limits,
    NoEngine,
    Operator,
    OperatorName,
    Outcome,
    OutOfMemory,
    OutOfTime,
    PlanningProblem,
    ProvenUnsolvable,
    Solved,
)
from maestra.learning.planning_pddl import compiled_pddl, grounded_pddl
from maestra.planners import fast_downward
from maestra.planners.fast_downward import BINARY_VARIABLE, FastDownwardPlanner, find_binary, sas
from tests.learning.planning_strategies import deleted_directly
from tests.planners.conftest import make_program

AMPLE = Limits(60.0, 2_000)


def fluents(names: str) -> frozenset[Fluent]:
    return frozenset(Fluent(name) for name in names.split())


DOOR = PlanningProblem(
    "door",
    fluents("closed"),
    fluents("inside"),
    (
        Operator(OperatorName("wait"), fluents("closed"), fluents("closed")),
        Operator(OperatorName("open"), fluents("closed"), fluents("ajar"), fluents("closed")),
        Operator(OperatorName("enter"), fluents("ajar"), fluents("inside"), fluents("outside")),
    ),
)


def test_a_problem_is_written_in_sas_plus_version_3() -> None:
    variables = "".join(
        f"begin_variable\nv{n}\n-1\n2\nAtom v{n}()\nNegatedAtom v{n}()\nend_variable\n"
        for n in range(4)  # closed, inside, ajar, outside
    )
    assert sas(DOOR) == (
        "begin_version\n3\nend_version\nbegin_metric\n0\nend_metric\n4\n"
        + variables
        + "0\nbegin_state\n0\n1\n1\n1\nend_state\nbegin_goal\n1\n1 0\nend_goal\n"
        # `wait` changes nothing and is left out.
        "2\n"
        "begin_operator\n1\n0\n2\n0 0 0 1\n0 2 -1 0\n1\nend_operator\n"
        "begin_operator\n2\n1\n2 0\n2\n0 1 -1 0\n0 3 -1 1\n1\nend_operator\n"
        "0\n"
    )


def test_the_program_named_by_the_environment_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(BINARY_VARIABLE, "/somewhere/downward")
    assert find_binary() == Path("/somewhere/downward")


def test_a_program_that_is_not_where_it_was_named_is_no_engine(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(BINARY_VARIABLE, "/somewhere/downward")
    outcome = FastDownwardPlanner().solve(DOOR, AMPLE)
    assert isinstance(outcome, NoEngine)
    assert "/somewhere/downward" in outcome.why


def test_the_installed_package_carries_the_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(BINARY_VARIABLE, raising=False)
    found = find_binary()
    assert found is not None
    assert found.name == "downward"
    assert "up_fast_downward" in found.parts


@pytest.mark.parametrize("package", ["no_such_package", "pytest"])
def test_without_the_package_it_is_looked_for_on_the_path(
    package: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(BINARY_VARIABLE, raising=False)
    monkeypatch.setattr(fast_downward, "_PACKAGE", package)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find_binary() is None
    program = make_program(tmp_path / "downward", "true")
    assert find_binary() == program


SAW_EVERYTHING = "echo 'Completely explored state space -- no solution!'"


@pytest.mark.parametrize(
    ("does", "kind"),
    [
        ("exit 11", ProvenUnsolvable),
        (f"{SAW_EVERYTHING}; exit 12", ProvenUnsolvable),
        ("exit 12", NoEngine),  # gave up, which proves nothing
        ("exit 22", OutOfMemory),
        ("exit 23", OutOfTime),
        ("exit 24", OutOfTime),
        ("exit 33", NoEngine),
        ("kill -SEGV $$", NoEngine),
        ("exit 0", NoEngine),  # and no plan
        ("echo '(1)' > plan", NoEngine),
        ("echo '(2)' > plan", NoEngine),
        ("echo '(99)' > plan", NoEngine),
        ("echo '(enter)' > plan", NoEngine),
        ("printf '(1)\\n(2)\\n; cost = 2 (unit cost)\\n' > plan", Solved),
    ],
)
def test_each_end_of_the_program_has_its_outcome(
    does: str, kind: type[Outcome], tmp_path: Path
) -> None:
    program = make_program(tmp_path / "downward", does)
    assert isinstance(FastDownwardPlanner(program).solve(DOOR, AMPLE), kind)


def test_a_broken_engine_is_named_with_its_last_words(tmp_path: Path) -> None:
    program = make_program(tmp_path / "downward", "echo 'Usage error occurred.'; exit 33")
    outcome = FastDownwardPlanner(program).solve(DOOR, AMPLE)
    assert outcome == NoEngine("Fast Downward", "ended with code 33: Usage error occurred.")


L11, L12, ODD = (LiteralName(name) for name in ("to = l11", "to = l12", "odd(v)"))
M19, M23 = ActionName("move-v19-t1"), ActionName("move-v23-t2")
TASK = DeletionTask(
    {M19: frozenset({L11, L12, ODD}), M23: frozenset({L11, L12, ODD})},
    (
        (Transition(M19, frozenset({L12})), Transition(M23, frozenset({L11}))),
        (Transition(M19, frozenset({L12, ODD})), Transition(M23, frozenset({L11}))),
    ),
)


def plan_of_the_whole_planner(domain: str, problem: str, folder: Path) -> list[list[str]]:
    """Fast Downward with its own translator, asked for a shortest plan."""
    binary = find_binary()
    assert binary is not None
    driver = next(p for p in binary.parents if p.name == "downward") / "fast-downward.py"
    (folder / "domain.pddl").write_text(domain, encoding="utf-8")
    (folder / "problem.pddl").write_text(problem, encoding="utf-8")
    files = ["--plan-file", "plan", "domain.pddl", "problem.pddl"]
    subprocess.run(
        [sys.executable, str(driver), *files, "--search", "astar(lmcut())"],
        check=True,
        capture_output=True,
        cwd=folder,
        timeout=60,
    )
    lines = (folder / "plan").read_text().splitlines()
    shutil.rmtree(folder)
    return [line.strip("()").split() for line in lines if not line.startswith(";")]


def test_its_translator_reads_the_audited_text_and_the_shortest_plan_is_the_deletion(
    tmp_path: Path,
) -> None:
    text = compiled_pddl(TASK)
    folder = tmp_path / "audit"
    folder.mkdir()
    plan = plan_of_the_whole_planner(text.domain, text.problem, folder)
    deleted = {
        (text.actions[step[1]], text.literals[step[2]])
        for step in plan
        if step[0] == "delete-literal"
    }
    expected = deleted_directly(TASK)
    assert deleted == {(action, name) for action, gone in expected.items() for name in gone}
    assert len(plan) == len(deleted) + 4


def test_its_translator_reads_the_grounded_text_with_the_same_shortest_plan(
    tmp_path: Path,
) -> None:
    problem = compile_whole(TASK)
    text = grounded_pddl(problem)
    folder = tmp_path / "grounded"
    folder.mkdir()
    plan = plan_of_the_whole_planner(text.domain, text.problem, folder)
    names = [text.operators[name] for (name,) in plan]
    deleted = {
        f"delete({action!r}, {name!r})"
        for action, gone in deleted_directly(TASK).items()
        for name in gone
    }
    assert {name for name in names if name.startswith("delete")} == deleted
    assert len(plan) == len(deleted) + 4
