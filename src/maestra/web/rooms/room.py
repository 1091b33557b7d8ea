"""One room: the session that is played there, its clock, and who follows it."""

from __future__ import annotations

import json
import logging
import threading
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import UTC
from typing import Final

from maestra.boards.replay import ReplayBoard
from maestra.coaching.commands import (
    AskCaregiver,
    Commands,
    Record,
    decode_command,
    encode_commands,
)
from maestra.coaching.events import Event, Paused, TimedEvent, TimePassed, encode_event
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import Entry, PatientId, Store, StoredSession
from maestra.coaching.recording import Start
from maestra.coaching.running import Running
from maestra.coaching.session import Phase, Session, due
from maestra.coaching.sitting import rise
from maestra.web.clock import Clock
from maestra.web.rooms.listeners import Listener
from maestra.web.rooms.stage import RoomName, RoomState, Said, Scenery, Stage

MOST_EVENTS: Final = 50_000
"""Of one session: a move a second for half a day. More is a program that runs wild."""
REPLAYABLE: Final = 20
"""Sentences whose sound can still be asked for: a page that comes back asks for the last one."""

_LOG: Final = logging.getLogger(__name__)


class NobodyPlaysError(Exception):
    """There is no session in the room, so nothing can happen in it."""


class TooManyEventsError(Exception):
    """The session has more events than any patient makes."""


@dataclass
class _Play:
    """A session under way, and where it is kept."""

    stored: StoredSession
    scenery: Scenery
    running: Running
    stage: Stage
    begun: Milliseconds
    """On the server's clock, when the session's own stood at 0."""
    is_kept: bool = False
    """Whether the store knows that it has ended, and what was learned."""
    said: deque[Said] = field(default_factory=lambda: deque(maxlen=REPLAYABLE))


