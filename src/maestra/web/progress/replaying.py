"""A session moment by moment: the board, what was said, and why.

It is read from the record alone: what was said then stands here, also when a newer Maestra would
say something else.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

from maestra.coaching.commands import AskCaregiver, Commands, Record, Say, decode_command
from maestra.coaching.events import (
    BoardBack,
    Event,
    SeveralTokens,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    decode_event,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.ports import Entry
from maestra.coaching.recording import Start, decode_start
from maestra.coaching.table import Table
from maestra.core.board import Cell, Column, Row
from maestra.core.state import State
from maestra.core.tokens import TokenId
from maestra.web.rooms.stage import Stage

NOTABLE: Final = (
    Note.MOVE,
    Note.REFUSED,
    Note.RETURNED,
    Note.OVERRIDDEN,
    Note.SKIPPED,
    Note.SILENCE,
    Note.PAUSED,
    Note.RESUMED,
    Note.BOARD_LOST,
    Note.BOARD_BACK,
    Note.NO_WAY_ON,
    Note.BEGUN,
    Note.ENDED,
)
"""What a moment is shown as on the time line, the first that applies."""


@dataclass(frozen=True, slots=True)
class Why:
    """What stands in the record about help."""

    level: int
    attempt: int
    step: int
    why: str
    """policy, silence, asked or ordered."""


@dataclass(frozen=True, slots=True)
class Moment:
    """What happened at one time, and everything as it was then."""

    number: int
    """From 0, the start."""
    at: Milliseconds
    event: Event | None
    """None at the start."""
    cells: Mapping[TokenId, Cell]
    """Where tokens lie; one in the air where it was lifted from."""
    held: TokenId | None
    pointed: tuple[Cell, ...] = ()
    wrong: tuple[Cell, ...] = ()
    """Where tokens lie that should be put back."""
    said: tuple[str, ...] = ()
    standing: str = ""
    """What was said last, now or before."""
    asked: tuple[str, ...] = ()
    """Of the caregiver."""
    help: Why | None = None
    kind: Note | None = None
    """The most notable thing about it."""
    notes: tuple[tuple[str, Mapping[str, Any]], ...] = ()
    """All that was noted, by kind, with its fields."""


@dataclass(frozen=True, slots=True)
class Recorded:
    """A session from its start to where the record ends."""

    start: Start
    moments: tuple[Moment, ...]
    """At least the start."""

    def nearest(self, number: int) -> Moment:
        """The moment of this number, or the first or last one."""
        return self.moments[min(max(number, 0), len(self.moments) - 1)]

    @property
    def notable(self) -> tuple[Moment, ...]:
        """Those that stand on the time line."""
        return tuple(one for one in self.moments if one.kind is not None)


def recorded(entries: Iterable[Entry]) -> Recorded | None:
    """The session whose entries these are; None if not even its start was kept.

    Raises:
        InvalidError: they are of another Maestra.
    """
    found = iter(entries)
    first = next(found, None)
    if first is None:
        return None
    start = decode_start(first.payload.encode())
    return Recorded(start, tuple(_moments(start, found)))


def _moments(start: Start, entries: Iterator[Entry]) -> Iterator[Moment]:
    lies = _Lies(Table.of(start.state), start.state)
    stage = Stage()
    moment = lies.moment(0, Milliseconds(0), None)
    waiting = True
    for entry in entries:
        if entry.kind == "event":
            if waiting:
                yield moment
            timed = decode_event(json.loads(entry.payload))
            lies = lies.after(timed.what)
            moment = lies.moment(moment.number + 1, timed.at, timed.what)
            moment = replace(moment, standing=_standing(stage), pointed=stage.pointed)
            waiting = True
        elif entry.kind == "commands":
            commands: Commands = tuple(map(decode_command, json.loads(entry.payload)))
            stage = stage.after(commands)
            lies = lies.noted(commands)
            moment = _with(lies.moment(moment.number, moment.at, moment.event), commands, stage)
            yield moment
            waiting = False
    if waiting:
        # The power went between an event and what was done about it.
        yield moment


@dataclass(frozen=True, slots=True)
class _Lies:
    """What lies where, and where it should."""

    table: Table
    should: State
    origin: Cell | None = None
    """Where the last right move came from."""

    def after(self, event: Event) -> _Lies:
        """Once the board has told this."""
        table = self.table
        match event:
            case TokenLifted(token) if token in table.cells:
                return replace(self, table=table.lifted(token))
            case TokenPlaced(token, cell) if token in self.should.cells:
                return replace(self, table=table.placed(token, cell))
            case TokenPutBack(token) if token in self.should.cells:
                cell = table.air.get(token, table.cells.get(token, self.should.cells[token]))
                return replace(self, table=table.placed(token, cell))
            case SeveralTokens(tokens):
                for token in tokens:
                    if token in table.cells:
                        table = table.lifted(token)
                return replace(self, table=table)
            case BoardBack(cells):
                lying = {token: cell for token, cell in cells.items() if cell in self.should.board}
                return replace(self, table=Table.seen(lying, self.should))
            case _:
                return self

    def noted(self, commands: Commands) -> _Lies:
        """Once moves were found right, or the last right one was judged otherwise."""
        lies = self
        for command in commands:
            match command:
                case Record(Note.MOVE.value, fields):
                    lies = lies.moved(fields, _cell(fields), _cell(fields, "from_"))
                case Record(Note.OVERRIDDEN.value, fields) if not fields["allowed"]:
                    lies = lies.moved(fields, self.origin, None)
                case _:
                    pass
        return lies

    def moved(self, fields: Mapping[str, Any], cell: Cell | None, origin: Cell | None) -> _Lies:
        """Once a token should lie elsewhere."""
        if cell is None:
            return self
        cells = {**self.should.cells, TokenId(str(fields["token"])): cell}
        return replace(self, should=State(self.should.board, cells), origin=origin)

    def moment(self, number: int, at: Milliseconds, event: Event | None) -> Moment:
        """The board as it is now."""
        cells = {**self.table.air, **self.table.cells}
        taken = set(self.table.cells.values())
        # A token in the air shows where it was, unless another one lies there now.
        shown = {
            token: cell
            for token, cell in cells.items()
            if cell in self.should.board and (token in self.table.cells or cell not in taken)
        }
        wrong = tuple(
            cell for token, cell in self.table.cells.items() if self.should.cells[token] != cell
        )
        held = next(reversed([token for token in self.table.air if token in shown]), None)
        return Moment(number, at, event, shown, held, wrong=wrong)


def _with(moment: Moment, commands: Commands, stage: Stage) -> Moment:
    notes = tuple((one.note, dict(one.fields)) for one in commands if isinstance(one, Record))
    kinds = {note for note, _ in notes}
    help_given = next((fields for note, fields in notes if note == Note.HELP.value), None)
    return replace(
        moment,
        pointed=stage.pointed,
        said=tuple(one.text for one in commands if isinstance(one, Say)),
        standing=_standing(stage),
        asked=tuple(one.text for one in commands if isinstance(one, AskCaregiver)),
        help=None if help_given is None else _why(help_given),
        kind=next((one for one in NOTABLE if one.value in kinds), None),
        notes=notes,
    )


def _standing(stage: Stage) -> str:
    return "" if stage.said is None else stage.said.text


def _why(fields: Mapping[str, Any]) -> Why:
    return Why(fields["level"], fields["attempt"], fields["step"], fields["why"])


def _cell(fields: Mapping[str, Any], prefix: str = "") -> Cell:
    return Cell(Row(int(fields[f"{prefix}row"])), Column(int(fields[f"{prefix}column"])))
