"""Engines behind learning's Planner port, one a file; nothing is imported before it is asked for.

`PLANNERS` is the registry: the contract suite iterates it, so a new engine is tested when it is
registered.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from maestra.learning.planning import Planner


def _clingo() -> Planner:
    from maestra.planners.clingo_planner import ClingoPlanner

    return ClingoPlanner()


def _fast_downward() -> Planner:
    from maestra.planners.fast_downward import FastDownwardPlanner

    return FastDownwardPlanner()


def _madagascar() -> Planner:
    from maestra.planners.madagascar import MadagascarPlanner

    return MadagascarPlanner()


PLANNERS: Final[Mapping[str, Callable[[], Planner]]] = MappingProxyType(
    {"clingo": _clingo, "fast-downward": _fast_downward, "madagascar": _madagascar}
)
"""How to make each planner, by its name. Making one starts nothing and looks for nothing."""