class Room:
    """A place where patients play, one after the other. All methods are for any thread."""

    def __init__(self, name: RoomName, store: Store, clock: Clock) -> None:
        """Empty as yet."""
        self.name: Final = name
        self._store = store
        self._clock = clock
        self._lock = threading.RLock()
        self._listeners: set[Listener] = set()
        self._play: _Play | None = None
        self._state = RoomState(name)

    @property
    def state(self) -> RoomState:
        """How everything is now."""
        return self._state

    @property
    def session(self) -> Session:
        """The session that is played, or was played last.

        Raises:
            NobodyPlaysError: there was none.
        """
        if self._play is None:
            raise NobodyPlaysError(self.name)
        return self._play.running.session

    @property
    def stored(self) -> StoredSession | None:
        """The session that is played, or was played last."""
        return None if self._play is None else self._play.stored

    @property
    def start(self) -> Start | None:
        """What that session follows from."""
        return None if self._play is None else self._play.scenery.start

    @property
    def patient(self) -> PatientId | None:
        """Who plays, or played last."""
        return None if self._play is None else self._play.stored.patient

    @property
    def is_used(self) -> bool:
        """Whether somebody plays here or follows the room."""
        return self._state.is_under_way or bool(self._listeners)

    def begin(self, stored: StoredSession, start: Start) -> None:
        """Let a session begin that the store knows already; who follows the room sees it.

        Raises:
            OSError: the start cannot be kept.
        """
        with self._lock:
            self._seat(stored, start, Stage())
            for listener in self._listeners:
                if listener.follows not in {None, stored.patient}:
                    listener.end()
            self._tell_all()

    def go_on(self, stored: StoredSession, start: Start, entries: Iterable[Entry]) -> None:
        """Let a session go on that the server was stopped in; it is paused until somebody resumes.

        Raises:
            OSError: that it is paused cannot be kept.
        """
        stage, said = Stage(), deque[Said](maxlen=REPLAYABLE)
        for entry in entries:
            if entry.kind == "commands":
                stage = stage.after(tuple(map(decode_command, json.loads(entry.payload))))
                if stage.said is not None and stage.said.number == stage.steps:
                    said.append(stage.said)
        with self._lock:
            play = self._seat(stored, start, stage)
            play.said.extend(said)
            if play.running.session.phase is Phase.PLAYING:
                self.tell(Paused())
            self._finish()

    def tell(self, event: Event, key: str | None = None) -> RoomState:
        """Let `event` happen; when this returns it is on the disk.

        Args:
            event: what happened.
            key: its teller's name for it, so that telling it again changes nothing.

        Raises:
            NobodyPlaysError: no session has begun here.
            TooManyEventsError: this one is too long already.
            OSError: it cannot be kept; then it has not happened.
        """
        with self._lock:
            play = self._play
            if play is None:
                raise NobodyPlaysError(self.name)
            if key is not None and play.running.has_heard(key):
                return self._state
            if play.stage.steps >= MOST_EVENTS:
                raise TooManyEventsError(self.name)
            try:
                commands = play.running.feed(event, self._now(play), self._utc(), key)
            except KeyError:
                # The patient has been erased, and with them the session.
                self.forget()
                raise NobodyPlaysError(self.name) from None
            self._changed(play, event, commands)
            self._finish()
            return self._state

    def tick(self) -> None:
        """Let time pass: prompts after a silence, and what could not be kept before.

        Raises:
            NobodyPlaysError: the patient has been erased.
            TooManyEventsError: the session has gone on for too long.
            OSError: what is due cannot be kept.
        """
        with self._lock:
            play = self._play
            if play is None or play.is_kept:
                return
            at = due(play.running.session)
            if at is not None and self._now(play) >= at:
                self.tell(TimePassed())
            self._finish()

    def forget(self) -> None:
        """Empty the room: what was played here is nobody's business any more."""
        with self._lock:
            self._play, self._state = None, RoomState(self.name)
            self._tell_all()

    def join(self, listener: Listener) -> None:
        """Follow the room from now on; the state as it is now comes first."""
        with self._lock:
            self._listeners.add(listener)
            listener.offer(self.message(for_caregiver=listener.for_caregiver))

    def leave(self, listener: Listener) -> None:
        """Follow no longer."""
        with self._lock:
            self._listeners.discard(listener)

    def sentence(self, number: int) -> Said:
        """What was said under this number, one of the last.

        Raises:
            KeyError: nothing, or too long ago.
        """
        with self._lock:
            said = () if self._play is None else tuple(self._play.said)
        return {one.number: one for one in said}[number]

    def message(self, *, for_caregiver: bool) -> str:
        """The state as the stream carries it."""
        return self._message(None, (), for_caregiver=for_caregiver)

    # ------------------------------------------------------------ within

    def _seat(self, stored: StoredSession, start: Start, stage: Stage) -> _Play:
        running = Running(
            stored.session, start, ReplayBoard(()), (), self._store.events, self._utc()
        )
        scenery = Scenery.of(self.name, stored.session, start)
        begun = Milliseconds(self._clock.monotonic() - running.session.now)
        play = _Play(stored, scenery, running, stage, begun)
        self._play = play
        self._state = scenery.state(running.session, stage)
        return play

    def _changed(self, play: _Play, event: Event, commands: Commands) -> None:
        session = play.running.session
        play.stage = play.stage.after(commands)
        if play.stage.said is not None and play.stage.said.number == play.stage.steps:
            play.said.append(play.stage.said)
        self._state = play.scenery.state(session, play.stage)
        self._tell_all(event, commands)

    def _tell_all(self, event: Event | None = None, commands: Commands = ()) -> None:
        """Each message is encoded once, however many follow the room."""
        messages: dict[bool, str] = {}
        for listener in self._listeners:
            whose = listener.for_caregiver
            if whose not in messages:
                messages[whose] = self._message(event, commands, for_caregiver=whose)
            listener.offer(messages[whose])

    def _message(self, event: Event | None, commands: Commands, *, for_caregiver: bool) -> str:
        fields = self._state.as_json(for_caregiver=for_caregiver)
        if event is not None:
            if not for_caregiver:
                commands = tuple(c for c in commands if not isinstance(c, AskCaregiver | Record))
            fields["event"] = encode_event(TimedEvent(Milliseconds(0), event))["what"]
            fields["commands"] = encode_commands(commands)
        return json.dumps(fields, ensure_ascii=False, separators=(",", ":"))

    def _finish(self) -> None:
        """Keep that the session has ended; what fails is tried again with the next tick."""
        play = self._play
        if play is None or play.is_kept or not play.running.has_ended:
            return
        try:
            rise(self._store, play.stored, play.running.session, self._utc())
        except OSError:
            _LOG.exception("room %s: that the session has ended cannot be kept yet", self.name)
        else:
            play.is_kept = True

    def _now(self, play: _Play) -> Milliseconds:
        return Milliseconds(self._clock.monotonic() - play.begun)

    def _utc(self) -> str:
        return self._clock.utc().astimezone(UTC).isoformat(timespec="milliseconds")
