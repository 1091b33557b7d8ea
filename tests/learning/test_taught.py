"""A lesson as an exercise that can be kept and played."""

from dataclasses import replace

import pytest

from maestra.core.faults import InvalidError
from maestra.core.tokens import Token
from maestra.learning.fewshot.learner import learn
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import Answer, Reply, RowQuestion
from maestra.rules.exercise import Exam, LearnStatus
from maestra.rules.setting import play_of
from tests.learning.caregivers import SMALL_BOARD, SMALL_DECK, small

SHOWN = (small("abc"), small("ade", 2))
ANSWERS = (Answer(RowQuestion(play_of(small("cba"))), Reply.NO),)


def test_an_exercise_keeps_the_lesson_and_what_it_rests_on() -> None:
    lesson = learn(SHOWN, ANSWERS)
    exam = Exam("2026-11-22", 10, 9)
    exercise = taught_exercise(lesson, exams=[exam])
    assert (exercise.board, exercise.deck) == (SMALL_BOARD, SMALL_DECK)
    assert exercise.conjunction == lesson.rules
    assert exercise.safe == lesson.safe
    assert exercise.status.value == lesson.status.value
    assert [one.rules for one in exercise.alternatives] == [r.rules for r in lesson.alternatives]
    evidence = exercise.evidence
    assert (evidence.demonstrations, evidence.answers, evidence.exams) == (SHOWN, ANSWERS, (exam,))


def test_a_confidence_that_sums_to_a_hair_above_one_is_one() -> None:
    lesson = learn(SHOWN)
    more = replace(lesson, confidence=1 + 1e-9, confidences=tuple(1 + 1e-9 for _ in lesson.rules))
    exercise = taught_exercise(more)
    assert exercise.confidence == 1
    assert all(one.confidence == 1 for one in exercise.rules)


def test_the_whole_dialogue_may_have_come_to_something_else() -> None:
    exercise = taught_exercise(learn(SHOWN), LearnStatus.CONTRADICTORY)
    assert exercise.status is LearnStatus.CONTRADICTORY


def test_decks_that_contradict_one_another_make_no_exercise() -> None:
    first, *others = SMALL_DECK.tokens
    deck = replace(SMALL_DECK, tokens=(Token(first.id, (("value", 99),)), *others))
    with pytest.raises(InvalidError, match="a"):
        taught_exercise(learn([SHOWN[0], replace(SHOWN[1], deck=deck)]))
