"""`maestra learn`: demonstrations in, an exercise and its rules in words out."""

import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import assert_never

import typer

from maestra.app import planner_named
from maestra.cli.exporting import write_pddl
from maestra.cli.faults_at import at_line
from maestra.cli.lesson import Lesson, Speech, next_to_show
from maestra.cli.loading import words_in
from maestra.cli.shown_file import MAX_KEPT, Shown, shown_in
from maestra.cli.streams import STANDARD, print_json, waiting, write_file
from maestra.cli.terms import THE_ANSWER_IS_NO
from maestra.core.faults import Fault, InvalidError
from maestra.core.json_lines import FormatError
from maestra.language import Language
from maestra.learning.compiled import CompiledReport
from maestra.learning.compiled_learner import CompiledLesson, learn_compiled, state
from maestra.learning.grounded import GroundedLearner
from maestra.learning.planning import (
    Limits,
    NoEngine,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Unsolved,
    Unsupported,
)
from maestra.learning.planning_pddl import compiled_pddl
from maestra.rules.exercise import GroundedExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.features import UnknownFeatureError, select_features
from maestra.rules.strips.vocabulary import Level, Vocabulary
from maestra.rules.summaries.summary import summarise


@dataclass(frozen=True, slots=True)
class Planning:
    """How the learner `compiled` plans."""

    engine: str
    time_s: float
    memory_mb: int
    pddl_folder: str | None
    """Where the planning problem is written, for audit."""


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be learned, and how."""

    demonstrations: str
    output: str
    features: tuple[str, ...] | None
    level: str
    planning: Planning | None
    """None: the learner `grounded`."""


def learn(request: Request, language: str, words_file: str | None, *, as_json: bool) -> None:
    """Learn, write the exercise, say its rules; exit 1 if they are not clear yet."""
    words = words_in(words_file)
    with shown_in(request.demonstrations) as shown:
        _check_features(shown, request.features)
        began_s = time.perf_counter()
        exercise, report = _learned(shown, request)
        summary = summarise(exercise)
        seconds = time.perf_counter() - began_s
        lesson = Lesson(exercise, summary, next_to_show(exercise, summary, shown.kept))
    write_file(request.output, encode_exercise(exercise))
    speech = Speech(Language(language), words)
    if as_json:
        print_json(lesson.as_json(speech, seconds, report))
    else:
        # The exercise itself may go to standard output.
        place = sys.stderr if request.output == STANDARD else sys.stdout
        lines = lesson.as_lines(speech, report, request.output)
        place.writelines(f"{line}\n" for line in lines)
    if not lesson.is_clear:
        raise typer.Exit(THE_ANSWER_IS_NO)


def _learned(shown: Shown, request: Request) -> tuple[GroundedExercise, CompiledReport | None]:
    level = Level(request.level)
    if request.planning is not None:
        return _planned(shown, level, request.features, request.planning)
    features = select_features(shown.deck, request.features)
    learner = GroundedLearner(Vocabulary(shown.board, shown.deck, level, features))
    for number, demonstration in shown.numbered():
        with at_line(shown.name, number):
            learner.show(demonstration)
    return learner.exercise(), None


def _planned(
    shown: Shown, level: Level, features: Sequence[str] | None, planning: Planning
) -> tuple[GroundedExercise, CompiledReport]:
    if not shown.is_whole:
        found, expected = f"{shown.count} demonstrations", f"at most {MAX_KEPT} for a planner"
        raise FormatError(shown.name, 1, (Fault("", found, expected),))
    if planning.pddl_folder is not None:
        with waiting("Writing PDDL"):
            texts = compiled_pddl(state(shown.kept, level, features).task)
        write_pddl(planning.pddl_folder, texts.domain, texts.problem)
    planner = planner_named(planning.engine)
    limits = Limits(planning.time_s, planning.memory_mb)
    with waiting(f"Planning with {planning.engine}"):
        lesson = learn_compiled(shown.kept, planner, limits, level, features)
    if not isinstance(lesson, CompiledLesson):
        raise InvalidError([_no_plan(lesson, planning)])
    return lesson.exercise, lesson.report


def _no_plan(outcome: Unsolved, planning: Planning) -> Fault:
    """Why a planner found nothing, as a fault of what it was given."""
    where = f"--engine {planning.engine}"
    match outcome:
        case NoEngine(_, why):
            return Fault(where, why, "an engine that is installed")
        case Unsupported(_, why):
            return Fault(where, why, "another engine")
        case OutOfTime():
            found = f"no plan in {planning.time_s:g} s"
            return Fault(where, found, "more time, with --time-limit")
        case OutOfMemory():
            found = f"no plan in {planning.memory_mb} MB"
            return Fault(where, found, "more memory, with --memory-limit")
        case ProvenUnsolvable():
            return Fault(where, "no plan, though there always is one", "another engine")
        case _:
            assert_never(outcome)


def _check_features(shown: Shown, features: Sequence[str] | None) -> None:
    """Refuse features that do not exist, as a fault of the option that names them."""
    try:
        select_features(shown.deck, features)
    except UnknownFeatureError as error:
        faults = [replace(one, where=f"--features {one.where}".rstrip()) for one in error.faults]
        raise InvalidError(faults) from None
