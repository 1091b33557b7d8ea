"""Everything that can happen in a session: a closed union, each with its JSON.

A session is its start and a list of these with their times; the same list gives the same
commands again (`replaying`). The board says what is moved, the clock that time passes, people
what they want, the robot whether it did what it was told.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from typing import Annotated, Any, Literal, TypeAlias, cast

from pydantic import Field, StrictBool, TypeAdapter

from maestra.coaching.fields import (
    STRICT,
    Level,
    Number,
    Place,
    Table,
    Text,
    Time,
    Token,
    Tokens,
    decode,
)
from maestra.rules.answers import Reply


@dataclass(frozen=True, slots=True)
class Begun:
    """Somebody sits down at the board."""

    __pydantic_config__ = STRICT
    event: Literal["begun"] = field(default="begun", kw_only=True, repr=False)


# ---------------------------------------------------------------- the board


@dataclass(frozen=True, slots=True)
class TokenLifted:
    """A token left its cell."""

    __pydantic_config__ = STRICT
    token: Token
    event: Literal["lifted"] = field(default="lifted", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class TokenPlaced:
    """A token was put on a cell."""

    __pydantic_config__ = STRICT
    token: Token
    cell: Place
    event: Literal["placed"] = field(default="placed", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class TokenPutBack:
    """A token is on the cell it was lifted from."""

    __pydantic_config__ = STRICT
    token: Token
    event: Literal["put-back"] = field(default="put-back", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class SeveralTokens:
    """Several tokens left their cells at once."""

    __pydantic_config__ = STRICT
    tokens: Tokens
    event: Literal["several"] = field(default="several", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class BoardLost:
    """The board does not answer."""

    __pydantic_config__ = STRICT
    event: Literal["board-lost"] = field(default="board-lost", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class BoardBack:
    """The board answers, and says what lies where; so it may at any time."""

    __pydantic_config__ = STRICT
    cells: Table
    event: Literal["board-back"] = field(default="board-back", kw_only=True, repr=False)


# ---------------------------------------------------------------- people


@dataclass(frozen=True, slots=True)
class HelpAsked:
    """The one who plays asks for help."""

    __pydantic_config__ = STRICT
    event: Literal["help-asked"] = field(default="help-asked", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class DoneSaid:
    """The one who plays or shows says that this is all."""

    __pydantic_config__ = STRICT
    event: Literal["done-said"] = field(default="done-said", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Paused:
    """The caregiver halts the session."""

    __pydantic_config__ = STRICT
    event: Literal["paused"] = field(default="paused", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Resumed:
    """The caregiver lets it go on."""

    __pydantic_config__ = STRICT
    event: Literal["resumed"] = field(default="resumed", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Skipped:
    """The caregiver skips what is being tried: a step of a play, a demonstration."""

    __pydantic_config__ = STRICT
    event: Literal["skipped"] = field(default="skipped", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class HintOrdered:
    """The caregiver has the robot help now; within the limits of the settings."""

    __pydantic_config__ = STRICT
    level: Level
    event: Literal["hint-ordered"] = field(default="hint-ordered", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class EndOrdered:
    """The caregiver ends the session."""

    __pydantic_config__ = STRICT
    event: Literal["end-ordered"] = field(default="end-ordered", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class VerdictOverridden:
    """The caregiver judges the last move otherwise."""

    __pydantic_config__ = STRICT
    allowed: StrictBool
    event: Literal["overridden"] = field(default="overridden", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Answered:
    """The caregiver answers the question of this number."""

    __pydantic_config__ = STRICT
    question: Number
    reply: Reply
    event: Literal["answered"] = field(default="answered", kw_only=True, repr=False)


# ---------------------------------------------------------------- the clock and the robot


@dataclass(frozen=True, slots=True)
class TimePassed:
    """Nothing else happened for a while."""

    __pydantic_config__ = STRICT
    event: Literal["time-passed"] = field(default="time-passed", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class RobotDone:
    """The robot has carried out the command of this number."""

    __pydantic_config__ = STRICT
    command: Number
    event: Literal["robot-done"] = field(default="robot-done", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class RobotFailed:
    """The robot could not carry out the command of this number."""

    __pydantic_config__ = STRICT
    command: Number
    why: Text
    event: Literal["robot-failed"] = field(default="robot-failed", kw_only=True, repr=False)


Event: TypeAlias = (
    Begun
    | TokenLifted
    | TokenPlaced
    | TokenPutBack
    | SeveralTokens
    | BoardLost
    | BoardBack
    | HelpAsked
    | DoneSaid
    | Paused
    | Resumed
    | Skipped
    | HintOrdered
    | EndOrdered
    | VerdictOverridden
    | Answered
    | TimePassed
    | RobotDone
    | RobotFailed
)
EventJson: TypeAlias = Annotated[Event, Field(discriminator="event")]
"""As a field of something that is read."""


@dataclass(frozen=True, slots=True)
class TimedEvent:
    """What happened, and when."""

    __pydantic_config__ = STRICT
    at: Time
    what: EventJson


@cache
def _adapter() -> TypeAdapter[TimedEvent]:
    return TypeAdapter(TimedEvent)


def encode_event(event: TimedEvent) -> dict[str, Any]:
    """The event as a line of a session has it; `decode_event` gives the same event again."""
    return cast("dict[str, Any]", _adapter().dump_python(event, mode="json"))


def decode_event(written: object) -> TimedEvent:
    """The event that the parsed JSON describes.

    Raises:
        InvalidError: it describes none; with every fault and its place.
    """
    return decode(_adapter(), written)
