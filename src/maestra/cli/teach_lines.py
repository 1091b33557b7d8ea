"""`maestra teach --protocol jsonl`: a line of JSON for each question, and one for its answer."""

import json

from maestra.cli.answer_lines import AGAIN, ENOUGH, AnswerJson, AnswerLines
from maestra.cli.streams import print_json
from maestra.cli.taught_lesson import lesson_json, rules_json, slips_json
from maestra.coaching.asking import as_demonstration, asked_play, moments, question_text
from maestra.core.demonstration import Play as Played
from maestra.core.formats import encode_demonstration, encode_move
from maestra.language.teaching import Teacher
from maestra.learning.contradictions import Contradiction, Said, Shown
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    AskSlip,
    AskWhichCounts,
    CellIsWrong,
    Counts,
    Dialogue,
    Enough,
    Event,
    Finished,
    Replied,
    ShownAgain,
    Side,
    SlipReplied,
    SlipReply,
)
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import RuledExercise
from maestra.rules.rule_json import encode_rule

REPLIES = tuple(reply.value for reply in Reply)
_MENDING = {Reply.YES.value: SlipReply.CONFIRMED, Reply.NO.value: SlipReply.TAKEN_BACK}


class TeachLines:
    """Asks a program."""

    def __init__(self, teacher: Teacher) -> None:
        """Put questions in words as `teacher` says them."""
        self._teacher = teacher
        self._answers = AnswerLines()
        self._id = 0

    def event(self, dialogue: Dialogue) -> Event:
        """What the program answers to what is asked; the end of input is enough.

        Raises:
            FormatError: a line that is no answer to it.
        """
        self._id += 1
        print_json(self._line(dialogue))
        match dialogue.ask:
            case AskQuestion() | AskAgain():
                answer = self._answer(REPLIES)
                return _enough(answer) or Replied(Reply(answer.answer))
            case AskCell():
                columns = self._teacher.board.columns
                answer = self._answer((Reply.UNSURE.value,), columns)
                cell = None if answer.column is None else answer.column - 1
                return _enough(answer) or CellIsWrong(cell)
            case AskSlip(slip):
                answer = self._answer((*_MENDING, AGAIN))
                if answer.answer == AGAIN:
                    like = dialogue.demonstrations[slip.demonstration]
                    return ShownAgain(self._answers.demonstration(like))
                return _enough(answer) or SlipReplied(_MENDING[str(answer.answer)])
            case AskWhichCounts():
                answer = self._answer([side.value for side in Side])
                return _enough(answer) or Counts(Side(answer.answer))
            case Finished():
                return Enough()

    def finish(
        self, dialogue: Dialogue, end: Finished, exercise: RuledExercise | None, seconds: float
    ) -> None:
        """The last line."""
        teacher, lesson = self._teacher, dialogue.lesson
        # Where nothing is left, the line still has what was learned before.
        exercise = exercise or taught_exercise(lesson, dialogue.status)
        print_json(
            {
                "type": "learned",
                **lesson_json(exercise, lesson, teacher, seconds, dialogue.counting),
                "questions": dialogue.asked,
                "ending": end.ending.value,
                "contradictions": [
                    _contradiction_json(dialogue, one, teacher) for one in end.unsettled
                ],
            }
        )

    def _answer(self, words: "tuple[str, ...] | list[str]", columns: int = 0) -> AnswerJson:
        return self._answers.next(self._id, words, columns)

    def _line(self, dialogue: Dialogue) -> dict[str, object]:
        """The line that asks."""
        text = question_text(dialogue, self._teacher)
        match dialogue.ask:
            case AskQuestion(question):
                return {
                    "type": "question",
                    "id": self._id,
                    **_question_json(question),
                    "text": text,
                    **self._so_far(dialogue),
                }
            case AskAgain(contradiction, question):
                return {
                    "type": "question",
                    "id": self._id,
                    **_question_json(question),
                    "text": text,
                    "contradiction": _contradiction_json(dialogue, contradiction, self._teacher),
                    **self._so_far(dialogue),
                }
            case AskCell(number):
                question = dialogue.answers[number].question
                return {
                    "type": "which",
                    "id": self._id,
                    "text": text,
                    "position": _question_json(question).get("position"),
                }
            case AskSlip(slip):
                return {
                    "type": "slip",
                    "id": self._id,
                    "text": text,
                    "demonstration": slip.demonstration + 1,
                    "move": slip.move + 1,
                    "position": played_json(dialogue.demonstrations[slip.demonstration]),
                }
            case AskWhichCounts(contradiction):
                return {
                    "type": "contradiction",
                    "id": self._id,
                    "text": text,
                    **_contradiction_json(dialogue, contradiction, self._teacher),
                }
            case Finished():
                return {}

    def _so_far(self, dialogue: Dialogue) -> dict[str, object]:
        lesson, teacher = dialogue.lesson, self._teacher
        return {
            "status": dialogue.status.value,
            "rules": rules_json(lesson, teacher),
            "slips": slips_json(lesson, teacher, dialogue.counting),
        }


def _enough(answer: AnswerJson) -> Enough | None:
    return Enough() if answer.answer == ENOUGH else None


def _question_json(question: Question) -> dict[str, object]:
    """What a question is about, as formats.md writes it."""
    play = asked_play(question)
    shown = {} if play is None else {"position": played_json(as_demonstration(play))}
    match question:
        case RowQuestion():
            return {"kind": "row", **shown}
        case MoveQuestion(position, token, cell):
            move = position.after(token, cell).moves()[-1]
            return {"kind": "move", **shown, "move": encode_move(move)}
        case RuleQuestion(rule):
            return {"kind": "rule", "rule": encode_rule(rule)}


def played_json(played: Played) -> object:
    """A play or position as a file of demonstrations has it."""
    return json.loads(encode_demonstration(played))


def _contradiction_json(
    dialogue: Dialogue, contradiction: Contradiction, teacher: Teacher
) -> dict[str, object]:
    """The two moments side by side."""
    earlier, later = moments(dialogue, contradiction, teacher)
    match contradiction.earlier:
        case Shown(number):
            what: dict[str, object] = {"demonstration": number + 1}
        case Said(number):
            what = {"answer": number + 1}
        case _:
            what = {}
    return {
        "earlier": {**what, "text": earlier},
        "later": {"answer": contradiction.later.answer + 1, "text": later},
    }
