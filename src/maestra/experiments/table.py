"""The paper's six exercises, taught with the fewest demonstrations, by each learner.

For each: how few demonstrations teach it, whether that is proven, whether the learner finds just
the preconditions that all right plays leave, and how long learning and explaining take; the paper
says "less than 2 seconds" for rules and explanations together [1, section 4.2].

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Final, TypeVar, assert_never

from maestra.app import PLANNER_NAMES, planner_named
from maestra.language import Language, explain_action, gap_sentences, rule_sentences
from maestra.learning.compiled_learner import CompiledLesson, learn_compiled
from maestra.learning.grounded import learn_grounded
from maestra.learning.planning import (
    Limits,
    NoEngine,
    OutOfMemory,
    OutOfTime,
    ProvenUnsolvable,
    Unsolved,
    Unsupported,
)
from maestra.learning.teaching_sets import TeachingSet, teaching_set
from maestra.rules.exercise import GroundedExercise
from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.summaries.summary import summarise

_Result = TypeVar("_Result")

GROUNDED: Final = "grounded"
LEARNERS: Final = (GROUNDED, *(f"compiled, {name}" for name in PLANNER_NAMES))
"""Each learner, and the planner it learns with."""
LIMITS: Final = Limits(time_s=300, memory_mb=4_096)
"""For the planner's whole work on one exercise."""


@dataclass(frozen=True, slots=True)
class TableRow:
    """One exercise, learned by one learner."""

    exercise: str
    """A key of `PAPER_EXERCISES`."""
    learner: str
    demonstrations: int
    lower_bound: int
    """No fewer demonstrations suffice; equal to `demonstrations`, it is proven that these are
    the fewest."""
    fewest_in_paper: int
    outcome: str
    """``exact``, ``not exact``, or why the planner found nothing."""
    learn_s: float | None
    """The median of the repetitions; None if nothing was learned."""
    explain_s: float | None
    """All rules in words, and each precondition as a sentence."""


def measure(exercise: str, learner: str, repeat: int, clock: Callable[[], float]) -> TableRow:
    """Teach one of the paper's exercises to one learner, and take the times.

    Args:
        exercise: a key of `PAPER_EXERCISES`.
        learner: one of `LEARNERS`.
        repeat: how often each time is taken, at least once.
        clock: the time in seconds, from any beginning.
    """
    taught = _taught(exercise)
    learned, learn_s = _timed(lambda: _learn(exercise, learner), repeat, clock)
    if isinstance(learned, str):
        return _row(exercise, learner, taught, learned)
    _, explain_s = _timed(lambda: explain(learned), repeat, clock)
    known = PAPER_EXERCISES[exercise]
    truth = ground_truth(known.plays(), known.vocabulary()).preconditions
    outcome = "exact" if learned.model.preconditions == truth else "not exact"
    return _row(exercise, learner, taught, outcome, (learn_s, explain_s))


def explain(exercise: GroundedExercise) -> tuple[str, ...]:
    """Everything there is to say about it, in English."""
    summary = summarise(exercise)
    sentences = (
        *rule_sentences(summary, Language.EN),
        *gap_sentences(summary, Language.EN),
    )
    details = (
        explain_action(exercise.model, action, Language.EN).sentence
        for action in exercise.model.preconditions
    )
    return (*(sentence.text for sentence in sentences), *details)


def _learn(exercise: str, learner: str) -> GroundedExercise | str:
    """What is learned, or why nothing is."""
    shown = _taught(exercise).demonstrations
    features = PAPER_EXERCISES[exercise].features
    if learner == GROUNDED:
        return learn_grounded(shown, features=features)
    planner = planner_named(learner.removeprefix("compiled, "))
    lesson = learn_compiled(shown, planner, LIMITS, features=features)
    return lesson.exercise if isinstance(lesson, CompiledLesson) else _why(lesson)


def _why(unsolved: Unsolved) -> str:
    match unsolved:
        case NoEngine():
            return "no engine"
        case OutOfTime():
            return "out of time"
        case OutOfMemory():
            return "out of memory"
        case Unsupported():
            return "unsupported"
        case ProvenUnsolvable():
            return "unsolvable"
        case _:
            assert_never(unsolved)


def _row(
    exercise: str,
    learner: str,
    taught: TeachingSet,
    outcome: str,
    times: tuple[float | None, float | None] = (None, None),
) -> TableRow:
    return TableRow(
        exercise,
        learner,
        len(taught.demonstrations),
        taught.lower_bound,
        PAPER_EXERCISES[exercise].fewest,
        outcome,
        *times,
    )


@cache
def _taught(exercise: str) -> TeachingSet:
    known = PAPER_EXERCISES[exercise]
    return teaching_set(known.plays(), known.vocabulary())


def _timed(
    work: Callable[[], _Result], repeat: int, clock: Callable[[], float]
) -> tuple[_Result, float]:
    """What `work` returns, and the median of how long it took."""
    times: list[float] = []
    while True:
        begun = clock()
        result = work()
        times.append(clock() - begun)
        if len(times) >= repeat:
            return result, statistics.median(times)
