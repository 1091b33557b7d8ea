"""What commands read from files: exercises, plays, a caregiver's own words."""

from collections.abc import Iterator

from maestra.cli.streams import Advance, named, read_chunks, read_whole
from maestra.core.demonstration import Play
from maestra.core.formats import read_plays
from maestra.language import NO_LEXICON, Lexicon, read_words
from maestra.rules.exercise import Exercise
from maestra.rules.exercise_format import decode_exercise


def exercise_in(path: str) -> Exercise:
    """The exercise in a file.

    Raises:
        OSError: the file cannot be read.
        FormatError: it is no exercise.
    """
    return decode_exercise(read_whole(path), named(path))


def words_in(path: str | None) -> Lexicon:
    """The words in a caregiver's file; none when there is no file.

    Raises:
        OSError: the file cannot be read.
        FormatError: it holds something else.
    """
    return NO_LEXICON if path is None else read_words(read_whole(path), named(path))


def plays_in(path: str, advance: Advance | None = None) -> Iterator[tuple[int, Play]]:
    """The plays of a file with the numbers of their lines, one after another.

    Raises:
        OSError: the file cannot be read.
        FormatError: at the first line that is no play.
    """
    return read_plays(read_chunks(path, advance), named(path))
