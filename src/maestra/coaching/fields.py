"""The fields of events, commands and settings as JSON has them.

Frozen dataclasses stay what they are; pydantic reads the annotations here at the boundary.
"""

from __future__ import annotations

from typing import Annotated, Final, NewType, TypeAlias, TypeVar

from pydantic import ConfigDict, Field, StrictInt, StrictStr, TypeAdapter, ValidationError
from pydantic.functional_serializers import PlainSerializer
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import WithJsonSchema

from maestra.core.board import MAX_SIDE, Cell, Column, Row
from maestra.core.demonstration import MAX_TIME_MS
from maestra.core.faults import InvalidError
from maestra.core.json_faults import Expecting
from maestra.core.text import MAX_TEXT, PLAIN
from maestra.core.tokens import MAX_TOKENS, TokenId
from maestra.rules.rule_json import faults_of_rule

Milliseconds = NewType("Milliseconds", int)
"""Since the session began, on a clock that never runs backwards."""

MAX_SAID: Final = 2_000
"""Characters of what is said at once: several sentences."""
STRICT: Final = ConfigDict(extra="forbid")
"""For every class that is read: an unknown field is refused."""

_Built = TypeVar("_Built")


def _cell(written: object) -> Cell:
    match written:
        case [int(row), int(column)] if _is_side(row) and _is_side(column):
            return Cell(Row(row), Column(column))
        case _:
            raise ValueError(f"[row, column], each from 1 to {MAX_SIDE}")


def _is_side(number: int) -> bool:
    return not isinstance(number, bool) and 1 <= number <= MAX_SIDE


def _pair(cell: Cell) -> list[int]:
    return [cell.row, cell.column]


_SIDE_SCHEMA: Final = {"type": "integer", "minimum": 1, "maximum": MAX_SIDE}

Place: TypeAlias = Annotated[
    Cell,
    PlainValidator(_cell),
    PlainSerializer(_pair, when_used="json"),
    WithJsonSchema({"type": "array", "prefixItems": [_SIDE_SCHEMA] * 2, "items": False}),
]
Token: TypeAlias = Annotated[
    TokenId,
    Field(min_length=1, max_length=MAX_TEXT, pattern=PLAIN, strict=True),
    Expecting(f"text of 1 to {MAX_TEXT} characters without control characters"),
]
Time: TypeAlias = Annotated[
    Milliseconds,
    Field(ge=0, le=MAX_TIME_MS, strict=True),
    Expecting("a whole number of milliseconds from 0"),
]
Number: TypeAlias = Annotated[
    StrictInt, Field(ge=0, le=MAX_TIME_MS), Expecting("a whole number from 0")
]
Seed: TypeAlias = Annotated[
    StrictInt, Field(ge=0, lt=2**64), Expecting("a whole number from 0 to 2^64 - 1")
]
Level: TypeAlias = Annotated[
    StrictInt, Field(ge=0, le=5), Expecting("an assistance level, 0 to 5")
]
"""How much the robot helps before a move: 0 your turn; 1 encourage or remind of the rule; 2 where
to look; 3 a few tokens, one of which is right; 4 the token and its place; 5 offer or place it."""
Text: TypeAlias = Annotated[
    StrictStr, Field(max_length=MAX_SAID), Expecting(f"text of at most {MAX_SAID} characters")
]
Tokens: TypeAlias = Annotated[tuple[Token, ...], Field(max_length=MAX_TOKENS)]
Cells: TypeAlias = Annotated[tuple[Place, ...], Field(max_length=MAX_TOKENS)]
Table: TypeAlias = Annotated[dict[Token, Place], Field(max_length=MAX_TOKENS)]
"""Which token lies on which cell."""

MAX_LEVEL: Final = 5


def decode(adapter: TypeAdapter[_Built], written: object) -> _Built:
    """What the parsed JSON describes.

    Raises:
        InvalidError: it describes nothing of the kind; with every fault and its place.
    """
    try:
        return adapter.validate_python(written)
    except ValidationError as error:
        raise InvalidError(faults_of_rule(error, written)) from None
