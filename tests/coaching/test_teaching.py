"""A caregiver's lesson, fact by fact, with the real learners."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from maestra.coaching.commands import AskCaregiver, Commands, Matter, Show, View
from maestra.coaching.events import (
    Answered,
    Begun,
    BoardBack,
    BoardLost,
    DoneSaid,
    EndOrdered,
    Event,
    HelpAsked,
    Paused,
    Resumed,
    SeveralTokens,
    Skipped,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.lesson import Lesson, Stage, new_lesson
from maestra.coaching.notes import Note
from maestra.coaching.teachers import AskingTeacher, GroundedTeacher, Teacher
from maestra.coaching.teaching import step
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.language.coach_keys import CoachKey
from maestra.rules.answers import Reply
from maestra.rules.exercise import GroundedExercise, RuledExercise
from tests.coaching.driving import fields_of, noted, said
from tests.coaching.plain_referee import BOARD, DECK, START, TOKENS, cell, token
from tests.coaching.test_any_lesson import SlowTeacher


@dataclass
class Class:
    """A lesson driven by hand."""

    lesson: Lesson

    @classmethod
    def begun(cls, teacher: Teacher | None = None) -> Class:
        taught = teacher or GroundedTeacher(Language.EN)
        new = cls(new_lesson(DECK, START, taught, Language.EN, 1))
        new.feed(Begun())
        return new

    def stage(self) -> Stage:
        return self.lesson.stage

    def count(self) -> int:
        return len(self.lesson.moves)

    def is_unclear(self) -> bool:
        return self.lesson.unclear

    def feed(self, event: Event) -> Commands:
        now = Milliseconds(self.lesson.now + 1_000)
        self.lesson, commands = step(self.lesson, event, now)
        return commands

    def move(self, value: int, row: int, column: int) -> Commands:
        self.feed(TokenLifted(token(value)))
        return self.feed(TokenPlaced(token(value), cell(row, column)))

    def show(self, *values: int) -> Commands:
        commands: Commands = ()
        for column, value in enumerate(values, start=1):
            commands = self.move(value, 1, column)
        return commands

    def clear(self) -> Commands:
        return self.feed(BoardBack(dict(zip(TOKENS, BOARD.storage_cells, strict=False))))


def test_a_full_row_is_learned_from_and_said_back() -> None:
    lesson = Class.begun()
    commands = lesson.show(3, 8, 21)
    assert said(commands)[:2] == [CoachKey.SEEN, CoachKey.UNDERSTOOD]
    assert lesson.stage() is Stage.CLEARING
    assert any(isinstance(c, Show) and c.view is View.RULES and c.lines for c in commands)
    lesson.clear()
    assert lesson.stage() is Stage.SHOWING
    assert lesson.count() == 0


def test_the_row_is_cleared_token_by_token_and_the_new_arrangement_is_the_next_start() -> None:
    lesson = Class.begun()
    lesson.show(3, 8, 21)
    lesson.move(3, 3, 3)
    lesson.move(8, 3, 2)
    assert lesson.stage() is Stage.CLEARING
    lesson.move(21, 2, 2)
    assert lesson.stage() is Stage.SHOWING
    assert lesson.lesson.start.cells[token(3)] == cell(3, 3)


def test_a_shorter_row_ends_when_somebody_says_so() -> None:
    lesson = Class.begun()
    assert said(lesson.feed(DoneSaid())) == [CoachKey.NOTHING_SHOWN]
    lesson.move(3, 1, 1)
    assert CoachKey.SEEN in said(lesson.feed(DoneSaid()))
    (play,) = lesson.lesson.plays
    assert len(play.moves) == 1


def test_a_token_taken_out_of_the_row_was_no_move() -> None:
    lesson = Class.begun()
    lesson.move(3, 1, 1)
    assert said(lesson.move(3, 2, 3)) == [CoachKey.TAKEN_BACK]
    assert lesson.count() == 0
    lesson.move(3, 1, 1)
    lesson.move(3, 1, 2)
    assert [move.destination for move in lesson.lesson.moves] == [cell(1, 2)]
    lesson.move(3, 3, 3)
    assert lesson.lesson.start.cells[token(3)] == cell(3, 3)


def test_moving_about_in_storage_is_another_start() -> None:
    lesson = Class.begun()
    lesson.move(3, 3, 3)
    assert lesson.count() == 0
    assert lesson.lesson.start.cells[token(3)] == cell(3, 3)
    assert noted(lesson.feed(TokenPutBack(token(3)))) == [Note.RETURNED]


def test_recording_waits_until_one_token_is_moved_at_a_time() -> None:
    lesson = Class.begun()
    lesson.feed(TokenLifted(token(3)))
    assert said(lesson.feed(TokenLifted(token(5)))) == [CoachKey.ONE_AT_A_TIME]
    lesson.feed(TokenPlaced(token(3), cell(1, 1)))
    assert lesson.count() == 0
    assert lesson.is_unclear()
    lesson.feed(TokenPlaced(token(5), START.cells[token(5)]))
    assert CoachKey.THANKS in said(lesson.feed(TokenPlaced(token(3), START.cells[token(3)])))
    assert not lesson.is_unclear()
    lesson.feed(SeveralTokens((token(3), token(5))))
    assert lesson.is_unclear()


def test_a_token_put_where_another_belongs_is_not_recorded() -> None:
    lesson = Class.begun()
    lesson.move(3, 1, 1)
    assert CoachKey.ONE_AT_A_TIME in said(lesson.feed(TokenPlaced(token(5), cell(1, 1))))
    other = Class.begun()
    other.move(3, 1, 1)
    assert CoachKey.ONE_AT_A_TIME in said(other.move(5, 2, 3))


def test_a_play_can_be_forgotten() -> None:
    lesson = Class.begun()
    lesson.move(3, 1, 1)
    assert said(lesson.feed(Skipped())) == [CoachKey.FORGOTTEN, CoachKey.CLEAR_THE_ROW]
    assert said(lesson.feed(Skipped())) == [CoachKey.CLEAR_THE_ROW]
    lesson.clear()
    assert lesson.lesson.plays == ()


def test_nothing_is_made_up_while_the_board_is_lost_or_the_lesson_paused() -> None:
    lesson = Class.begun()
    lesson.feed(BoardLost())
    lesson.move(3, 1, 1)
    assert said(lesson.feed(HelpAsked())) == []
    lesson.feed(BoardBack({**START.cells, token(3): cell(1, 1)}))
    assert lesson.count() == 0
    assert lesson.is_unclear()
    other = Class.begun()
    other.feed(Paused())
    other.move(3, 1, 1)
    assert noted(other.feed(Paused())) == [Note.UNEXPECTED]
    other.feed(Resumed())
    assert other.count() == 0
    assert other.is_unclear()


def test_a_lesson_that_begins_with_a_full_row_asks_to_clear_it() -> None:
    start = START.__class__(BOARD, {**START.cells, token(3): cell(1, 1)})
    lesson = Class(new_lesson(DECK, start, GroundedTeacher(Language.EN), Language.EN, 1))
    assert CoachKey.CLEAR_THE_ROW in said(lesson.feed(Begun()))


def test_strangers_and_cells_that_are_not_there_are_answered() -> None:
    lesson = Class.begun()
    assert said(lesson.feed(TokenPutBack(TokenId("z")))) == [CoachKey.UNKNOWN_TOKEN]
    assert said(lesson.feed(TokenPlaced(TokenId("z"), cell(1, 1)))) == [CoachKey.UNKNOWN_TOKEN]
    (asked,) = lesson.feed(TokenPlaced(token(3), cell(9, 9)))
    assert isinstance(asked, AskCaregiver)
    commands = lesson.feed(BoardBack({TokenId("z"): cell(1, 1), token(3): cell(9, 9)}))
    assert any(isinstance(c, AskCaregiver) for c in commands)


def test_what_cannot_be_learned_from_is_said_and_dropped() -> None:
    lesson = Class.begun(Refusing(Language.EN))
    commands = lesson.show(3, 8, 21)
    (asked,) = [c for c in commands if isinstance(c, AskCaregiver)]
    assert asked.matter is Matter.DEMONSTRATION
    assert lesson.lesson.plays == ()


class Refusing(GroundedTeacher):
    """Cannot learn from anything."""

    def shown(self, play: Demonstration) -> GroundedTeacher:
        raise InvalidError([Fault("moves", str(len(play.moves)), "others")])


def test_the_end_says_whether_all_is_clear() -> None:
    lesson = Class.begun()
    lesson.show(3, 8, 21)
    commands = lesson.feed(EndOrdered())
    assert said(commands) == [CoachKey.NOT_CLEAR]
    assert fields_of(commands, Note.LEARNED) == {"learned": False, "demonstrations": 1}
    assert noted(lesson.feed(Begun())) == [Note.UNEXPECTED]


def test_the_few_shot_teacher_asks_and_learns_from_the_answers() -> None:
    lesson = Class.begun(AskingTeacher(Language.EN))
    commands = lesson.show(3, 8, 21)
    asked = [c for c in commands if isinstance(c, AskCaregiver)]
    assert [one.matter for one in asked] == [Matter.QUESTION]
    assert lesson.stage() is Stage.ASKING
    assert lesson.feed(DoneSaid())
    assert noted(lesson.feed(Answered(99, Reply.YES))) == [Note.ANSWERED]
    lesson.feed(Skipped())
    for _ in range(5):
        if lesson.stage() is not Stage.ASKING:
            break
        assert lesson.lesson.question is not None
        lesson.feed(Answered(lesson.lesson.question, Reply.YES))
    assert lesson.stage() is Stage.CLEARING
    assert isinstance(lesson.lesson.teacher.exercise, RuledExercise)


def test_a_teacher_that_asks_nothing_ignores_answers() -> None:
    teacher = GroundedTeacher(Language.EN)
    assert teacher.answered(Reply.YES) is teacher
    asking = AskingTeacher(Language.EN)
    assert asking.answered(Reply.YES) is asking
    with pytest.raises(ValueError, match="nothing has been shown"):
        _ = asking.exercise
    lesson = Class.begun()
    lesson.show(3, 8, 21)
    assert isinstance(lesson.lesson.teacher.exercise, GroundedExercise)


def test_forgetting_before_anything_was_moved_changes_nothing() -> None:
    lesson = Class.begun()
    assert said(lesson.feed(Skipped())) == [CoachKey.FORGOTTEN]
    assert lesson.stage() is Stage.SHOWING


def test_once_all_is_clear_no_other_play_is_asked_for() -> None:
    shown = Demonstration(DECK, START, ())
    lesson = Class.begun(SlowTeacher(plays=(shown, shown)))
    commands = lesson.show(3, 8, 21)
    assert CoachKey.SHOW_ANOTHER not in said(commands)
    assert said(lesson.feed(EndOrdered())) == [CoachKey.LEARNED]
