"""What is known before an attempt, what may be done, and what can become of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Final

from maestra.coaching.fields import MAX_LEVEL


class Outcome(Enum):
    """What became of an attempt."""

    RIGHT = "right"
    WRONG = "wrong"
    SILENCE = "silence"


STRAIN: Final = MappingProxyType({Outcome.RIGHT: -2, Outcome.WRONG: 2, Outcome.SILENCE: 1})
"""What each outcome adds to a patient's strain, in halves of an error: our assumption."""


@dataclass(frozen=True, slots=True)
class Situation:
    """Before an attempt."""

    left: int = 1
    """About how many moves the exercise still needs, this one too; at least 1."""
    last: Outcome = Outcome.RIGHT
    """Before the first attempt at a move: right."""
    silences: int = 0
    """Unanswered prompts at this move."""
    standing: int = 0
    """The level of the help at this move that was last said."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What the caregiver allows."""

    least: int = 0
    most: int = MAX_LEVEL
    waits: bool = False
    """After a first silence no more than encouragement: a human-centred robot."""

    def clamp(self, level: int) -> int:
        """The allowed level nearest to `level`."""
        return min(max(level, self.least), self.most)

    @property
    def levels(self) -> range:
        """Those allowed."""
        return range(self.least, self.most + 1)

    @property
    def after_silence(self) -> range:
        """Those allowed after a first silence."""
        return (
            range(self.least, max(self.least, min(self.most, 1)) + 1)
            if self.waits
            else self.levels
        )
