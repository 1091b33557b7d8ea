"""What a dialogue asks its caregiver, in words and as plays to be drawn."""

from __future__ import annotations

from typing import assert_never

from maestra.core.demonstration import Demonstration
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey
from maestra.learning.contradictions import Contradiction, Said, Shown, Understood
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    Dialogue,
    Finished,
)
from maestra.rules.answers import MoveQuestion, Question, RowQuestion, RuleQuestion
from maestra.rules.setting import Play, play_of


def question_text(dialogue: Dialogue, teacher: Teacher) -> str:
    """What is asked, in one sentence or two; empty if nothing is."""
    match dialogue.ask:
        case AskQuestion(question):
            return teacher.question(question)
        case AskAgain(contradiction, question):
            earlier, later = moments(dialogue, contradiction, teacher)
            asked = teacher.question(question)
            return teacher.say(TeachKey.ASK_AGAIN, earlier=earlier, later=later, question=asked)
        case AskCell():
            return teacher.say(TeachKey.WHICH_IS_WRONG)
        case AskSlip(slip):
            play = play_of(dialogue.demonstrations[slip.demonstration])
            number, rules = slip.demonstration + 1, dialogue.lesson.rules
            return teacher.slip(number, play, slip.move, rules)
        case AskWhichCounts():
            return teacher.say(TeachKey.WHICH_COUNTS)
        case Finished():
            return ""
        case _:
            assert_never(dialogue.ask)


def moments(dialogue: Dialogue, contradiction: Contradiction, teacher: Teacher) -> tuple[str, str]:
    """The two moments in words, the earlier first."""
    later = dialogue.answers[contradiction.later.answer]
    earlier = contradiction.earlier
    match earlier:
        case Shown(number):
            play = play_of(dialogue.demonstrations[number])
            text = teacher.shown(number + 1, play, later)
        case Said(number):
            text = teacher.said(dialogue.answers[number])
        case Understood():
            text = teacher.understood(dialogue.lesson.rules)
        case _:
            assert_never(earlier)
    return text, teacher.said(later)


def asked_play(question: Question) -> Play | None:
    """The play to show with a question: the finished one, or where the move is to be made."""
    match question:
        case RowQuestion(play):
            return play
        case MoveQuestion(position):
            return position
        case RuleQuestion():
            return None
        case _:
            assert_never(question)


def as_demonstration(play: Play) -> Demonstration:
    """A play as the board saw it."""
    return Demonstration(play.setting.deck, play.setting.start, play.moves())
