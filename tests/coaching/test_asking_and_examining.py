"""What is asked and what an exam comes to, in words."""

from dataclasses import replace

import pytest

from maestra.coaching.asking import as_demonstration, asked_play, moments, question_text
from maestra.coaching.examining import Changes, changes, examined, truth
from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.language import Language
from maestra.language.teaching import Teacher
from maestra.learning.contradictions import Contradiction, Said, Shown, Understood
from maestra.learning.dialogue import (
    Ask,
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    Dialogue,
    Ending,
    Finished,
    Terms,
    begin,
)
from maestra.learning.exam import ExamPlay
from maestra.learning.fewshot.lesson import Slip
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import Exam
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.paper import NUMBER_DECK
from maestra.rules.setting import Play, Setting, play_of
from maestra.rules.telling import dealt, told_exercise

BOARD = Board()
START: State = dealt(NUMBER_DECK, BOARD)
TEACHER = Teacher(Language.EN, BOARD, NUMBER_DECK)
BOUND = "With 95 % confidence fewer than 46 % of my plays would be wrong."
RISING = Ordered("value", Direction.RISING)
FALLING = Ordered("value", Direction.FALLING)


def shown() -> Demonstration:
    tokens = [token.id for token in NUMBER_DECK.tokens[:5]]
    moves = zip(tokens, BOARD.goal_cells, strict=True)
    return Demonstration(
        NUMBER_DECK, START, tuple(Move(t, START.cells[t], cell) for t, cell in moves)
    )


ROW = RowQuestion(play_of(shown()))
MOVE = MoveQuestion(Play.begin(Setting(NUMBER_DECK, START)), 0, 0)
RULE = RuleQuestion(RISING)
CLASH = Contradiction(Shown(0), Said(0))


@pytest.fixture(scope="module")
def dialogue() -> Dialogue:
    begun = begin([shown()], (), Terms(questions=0))
    return replace(begun, answers=(Answer(ROW, Reply.NO), Answer(RULE, Reply.YES)))


def asking(dialogue: Dialogue, ask: Ask) -> str:
    return question_text(replace(dialogue, ask=ask), TEACHER)


def test_each_thing_that_is_asked_has_its_sentence(dialogue: Dialogue) -> None:
    assert asking(dialogue, AskQuestion(ROW)) == "Is this row right: 19, 23, 32, 34, 36?"
    assert asking(dialogue, AskCell(0)) == "Which token is wrong in this row?"
    assert "was" in asking(dialogue, AskSlip(Slip(0, 1, 0.9)))
    assert asking(dialogue, AskWhichCounts(CLASH)) == "Which of the two counts?"
    assert asking(dialogue, AskAgain(CLASH, ROW)).endswith(
        "Is this row right: 19, 23, 32, 34, 36?"
    )
    assert asking(dialogue, Finished(Ending.SURE, ())) == ""


def test_both_moments_are_said_the_earlier_first(dialogue: Dialogue) -> None:
    wrong = "You said that this row is wrong: 19, 23, 32, 34, 36."
    assert moments(dialogue, CLASH, TEACHER) == (
        "In the first demonstration you made this row: 19, 23, 32, 34, 36.",
        wrong,
    )
    said, _ = moments(dialogue, Contradiction(Said(1), Said(0)), TEACHER)
    assert said.startswith("You said that this is meant:")
    understood, _ = moments(dialogue, Contradiction(Understood(), Said(0)), TEACHER)
    assert understood.startswith("From all the rest I understood:")


def test_a_question_is_drawn_as_the_play_it_is_about() -> None:
    assert asked_play(ROW) == ROW.play
    assert asked_play(MOVE) == MOVE.position
    assert asked_play(RULE) is None
    assert as_demonstration(ROW.play) == shown()


def test_an_exam_that_agrees_in_all_is_only_counted() -> None:
    exercise = told_exercise((FullRow(), RISING), BOARD, NUMBER_DECK)
    outcome = examined(exercise, [(ExamPlay(ROW.play, is_right=True), Reply.YES)], "2026-05-04")
    assert (outcome.changes, outcome.objected) == (None, False)
    assert outcome.exercise.evidence.exams == (Exam("2026-05-04", 1, 1),)
    assert outcome.most_wrong == pytest.approx(0.95)


def test_what_is_new_and_what_is_gone_is_told() -> None:
    before = told_exercise((FullRow(), RISING), BOARD, NUMBER_DECK)
    after = told_exercise((FullRow(), FALLING), BOARD, NUMBER_DECK)
    assert changes(before, after) == Changes((FALLING,), (RISING,))


@pytest.mark.parametrize(
    ("exam", "sentences"),
    [
        (Exam("d", 0, 0), ("You judged none of my plays, so I know no more than before.",)),
        (Exam("d", 1, 0), ("You agreed with 0 of 1 plays.",)),
        (
            Exam("d", 5, 5, 3, 2),
            (
                f"You agreed with 5 of 5 plays. {BOUND}",
                "Of 3 rows that I hold for wrong you called 2 wrong too.",
            ),
        ),
    ],
)
def test_the_truth_of_an_exam_is_plain(exam: Exam, sentences: tuple[str, ...]) -> None:
    assert truth(exam, TEACHER) == sentences
