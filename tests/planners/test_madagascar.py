from pathlib import Path

import pytest

from maestra.learning.planning import (
    Fluent,
    Limits,
    NoEngine,
    Operator,
    OperatorName,
    Outcome,
    OutOfMemory,
    PlanningProblem,
    Solved,
    Unsupported,
)
from maestra.planners.madagascar import BINARY_VARIABLE, MadagascarPlanner, find_binary
from tests.planners.conftest import make_program

AMPLE = Limits(60.0, 2_000)


def fluents(names: str) -> frozenset[Fluent]:
    return frozenset(Fluent(name) for name in names.split())


def problem(name: str, *operators: Operator, goal: str = "a") -> PlanningProblem:
    return PlanningProblem(name, frozenset(), fluents(goal), operators)


ONE = Operator(OperatorName("o0"), frozenset(), fluents("a"))
TWO = Operator(OperatorName("o1"), frozenset(), fluents("b"))
THREE = Operator(OperatorName("o2"), fluents("a b"), fluents("c"))


def test_several_operators_of_one_step_are_taken_one_after_another() -> None:
    outcome = MadagascarPlanner().solve(problem("steps", ONE, TWO, THREE, goal="c"), AMPLE)
    assert isinstance(outcome, Solved)
    assert outcome.plan == ("o0", "o1", "o2")
    assert outcome.engine == "Madagascar Mp"


@pytest.mark.parametrize(
    ("name", "kind"),
    [("cramped", OutOfMemory), ("mumble", NoEngine), ("lie", NoEngine), ("plain", Solved)],
)
def test_each_end_of_the_program_has_its_outcome(name: str, kind: type[Outcome]) -> None:
    assert isinstance(MadagascarPlanner().solve(problem(name, ONE), AMPLE), kind)


def test_a_broken_engine_is_named_with_its_last_words() -> None:
    outcome = MadagascarPlanner().solve(problem("mumble", ONE), AMPLE)
    assert outcome == NoEngine("Madagascar Mp", "ended with code 3: a table")


def test_a_plan_not_found_proves_nothing() -> None:
    either = (
        Operator(OperatorName("left"), frozenset(), fluents("l"), fluents("r")),
        Operator(OperatorName("right"), frozenset(), fluents("r"), fluents("l")),
    )
    outcome = MadagascarPlanner().solve(problem("either", *either, goal="l r"), AMPLE)
    assert isinstance(outcome, Unsupported)


def test_its_programs_are_looked_for_on_the_path_in_their_order(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(BINARY_VARIABLE)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find_binary() is None
    for name in ("M", "MpC", "Mp"):
        program = make_program(tmp_path / name, "true")
        assert find_binary() == program


def test_the_variable_names_a_program_by_path_or_by_name_and_no_other_is_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    program = make_program(tmp_path / "M", "true")
    make_program(tmp_path / "Mp", "true")
    monkeypatch.setenv(BINARY_VARIABLE, "M")
    assert find_binary() == program
    monkeypatch.setenv(BINARY_VARIABLE, str(program))
    assert find_binary() == program
    monkeypatch.setenv(BINARY_VARIABLE, "Madagascar")
    assert find_binary() is None


def test_the_program_given_is_used(tmp_path: Path) -> None:
    program = make_program(tmp_path / "MpC", "exit 9")
    outcome = MadagascarPlanner(program).solve(problem("given", ONE), AMPLE)
    assert outcome == NoEngine("Madagascar MpC", "ended with code 9: it said nothing")
