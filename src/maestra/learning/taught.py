"""A few-shot lesson as an exercise that can be kept and played."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.learning.fewshot.lesson import Lesson
from maestra.rules.decks import merge_decks
from maestra.rules.exercise import (
    Alternative,
    Evidence,
    Exam,
    LearnStatus,
    RuledExercise,
    meant_rules,
)


def taught_exercise(
    lesson: Lesson, status: LearnStatus | None = None, exams: Sequence[Exam] = ()
) -> RuledExercise:
    """The exercise that a lesson came to, with what it rests on.

    Args:
        lesson: what was learned.
        status: what the whole dialogue came to; None: as the lesson says.
        exams: those that were held before.

    Raises:
        InvalidError: the demonstrations' decks contradict one another.
    """
    first = lesson.demonstrations[0]
    return RuledExercise(
        first.board,
        merge_decks([shown.deck for shown in lesson.demonstrations]),
        meant_rules(lesson.rules, [min(1.0, one) for one in lesson.confidences]),
        min(1.0, lesson.confidence),
        status or LearnStatus(lesson.status.value),
        lesson.safe,
        tuple(Alternative(one.rules, min(1.0, one.weight)) for one in lesson.alternatives),
        Evidence(lesson.demonstrations, lesson.answers, tuple(exams)),
    )
