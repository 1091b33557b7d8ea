"""Demonstrations as JSON Lines: what docs/schemas/demonstration-1.schema.json says, and no more.

Pure: it decodes bytes that somebody else read, in chunks of any size.
"""

from __future__ import annotations

import json
from decimal import Decimal
from typing import TYPE_CHECKING, Annotated, Final, Literal, cast

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    StrictInt,
    StrictStr,
    ValidationError,
    WithJsonSchema,
)
from pydantic.functional_validators import PlainValidator

from maestra.core.board import MAX_SIDE, Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.json_lines import FormatError, decode_object, shorten, split_lines
from maestra.core.state import Move, State
from maestra.core.tokens import MAX_NUMBER, MAX_TOKENS, Deck, Token, TokenId, Value

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from pydantic_core import ErrorDetails

DEMONSTRATION_FORMAT: Final = "maestra.demonstration/1"

MAX_MOVES: Final = 100_000
"""A move a second for a whole day."""
MAX_TEXT: Final = 1_000
"""Characters in an id, a name, a string value, a label: a tag's UID has 20."""
MAX_WORDS: Final = 1_000_000
"""Words in a lexicon: larger than any language's dictionary of base forms."""


def _value(value: object) -> Value:
    if isinstance(value, bool) or not isinstance(value, int | Decimal | str):
        message = "a number or a string"
        raise ValueError(message)  # noqa: TRY004 - pydantic turns only ValueError into a fault
    if isinstance(value, str) and len(value) > MAX_TEXT:
        message = f"a string of at most {MAX_TEXT} characters"
        raise ValueError(message)
    return value


