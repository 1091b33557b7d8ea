"""What a draft comes to: the dialogue about it, the exercise, the exam. All worked out from it.

Learning takes from a tenth of a second to two; what was worked out last is remembered, so a page
that is only looked at costs nothing, and after a restart it is simply worked out again.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Final

from maestra.core.demonstration import Demonstration
from maestra.language import Language
from maestra.language.teaching import Teacher
from maestra.learning.dialogue import (
    AskSlip,
    Dialogue,
    Finished,
    NotAskedError,
    Terms,
    begin,
    step,
)
from maestra.learning.exam import ExamPlay, exam_plays, objections, result
from maestra.learning.grounded import learn_grounded
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import Answer
from maestra.rules.answers import Reply as Word
from maestra.rules.exercise import Evidence, Exercise, RuledExercise
from maestra.rules.setting import Index
from maestra.rules.telling import told_exercise
from maestra.web.teach.draft import Draft, Examined, Replied, Reply

REMEMBERED: Final = 4
"""Dialogues: each holds what its lesson rests on, 7 MB for ten numbers; two people may teach at
once, and each next answer needs the dialogue before it."""
EXAM_PLAYS: Final = 5
"""Right ones, and as many near misses: two minutes of a caregiver's attention."""


def dialogue_of(draft: Draft) -> Dialogue | None:
    """What is understood from the demonstrations that count, and what is asked; None without any.

    Its demonstrations are numbered as they count; `counting` says which they are.
    """
    taught = draft.taught
    numbers, answers = taught.base
    if not numbers:
        return None
    shown = tuple(draft.demonstrations[k] for k in numbers)
    return _dialogue(shown, answers, taught.replies)


def reply_to(draft: Draft, said: Reply) -> Replied:
    """The step that a reply to what is asked makes.

    Raises:
        NotAskedError: nothing is asked, or something else.
        InvalidError: a cell that is not on the row.
    """
    taught = draft.taught
    numbers, answers = taught.base
    shown = tuple(draft.demonstrations[k] for k in numbers)
    if not shown or isinstance(_dialogue(shown, answers, taught.replies).ask, Finished):
        raise NotAskedError(f"{said} to nothing")
    after = _dialogue(shown, answers, (*taught.replies, said))
    out = taught.out | {numbers[k] for k in after.taken_back}
    return Replied(said, after.answers, out)


def slip_of(draft: Draft, dialogue: Dialogue) -> tuple[Index, Index] | None:
    """The demonstration and the move that are asked about as a likely mistake, both from 0."""
    if not isinstance(dialogue.ask, AskSlip):
        return None
    numbers, _ = draft.taught.base
    return numbers[dialogue.ask.slip.demonstration], dialogue.ask.slip.move


def exercise_of(draft: Draft) -> Exercise | None:
    """What can be played now; None where nothing was shown or told."""
    taught = draft.taught
    shown = tuple(draft.demonstrations[k] for k in taught.counting)
    if taught.told is not None:
        evidence = Evidence(shown, taught.answers, taught.exams)
        return told_exercise(taught.told, draft.board, draft.deck, evidence)
    if not shown:
        return None
    if draft.features is not None:
        return _grounded(shown, draft.features)
    dialogue = dialogue_of(draft)
    return None if dialogue is None else _taught(dialogue, draft)


def exam_of(draft: Draft, exercise: RuledExercise) -> tuple[ExamPlay, ...]:
    """The plays of the exam that is under way; none where there is none."""
    if draft.exam is None:
        return ()
    return _exam_plays(exercise, draft.exam.seed)


def examined(plays: Sequence[ExamPlay], replies: Sequence[Word], date: str) -> Examined:
    """The step that an exam makes: its result, and the plays judged otherwise."""
    judged = list(zip(plays, replies, strict=False))
    return Examined(result(judged, date), objections(judged))


def teacher_of(draft: Draft, language: Language) -> Teacher:
    """Who speaks of the draft."""
    return Teacher(language, draft.board, draft.deck)


@lru_cache(maxsize=REMEMBERED)
def _dialogue(
    shown: tuple[Demonstration, ...], answers: tuple[Answer, ...], replies: tuple[Reply, ...]
) -> Dialogue:
    if not replies:
        return begin(shown, answers, Terms())
    return step(_dialogue(shown, answers, replies[:-1]), replies[-1])


@lru_cache(maxsize=REMEMBERED)
def _grounded(shown: tuple[Demonstration, ...], features: tuple[str, ...]) -> Exercise:
    return learn_grounded(shown, features=features)


@lru_cache(maxsize=REMEMBERED)
def _exam_plays(exercise: RuledExercise, seed: int) -> tuple[ExamPlay, ...]:
    return exam_plays(exercise, EXAM_PLAYS, seed)


def _taught(dialogue: Dialogue, draft: Draft) -> RuledExercise:
    return taught_exercise(dialogue.lesson, dialogue.status, draft.taught.exams)
