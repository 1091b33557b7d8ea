"""What every route works with; made once when the server starts."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, cast

from fastapi import Depends
from starlette.requests import HTTPConnection

from maestra.storage.store import SqlStore
from maestra.web.access.doors import Doors
from maestra.web.clock import Clock, SystemClock


@dataclass(frozen=True)
class Context:
    """The record, the clock and how the server is reached."""

    store: SqlStore
    folder: Path
    """For what can be made again: spoken sentences."""
    clock: Clock = field(default_factory=SystemClock)
    doors: Doors = field(default_factory=Doors)
    over_tls: bool = False
    """Whether browsers reach it by https, so that cookies are for https alone."""


def context_of(connection: HTTPConnection) -> Context:
    """The context of the application that is asked."""
    return cast("Context", connection.app.state.context)


Here = Annotated[Context, Depends(context_of)]
