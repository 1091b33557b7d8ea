"""All rooms of a server: sessions begin here, go on after a restart, and end."""

from __future__ import annotations

import asyncio
import logging
import re
import secrets
import sys
import threading
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager, suppress
from typing import Annotated, Final, cast

from anyio import to_thread
from fastapi import Depends
from starlette.requests import HTTPConnection

from maestra.coaching.events import Begun
from maestra.coaching.ports import PatientId, SessionId, StoredSession
from maestra.coaching.recording import decode_start
from maestra.coaching.remembered import Remembered
from maestra.coaching.settings import Profile, settings_for
from maestra.coaching.sitting import Chosen, known_patient, sit_down
from maestra.core.faults import InvalidError
from maestra.core.json_lines import FormatError
from maestra.language import Language
from maestra.rules.exercise_format import decode_exercise
from maestra.storage.store import SqlStore
from maestra.web.clock import Clock
from maestra.web.rooms.room import NobodyPlaysError, Room, TooManyEventsError
from maestra.web.rooms.stage import RoomName

MOST_ROOMS: Final = 100
"""On one server: more patients than anybody accompanies at once, and each takes half a MB."""
TICK_S: Final = 0.25
"""How often silences are looked at; nobody notices a prompt that comes so much later."""
SWITCH_S: Final = 0.0005
"""How long a thread may keep others waiting. With Python's 5 ms whoever writes to the disk waits
as long after each of its calls while something is worked out elsewhere."""
_SESSION: Final = re.compile(r"room-([a-z0-9]{1,20})-[0-9a-f]{16}")

_LOG: Final = logging.getLogger(__name__)


class TakenError(Exception):
    """Another session is under way in this room, or this patient plays in another one."""


class NoRoomLeftError(Exception):
    """There are as many rooms as one server has."""