_Text = Annotated[StrictStr, Field(min_length=1, max_length=MAX_TEXT)]
_Side = Annotated[StrictInt, Field(ge=1, le=MAX_SIDE)]
_Place = tuple[StrictInt, StrictInt]
_Value = Annotated[
    object,
    PlainValidator(_value),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "number", "minimum": -MAX_NUMBER, "maximum": MAX_NUMBER},
                {"type": "string", "maxLength": MAX_TEXT},
            ]
        }
    ),
]
_Order = Annotated[tuple[_Text, ...], Field(min_length=1)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class _BoardJson(_Strict):
    rows: _Side = 4
    columns: _Side = 5
    goal_row: _Side = 1


class _MoveJson(_Strict):
    token: _Text
    origin: _Place
    destination: _Place


class DeckJson(_Strict):
    """The fields of a line that make its deck; exercises write theirs in the same way."""

    tokens: Annotated[dict[_Text, dict[_Text, _Value]], Field(min_length=1, max_length=MAX_TOKENS)]
    orders: dict[_Text, _Order] = Field(default_factory=dict[str, tuple[str, ...]])
    cycles: dict[_Text, _Order] = Field(default_factory=dict[str, tuple[str, ...]])
    relations: dict[_Text, tuple[tuple[_Text, _Text], ...]] = Field(
        default_factory=dict[str, tuple[tuple[str, str], ...]]
    )
    lexicon: Annotated[tuple[_Text, ...], Field(max_length=MAX_WORDS)] = ()

    def deck(self) -> Deck:
        """The deck these fields describe.

        Raises:
            InvalidError: the deck contradicts itself.
        """
        tokens = tuple(
            Token(
                TokenId(token),
                tuple((name, cast("Value", value)) for name, value in shown.items()),
            )
            for token, shown in self.tokens.items()
        )
        relations = {name: frozenset(pairs) for name, pairs in self.relations.items()}
        return Deck(tokens, self.orders, self.cycles, relations, self.lexicon)


class DemonstrationJson(DeckJson):
    """One line of a file of demonstrations, plays or positions."""

    format: Literal["maestra.demonstration/1"]
    board: _BoardJson
    start: dict[_Text, _Place]
    moves: Annotated[tuple[_MoveJson, ...], Field(max_length=MAX_MOVES)]
    label: Annotated[StrictStr, Field(max_length=MAX_TEXT)] | None = None
    times_ms: tuple[StrictInt, ...] | None = None
    source: Annotated[StrictStr, Field(max_length=MAX_TEXT)] | None = None

    def demonstration(self) -> Demonstration:
        """The demonstration this line describes.

        Raises:
            InvalidError: the line is well-formed, but no board could show it.
        """
        board = Board(self.board.rows, self.board.columns, Row(self.board.goal_row))
        deck = self.deck()
        start = _state(board, self.start)
        moves = tuple(
            Move(TokenId(move.token), _cell(move.origin), _cell(move.destination))
            for move in self.moves
        )
        return Demonstration(deck, start, moves, self.label, self.times_ms, self.source)


def read_demonstrations(chunks: Iterable[bytes], file: str) -> Iterator[Demonstration]:
    """The demonstrations of a file, one after another, in constant memory.

    Args:
        chunks: the file's bytes, cut anywhere.
        file: its name, for messages.

    Raises:
        FormatError: at the first line that is no demonstration, is on another board than the
            first, or when there is none at all.
    """
    board: Board | None = None
    for number, line in split_lines(chunks, file):
        demonstration = decode_demonstration(line, file, number)
        if board is not None and demonstration.board != board:
            found, expected = (
                _describe(demonstration.board),
                f"{_describe(board)} as on line 1",
            )
            raise FormatError(file, number, (Fault("board", found, expected),))
        board = demonstration.board
        yield demonstration
    if board is None:
        expected = "at least one demonstration, one a line"
        raise FormatError(file, 1, (Fault("", "an empty file", expected),))


def decode_demonstration(line: bytes, file: str = "-", number: int = 1) -> Demonstration:
    """The demonstration on one line.

    Raises:
        FormatError: it is none; with every fault.
    """
    fields = decode_object(line, file, number, DEMONSTRATION_FORMAT)
    try:
        return DemonstrationJson.model_validate(fields).demonstration()
    except ValidationError as error:
        faults = tuple(_fault(detail) for detail in error.errors(include_url=False))
        raise FormatError(file, number, faults) from None
    except InvalidError as error:
        raise FormatError(file, number, error.faults) from None


def encode_demonstration(demonstration: Demonstration) -> str:
    """The demonstration as one line of JSON, without the line's end."""
    board = demonstration.board
    fields: dict[str, object] = {
        "format": DEMONSTRATION_FORMAT,
        "board": {
            "rows": board.rows,
            "columns": board.columns,
            "goal_row": board.goal_row,
        },
        **encode_deck(demonstration.deck),
        "start": {token: _pair(cell) for token, cell in demonstration.start.cells.items()},
        "moves": [encode_move(move) for move in demonstration.moves],
    }
    optional = {
        "label": demonstration.label,
        "times_ms": demonstration.times_ms,
        "source": demonstration.source,
    }
    fields |= {name: value for name, value in optional.items() if value is not None}
    return json.dumps(fields, ensure_ascii=False)


def encode_deck(deck: Deck) -> dict[str, object]:
    """The fields of `DeckJson`, the empty ones left out."""
    optional: dict[str, object] = {
        "orders": {name: list(values) for name, values in deck.orders.items()},
        "cycles": {name: list(values) for name, values in deck.cycles.items()},
        "relations": {name: sorted(map(list, pairs)) for name, pairs in deck.relations.items()},
        "lexicon": list(deck.lexicon),
    }
    tokens = {token.id: encode_attributes(token.attributes) for token in deck.tokens}
    return {"tokens": tokens} | {name: value for name, value in optional.items() if value}


def encode_attributes(
    attributes: Iterable[tuple[str, Value]],
) -> dict[str, int | float | str]:
    """What a token shows, as JSON numbers and strings."""
    return {
        name: float(value) if isinstance(value, Decimal) else value for name, value in attributes
    }


def encode_move(move: Move) -> dict[str, object]:
    """A move as formats.md writes it."""
    return {
        "token": move.token,
        "origin": _pair(move.origin),
        "destination": _pair(move.destination),
    }


def _fault(detail: ErrorDetails) -> Fault:
    """Pydantic's words in ours: the path in brackets and dots, what is there, what should be."""
    path = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in detail["loc"])
    where = path.removeprefix(".").removesuffix(".[key]")
    found, context = shorten(detail["input"]), detail.get("ctx", {})
    match detail["type"]:
        case "missing":
            return Fault(where, "missing", "this field")
        case "extra_forbidden":
            return Fault(where, "unknown field", "only the fields of the format")
        case "value_error":
            return Fault(where, found, str(context["error"]))
        case _:
            message = detail["msg"]
            return Fault(where, found, message[0].lower() + message[1:])


def _state(board: Board, places: Mapping[str, tuple[int, int]]) -> State:
    try:
        return State(board, {TokenId(token): _cell(place) for token, place in places.items()})
    except InvalidError as error:
        raise InvalidError(
            [Fault(f"start.{fault.where}", fault.found, fault.expected) for fault in error.faults]
        ) from None


def _cell(place: tuple[int, int]) -> Cell:
    return Cell(Row(place[0]), Column(place[1]))


def _pair(cell: Cell) -> tuple[int, int]:
    return (cell.row, cell.column)


def _describe(board: Board) -> str:
    return f"{board.rows} x {board.columns} with goal row {board.goal_row}"
