"""What an exam comes to: what was learned from it, and the plain truth about it in words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey
from maestra.learning.exam import ExamPlay, most_wrong, objections, result
from maestra.learning.fewshot.learner import learn
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import Reply
from maestra.rules.exercise import Exam, RuledExercise
from maestra.rules.rule import Rule

_ALL_PERCENT: Final = 100


@dataclass(frozen=True, slots=True)
class Changes:
    """What became of the rules."""

    added: tuple[Rule, ...] = ()
    dropped: tuple[Rule, ...] = ()


@dataclass(frozen=True, slots=True)
class Outcome:
    """What an exam came to."""

    exam: Exam
    exercise: RuledExercise
    changes: Changes | None
    """None: nothing was learned from it."""
    objected: bool

    @property
    def most_wrong(self) -> float:
        """The share of plays that may be wrong at most, with 95 % confidence."""
        return most_wrong(self.exam.plays, self.exam.agreed)


def examined(
    exercise: RuledExercise, judged: Sequence[tuple[ExamPlay, Reply]], date: str
) -> Outcome:
    """The exercise with the exam, and with what was learned from objections."""
    held, new = result(judged, date), objections(judged)
    evidence = exercise.evidence
    if not new or not evidence.demonstrations:
        answers = (*evidence.answers, *new)
        kept = replace(evidence, answers=answers, exams=(*evidence.exams, held))
        return Outcome(held, replace(exercise, evidence=kept), None, bool(new))
    lesson = learn(evidence.demonstrations, (*evidence.answers, *new))
    after = taught_exercise(lesson, exams=(*evidence.exams, held))
    return Outcome(held, after, changes(exercise, after), objected=True)


def changes(before: RuledExercise, after: RuledExercise) -> Changes:
    """Which rules are new, and which are gone."""
    old, new = before.conjunction, after.conjunction
    return Changes(
        tuple(rule for rule in new if rule not in old),
        tuple(rule for rule in old if rule not in new),
    )


def truth(exam: Exam, teacher: Teacher) -> tuple[str, ...]:
    """How often the caregiver agreed and what that is worth; then the same of near misses."""
    if not exam.plays:
        result_said = teacher.say(TeachKey.NOTHING_EXAMINED)
    else:
        result_said = teacher.say(TeachKey.AGREED, agreed=exam.agreed, plays=exam.plays)
        percent = math.ceil(_ALL_PERCENT * most_wrong(exam.plays, exam.agreed))
        if percent < _ALL_PERCENT:  # fewer than all is no news
            result_said = f"{result_said} {teacher.say(TeachKey.BOUND, percent=percent)}"
    if not exam.near_misses:
        return (result_said,)
    plays, agreed = exam.near_misses, exam.near_misses_agreed
    return result_said, teacher.say(TeachKey.NEAR_MISSES, plays=plays, agreed=agreed)
