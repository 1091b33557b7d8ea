"""What is to be seen and heard in a room: all of it follows from the session and its commands.

So a client that missed something, and a server that was switched off, are right again as soon as
they have the newest state.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final, NewType

from maestra.coaching.commands import (
    AskCaregiver,
    Command,
    Commands,
    Express,
    Expression,
    Gesture,
    GestureName,
    MoveToken,
    PointAt,
    Record,
    Say,
    Show,
    encode_command,
)
from maestra.coaching.notes import Note
from maestra.coaching.recording import Start
from maestra.coaching.session import Ending, Session
from maestra.coaching.settings import Modality
from maestra.coaching.table import Table
from maestra.core.board import Board, Cell
from maestra.core.tokens import TokenId
from maestra.language import NO_LEXICON, Language, Lexicon, read_words
from maestra.web.board_view import tokens_by_id
from maestra.web.token_view import TokenView

RoomName = NewType("RoomName", str)
"""A place's short name, in addresses too: ``1``, ``garden``."""
ROOM_PATTERN: Final = r"^[a-z0-9]{1,20}$"

EMPTY: Final = "empty"
"""The phase of a room in which nobody has begun anything."""


@dataclass(frozen=True, slots=True)
class Said:
    """What the robot said last: all the sentences of one moment."""

    number: int
    text: str


@dataclass(frozen=True, slots=True)
class Stage:
    """What all commands so far come to."""

    steps: int = 0
    """Moments so far, each with its commands."""
    said: Said | None = None
    expression: Expression = Expression.NEUTRAL
    gesture: GestureName | None = None
    """Of the last moment alone."""
    pointed: tuple[Cell, ...] = ()
    shown: Show | None = None
    asked: AskCaregiver | None = None
    moves: tuple[MoveToken, ...] = ()
    """Which the robot has not yet told the outcome of."""

    def after(self, commands: Commands) -> Stage:
        """The stage one moment later."""
        stage = replace(self, steps=self.steps + 1, gesture=None)
        sentences = [command.text for command in commands if isinstance(command, Say)]
        if sentences:
            said = Said(stage.steps, " ".join(sentences))
            # A new sentence: what the one before it pointed at no longer matters.
            stage = replace(stage, said=said, pointed=())
        for command in commands:
            stage = _with(stage, command)
        return stage


@dataclass(frozen=True)
class RoomState:
    """All that anybody in a room needs to know, in one message."""

    room: RoomName
    sequence: int = 0
    """Moments of the session so far."""
    session: str = ""
    phase: str = EMPTY
    connected: bool = True
    board: tuple[int, int, int] | None = None
    """Rows, columns, goal row."""
    cells: Mapping[TokenId, Cell] | None = None
    """Where tokens lie; one that was lifted still counts as where it was lifted from."""
    held: tuple[TokenId, ...] = ()
    """Those that were lifted; the last one last."""
    tokens: Mapping[TokenId, TokenView] | None = None
    rules: tuple[str, ...] = ()
    """What the exercise asks for, in sentences."""
    said: Said | None = None
    expression: Expression = Expression.NEUTRAL
    gesture: GestureName | None = None
    pointed: tuple[Cell, ...] = ()
    shown: Show | None = None
    question: AskCaregiver | None = None
    awaiting: tuple[MoveToken, ...] = ()
    """Tokens that a robot is to move."""
    language: Language = Language.EN
    moves: int = 0
    """The patient's own right ones."""
    speaks: bool = False
    """Whether what is said can be heard, and is to be."""
    another_round: bool = False
    """Whether the sitting has a round more, which may begin now."""
    has_board: bool = False
    """Whether a board has joined; then screens show it, and nothing is moved on them."""

    @property
    def is_under_way(self) -> bool:
        """Whether a session is going on."""
        return self.phase not in {EMPTY, "ended"}

    def as_json(self, *, for_caregiver: bool) -> dict[str, Any]:
        """As the stream carries it; what is asked of the caregiver is for nobody else."""
        shown, question = self.shown, self.question if for_caregiver else None
        return {
            "sequence": self.sequence,
            "type": "state",
            "room": self.room,
            "session": self.session,
            "phase": self.phase,
            "connected": self.connected,
            "board": None
            if self.board is None
            else dict(zip(("rows", "columns", "goal_row"), self.board, strict=True)),
            "cells": _pairs(self.cells or {}),
            "held": list(self.held),
            "tokens": {one: view.as_json() for one, view in (self.tokens or {}).items()},
            "rules": list(self.rules),
            "said": None
            if self.said is None
            else {
                "number": self.said.number,
                "text": self.said.text,
                "speech": f"/api/rooms/{self.room}/speech/{self.said.number}"
                if self.speaks
                else None,
            },
            "expression": self.expression.value,
            "gesture": None if self.gesture is None else self.gesture.value,
            "pointed": [[cell.row, cell.column] for cell in self.pointed],
            "view": None
            if shown is None
            else {
                "view": shown.view.value,
                "tokens": list(shown.tokens),
                "lines": list(shown.lines),
            },
            "question": None
            if question is None
            else {
                "number": question.number,
                "matter": question.matter.value,
                "text": question.text,
                "tokens": list(question.tokens),
            },
            "awaiting": [encode_command(one) for one in self.awaiting],
            "language": self.language.value,
            "moves": self.moves,
            "another_round": self.another_round,
            "has_board": self.has_board,
        }


