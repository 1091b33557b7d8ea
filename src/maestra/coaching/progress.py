"""How a patient gets on, worked out from the record alone; pure, for terminal, page and web.

What is measured of a session:

- completion: whether the play came to its right end;
- first attempts: of all steps (right moves made, by whomever), how many the patient made without
  a refused attempt before;
- reaction times: from the moment it is the patient's turn (the beginning, the last right move, a
  token put back, the end of a pause) until a token is lifted, where the patient then places it;
- assistance: the mean over steps of the highest level of help given for each.

A trend compares each session with each later one: S is how often the later is higher less how
often it is lower. With n sessions of which none are equal S has variance n (n - 1) (2 n + 5) / 18
when nothing changes; equal ones are taken off that. We speak of a trend where S is further from 0
than a standard normal variable is in one case of twenty on that side (the Mann-Kendall test).
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from itertools import combinations
from math import sqrt
from statistics import median
from typing import Any, Final, TypeAlias

from maestra.coaching.fields import Milliseconds
from maestra.coaching.moving import OWN
from maestra.coaching.notes import Note
from maestra.coaching.ports import Entry, PatientId, SessionId, Store, StoredSession
from maestra.coaching.session import Ending

FEWEST_FOR_TREND: Final = 4
"""With three sessions even the clearest order comes about by chance in one case of six."""
ONE_IN_TWENTY: Final = 1.645
"""A standard normal variable is beyond this in 5 % of cases."""

_BEGINNING: Final = Milliseconds(0)

_Json: TypeAlias = dict[str, Any]


class Trend(Enum):
    """Where a measure goes from session to session."""

    RISING = "rising"
    FALLING = "falling"
    STEADY = "steady"
    TOO_FEW = "too-few"
    """Too few sessions to tell."""


@dataclass(frozen=True, slots=True)
class SessionProgress:
    """One session in figures."""

    session: SessionId
    exercise: str
    begun_utc: str
    completed: bool
    steps: int
    first_attempts: int
    """Of the steps, those that the patient made at the first attempt."""
    refused: int
    reactions: tuple[Milliseconds, ...]
    assistance: float | None
    """Mean level, 0 to 5; None where no step was made."""
    lasted: Milliseconds

    @property
    def first_attempt_share(self) -> float | None:
        """First attempts of all steps; None where none was made."""
        return self.first_attempts / self.steps if self.steps else None

    @property
    def reaction(self) -> float | None:
        """The median reaction time in milliseconds; None where there is none."""
        return median(self.reactions) if self.reactions else None


@dataclass(frozen=True, slots=True)
class ExerciseProgress:
    """All sessions of one exercise, the earliest first, and what they come to."""

    exercise: str
    sessions: tuple[SessionProgress, ...]

    @property
    def completion(self) -> float:
        """The share of sessions that came to their right end."""
        return sum(one.completed for one in self.sessions) / len(self.sessions)

    @property
    def first_attempt_share(self) -> float | None:
        """First attempts of all steps of all sessions."""
        steps = sum(one.steps for one in self.sessions)
        return sum(one.first_attempts for one in self.sessions) / steps if steps else None

    @property
    def reaction(self) -> float | None:
        """The median of all reaction times in milliseconds."""
        all_of_them = [each for one in self.sessions for each in one.reactions]
        return median(all_of_them) if all_of_them else None

    @property
    def assistance(self) -> float | None:
        """The mean level over all steps."""
        weighed = [
            (one.assistance, one.steps) for one in self.sessions if one.assistance is not None
        ]
        steps = sum(number for _, number in weighed)
        return sum(level * number for level, number in weighed) / steps if steps else None

    @property
    def trends(self) -> Trends:
        """Where each measure goes."""
        return Trends(
            trend(one.first_attempt_share for one in self.sessions),
            trend(one.reaction for one in self.sessions),
            trend(one.assistance for one in self.sessions),
        )


@dataclass(frozen=True, slots=True)
class Trends:
    """Where each measure of an exercise goes."""

    first_attempts: Trend
    reaction: Trend
    assistance: Trend


def progress(store: Store, patient: PatientId) -> tuple[ExerciseProgress, ...]:
    """A patient's progress in each exercise, by name."""
    played: dict[str, list[SessionProgress]] = {}
    for session in store.sessions(patient):
        found = of_session(session, store.events.entries(session.session))
        played.setdefault(session.exercise, []).append(found)
    return tuple(ExerciseProgress(name, tuple(played[name])) for name in sorted(played))


