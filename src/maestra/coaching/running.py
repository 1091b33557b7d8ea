"""A session with its board, robot and record: whoever has a clock feeds it.

Each event is kept before anything is done about it, with the commands that it led to, so that
what was acknowledged is on the disk; then the robot carries the commands out, and what comes of
them is fed in turn.
"""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Sequence
from typing import Final

from maestra.coaching.commands import Command, Commands, encode_commands
from maestra.coaching.events import Event, TimedEvent, TimePassed, decode_event
from maestra.coaching.fields import Milliseconds
from maestra.coaching.playing import step
from maestra.coaching.ports import Board, Entry, EventStore, NewEntry, Robot, SessionId
from maestra.coaching.recording import Start, encode_line, encode_start
from maestra.coaching.session import Phase, Session, due

MOST_ECHOES: Final = 200
"""Events that one event may lead to through the robot: far more than a move needs."""


class Running:
    """One session under way."""

    def __init__(
        self,
        identity: SessionId,
        start: Start,
        board: Board,
        robots: Sequence[Robot],
        store: EventStore,
        utc: str,
    ) -> None:
        """Keep the start; or, if the store has the session already, go on from what it has.

        Args:
            identity: the session's, unique in the store.
            start: what it follows from.
            board: tells what is moved.
            robots: carry commands out, each in its way.
            store: keeps events and commands.
            utc: the time of day.

        Raises:
            InvalidError: the tokens do not fit the exercise, or what is kept is no session.
            OSError: the start cannot be kept.
        """
        self.session: Session = start.session()
        self._identity = identity
        self._board = board
        self._robots = tuple(robots)
        self._store = store
        self._keys: set[str] = set()
        self._count = 0
        for entry in store.entries(identity):
            self._recall(entry)
        if not self._count:
            self._keep("start", Milliseconds(0), encode_start(start), utc)

    @property
    def has_ended(self) -> bool:
        """Whether it is over."""
        return self.session.phase is Phase.ENDED

    def has_heard(self, key: str) -> bool:
        """Whether an event has been fed under this key."""
        return self._key(key) in self._keys

    def feed(self, event: Event, now: Milliseconds, utc: str, key: str | None = None) -> Commands:
        """Let `event` happen, and all that follows from it; returns what was done.

        Args:
            event: what happened.
            now: since the session began.
            utc: the time of day.
            key: the teller's own name for this event; told again under it, nothing happens.

        Raises:
            OSError: it cannot be kept; then nothing was done about it.
        """
        if key is not None and self.has_heard(key):
            return ()
        waiting: deque[Event] = deque([event])
        done: list[Command] = []
        for _ in range(MOST_ECHOES):
            if not waiting:
                break
            commands = self._step(waiting.popleft(), now, utc, key)
            key = None
            done += commands
            for command in commands:
                for robot in self._robots:
                    waiting.extend(robot.carry_out(command))
            waiting.extend(self._board.events())
        return tuple(done)

    def poll(self, now: Milliseconds, utc: str) -> Commands:
        """Feed what board and robots have told since, and the time if something is due.

        Raises:
            OSError: it cannot be kept.
        """
        told = [*self._board.events(), *(each for one in self._robots for each in one.outcomes())]
        at = due(self.session)
        if at is not None and now >= at:
            told.append(TimePassed())
        return tuple(command for event in told for command in self.feed(event, now, utc))

    def _step(self, event: Event, now: Milliseconds, utc: str, key: str | None) -> Commands:
        session, commands = step(self.session, event, now)
        timed = TimedEvent(Milliseconds(session.now if not self.has_ended else now), event)
        written = json.dumps(encode_commands(commands), ensure_ascii=False)
        self._keep("event", timed.at, encode_line(timed), utc, written, key)
        self.session = session
        return commands

    def _keep(
        self,
        kind: str,
        at: Milliseconds,
        payload: str,
        utc: str,
        commands: str | None = None,
        teller_key: str | None = None,
    ) -> None:
        key = f"{self._identity}:{self._count}" if teller_key is None else self._key(teller_key)
        entries = [NewEntry(self._identity, key, at, utc, kind, payload)]
        if commands is not None:
            of_commands = f"{self._identity}:{self._count}:commands"
            entries.append(NewEntry(self._identity, of_commands, at, utc, "commands", commands))
        self._store.append(entries)
        self._keys.add(key)
        self._count += 1

    def _key(self, teller_key: str) -> str:
        return f"{self._identity}:told:{teller_key}"

    def _recall(self, entry: Entry) -> None:
        """What was kept happens again, without being done again."""
        if entry.kind == "commands":
            return
        if entry.kind == "event":
            event = decode_event(json.loads(entry.payload))
            self.session, _ = step(self.session, event.what, event.at)
        self._keys.add(entry.key)
        self._count += 1
