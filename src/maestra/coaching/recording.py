"""A session as a file, and as the same commands again.

JSON Lines, `maestra.session/1`: the first line is the start, with all that the commands follow
from (exercise, tokens as they lie, settings, seed, what the policy knew); each further line is an
event with its time. Pure: it decodes bytes that somebody else read.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, StrictStr, ValidationError

from maestra import __version__
from maestra.coaching.commands import Commands
from maestra.coaching.events import TimedEvent, decode_event, encode_event
from maestra.coaching.fields import Seed
from maestra.coaching.playing import step
from maestra.coaching.policies import Policy, decode_policy, encode_policy
from maestra.coaching.referee import ExerciseReferee
from maestra.coaching.session import Game, Session, new_session
from maestra.coaching.settings import Settings, decode_settings, encode_settings
from maestra.core.demonstration import Play
from maestra.core.faults import Fault, InvalidError
from maestra.core.formats import decode_demonstration, encode_demonstration
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object, split_lines
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.language import NO_LEXICON, read_words
from maestra.rules.exercise import Exercise
from maestra.rules.exercise_format import decode_exercise, encode_exercise

SESSION_FORMAT: Final = "maestra.session/1"

_Built = TypeVar("_Built")


@dataclass(frozen=True)
class Start:
    """All that a session follows from."""

    exercise: Exercise
    deck: Deck
    state: State
    settings: Settings
    seed: int
    policy: Policy
    """What the policy knew of the patient."""
    patient: str = ""
    """A pseudonym, perhaps none."""
    words: str | None = None
    """A caregiver's own words, the text of a file `maestra.words/1`; None: none."""

    def session(self) -> Session:
        """The session that begins so.

        Raises:
            InvalidError: the deck or the board does not fit the exercise.
            FormatError: the words are none.
        """
        words = NO_LEXICON if self.words is None else read_words(self.words.encode())
        referee = ExerciseReferee(self.exercise, self.deck, self.settings.language, words)
        return new_session(Game(referee, self.settings, self.state, self.seed), self.policy)


class StartJson(BaseModel):
    """The first line of a session."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    format: Annotated[Literal["maestra.session/1"], Field(description="This format's name.")]
    maestra: Annotated[StrictStr, Field(description="The version that played it.")]
    patient: Annotated[StrictStr, Field(description="A pseudonym; may be empty.")] = ""
    seed: Annotated[Seed, Field(description="Decides all that was left to chance.")]
    exercise: Annotated[dict[str, Any], Field(description="As `maestra.exercise/1` has it.")]
    play: Annotated[
        dict[str, Any],
        Field(description="The tokens as they lay: `maestra.demonstration/1` without moves."),
    ]
    settings: Annotated[dict[str, Any], Field(description="As `maestra.settings/1` has them.")]
    policy: Annotated[dict[str, Any], Field(description="How much to help, as it was known.")]
    words: Annotated[
        dict[str, Any] | None,
        Field(description="A caregiver's own words, as `maestra.words/1` has them."),
    ] = None


def encode_start(start: Start) -> str:
    """The first line of a session, without the line's end."""
    play = Play(start.deck, start.state, ())
    fields = {
        "format": SESSION_FORMAT,
        "maestra": __version__,
        "patient": start.patient,
        "seed": start.seed,
        "exercise": json.loads(encode_exercise(start.exercise)),
        "play": json.loads(encode_demonstration(play)),
        "settings": encode_settings(start.settings),
        "policy": encode_policy(start.policy),
    }
    if start.words is not None:
        fields["words"] = json.loads(start.words)
    return json.dumps(fields, ensure_ascii=False)


def encode_line(event: TimedEvent) -> str:
    """A further line of a session, without the line's end."""
    return json.dumps(encode_event(event), ensure_ascii=False)


def decode_start(line: bytes, file: str = "-", number: int = 1) -> Start:
    """The start on a session's first line.

    Raises:
        FormatError: it is none; with every fault and its place.
    """
    fields = decode_object(line, file, number, SESSION_FORMAT)
    try:
        written = StartJson.model_validate(fields)
        play = _within("play", lambda: decode_demonstration(_bytes(written.play), file, number))
        return Start(
            _within("exercise", lambda: decode_exercise(_bytes(written.exercise), file)),
            play.deck,
            play.start,
            _within("settings", lambda: decode_settings(written.settings)),
            written.seed,
            _within("policy", lambda: decode_policy(written.policy)),
            written.patient,
            None if written.words is None else _words(written.words, file),
        )
    except ValidationError as error:
        raise FormatError(file, number, faults_of_validation(error, StartJson)) from None
    except InvalidError as error:
        raise FormatError(file, number, error.faults) from None


def read_session(chunks: Iterable[bytes], file: str) -> tuple[Start, Iterator[TimedEvent]]:
    """A session's start, and its events one after another.

    Args:
        chunks: the file's bytes, cut anywhere.
        file: its name, for messages.

    Raises:
        FormatError: the first line is no start; or, later, a line that is no event.
    """
    lines = split_lines(chunks, file)
    first = next(lines, None)
    if first is None:
        raise FormatError(file, 1, (Fault("", "an empty file", "a session"),))
    return decode_start(first[1], file, first[0]), _events(lines, file)


def replay(session: Session, events: Iterable[TimedEvent]) -> Iterator[tuple[Session, Commands]]:
    """The session after each event, and what was done then: the same as when it was played."""
    for event in events:
        session, commands = step(session, event.what, event.at)
        yield session, commands


def _events(lines: Iterable[tuple[int, bytes]], file: str) -> Iterator[TimedEvent]:
    for number, line in lines:
        try:
            yield decode_event(_parsed(line))
        except InvalidError as error:
            raise FormatError(file, number, error.faults) from None


def _parsed(line: bytes) -> object:
    try:
        return json.loads(line)
    except ValueError:
        raise InvalidError([Fault("", "no JSON", "an event, one a line")]) from None


def _within(place: str, build: Callable[[], _Built]) -> _Built:
    """What `build` makes; its faults are seen from outside `place`."""
    try:
        return build()
    except InvalidError as error:
        raise InvalidError([fault.under(place) for fault in error.faults]) from None


def _words(fields: dict[str, Any], file: str) -> str:
    """The text of a file of words, which `fields` are if this raises nothing."""
    text = _bytes(fields)
    read_words(text, file)
    return text.decode()


def _bytes(fields: dict[str, Any]) -> bytes:
    # Fractions come as Decimal, which JSON writes as the float of the same digits.
    return json.dumps(fields, ensure_ascii=False, default=float).encode()
