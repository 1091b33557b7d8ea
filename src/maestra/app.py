"""The only place that wires adapters to ports."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from maestra.core.faults import Fault, InvalidError
from maestra.planners import PLANNERS

if TYPE_CHECKING:
    from maestra.coaching.ports import Store
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


def record_at(data: str | None = None, keys: str | None = None) -> Store:
    """The record of sessions, to read and write: in a folder, or a PostgreSQL database by URL.

    Raises:
        InvalidError: somebody else is writing to it, or its keys are not there.
        OSError: it cannot be reached.
    """
    # Only who keeps a record waits for the database's libraries.
    from maestra.storage.opening import open_store, place  # noqa: PLC0415

    return open_store(place(data, keys))


def record_to_read(data: str | None = None, keys: str | None = None) -> Store:
    """The same, to read; also while somebody writes.

    Raises:
        InvalidError: there is none, or its keys are not there.
        OSError: it cannot be reached.
    """
    from maestra.storage.opening import open_to_read, place  # noqa: PLC0415

    return open_to_read(place(data, keys))
