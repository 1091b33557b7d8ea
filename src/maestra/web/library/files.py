"""Exercises as files: brought in, saved, and as PDDL."""

from __future__ import annotations

import io
import multiprocessing
import threading
import zipfile
from concurrent.futures import ProcessPoolExecutor
from functools import lru_cache
from typing import Final
from urllib.parse import quote

from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.formats import encode_demonstration
from maestra.core.json_lines import FormatError
from maestra.core.text import without_accents
from maestra.learning.model_pddl import exercise_pddl
from maestra.rules.exercise import Exercise, GroundedExercise
from maestra.rules.exercise_format import decode_exercise, encode_exercise
from maestra.rules.grounding import grounded_from

MOST_BYTES: Final = 1024 * 1024
"""Of a file that is brought in: a hundred demonstrations are a fifth of it."""
MOST_TITLE: Final = 100
"""Letters of a title: it stands in lists and in the patient's plan."""
ENDING: Final = ".exercise.json"
PDDL_KEPT: Final = 30
"""Archives kept in memory, 20 kB each: making one takes up to half a minute."""

_MAKING_PDDL: Final = threading.Lock()


def exercise_of(content: bytes, file: str) -> Exercise:
    """The exercise in a file.

    Raises:
        FormatError: it is none, or is too large; with every fault.
    """
    if len(content) > MOST_BYTES:
        found = f"{len(content) // 1024} kB"
        raise FormatError(file, 1, (Fault("", found, f"at most {MOST_BYTES // 1024} kB"),))
    return decode_exercise(content, file)


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
