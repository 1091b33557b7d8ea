"""Exercises made of rules, in and out of files, for the commands that teach and examine them."""

from maestra.cli.streams import named, read_whole
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.rules.exercise import RuledExercise
from maestra.rules.exercise_format import decode_exercise


def ruled_exercise_in(path: str) -> RuledExercise:
    """The exercise in a file.

    Raises:
        OSError: the file cannot be read.
        FormatError: it is no exercise, or is made of actions, which nobody asks about.
    """
    exercise = decode_exercise(read_whole(path), named(path))
    if not isinstance(exercise, RuledExercise):
        expected = '"ruled": an exercise that `teach`, `tell` or `learn --learner fewshot` wrote'
        raise FormatError(named(path), 1, (Fault("kind", '"grounded"', expected),))
    return exercise
