"""Exercises as JSON files: what docs/schemas/exercise-1.schema.json says, and no more.

Pure: it decodes bytes that somebody else read.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Final, assert_never

from pydantic import Field, RootModel, ValidationError

from maestra.core.faults import Fault, InvalidError, shorten
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object
from maestra.rules.exercise import Exercise, GroundedExercise, RuledExercise
from maestra.rules.grounded_format import GroundedJson, encode_grounded
from maestra.rules.picture_format import NO_PICTURES, CarriedPicture, encode_pictures
from maestra.rules.ruled_format import RuledJson, encode_ruled

EXERCISE_FORMAT: Final = "maestra.exercise/1"
MAX_EXERCISE_BYTES: Final = 64 * 2**20
"""A 20 x 20 board with 100 tokens takes 3 MB; a longer file is a wrong one."""
_END: Final = "}\n"


class ExerciseJson(RootModel[Annotated[GroundedJson | RuledJson, Field(discriminator="kind")]]):
    """An exercise of either kind."""


def decode_exercise(content: bytes, file: str = "-") -> Exercise:
    """The exercise in a file's bytes.

    Raises:
        FormatError: as `decode_with_pictures`.
    """
    exercise, _ = decode_with_pictures(content, file)
    return exercise


def decode_with_pictures(
    content: bytes, file: str = "-"
) -> tuple[Exercise, Mapping[str, CarriedPicture]]:
    """The exercise in a file's bytes, and the pictures that the file carries for its tokens.

    Raises:
        FormatError: it is none, or larger than `MAX_EXERCISE_BYTES`; with every fault.
    """
    if len(content) > MAX_EXERCISE_BYTES:
        found = f"a file larger than {MAX_EXERCISE_BYTES // 2**20} MB"
        raise FormatError(file, 1, (Fault("", found, "an exercise"),))
    fields = decode_object(content, file, 1, EXERCISE_FORMAT)
    model = _model(fields, file)
    try:
        read = model.model_validate(fields)
        exercise = read.exercise()
        return exercise, read.carried(exercise.deck)
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_validation(error, model)) from None
    except InvalidError as error:
        raise FormatError(file, 1, error.faults) from None


def encode_exercise(
    exercise: Exercise, pictures: Mapping[str, CarriedPicture] = NO_PICTURES
) -> str:
    """The exercise as JSON, an action or a rule a line; then its pictures, if it has any."""
    text = _encode(exercise)
    if not pictures:
        return text
    return f"{text.removesuffix(_END)},\n {encode_pictures(pictures)}{_END}"


def _encode(exercise: Exercise) -> str:
    match exercise:
        case GroundedExercise():
            return encode_grounded(exercise)
        case RuledExercise():
            return encode_ruled(exercise)
        case _:
            assert_never(exercise)


def _model(fields: dict[str, object], file: str) -> type[GroundedJson | RuledJson]:
    """What reads the file's kind of exercise."""
    kind = fields.get("kind")
    match kind:
        case "grounded":
            return GroundedJson
        case "ruled":
            return RuledJson
        case _:
            found = shorten(kind) if "kind" in fields else "missing"
            raise FormatError(file, 1, (Fault("kind", found, '"grounded" or "ruled"'),))
