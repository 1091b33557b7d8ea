"""The only place that wires adapters to ports."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from maestra.core.faults import Fault, InvalidError
from maestra.planners import PLANNERS

if TYPE_CHECKING:
    from maestra.learning.planning import Planner

PLANNER_NAMES: Final = tuple(PLANNERS)
"""The planners that `planner_named` knows."""


def planner_named(name: str) -> Planner:
    """The planner of this name; whether its engine is installed shows when it solves.

    Raises:
        InvalidError: there is none.
    """
    if name not in PLANNERS:
        raise InvalidError([Fault("engine", name, f"one of {', '.join(PLANNERS)}")])
    return PLANNERS[name]()
