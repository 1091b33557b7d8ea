"""Exercises as files: brought in, saved, and as PDDL."""

from __future__ import annotations

import io
import multiprocessing
import threading
import zipfile
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import lru_cache, partial
from typing import Final, cast
from urllib.parse import quote

from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError, attempt
from maestra.core.formats import encode_demonstration
from maestra.core.json_lines import FormatError, parse_object
from maestra.core.text import without_accents
from maestra.learning.model_pddl import exercise_pddl
from maestra.rules.exercise import Exercise, GroundedExercise
from maestra.rules.exercise_format import decode_exercise, decode_with_pictures, encode_exercise
from maestra.rules.grounding import grounded_from
from maestra.rules.picture_format import CarriedPicture, pictured
from maestra.storage.drafts import Drafts, StoredPicture
from maestra.storage.store import SqlStore
from maestra.web.library.collection import Item
from maestra.web.teach.pictures import stored

MOST_BYTES: Final = 15 * 1024 * 1024
"""Of a file that is brought in, with its pictures: what a form with files may be, and some room
for the form. As many pictures as the largest board has tokens, 70, may have 160 kB each in it; a
photograph is kept with some 50 to 90."""
MOST_BYTES_BESIDES: Final = 1024 * 1024
"""Of it without its pictures: a hundred demonstrations are a fifth of it."""
MOST_TITLE: Final = 100
"""Letters of a title: it stands in lists and in the patient's plan."""
ENDING: Final = ".exercise.json"
PDDL_KEPT: Final = 30
"""Archives kept in memory, 20 kB each: making one takes up to half a minute."""

_MAKING_PDDL: Final = threading.Lock()


def exercise_of(content: bytes, file: str) -> tuple[Exercise, Mapping[str, StoredPicture]]:
    """The exercise in a file, and its tokens' pictures, written anew: somebody else made the file.

    Raises:
        FormatError: it is none, or is too large, or a picture cannot be kept; with every fault.
    """
    _demand_room(content, file)
    exercise, carried = decode_with_pictures(content, file)
    faults: list[Fault] = []
    made = {
        value: attempt(partial(stored, one.content, value), faults, "pictures")
        for value, one in carried.items()
    }
    if faults:
        raise FormatError(file, 1, tuple(faults))
    return exercise, {value: one for value, one in made.items() if one is not None}


def file_of(store: SqlStore, item: Item) -> str:
    """The file of an exercise, with the pictures on its tokens."""
    text = store.exercise(item.name, item.version).exercise
    drafts = Drafts(store)
    shown = drafts.shown(item.name, item.version)
    if item.exercise is None or not shown:
        return text
    kept = {
        value: drafts.picture(shown[value])
        for value in sorted(pictured(item.exercise.deck) & shown.keys())
    }
    carried = {value: CarriedPicture(one.media_type, one.content) for value, one in kept.items()}
    return encode_exercise(item.exercise, carried)


def _demand_room(content: bytes, file: str) -> None:
    """Refuse a large file before its rules are looked at, which takes long.

    Raises:
        FormatError: it is too large, with its pictures or without.
    """
    size, most, besides = len(content), MOST_BYTES, ""
    if MOST_BYTES_BESIDES < size <= MOST_BYTES:
        size -= _letters_of_pictures(parse_object(content, file, 1).get("pictures"))
        most, besides = MOST_BYTES_BESIDES, " besides pictures"
    if size > most:
        fault = Fault("", f"{size // 1024} kB{besides}", f"at most {most // 1024} kB")
        raise FormatError(file, 1, (fault,))


def _letters_of_pictures(written: object) -> int:
    """How long the pictures' contents are; what is wrong with them is not said here."""
    pictures = cast("dict[str, object]", written) if isinstance(written, dict) else {}
    letters = 0
    for one in pictures.values():
        match one:
            case {"content": str(content)}:
                letters += len(content)
            case _:
                pass
    return letters


def title_of(file: str) -> str:
    """What to call what was brought in from a file of this name."""
    title = file.removesuffix(ENDING).removesuffix(".json")
    plain = "".join(letter for letter in title if letter.isprintable()).strip()
    return plain[:MOST_TITLE]


def fresh(title: str, taken: frozenset[str]) -> str:
    """The title, with the first number that makes it one that nothing has."""
    number, name = 1, title
    while name in taken:
        number += 1
        mark = f" ({number})"
        name = title[: MOST_TITLE - len(mark)] + mark
    return name


def attached(title: str, ending: str) -> dict[str, str]:
    """The header that has a browser save the answer as a file of this name."""
    plain = "".join(one if one.isalnum() else "-" for one in without_accents(title))
    ascii_name = plain.encode("ascii", "replace").decode().replace("?", "-")
    return {
        "Content-Disposition": f'attachment; filename="{ascii_name}{ending}"; '
        f"filename*=UTF-8''{quote(title, safe='')}{ending}"
    }


def demonstrations_in(exercise: Exercise) -> str:
    """What the exercise was learned from, as JSON Lines."""
    shown: tuple[Demonstration, ...] = ()
    if not isinstance(exercise, GroundedExercise):
        shown = exercise.evidence.demonstrations
    return "".join(f"{encode_demonstration(one)}\n" for one in shown)


@lru_cache(maxsize=PDDL_KEPT)
def pddl_archive(text: str) -> bytes:
    """A zip with the domain and the problem of the exercise that is written so.

    Raises:
        InvalidError: no preconditions say the same as its rules, or it is too large.
    """
    # In a process of its own: it may compute for half a minute, and the streams must not wait.
    spawned = multiprocessing.get_context("spawn")
    with _MAKING_PDDL, ProcessPoolExecutor(max_workers=1, mp_context=spawned) as process:
        return process.submit(zipped_pddl, text).result()


def zipped_pddl(text: str) -> bytes:
    """The same, in this process."""
    exercise = decode_exercise(text.encode())
    actions = exercise if isinstance(exercise, GroundedExercise) else grounded_from(exercise)
    texts = exercise_pddl(actions)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as zipped:
        zipped.writestr("domain.pddl", texts.domain)
        zipped.writestr("problem.pddl", texts.problem)
        zipped.writestr("exercise.json", encode_exercise(exercise))
    return archive.getvalue()


def lines_of(error: InvalidError) -> tuple[str, ...]:
    """Each fault as one line."""
    return tuple(str(fault) for fault in error.faults)
