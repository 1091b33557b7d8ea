"""`maestra exam`: Maestra plays by its rules, and the caregiver says what is right."""

import datetime as dt
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import typer

from maestra.cli.answer_lines import ENOUGH, AnswerLines
from maestra.cli.lesson_of_rules import ruled_lines
from maestra.cli.loading import words_in
from maestra.cli.outputs import Output, Said, Tone
from maestra.cli.ruled_file import ruled_exercise_in
from maestra.cli.screen import Screen
from maestra.cli.streams import print_json, write_file
from maestra.cli.taught_lesson import speech_of
from maestra.cli.teach_lines import REPLIES, played_json
from maestra.cli.teach_telling import drawn, how_to
from maestra.cli.teach_words import word_typed
from maestra.cli.terms import THE_ANSWER_IS_NO
from maestra.coaching.asking import as_demonstration
from maestra.coaching.examining import Changes, Outcome, examined, truth
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.language import Language
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey as Key
from maestra.language.terminal import TerminalKey, terminal_sentence
from maestra.learning.exam import ExamPlay, exam_plays
from maestra.rules.answers import Reply, RowQuestion
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.rule import Rule

_KEYS = {Key.TYPE_YES: Reply.YES, Key.TYPE_NO: Reply.NO, Key.TYPE_UNSURE: Reply.UNSURE}


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be examined, and how."""

    exercise: str
    output: str
    plays: int
    seed: int
    by_lines: bool
    """Whether a program answers, line by line."""


def exam(request: Request, language: str, words_file: str | None) -> None:
    """Hold the exam, learn from it, write the exercise; exit 1 if there was any disagreement."""
    words = words_in(words_file)
    exercise = ruled_exercise_in(request.exercise)
    teacher = Teacher(Language(language), exercise.board, exercise.deck, words)
    plays = exam_plays(exercise, request.plays, request.seed)
    if not any(one.is_right for one in plays):
        expected = "rules of which a right play can be found"
        raise FormatError(request.exercise, 1, (Fault("rules", "no right play", expected),))
    ask = _ByLines(teacher, plays) if request.by_lines else _OnTerminal(teacher, plays)
    judged = tuple(ask.judged())
    outcome = examined(exercise, judged, dt.datetime.now(dt.UTC).date().isoformat())
    write_file(request.output, encode_exercise(outcome.exercise))
    ask.finish(outcome, request.output)
    if outcome.objected:
        raise typer.Exit(THE_ANSWER_IS_NO)


def told(outcome: Outcome, teacher: Teacher) -> Iterator[Output]:
    """The result in words: plain truth, then what changed."""
    heading, *rest = truth(outcome.exam, teacher)
    yield Said(heading, Tone.HEADING)
    yield from map(Said, rest)
    if outcome.changes is None:
        if outcome.objected:
            yield Said(teacher.say(Key.ONLY_TOLD), Tone.WRONG)
        return
    is_same = outcome.changes == Changes()
    yield Said(teacher.say(Key.UNCHANGED if is_same else Key.CHANGED))
    yield from (Said(f"- {teacher.rule(rule)}", Tone.ASIDE) for rule in outcome.changes.dropped)
    yield from (Said(f"+ {teacher.rule(rule)}", Tone.NEW) for rule in outcome.changes.added)
    yield Said(teacher.say(Key.NOW), Tone.HEADING)
    yield from (Said(line) for line in ruled_lines(outcome.exercise, speech_of(teacher)))
    yield Said(teacher.say(Key.EXAMINE_AGAIN), Tone.HEADING)


class _OnTerminal:
    """Asks a person."""

    def __init__(self, teacher: Teacher, plays: Sequence[ExamPlay]) -> None:
        self._teacher, self._plays = teacher, plays
        self._screen = Screen(terminal_sentence(TerminalKey.GOAL, teacher.language))

    def judged(self) -> Iterator[tuple[ExamPlay, Reply]]:
        """The plays with what was said of each, until it is enough."""
        lines = self._screen.lines()
        self._screen.show((Said(self._teacher.say(Key.EXAM), Tone.HEADING),))
        for number, one in enumerate(self._plays, start=1):
            self._ask(number, one)
            reply = self._reply(lines)
            if reply is None:
                return
            yield one, reply

    def finish(self, outcome: Outcome, file: str) -> None:
        """Say the result."""
        saved = Said(self._teacher.say(Key.SAVED, file=file))
        self._screen.show((*told(outcome, self._teacher), saved))

    def _ask(self, number: int, one: ExamPlay) -> None:
        count = len(self._plays)
        self._screen.show(
            (
                Said(self._teacher.say(Key.NTH_PLAY, number=number, count=count), Tone.HEADING),
                drawn(one.play),
                Said(self._teacher.question(RowQuestion(one.play))),
                how_to(self._teacher, Key.HOW_TO_REPLY),
            )
        )

    def _reply(self, lines: Iterator[str]) -> Reply | None:
        """What is typed; None: that's enough."""
        for line in lines:
            key = word_typed(line, [*_KEYS, Key.TYPE_ENOUGH], self._teacher.language)
            if key is not None:
                return _KEYS.get(key)
            if line.strip():
                self._screen.show((Said(self._teacher.say(Key.NOT_UNDERSTOOD), Tone.WRONG),))
        return None


class _ByLines:
    """Asks a program."""

    def __init__(self, teacher: Teacher, plays: Sequence[ExamPlay]) -> None:
        self._teacher, self._plays = teacher, plays

    def judged(self) -> Iterator[tuple[ExamPlay, Reply]]:
        """The plays with what was answered to each, until it is enough."""
        answers = AnswerLines()
        for number, one in enumerate(self._plays, start=1):
            print_json(
                {
                    "type": "question",
                    "id": number,
                    "kind": "row",
                    "position": played_json(as_demonstration(one.play)),
                    "text": self._teacher.question(RowQuestion(one.play)),
                }
            )
            answer = answers.next(number, REPLIES)
            if answer.answer == ENOUGH:
                return
            yield one, Reply(answer.answer)

    def finish(self, outcome: Outcome, file: str) -> None:  # noqa: ARG002 - the program named the file
        """The last line."""
        held, changes = outcome.exam, outcome.changes
        texts = [one.text for one in told(outcome, self._teacher) if isinstance(one, Said)]
        print_json(
            {
                "type": "examined",
                "plays": held.plays,
                "agreed": held.agreed,
                "near_misses": held.near_misses,
                "near_misses_agreed": held.near_misses_agreed,
                "most_wrong": round(outcome.most_wrong, 4),
                "confidence": 0.95,
                "text": " ".join(texts),
                "status": outcome.exercise.status.value,
                "learned_again": changes is not None,
                "added": self._rules(() if changes is None else changes.added),
                "dropped": self._rules(() if changes is None else changes.dropped),
            }
        )

    def _rules(self, rules: Sequence[Rule]) -> list[dict[str, str]]:
        return [{"id": one.id, "text": one.text} for one in self._teacher.rules(rules)]
