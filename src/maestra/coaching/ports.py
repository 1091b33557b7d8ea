"""What a session needs of the world: a board, a robot, a place for its record.

Each port has a simulated twin and one contract suite that runs on all of its adapters
(tests/boards, tests/robots, tests/storage). Adapters are wired to ports in `app` alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NewType, Protocol

from maestra.coaching.commands import Command
from maestra.coaching.events import Event
from maestra.coaching.fields import Milliseconds

SessionId = NewType("SessionId", str)
PatientId = NewType("PatientId", str)
"""A pseudonym; names are kept apart and encrypted."""


class Board(Protocol):
    """Where tokens lie: it tells what is moved."""

    def events(self) -> Sequence[Event]:
        """What has happened since the last call, in order; never waits."""
        ...

    def close(self) -> None:
        """Let go of it; there are no events afterwards."""
        ...


class Robot(Protocol):
    """Who speaks, looks, points and moves tokens."""

    def carry_out(self, command: Command) -> Sequence[Event]:
        """Do what can be done, and tell the outcome of what has a number.

        What this robot has no means for is passed over, but a `MoveToken` always has an outcome,
        now or in a later call of `outcomes`.
        """
        ...

    def outcomes(self) -> Sequence[Event]:
        """Outcomes that have come in since the last call; never waits."""
        ...

    def close(self) -> None:
        """Let go of it."""
        ...


@dataclass(frozen=True, slots=True)
class NewEntry:
    """What is to be kept of one moment of a session."""

    session: SessionId
    key: str
    """The same for the same moment: what is appended again under its key is kept once."""
    at: Milliseconds
    """Monotonic, since the session began."""
    utc: str
    """The time of day as ISO 8601 in UTC, for people."""
    kind: str
    """``start``, ``event`` or ``commands``."""
    payload: str
    """JSON: of a start an object with at least ``seed`` and ``maestra``, the program's version; of
    an event what `encode_event` gives; of commands the list that `encode_commands` gives."""


@dataclass(frozen=True, slots=True)
class Entry(NewEntry):
    """What has been kept."""

    sequence: int
    """From 1, without gaps, over all sessions of a store."""


class EventStore(Protocol):
    """An append-only record: nothing in it is changed or taken away."""

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        """Keep them, all or none; when this returns they are on the disk.

        Entries whose key is known already are not kept again: the kept ones are returned.

        Raises:
            OSError: they cannot be kept.
            KeyError: their session has not been saved, so nobody knows whose they are.
        """
        ...

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        """What has been kept, of one session or of all, in order."""
        ...


@dataclass(frozen=True, slots=True)
class StoredExercise:
    """One version of an exercise."""

    name: str
    version: int
    """From 1."""
    exercise: str
    """The exercise's file."""
    demonstrations: str
    """What it was learned from: JSON Lines, perhaps none."""


@dataclass(frozen=True, slots=True)
class StoredSession:
    """A session, and what it was played with."""

    session: SessionId
    patient: PatientId
    exercise: str
    version: int
    settings: str
    """JSON, as they were when it began."""
    begun_utc: str
    ended_utc: str | None = None


class Store(Protocol):
    """Exercises with their versions, patients, settings, sessions, and the record of events."""

    @property
    def events(self) -> EventStore:
        """The record."""
        ...

    def save_exercise(self, name: str, exercise: str, demonstrations: str = "") -> int:
        """Keep a new version; returns its number. What equals the latest makes no new one."""
        ...

    def exercise(self, name: str, version: int | None = None) -> StoredExercise:
        """A version of an exercise, the latest if none is named.

        Raises:
            KeyError: there is none.
        """
        ...

    def exercises(self) -> tuple[StoredExercise, ...]:
        """The latest version of each, by name."""
        ...

    def save_settings(self, patient: PatientId, settings: str) -> None:
        """Keep a patient's settings (JSON); who is not known yet is then."""
        ...

    def settings(self, patient: PatientId) -> str:
        """A patient's settings.

        Raises:
            KeyError: there are none.
        """
        ...

    def patients(self) -> tuple[PatientId, ...]:
        """All pseudonyms, in order."""
        ...

    def save_session(self, session: StoredSession) -> None:
        """Keep a session; one with its id is replaced, for it has ended."""
        ...

    def sessions(self, patient: PatientId | None = None) -> tuple[StoredSession, ...]:
        """The sessions of one patient or of all, the earliest first."""
        ...

    def close(self) -> None:
        """Let go of it."""
        ...