class Rooms:
    """Every room by its name. All methods are for any thread."""

    def __init__(self, store: SqlStore, clock: Clock, *, can_speak: bool = False) -> None:
        """The rooms in which sessions were under way when the server was stopped go on, paused."""
        self._store = store
        self._clock = clock
        self.can_speak: Final = can_speak
        """Whether sentences can be heard."""
        if not can_speak:
            _LOG.warning("espeak-ng is not installed: what the robot says is only shown")
        self.lobby: Final = Room(RoomName("waiting-room"), store, clock)
        """Never played in, for no room may be called so: patients' screens wait there for their
        next session."""
        self._lock = threading.RLock()
        self._rooms: dict[RoomName, Room] = {}
        for stored in store.sessions():
            named = _SESSION.fullmatch(stored.session)
            if stored.ended_utc is None and named is not None:
                self._restore(RoomName(named[1]), stored)

    def begin(
        self,
        patient: PatientId,
        exercise: str,
        *,
        version: int | None = None,
        room: RoomName | None = None,
        language: Language = Language.EN,
    ) -> Room:
        """Begin a session; nobody has sat down yet.

        Args:
            patient: who is to play; settings are those that the store has, else the defaults.
            exercise: its name in the store.
            version: the latest if None.
            room: where; a free one if None.
            language: of a patient for whom nothing is set yet.

        Raises:
            KeyError: there is no such exercise.
            InvalidError: it cannot be played on its board, or its file is broken.
            TakenError: the room or the patient is taken.
            NoRoomLeftError: there are too many rooms.
            OSError: it cannot be kept.
        """
        chosen = self._chosen(exercise, version)
        with self._lock:
            there = self.of(patient)
            if there is not None and there.state.is_under_way:
                raise TakenError(patient)
            place = self.place(self._free() if room is None else room)
            self._begin(place, patient, chosen, language)
            return place

    def once_more(self, place: Room) -> None:
        """Begin the sitting's next round in a room; somebody sits there, so it begins at once.

        Raises:
            TakenError: there is none, or it has begun already.
            InvalidError: the exercise cannot be played on its board.
            OSError: it cannot be kept.
        """
        with self._lock:
            stored, scenery = place.stored, place.scenery
            if stored is None or scenery is None or not place.state.another_round:
                raise TakenError(place.name)
            chosen = self._chosen(stored.exercise, stored.version)
            language = scenery.start.settings.language
            self._begin(place, stored.patient, chosen, language, scenery.round + 1)
            place.tell(Begun())

    def place(self, name: RoomName) -> Room:
        """The room of this name, perhaps empty.

        Raises:
            NoRoomLeftError: it would be one too many.
        """
        with self._lock:
            if name not in self._rooms:
                if len(self._rooms) >= MOST_ROOMS:
                    self._clear_away()
                self._rooms[name] = Room(name, self._store, self._clock, can_speak=self.can_speak)
            return self._rooms[name]

    def named(self, name: RoomName) -> Room:
        """The room of this name.

        Raises:
            KeyError: there is none.
        """
        return self._rooms[name]

    def of(self, patient: PatientId) -> Room | None:
        """Where a patient plays, or else has played since the server was started."""
        rooms = [room for room in self.all() if room.patient == patient]
        return max(rooms, key=lambda room: room.state.is_under_way, default=None)

    def all(self) -> tuple[Room, ...]:
        """Every room, by name."""
        with self._lock:
            return tuple(room for _, room in sorted(self._rooms.items()))

    def forget(self, patient: PatientId) -> None:
        """Empty the rooms of a patient who is erased."""
        for room in self.all():
            if room.patient == patient:
                room.forget()

    def tick(self) -> None:
        """Let time pass in every room."""
        for room in self.all():
            try:
                room.tick()
            except (OSError, NobodyPlaysError, TooManyEventsError):
                # The other rooms go on; this one is tried again with the next tick.
                _LOG.exception("room %s: time cannot pass", room.name)

    @asynccontextmanager
    async def ticking(self) -> AsyncGenerator[None]:
        """Let time pass by itself as long as this lasts."""
        sys.setswitchinterval(SWITCH_S)
        task = asyncio.create_task(self._tick_for_ever())
        try:
            yield
        finally:
            task.cancel()
            with suppress(asyncio.CancelledError):
                await task

    # ------------------------------------------------------------ within

    def _chosen(self, exercise: str, version: int | None) -> Chosen:
        found = self._store.exercise(exercise, version)
        return Chosen(found.name, found.version, decode_exercise(found.exercise.encode()))

    def _begin(
        self,
        place: Room,
        patient: PatientId,
        chosen: Chosen,
        language: Language,
        number: int = 1,
    ) -> None:
        if place.state.is_under_way:
            raise TakenError(place.name)
        try:
            known = known_patient(self._store, patient)
        except KeyError:
            known = Remembered(settings_for(Profile(), language))
        sitting = sit_down(
            SessionId(f"room-{place.name}-{secrets.token_hex(8)}"),
            patient,
            chosen,
            known,
            seed=secrets.randbits(64),
            utc=self._clock.utc().isoformat(timespec="milliseconds"),
        )
        sitting.keep(self._store)
        place.begin(sitting.stored, sitting.start, number)
        for other in {self.lobby, *self.all()} - {place}:
            other.dismiss(patient)

    async def _tick_for_ever(self) -> None:
        while True:
            await asyncio.sleep(TICK_S)
            await to_thread.run_sync(self.tick)

    def _free(self) -> RoomName:
        """The first of 1, 2, 3... in which nobody plays."""
        numbers = (RoomName(str(number)) for number in range(1, MOST_ROOMS + 1))
        taken = {room.name for room in self.all() if room.state.is_under_way}
        return next((name for name in numbers if name not in taken), RoomName("1"))

    def _clear_away(self) -> None:
        """Drop a room that nobody uses.

        Raises:
            NoRoomLeftError: all are used.
        """
        for name, room in self._rooms.items():
            if not room.is_used:
                del self._rooms[name]
                return
        raise NoRoomLeftError

    def _restore(self, name: RoomName, stored: StoredSession) -> None:
        entries = tuple(self._store.events.entries(stored.session))
        if not entries:
            return  # switched off before its start was kept: nothing was played
        try:
            start = decode_start(entries[0].payload.encode(), f"session {stored.session}")
            self.place(name).go_on(stored, start, entries)
        except (FormatError, InvalidError):
            # A newer Maestra may have written it; the other rooms open all the same.
            _LOG.exception("room %s: its session cannot go on", name)


def rooms_of(connection: HTTPConnection) -> Rooms:
    """The rooms of the application that is asked."""
    return cast("Rooms", connection.app.state.rooms)


RoomsHere = Annotated[Rooms, Depends(rooms_of)]
