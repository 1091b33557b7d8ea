"""What is told to a room and what it answers, as JSON; the OpenAPI document shows the same."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr

from maestra.coaching.events import EventJson
from maestra.core.text import PLAIN
from maestra.web.rooms.stage import ROOM_PATTERN

MOST_CHARACTERS: Final = 16_384
"""Of one message to the stream: a board of a hundred tokens says what lies where in 4 kB."""
MOST_OF_AN_ID: Final = 64
"""Characters: a UUID has 36."""

TellerId = Annotated[
    StrictStr,
    Field(
        min_length=1,
        max_length=MOST_OF_AN_ID,
        pattern=PLAIN,
        description="The teller's own name for this event, used for no other. "
        "Told again under it, an event happens once.",
    ),
]
Pair = Annotated[list[int], Field(min_length=2, max_length=2, description="Row and column.")]


class Told(BaseModel):
    """Something that happened in a room."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    id: TellerId
    event: Annotated[EventJson, Field(description="What happened.")]


class Beginning(BaseModel):
    """A session to begin."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    patient: Annotated[StrictStr, Field(max_length=200, description="A pseudonym.")]
    exercise: Annotated[StrictStr, Field(max_length=200, description="The exercise's name.")]
    version: Annotated[
        StrictInt | None, Field(ge=1, le=2**31 - 1, description="The latest if there is none.")
    ] = None
    room: Annotated[
        StrictStr | None, Field(pattern=ROOM_PATTERN, description="A free one if there is none.")
    ] = None


class TokenLooks(BaseModel):
    """What a token looks like."""

    label: str
    name: str
    notes: list[str]
    colour: str
    shape: str
    picture: str
    size: str


class Size(BaseModel):
    """Of the board."""

    rows: int
    columns: int
    goal_row: int


class Sentence(BaseModel):
    """What the robot said last."""

    number: int
    text: str
    speech: Annotated[str | None, Field(description="Where it can be heard, if it can.")]


class Shown(BaseModel):
    """What the screen shows besides the board."""

    view: str
    tokens: list[str]
    lines: list[str]


class Asked(BaseModel):
    """What the caregiver is asked; an `answered` event names its number."""

    number: int
    matter: str
    text: str
    tokens: list[str]


class StateJson(BaseModel):
    """A room as it is now."""

    sequence: Annotated[int, Field(description="Moments of the session so far.")]
    type: Literal["state"]
    room: str
    session: Annotated[str, Field(description="Another one begins again at sequence 0.")]
    phase: Literal["empty", "ready", "playing", "paused", "ended"]
    connected: Annotated[bool, Field(description="Whether the board answers.")]
    board: Size | None
    cells: Annotated[
        dict[str, Pair],
        Field(description="Where each token lies; a lifted one where it was lifted from."),
    ]
    held: Annotated[list[str], Field(description="Tokens that were lifted.")]
    tokens: dict[str, TokenLooks]
    rules: Annotated[list[str], Field(description="What the exercise asks for.")]
    said: Sentence | None
    expression: str
    gesture: str | None
    pointed: list[Pair]
    view: Shown | None
    question: Annotated[Asked | None, Field(description="For caregivers only.")]
    awaiting: Annotated[
        list[dict[str, Any]], Field(description="Tokens that a robot is to move: commands.")
    ]
    language: str
    moves: Annotated[int, Field(description="The patient's own right ones.")]
    another_round: Annotated[
        bool, Field(description="Whether the sitting has a round more, which may begin now.")
    ]
    has_board: Annotated[
        bool, Field(description="Whether a board has joined; then screens only show it.")
    ]
