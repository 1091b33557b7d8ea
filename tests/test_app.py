import pytest

from maestra.app import planner_named
from maestra.core.faults import InvalidError
from maestra.planners import PLANNERS


@pytest.mark.parametrize("name", PLANNERS)
def test_each_planner_is_found_by_its_name(name: str) -> None:
    assert planner_named(name).name


def test_an_unknown_planner_is_refused_with_those_there_are() -> None:
    with pytest.raises(InvalidError, match="engine: mp, expected one of clingo, fast-downward"):
        planner_named("mp")