@dataclass(frozen=True)
class Scenery:
    """What stays the same through a session."""

    room: RoomName
    start: Start
    session: str
    tokens: Mapping[TokenId, TokenView]
    pictures: Mapping[str, str]
    """What tokens show under `picture`, to the addresses of pictures."""
    lexicon: Lexicon
    round: int
    """Of the sitting, from 1."""
    speaks: bool

    @classmethod
    def of(
        cls,
        room: RoomName,
        session: str,
        start: Start,
        pictures: Mapping[str, str],
        *,
        number: int,
        can_speak: bool,
    ) -> Scenery:
        """Made once, when the session begins.

        Args:
            room: where it is played.
            session: its id.
            start: what it follows from.
            pictures: what tokens show under `picture`, to the addresses of pictures.
            number: which round of the sitting it is, from 1.
            can_speak: whether there is a voice at all.
        """
        settings = start.settings
        lexicon = NO_LEXICON if start.words is None else read_words(start.words.encode())
        board = start.state.board
        tokens = tokens_by_id(start.deck, board, settings.language, lexicon, pictures)
        speaks = can_speak and Modality.SPEECH in settings.modalities
        return cls(room, start, session, tokens, pictures, lexicon, number, speaks)

    def state(self, session: Session, stage: Stage) -> RoomState:
        """The room's state: nothing but what follows from these."""
        table, asked = session.table, stage.asked
        board = self.start.state.board
        # A question stands until what it is about is settled.
        stands = asked is not None and session.question == (asked.number, asked.matter)
        return RoomState(
            room=self.room,
            sequence=stage.steps,
            session=self.session,
            phase=session.phase.value,
            connected=session.connected,
            board=(board.rows, board.columns, board.goal_row),
            cells=_seen(table, board),
            held=tuple(table.air),
            tokens=self.tokens,
            rules=session.game.referee.rules,
            said=stage.said,
            expression=stage.expression,
            gesture=stage.gesture,
            pointed=stage.pointed,
            shown=stage.shown,
            question=asked if stands else None,
            awaiting=tuple(one for one in stage.moves if table.cells.get(one.token) == one.origin),
            language=self.start.settings.language,
            moves=session.tally.moves,
            speaks=self.speaks,
            another_round=session.ending is Ending.COMPLETE
            and self.round < self.start.settings.rounds,
        )


def _seen(table: Table, board: Board) -> dict[TokenId, Cell]:
    """Where a screen shows each token: a lifted one where it was lifted from.

    Where another lies by now it is shown in storage, so that it can still be taken.
    """
    cells = dict(table.cells)
    for token, origin in table.air.items():
        taken = set(cells.values())
        free = [cell for cell in (origin, *board.storage_cells) if cell not in taken]
        if free:
            cells[token] = free[0]
    return cells


def _pairs(cells: Mapping[TokenId, Cell]) -> dict[TokenId, list[int]]:
    return {token: [cell.row, cell.column] for token, cell in cells.items()}


def _with(stage: Stage, command: Command) -> Stage:
    match command:
        case Express(expression):
            return replace(stage, expression=expression)
        case Gesture(gesture):
            return replace(stage, gesture=gesture)
        case PointAt(cells):
            return replace(stage, pointed=cells)
        case Show():
            return replace(stage, shown=command)
        case AskCaregiver():
            return replace(stage, asked=command)
        case MoveToken():
            return replace(stage, moves=(*stage.moves, command))
        case Record(Note.ROBOT_DONE.value | Note.ROBOT_FAILED.value, {"command": done}):
            left = tuple(one for one in stage.moves if one.number != done)
            return replace(stage, moves=left)
        case _:
            return stage
