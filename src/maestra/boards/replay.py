"""A board that tells again what a board once told: a recorded session, one event a call."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from typing import Final

from maestra.coaching.events import (
    BoardBack,
    BoardLost,
    Event,
    SeveralTokens,
    TimedEvent,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)

_OF_BOARDS: Final = (
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    SeveralTokens,
    BoardLost,
    BoardBack,
)


class ReplayBoard:
    """The board's part of a session; what people, clock and robot did is left out."""

    def __init__(self, events: Iterable[TimedEvent]) -> None:
        """Be ready to tell the board's events, in their order."""
        self._left = deque(event.what for event in events if isinstance(event.what, _OF_BOARDS))

    @property
    def has_more(self) -> bool:
        """Whether anything is left to tell."""
        return bool(self._left)

    def events(self) -> Sequence[Event]:
        """The next event; none when all have been told."""
        return [self._left.popleft()] if self._left else []

    def close(self) -> None:
        """Tell nothing more."""
        self._left.clear()
