"""Demonstrations as JSON Lines: what docs/schemas/demonstration-1.schema.json says, and no more.

Pure: it decodes bytes that somebody else read, in chunks of any size.
"""

import json
from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal
from functools import lru_cache
from typing import Annotated, Final, Literal, TypeVar, cast

from pydantic import BaseModel, ConfigDict, FailFast, Field, StrictInt, StrictStr, ValidationError
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import WithJsonSchema

from maestra.core.board import MAX_SIDE, Board, Cell, Column, Row
from maestra.core.demonstration import MAX_MOVES, MAX_TIME_MS, Demonstration, Play, Source
from maestra.core.faults import Fault, InvalidError, attempt
from maestra.core.json_faults import AtMost, Expecting, faults_of_validation
from maestra.core.json_lines import FormatError, decode_object, split_lines
from maestra.core.state import Move, State
from maestra.core.text import MAX_TEXT, PLAIN
from maestra.core.tokens import (
    MAX_LISTED,
    MAX_NAMES,
    MAX_NUMBER,
    MAX_TOKENS,
    MAX_WORDS,
    Deck,
    Token,
    TokenId,
    Value,
    expected_value,
)

DEMONSTRATION_FORMAT: Final = "maestra.demonstration/1"

_Played = TypeVar("_Played", bound=Play)


def _value(value: object) -> Value:
    if (expected := expected_value(value)) is not None:
        raise ValueError(expected)
    return cast("Value", value)


_Text = Annotated[
    StrictStr,
    Field(min_length=1, max_length=MAX_TEXT, pattern=PLAIN),
    Expecting(f"text of 1 to {MAX_TEXT} characters without control characters"),
]
_Side = Annotated[
    StrictInt, Field(ge=1, le=MAX_SIDE), Expecting(f"a whole number from 1 to {MAX_SIDE}")
]
_Place = Annotated[
    tuple[StrictInt, StrictInt],
    Expecting("a cell, [row, column]"),
    WithJsonSchema(
        {
            "type": "array",
            "description": "A cell: [row, column], both from 1; row 1, column 1 is the left end "
            "of the first row as the patient sits.",
            "prefixItems": [{"type": "integer", "minimum": 1, "maximum": MAX_SIDE}] * 2,
            "minItems": 2,
            "maxItems": 2,
        }
    ),
]
_Value = Annotated[
    object,
    PlainValidator(_value),
    WithJsonSchema(
        {
            "description": "A number is ordinal: ordered, with arithmetic, of at most 15 digits. "
            "A string is nominal: only the same or different, unless `orders` or `cycles` says "
            "more or it is one letter under the name `letter`.",
            "anyOf": [
                {"type": "number", "minimum": -MAX_NUMBER, "maximum": MAX_NUMBER},
                {"type": "string", "maxLength": MAX_TEXT, "pattern": PLAIN},
            ],
        }
    ),
]
# Deck refuses what is empty: pydantic would call a list empty once all of it is wrong.
_Order = Annotated[
    tuple[_Text, ...],
    Field(max_length=MAX_LISTED, json_schema_extra={"minItems": 1}),
    FailFast(),
    AtMost(MAX_LISTED),
]
_Pair = Annotated[tuple[_Text, _Text], Expecting("a pair of names")]
_Pairs = Annotated[tuple[_Pair, ...], Field(max_length=MAX_LISTED), FailFast(), AtMost(MAX_LISTED)]
_TimeMs = Annotated[
    StrictInt, Field(ge=0, le=MAX_TIME_MS), Expecting("a whole number of milliseconds from 0")
]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class BoardJson(_Strict):
    """The grid that the tokens lie on."""

    rows: Annotated[_Side, Field(description="How many rows, the goal row among them.")] = 4
    columns: Annotated[_Side, Field(description="How many cells each row has.")] = 5
    goal_row: Annotated[
        _Side, Field(description="The row that tokens are moved to, counted from 1.")
    ] = 1

    def board(self) -> Board:
        """The board these fields describe.

        Raises:
            InvalidError: its goal row is not on it.
        """
        return _board(self.rows, self.columns, self.goal_row)


class MoveJson(_Strict):
    """One pick-and-place."""

    token: Annotated[_Text, Field(description="The id of the token that is moved.")]
    origin: Annotated[_Place, Field(description="Where it lay.")]
    destination: Annotated[_Place, Field(description="Where it was put: an empty cell.")]


