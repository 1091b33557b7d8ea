"""Everything a session has others do: a closed union, each with its JSON.

Robots, screens and records carry commands out; none of them decides anything. A command that
can fail has a number, by which its outcome comes back as an event.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from functools import cache
from typing import Annotated, Any, Literal, TypeAlias, cast

from pydantic import Field, TypeAdapter

from maestra.coaching.fields import STRICT, Cells, Number, Place, Text, Token, decode


class Expression(Enum):
    """What the robot's face shows."""

    NEUTRAL = "neutral"
    HAPPY = "happy"
    THINKING = "thinking"
    CARING = "caring"


class GestureName(Enum):
    """What the robot's body does."""

    GREET = "greet"
    NOD = "nod"
    CHEER = "cheer"
    OFFER = "offer"


class View(Enum):
    """What the screen shows besides the board."""

    YOUR_TURN = "your-turn"
    PUT_BACK = "put-back"
    ONE_AT_A_TIME = "one-at-a-time"
    PAUSED = "paused"
    NO_BOARD = "no-board"
    SHOW_ME = "show-me"
    CLEAR_THE_ROW = "clear-the-row"
    RULES = "rules"
    ENDED = "ended"


class Matter(Enum):
    """What the caregiver is asked for."""

    PUT_BACK = "put-back"
    """Put the tokens back that lie wrong."""
    CHECK_BOARD = "check-board"
    """The board has a token that is not the exercise's, or none where one should be."""
    PLACE = "place"
    """Place a token that the patient is to be spared."""
    NO_WAY_ON = "no-way-on"
    """No move is right any more: end the session, or judge the last move otherwise."""
    LONG_SILENCE = "long-silence"
    """Nobody has answered several prompts."""
    QUESTION = "question"
    """A question about the exercise that is being taught."""
    DEMONSTRATION = "demonstration"
    """What was shown cannot be learned from."""


@dataclass(frozen=True, slots=True)
class Say:
    """Say a phrase, as text, speech or both."""

    __pydantic_config__ = STRICT
    key: Text
    """Which phrase of language/."""
    arguments: dict[Text, Text]
    """What its gaps were filled with."""
    text: Text
    """The phrase in the session's language, for robots that know no language."""
    command: Literal["say"] = field(default="say", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Express:
    """Show an expression."""

    __pydantic_config__ = STRICT
    expression: Expression
    command: Literal["express"] = field(default="express", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Gesture:
    """Make a gesture."""

    __pydantic_config__ = STRICT
    gesture: GestureName
    command: Literal["gesture"] = field(default="gesture", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class LookAt:
    """Look at these cells; at the person, if there is none."""

    __pydantic_config__ = STRICT
    cells: Cells
    command: Literal["look-at"] = field(default="look-at", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class PointAt:
    """Point at these cells, on the board or on the screen."""

    __pydantic_config__ = STRICT
    cells: Cells
    command: Literal["point-at"] = field(default="point-at", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class MoveToken:
    """Move a token; `RobotDone` or `RobotFailed` with this number says how it went."""

    __pydantic_config__ = STRICT
    number: Number
    token: Token
    origin: Place
    destination: Place
    command: Literal["move-token"] = field(default="move-token", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Show:
    """Show this on the screen."""

    __pydantic_config__ = STRICT
    view: View
    tokens: tuple[Token, ...] = ()
    """Those it is about."""
    lines: tuple[Text, ...] = ()
    """Sentences that stand there."""
    command: Literal["show"] = field(default="show", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Record:
    """Keep a note beside the events."""

    __pydantic_config__ = STRICT
    note: Text
    """Its kind, a name of `notes`."""
    fields: dict[Text, int | bool | str | None]
    command: Literal["record"] = field(default="record", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class AskCaregiver:
    """Ask the caregiver for something."""

    __pydantic_config__ = STRICT
    number: Number
    """An `Answered` event names it."""
    matter: Matter
    text: Text
    """What is asked, in the session's language."""
    tokens: tuple[Token, ...] = ()
    """Those it is about."""
    command: Literal["ask-caregiver"] = field(default="ask-caregiver", kw_only=True, repr=False)


Command: TypeAlias = (
    Say | Express | Gesture | LookAt | PointAt | MoveToken | Show | Record | AskCaregiver
)
Commands: TypeAlias = tuple[Command, ...]


@cache
def _adapter() -> TypeAdapter[Command]:
    return TypeAdapter(Annotated[Command, Field(discriminator="command")])


def encode_command(command: Command) -> dict[str, Any]:
    """The command as JSON has it; `decode_command` gives the same command again."""
    return cast("dict[str, Any]", _adapter().dump_python(command, mode="json"))


def encode_commands(commands: Sequence[Command]) -> list[dict[str, Any]]:
    """Each command as JSON has it."""
    return [encode_command(command) for command in commands]


def decode_command(written: object) -> Command:
    """The command that the parsed JSON describes.

    Raises:
        InvalidError: it describes none; with every fault and its place.
    """
    return decode(_adapter(), written)
