import math

import pytest

from maestra.core.faults import InvalidError
from maestra.learning.planning import Fluent, Limits, Operator, OperatorName, PlanningProblem

NOTHING: frozenset[Fluent] = frozenset()


def fluents(names: str) -> frozenset[Fluent]:
    return frozenset(Fluent(name) for name in names.split())


def operator(name: str, needs: str = "", adds: str = "", deletes: str = "") -> Operator:
    return Operator(OperatorName(name), fluents(needs), fluents(adds), fluents(deletes))


def test_a_problem_lists_each_fluent_it_speaks_of_once() -> None:
    operators = (operator("o", "b", "c", "d"), operator("n", "a", "b"))
    problem = PlanningProblem("p", fluents("z a"), fluents("g"), operators)
    assert problem.fluents == ("a", "z", "g", "b", "c", "d")


def test_a_problem_knows_whether_it_deletes() -> None:
    assert PlanningProblem("p", NOTHING, NOTHING, (operator("o", adds="a"),)).deletes_nothing
    deleting = PlanningProblem("p", NOTHING, NOTHING, (operator("o", deletes="a"),))
    assert not deleting.deletes_nothing


def test_every_fault_of_a_problem_is_reported_at_once() -> None:
    blank = Fluent(" ")
    operators = (
        operator("o", adds="a b", deletes="b a"),
        operator("o"),
        Operator(OperatorName(""), frozenset({blank}), NOTHING),
    )
    with pytest.raises(InvalidError) as refused:
        PlanningProblem("p", NOTHING, NOTHING, operators)
    assert [str(fault) for fault in refused.value.faults] == [
        "operators: 2 operators named 'o', expected different names",
        "operators['o']: 'a' both added and deleted, expected one of the two",
        "operators['o']: 'b' both added and deleted, expected one of the two",
        "operators['']: no name, expected a name that is not blank",
        "fluents: ' ', expected a name that is not blank",
    ]


@pytest.mark.parametrize("time_s", [0.0, -1.0, math.inf, math.nan])
def test_a_time_limit_is_positive_and_finite(time_s: float) -> None:
    with pytest.raises(InvalidError, match="time_s"):
        Limits(time_s, 1)


def test_every_fault_of_limits_is_reported_at_once() -> None:
    with pytest.raises(InvalidError) as refused:
        Limits(0.0, 0)
    assert [fault.where for fault in refused.value.faults] == ["time_s", "memory_mb"]