class DeckJson(_Strict):
    """The fields of a line that make its deck; exercises write theirs in the same way."""

    tokens: Annotated[
        dict[_Text, Annotated[dict[_Text, _Value], Field(max_length=MAX_NAMES)]],
        Field(
            max_length=MAX_TOKENS,
            json_schema_extra={"minProperties": 1},
            description="Each token's id (on an electronic board the UID of its tag) with its "
            "attributes by name. An attribute holds numbers on all tokens or strings on all.",
            examples=[{"04A3B2": {"value": 19}, "04A3B3": {"value": 23, "colour": "red"}}],
        ),
        AtMost(MAX_TOKENS),
    ]
    orders: Annotated[
        dict[_Text, _Order],
        Field(
            max_length=MAX_NAMES,
            description="Attributes whose strings are ordered, each with its values from first "
            "to last.",
            examples=[{"day": ["Monday", "Tuesday"]}],
        ),
    ] = Field(default_factory=dict[str, tuple[str, ...]])
    cycles: Annotated[
        dict[_Text, _Order],
        Field(
            max_length=MAX_NAMES,
            description="As `orders`, but the first value also follows the last.",
        ),
    ] = Field(default_factory=dict[str, tuple[str, ...]])
    relations: Annotated[
        dict[_Text, _Pairs],
        Field(
            max_length=MAX_NAMES,
            description="Relations between tokens, each with its pairs of values of the "
            "attribute `name`.",
            examples=[{"partner": [["cup", "saucer"]]}],
        ),
    ] = Field(default_factory=dict[str, tuple[tuple[str, str], ...]])
    lexicon: Annotated[
        tuple[_Text, ...],
        Field(
            max_length=MAX_WORDS,
            description="The words that count as words, for rules about spelling.",
            examples=[["CURIE"]],
        ),
        FailFast(),
        AtMost(MAX_WORDS),
    ] = ()

    def deck(self) -> Deck:
        """The deck these fields describe.

        Raises:
            InvalidError: the deck contradicts itself.
        """
        tokens = tuple(
            Token(TokenId(token), tuple(cast("dict[str, Value]", shown).items()))
            for token, shown in self.tokens.items()
        )
        relations = {name: frozenset(pairs) for name, pairs in self.relations.items()}
        return Deck(tokens, self.orders, self.cycles, relations, self.lexicon)


