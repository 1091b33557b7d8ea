"""One room: the session that is played there, its clock, and who follows it."""

from __future__ import annotations

import json
import logging
import threading
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
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
from maestra.coaching.events import (
    BoardLost,
    Event,
    Paused,
    TimedEvent,
    TimePassed,
    encode_event,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import Entry, PatientId, StoredSession
from maestra.coaching.recording import Start
from maestra.coaching.running import Running
from maestra.coaching.session import Phase, Session, due
from maestra.coaching.settings import Settings
from maestra.coaching.sitting import rise
from maestra.storage.store import SqlStore
from maestra.web.clock import Clock
from maestra.web.rooms.listeners import Listener, offer_all
from maestra.web.rooms.stage import RoomName, RoomState, Said, Scenery, Stage
from maestra.web.teach.pictures import shown_in

MOST_EVENTS: Final = 50_000
"""Of one session: a move a second for half a day. More is a program that runs wild."""
BOARD_RETURNS_MS: Final = 10_000
"""How long a board's stream may be broken off before the patient hears of it: most cuts are over
by then, and nobody needs to know of those."""
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

    def __init__(
        self, name: RoomName, store: SqlStore, clock: Clock, *, can_speak: bool = False
    ) -> None:
        """Empty as yet; `can_speak`: whether sentences can be heard."""
        self.name: Final = name
        self._store = store
        self._clock = clock
        self._can_speak = can_speak
        self._lock = threading.RLock()
        self._listeners: set[Listener] = set()
        self._play: _Play | None = None
        self._state = RoomState(name)
        self._board_left: Milliseconds | None = None
        """When the board's stream broke off, until it is back or is given up."""

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
    def scenery(self) -> Scenery | None:
        """What that session looks like."""
        return None if self._play is None else self._play.scenery

    @property
    def patient(self) -> PatientId | None:
        """Who plays, or played last."""
        return None if self._play is None else self._play.stored.patient

    @property
    def is_used(self) -> bool:
        """Whether somebody plays here or follows the room."""
        return self._state.is_under_way or bool(self._listeners)

    def begin(self, stored: StoredSession, start: Start, number: int = 1) -> None:
        """Let a session begin that the store knows already; who follows the room sees it.

        Args:
            stored: the session.
            start: what it follows from.
            number: which round of the sitting it is.

        Raises:
            OSError: the start cannot be kept.
        """
        with self._lock:
            for listener in self._listeners:
                if listener.follows is not None:
                    # Before anything is shown. Also of the same patient: all begins anew.
                    listener.end()
            self._seat(stored, start, Stage(), number)

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

        While something is being told nothing is done: the next tick is soon enough.

        Raises:
            NobodyPlaysError: the patient has been erased.
            TooManyEventsError: the session has gone on for too long.
            OSError: what is due cannot be kept.
        """
        if not self._lock.acquire(blocking=False):
            return
        try:
            play = self._play
            if play is None or play.is_kept:
                return
            at, left = due(play.running.session), self._board_left
            if left is not None and self._clock.monotonic() - left >= BOARD_RETURNS_MS:
                self._board_left = None
                self.tell(BoardLost())
            elif at is not None and self._now(play) >= at:
                self.tell(TimePassed())
            self._finish()
        finally:
            self._lock.release()

    def forget(self) -> None:
        """Empty the room: what was played here is nobody's business any more."""
        with self._lock:
            self._play = None
            self._show()

    def join(self, listener: Listener) -> None:
        """Follow the room from now on; the state as it is now comes first."""
        with self._lock:
            self._listeners.add(listener)
            self._board_left = None if listener.is_board else self._board_left
            if self._has_board is not self._state.has_board:
                self._show()
            else:
                listener.offer(self._message(for_caregiver=listener.for_caregiver))

    def leave(self, listener: Listener) -> None:
        """Follow no longer."""
        with self._lock:
            self._listeners.discard(listener)
            if self._has_board is not self._state.has_board:
                self._board_left = self._clock.monotonic()
                self._show()

    def dismiss(self, patient: PatientId) -> None:
        """Have those come anew who follow this patient."""
        with self._lock:
            for listener in self._listeners:
                if listener.follows == patient:
                    listener.end()

    def sentence(self, number: int) -> tuple[str, Settings]:
        """What was said under this number, one of the last, and how it is to be spoken.

        Raises:
            KeyError: nothing, or too long ago.
        """
        with self._lock:
            if self._play is None:
                raise KeyError(number)
            said = {one.number: one.text for one in self._play.said}
            return said[number], self._play.scenery.start.settings

    # ------------------------------------------------------------ within

    def _seat(self, stored: StoredSession, start: Start, stage: Stage, number: int = 1) -> _Play:
        running = Running(
            stored.session, start, ReplayBoard(()), (), self._store.events, self._utc()
        )
        pictures = shown_in(self._store, stored.exercise, stored.version)
        can_speak = self._can_speak
        scenery = Scenery.of(
            self.name, stored.session, start, pictures, number=number, can_speak=can_speak
        )
        begun = Milliseconds(self._clock.monotonic() - running.session.now)
        play = _Play(stored, scenery, running, stage, begun)
        self._play = play
        self._board_left = None
        self._show()
        return play

    def _changed(self, play: _Play, event: Event, commands: Commands) -> None:
        play.stage = play.stage.after(commands)
        if play.stage.said is not None and play.stage.said.number == play.stage.steps:
            play.said.append(play.stage.said)
        self._show(event, commands)

    @property
    def _has_board(self) -> bool:
        return any(listener.is_board for listener in self._listeners)

    def _show(self, event: Event | None = None, commands: Commands = ()) -> None:
        """Let everybody know how things are; each message is encoded once for all."""
        state, play = RoomState(self.name), self._play
        if play is not None:
            state = play.scenery.state(play.running.session, play.stage)
        self._state = replace(state, has_board=self._has_board)
        messages = {
            whose: self._message(event, commands, for_caregiver=whose)
            for whose in {listener.for_caregiver for listener in self._listeners}
        }
        offer_all({one: messages[one.for_caregiver] for one in self._listeners})

    def _message(
        self,
        event: Event | None = None,
        commands: Commands = (),
        *,
        for_caregiver: bool,
    ) -> str:
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
