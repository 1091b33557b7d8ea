"""All time of the web app comes from here, so that tests can hold it still."""

from __future__ import annotations

import time
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Protocol

from maestra.coaching.fields import Milliseconds


class Clock(Protocol):
    """What tells the time."""

    def monotonic(self) -> Milliseconds:
        """Since some moment; never goes back."""
        ...

    def utc(self) -> datetime:
        """The time of day, with its zone."""
        ...


@dataclass(frozen=True, slots=True)
class SystemClock:
    """The computer's."""

    def monotonic(self) -> Milliseconds:
        """Since the computer was started."""
        return Milliseconds(time.monotonic_ns() // 1_000_000)

    def utc(self) -> datetime:
        """The time of day."""
        return datetime.now(UTC)
