"""An exercise to play in a room, and somebody who plays it."""

import json
from dataclasses import replace
from typing import Final

from maestra.coaching.ports import PatientId, Store
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.settings import Settings
from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import Move
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.exercise import LearnStatus, RuledExercise, meant_rules
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import NUMBER_DECK
from maestra.rules.setting import Line
from maestra.storage.drafts import Drafts, StoredPicture
from maestra.storage.store import SqlStore
from maestra.web.rooms.room import Room
from maestra.web.token_view import PICTURE

RULES: Final = (
    Ordered("value", Direction.RISING, strict=True, line=Line.ROW),
    FullRow(),
    FillOrder(Filling.LEFT_TO_RIGHT),
)
ASCENDING: Final = RuledExercise(
    Board(),
    NUMBER_DECK,
    meant_rules(RULES, [1.0, 1.0, 1.0]),
    1.0,
    LearnStatus.TOLD,
    RULES,
)
HERON: Final = PatientId("heron")
PLOVER: Final = PatientId("plover")


def prepare(store: Store, settings: Settings | None = None) -> None:
    """Have the store know the exercise, and two patients."""
    store.save_exercise("ascending", encode_exercise(ASCENDING))
    for patient in (HERON, PLOVER):
        store.save_settings(patient, write_remembered(Remembered(settings or Settings())))


def keep_cups(store: SqlStore) -> str:
    """Have the store know an exercise with a picture on each token; the picture's address."""
    tokens = [Token(one.id, (*one.attributes, (PICTURE, "cup"))) for one in NUMBER_DECK.tokens]
    exercise = replace(ASCENDING, deck=Deck(tuple(tokens)))
    version = store.save_exercise("cups", encode_exercise(exercise))
    digest = Drafts(store).keep_picture(StoredPicture("image/png", b"png"))
    Drafts(store).save_shown("cups", version, {"cup": digest})
    return f"/pictures/{digest}"


def right_move(room: Room) -> Move:
    """A move that is right now."""
    session = room.session
    return session.game.referee.right_moves(session.position)[0]


def wrong_move(room: Room) -> Move:
    """One that is not."""
    session = room.session
    now, right = session.position.now, set(session.game.referee.right_moves(session.position))
    free = [cell for cell in now.board.goal_cells if cell not in now.tokens]
    moves = (
        Move(token, origin, cell)
        for cell in free
        for token, origin in now.cells.items()
        if origin not in now.board.goal_cells
    )
    return next(move for move in moves if move not in right)


def pair(cell: Cell) -> list[int]:
    return [cell.row, cell.column]


def placed(move: Move) -> dict[str, object]:
    """The event of a move, as JSON."""
    return {"event": "placed", "token": move.token, "cell": pair(move.destination)}


def told(identity: str, event: str, **fields: object) -> str:
    """A message to the stream."""
    return json.dumps({"id": identity, "event": {"event": event, **fields}})


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def token(name: str) -> TokenId:
    return TokenId(name)