def of_session(session: StoredSession, entries: Iterable[Entry]) -> SessionProgress:
    """One session in figures; what the record holds of it, even if it was broken off."""
    seen = _Seen()
    for entry in entries:
        if entry.kind == "event":
            seen.happened(json.loads(entry.payload)["what"]["event"], entry.at)
        elif entry.kind == "commands":
            for command in json.loads(entry.payload):
                if command["command"] == "record":
                    seen.noted(command["note"], command["fields"], entry.at)
        seen.lasted = entry.at
    return SessionProgress(
        session.session,
        session.exercise,
        session.begun_utc,
        seen.completed,
        len(seen.levels),
        seen.first_attempts,
        seen.refused,
        tuple(seen.reactions),
        sum(seen.levels) / len(seen.levels) if seen.levels else None,
        seen.lasted,
    )


@dataclass
class _Seen:
    """What has been read of a session so far."""

    completed: bool = False
    levels: list[int] = field(default_factory=list[int])
    first_attempts: int = 0
    refused: int = 0
    reactions: list[Milliseconds] = field(default_factory=list[Milliseconds])
    lasted: Milliseconds = _BEGINNING
    _refused_now: bool = False
    _turn_since: Milliseconds | None = None
    _took: Milliseconds | None = None

    def happened(self, event: str, at: Milliseconds) -> None:
        if event == "lifted" and self._turn_since is not None and self._took is None:
            self._took = Milliseconds(at - self._turn_since)

    def noted(self, note: str, fields: _Json, at: Milliseconds) -> None:
        match note:
            case Note.MOVE.value:
                self._moved(fields)
                self._turn_begins(at)
            case Note.REFUSED.value:
                self.refused += 1
                self._refused_now = True
                self._reacted()
                self._turn_since = None
            case Note.BEGUN.value | Note.RETURNED.value | Note.RESUMED.value:
                self._turn_begins(at)
            case Note.BOARD_BACK.value:
                self._turn_begins(at)
            case Note.PAUSED.value | Note.BOARD_LOST.value:
                self._turn_since = self._took = None
            case Note.ENDED.value:
                self.completed = fields["ending"] == Ending.COMPLETE.value
            case _:
                pass

    def _moved(self, fields: _Json) -> None:
        self.levels.append(fields["level"])
        if fields["by"] == OWN:
            self.first_attempts += not self._refused_now
            self._reacted()
        self._refused_now = False

    def _reacted(self) -> None:
        if self._took is not None:
            self.reactions.append(self._took)
        self._took = None

    def _turn_begins(self, at: Milliseconds) -> None:
        self._turn_since, self._took = at, None


def trend(measures: Iterable[float | None]) -> Trend:
    """Where a measure goes; sessions without it are passed over."""
    values = [one for one in measures if one is not None]
    if len(values) < FEWEST_FOR_TREND:
        return Trend.TOO_FEW
    ups = sum((later > earlier) - (later < earlier) for earlier, later in combinations(values, 2))
    variance = _variance(values)
    # Half-way between the values that S can take: it goes up by two.
    further = max(abs(ups) - 1, 0)
    if variance == 0 or further / sqrt(variance) <= ONE_IN_TWENTY:
        return Trend.STEADY
    return Trend.RISING if ups > 0 else Trend.FALLING


def _variance(values: Sequence[float]) -> float:
    def share(number: int) -> int:
        return number * (number - 1) * (2 * number + 5)

    return (share(len(values)) - sum(share(ties) for ties in Counter(values).values())) / 18
