"""Questions: what they are about, what they tell, and where they lead."""

from __future__ import annotations

import numpy as np
import pytest

from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.questions import (
    QuestionKind,
    information,
    next_question,
)
from maestra.rules.answers import MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.order import Ordered
from tests.learning.fewshot_plays import answered, shown

RISING = Ordered("value")
ONE = [shown((0, 2, 5, 7, 8))]
KINDS = {
    QuestionKind.ROW: RowQuestion,
    QuestionKind.MOVE: MoveQuestion,
    QuestionKind.RULE: RuleQuestion,
}


def test_answers_of_even_odds_tell_most() -> None:
    worth = information(np.array([0.0, 0.5, 1.0]))
    assert worth[1] > 0.7
    assert worth[0] == pytest.approx(0, abs=1e-9)
    assert worth[2] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("kind", list(QuestionKind))
def test_only_the_wanted_kinds_are_asked(kind: QuestionKind) -> None:
    assert isinstance(next_question(learn(ONE), {kind}), KINDS[kind])


def test_questions_lead_to_rising_numbers() -> None:
    lesson = learn(ONE)
    for _ in range(5):
        question = next_question(lesson, {QuestionKind.ROW})
        if question is None:
            break
        assert isinstance(question, RowQuestion)
        assert question not in {answer.question for answer in lesson.answers}
        lesson = answered(lesson, question, Reply.YES if RISING.holds(question.play) else Reply.NO)
    assert RISING in lesson.rules


def test_who_is_sure_asks_nothing() -> None:
    rising = [(0, 2, 5, 7, 8), (1, 3, 4, 6, 9), (2, 3, 6, 8, 9), (0, 1, 4, 5, 6), (0, 3, 4, 7, 9)]
    lesson = learn([shown(row, turn) for turn, row in enumerate(rising)])
    assert lesson.status is LearnStatus.LEARNED
    assert next_question(lesson) is None


def test_an_unsure_answer_is_not_asked_for_again() -> None:
    lesson = learn(ONE)
    first = next_question(lesson, {QuestionKind.ROW})
    assert first is not None
    again = next_question(answered(lesson, first, Reply.UNSURE), {QuestionKind.ROW})
    assert again is not None
    assert again != first


def test_rows_with_gaps_are_asked_about() -> None:
    lesson = learn([shown((2, 4, 5)), shown((4, 6, 8), 3)])
    for _ in range(2):
        question = next_question(lesson, {QuestionKind.ROW})
        assert isinstance(question, RowQuestion)
        lesson = answered(lesson, question, Reply.YES)


def test_an_order_of_placement_is_asked_about() -> None:
    back = (4, 3, 2, 1, 0)
    lesson = learn([shown((0, 2, 5, 7, 8), 0, back), shown((1, 3, 4, 6, 9), 2, back)])
    assert isinstance(next_question(lesson, {QuestionKind.RULE}), RuleQuestion)
