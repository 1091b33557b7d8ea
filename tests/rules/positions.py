"""The positions that a play goes through."""

from __future__ import annotations

from collections.abc import Iterator

from maestra.core.demonstration import Demonstration
from maestra.rules.position import Position


def positions_of(play: Demonstration) -> Iterator[Position]:
    """Before the first move, then after each one."""
    position = Position.begin(play.start)
    yield position
    for move in play.moves:
        position = position.after(move)
        yield position
