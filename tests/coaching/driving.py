"""A session driven by hand: events in, commands kept, what was said at hand."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from maestra.coaching.commands import Command, Commands, Record, Say
from maestra.coaching.events import Event, TimedEvent, TimePassed, TokenLifted, TokenPlaced
from maestra.coaching.fields import Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.playing import step
from maestra.coaching.policies import Policy
from maestra.coaching.session import Game, Session, due, new_session
from maestra.core.tokens import TokenId
from maestra.language.coach_keys import CoachKey
from tests.coaching.plain_referee import cell, token


@dataclass
class Driver:
    """Feeds events to a session, one second after another if no time is given."""

    session: Session
    events: list[TimedEvent] = field(default_factory=list[TimedEvent])
    commands: list[Commands] = field(default_factory=list[Commands])

    @classmethod
    def of(cls, game: Game, policy: Policy | None = None) -> Driver:
        return cls(new_session(game, policy))

    def feed(self, event: Event, after_ms: int = 1_000) -> Commands:
        at = Milliseconds(self.session.now + after_ms)
        self.session, commands = step(self.session, event, at)
        self.events.append(TimedEvent(at, event))
        self.commands.append(commands)
        return commands

    def move(self, value: int, row: int, column: int) -> Commands:
        """Lift a token and place it; what the placing led to."""
        self.feed(TokenLifted(token(value)))
        return self.feed(TokenPlaced(token(value), cell(row, column)))

    def home(self, value: int) -> Commands:
        """Put a token back where it belongs."""
        where = self.session.position.now.cells[token(value)]
        return self.move(value, where.row, where.column)

    def wait(self) -> Commands:
        """Let time pass until something is due."""
        at = due(self.session)
        assert at is not None
        return self.feed(TimePassed(), at - self.session.now)

    def astray(self) -> tuple[TokenId, ...]:
        return self.session.table.astray(self.session.position.now)


def said(commands: Iterable[Command]) -> list[CoachKey]:
    """What was said, by its keys."""
    return [CoachKey(command.key) for command in commands if isinstance(command, Say)]


def noted(commands: Iterable[Command]) -> list[Note]:
    """What was noted, by its kind."""
    return [Note(command.note) for command in commands if isinstance(command, Record)]


def fields_of(commands: Iterable[Command], note: Note) -> dict[str, int | bool | str | None]:
    """The fields of the first note of a kind."""
    return next(c.fields for c in commands if isinstance(c, Record) and c.note == note.value)


def of_kind(commands: Iterable[Command], kind: type[Command]) -> list[Command]:
    return [command for command in commands if isinstance(command, kind)]
