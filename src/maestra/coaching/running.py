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
from maestra.coaching.events import Event, TimedEvent, TimePassed
from maestra.coaching.fields import Milliseconds
from maestra.coaching.playing import step
from maestra.coaching.ports import Board, EventStore, NewEntry, Robot, SessionId
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
        """Keep the start; nothing else happens yet.

        Args:
            identity: the session's, unique in the store.
            start: what it follows from.
            board: tells what is moved.
            robots: carry commands out, each in its way.
            store: keeps events and commands.
            utc: the time of day.

        Raises:
            InvalidError: the tokens do not fit the exercise.
            OSError: the start cannot be kept.
        """
        self.session: Session = start.session()
        self._identity = identity
        self._board = board
        self._robots = tuple(robots)
        self._store = store
        self._count = 0
        self._keep("start", Milliseconds(0), encode_start(start), utc)

    @property
    def has_ended(self) -> bool:
        """Whether it is over."""
        return self.session.phase is Phase.ENDED

    def feed(self, event: Event, now: Milliseconds, utc: str) -> Commands:
        """Let `event` happen, and all that follows from it; returns what was done.

        Raises:
            OSError: it cannot be kept; then nothing was done about it.
        """
        waiting: deque[Event] = deque([event])
        done: list[Command] = []
        for _ in range(MOST_ECHOES):
            if not waiting:
                break
            commands = self._step(waiting.popleft(), now, utc)
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

    def _step(self, event: Event, now: Milliseconds, utc: str) -> Commands:
        session, commands = step(self.session, event, now)
        timed = TimedEvent(Milliseconds(session.now if not self.has_ended else now), event)
        written = json.dumps(encode_commands(commands), ensure_ascii=False)
        self._keep("event", timed.at, encode_line(timed), utc, written)
        self.session = session
        return commands

    def _keep(
        self, kind: str, at: Milliseconds, payload: str, utc: str, commands: str | None = None
    ) -> None:
        number = self._count
        entries = [NewEntry(self._identity, f"{self._identity}:{number}", at, utc, kind, payload)]
        if commands is not None:
            key = f"{self._identity}:{number}:commands"
            entries.append(NewEntry(self._identity, key, at, utc, "commands", commands))
        self._store.append(entries)
        self._count += 1