class DemonstrationJson(DeckJson):
    """One line of a file of demonstrations, plays or positions (JSON Lines, UTF-8).

    All three have one shape: a play is a demonstration by a patient, a position a play that is
    not finished.
    """

    format: Annotated[
        Literal["maestra.demonstration/1"],
        Field(description="The name and version of this format."),
    ]
    board: Annotated[BoardJson, Field(description="The board, the same on every line of a file.")]
    start: Annotated[
        dict[_Text, _Place],
        Field(
            max_length=MAX_TOKENS,
            description="Where each token of `tokens` lies before the first move; one token a "
            "cell at most.",
            examples=[{"04A3B2": [2, 1], "04A3B3": [3, 4]}],
        ),
        AtMost(MAX_TOKENS),
    ]
    moves: Annotated[
        tuple[MoveJson, ...],
        Field(
            max_length=MAX_MOVES,
            description="What was moved, in order; each move starts where its token lies by then.",
            examples=[[{"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]}]],
        ),
        AtMost(MAX_MOVES),
    ]
    label: Annotated[
        Annotated[
            StrictStr,
            Field(max_length=MAX_TEXT, pattern=PLAIN),
            Expecting(f"text of at most {MAX_TEXT} characters without control characters"),
        ]
        | None,
        Field(description="Any text: a name, a note. It changes nothing."),
    ] = None
    times_ms: Annotated[
        tuple[_TimeMs, ...] | None,
        Field(
            max_length=MAX_MOVES,
            description="When each move was made: milliseconds since the start, one for each "
            "move, never falling.",
        ),
        AtMost(MAX_MOVES),
    ] = None
    source: Annotated[
        Annotated[Source, Expecting("one of board, file, simulated")] | None,
        Field(description="Where it was played."),
    ] = None

    def played(self, kind: type[_Played], deck_of: Callable[[DeckJson], Deck]) -> _Played:
        """What this line describes, as `kind`, its deck made by `deck_of`.

        Raises:
            InvalidError: the line is well-formed, but no board could show it; with every fault
                of the board, the deck and the start, or else every fault of the moves.
        """
        faults: list[Fault] = []
        board = attempt(self.board.board, faults, "board")
        deck = attempt(lambda: deck_of(self), faults)
        start = None if board is None else attempt(lambda: self._start(board), faults, "start")
        if deck is None or start is None:
            raise InvalidError(faults)
        moves = tuple(
            Move(TokenId(move.token), _cell(*move.origin), _cell(*move.destination))
            for move in self.moves
        )
        return kind(deck, start, moves, self.label, self.times_ms, self.source)

    def _start(self, board: Board) -> State:
        return State(board, {TokenId(token): _cell(*at) for token, at in self.start.items()})


def read_demonstrations(chunks: Iterable[bytes], file: str) -> Iterator[Demonstration]:
    """The demonstrations of a file, one after another, in constant memory.

    Args:
        chunks: the file's bytes, cut anywhere.
        file: its name, for messages.

    Raises:
        FormatError: at the first line that is no demonstration, is on another board than the
            first, or when there is none at all.
    """
    for _, demonstration in read_numbered(chunks, file, Demonstration):
        yield demonstration


def read_plays(chunks: Iterable[bytes], file: str) -> Iterator[tuple[int, Play]]:
    """The plays of a file with the numbers of their lines; else as `read_demonstrations`."""
    return read_numbered(chunks, file, Play)


def read_numbered(
    chunks: Iterable[bytes], file: str, kind: type[_Played]
) -> Iterator[tuple[int, _Played]]:
    """What is on each line, as `kind`, with the line's number; else as `read_demonstrations`."""
    first: tuple[int, Board] | None = None
    decks = _Decks()
    for number, line in split_lines(chunks, file):
        played = _decode(line, file, number, kind, decks.deck_of)
        board = played.board
        if first is None:
            first = (number, board)
        elif board != first[1]:
            expected = f"{_describe(first[1])} as on line {first[0]}"
            raise FormatError(file, number, (Fault("board", _describe(board), expected),))
        yield number, played
    if first is None:
        expected = "at least one demonstration, one a line"
        raise FormatError(file, 1, (Fault("", "an empty file", expected),))


def decode_demonstration(line: bytes, file: str = "-", number: int = 1) -> Demonstration:
    """The demonstration on one line.

    Raises:
        FormatError: it is none; with every fault.
    """
    return _decode(line, file, number, Demonstration, DeckJson.deck)


def encode_demonstration(played: Play) -> str:
    """The demonstration, play or position as one line of JSON, without the line's end."""
    board = played.board
    fields: dict[str, object] = {
        "format": DEMONSTRATION_FORMAT,
        "board": {"rows": board.rows, "columns": board.columns, "goal_row": board.goal_row},
        **encode_deck(played.deck),
        "start": {token: _pair(cell) for token, cell in sorted(played.start.cells.items())},
        "moves": [encode_move(move) for move in played.moves],
    }
    optional = {
        "label": played.label,
        "times_ms": played.times_ms,
        "source": played.source,
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


def encode_attributes(attributes: Iterable[tuple[str, Value]]) -> dict[str, int | float | str]:
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


class _Decks:
    """The deck of the line before: most files have one, built once, not a million times."""

    def __init__(self) -> None:
        self._last: tuple[object, Deck] | None = None

    def deck_of(self, fields: DeckJson) -> Deck:
        """The deck that `fields` describe."""
        written = (fields.tokens, fields.orders, fields.cycles, fields.relations, fields.lexicon)
        if self._last is None or self._last[0] != written:
            self._last = (written, fields.deck())
        return self._last[1]


def _decode(
    line: bytes, file: str, number: int, kind: type[_Played], deck_of: Callable[[DeckJson], Deck]
) -> _Played:
    fields = decode_object(line, file, number, DEMONSTRATION_FORMAT)
    try:
        return DemonstrationJson.model_validate(fields).played(kind, deck_of)
    except ValidationError as error:
        faults = faults_of_validation(error, DemonstrationJson)
        raise FormatError(file, number, faults) from None
    except InvalidError as error:
        raise FormatError(file, number, error.faults) from None


# Both are pure; one object a cell and a board saves most of a million lines' time and memory.
@lru_cache(maxsize=2 * MAX_SIDE**2)
def _cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


@lru_cache(maxsize=16)
def _board(rows: int, columns: int, goal_row: int) -> Board:
    return Board(rows, columns, Row(goal_row))


def _pair(cell: Cell) -> tuple[int, int]:
    return (cell.row, cell.column)


def _describe(board: Board) -> str:
    return f"{board.rows} x {board.columns} with goal row {board.goal_row}"
