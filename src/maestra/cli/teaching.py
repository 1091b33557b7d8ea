"""`maestra teach`: demonstrations in, questions out, replies in, an exercise out."""

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import typer

from maestra.cli.faults_at import at_line
from maestra.cli.lesson_of_rules import ruled_lines
from maestra.cli.loading import words_in
from maestra.cli.ruled_file import ruled_exercise_in
from maestra.cli.shown_file import shown_in
from maestra.cli.streams import STANDARD, print_json, print_lines, write_file
from maestra.cli.taught_lesson import lesson_json, speech_of
from maestra.cli.teach_lines import TeachLines
from maestra.cli.teach_terminal import TeachTerminal
from maestra.cli.terms import THE_ANSWER_IS_NO
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.language import Language, Lexicon
from maestra.language.teaching import Teacher
from maestra.language.teaching_keys import TeachKey
from maestra.learning.dialogue import (
    Dialogue,
    Ending,
    Event,
    Finished,
    Terms,
    begin,
    step,
)
from maestra.learning.fewshot.questions import QuestionKind
from maestra.learning.taught import taught_exercise
from maestra.rules.answers import Answer, Reply, RuleQuestion
from maestra.rules.decks import merge_decks
from maestra.rules.exercise import Exam, LearnStatus, RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.setting import play_of

MAX_TAUGHT = 200
"""Demonstrations that are weighed one against the other; people show three."""


@dataclass(frozen=True, slots=True)
class Request:
    """What is to be taught, and how."""

    demonstrations: str | None
    output: str
    goes_on: str | None
    """The exercise that teaching goes on with."""
    questions: int
    kinds: tuple[str, ...]
    seed: int
    by_lines: bool
    """Whether a program answers, line by line."""
    follow_ups: bool
    """Whether that program understands more than questions."""


@dataclass(frozen=True, slots=True)
class Before:
    """What was shown, answered and examined on other days."""

    demonstrations: tuple[Demonstration, ...] = ()
    answers: tuple[Answer, ...] = ()
    exams: tuple[Exam, ...] = ()


@dataclass(slots=True)
class Stopwatch:
    """How long Maestra itself took, without the time that people need."""

    seconds: float = field(default=0.0)

    def begin(self, shown: Sequence[Demonstration], before: Before, terms: Terms) -> Dialogue:
        """`maestra.learning.dialogue.begin`."""
        return self._timed(lambda: begin(shown, before.answers, terms))

    def step(self, dialogue: Dialogue, event: Event) -> Dialogue:
        """`maestra.learning.dialogue.step`."""
        return self._timed(lambda: step(dialogue, event))

    def _timed(self, work: Callable[[], Dialogue]) -> Dialogue:
        began = time.perf_counter()
        dialogue = work()
        self.seconds += time.perf_counter() - began
        return dialogue


def teach(request: Request, language: str, words_file: str | None) -> None:
    """Lead the dialogue, write what was taught; exit 1 if it is not clear in the end."""
    words = words_in(words_file)
    before = Before() if request.goes_on is None else _before(request.goes_on)
    shown = (*before.demonstrations, *demonstrations_in(request.demonstrations, before))
    terms = Terms(
        request.questions,
        frozenset(map(QuestionKind, request.kinds)),
        follow_ups=request.follow_ups,
        seed=request.seed,
    )
    teacher = teacher_for(shown, Language(language), words)
    watch = Stopwatch()
    ask = TeachLines(teacher) if request.by_lines else TeachTerminal(teacher)
    dialogue = watch.begin(shown, before, terms)
    while not isinstance(dialogue.ask, Finished):
        dialogue = watch.step(dialogue, ask.event(dialogue))
    exercise = None
    if dialogue.ask.ending is not Ending.NOTHING_LEFT:
        exercise = taught_exercise(dialogue.lesson, dialogue.status, before.exams)
        write_file(request.output, encode_exercise(exercise))
    ask.finish(dialogue, dialogue.ask, exercise, watch.seconds)
    if exercise is not None and not request.by_lines:
        print_lines(saved(request.output, teacher))
    if dialogue.status is not LearnStatus.LEARNED:
        raise typer.Exit(THE_ANSWER_IS_NO)


def learn_by_few(
    demonstrations: str, output: str, language: str, words_file: str | None, *, as_json: bool
) -> None:
    """`maestra learn --learner fewshot`: the same without asking."""
    words = words_in(words_file)
    shown = demonstrations_in(demonstrations, Before())
    watch = Stopwatch()
    dialogue = watch.begin(shown, Before(), Terms(questions=0, follow_ups=False))
    exercise = taught_exercise(dialogue.lesson)
    write_file(output, encode_exercise(exercise))
    teacher = teacher_for(shown, Language(language), words)
    if as_json:
        print_json(lesson_json(exercise, dialogue.lesson, teacher, watch.seconds))
    else:
        # The exercise itself may go to standard output.
        place = sys.stderr if output == STANDARD else sys.stdout
        lines = [*ruled_lines(exercise, speech_of(teacher)), *saved(output, teacher)]
        place.writelines(f"{line}\n" for line in lines)
    if dialogue.status is not LearnStatus.LEARNED:
        raise typer.Exit(THE_ANSWER_IS_NO)


def saved(output: str, teacher: Teacher) -> list[str]:
    """Where the exercise is now, if that is a file."""
    return [] if output == STANDARD else [teacher.say(TeachKey.SAVED, file=output)]


def demonstrations_in(path: str | None, before: Before) -> tuple[Demonstration, ...]:
    """The demonstrations of a file, on the board of those before.

    Raises:
        OSError: the file cannot be read.
        FormatError: it holds something else, or what a few-shot learner cannot learn from.
    """
    if path is None:
        return ()
    with shown_in(path) as shown:
        if shown.count + len(before.demonstrations) > MAX_TAUGHT:
            fault = Fault("", f"{shown.count} demonstrations", f"at most {MAX_TAUGHT} in all")
            raise FormatError(shown.name, 1, (fault,))
        for number, one in zip(shown.lines, shown.kept, strict=True):
            with at_line(shown.name, number):
                play_of(one)
                merge_decks([*(old.deck for old in before.demonstrations), one.deck])
            if before.demonstrations and one.board != before.demonstrations[0].board:
                fault = Fault("board", "another board", "the board of the exercise to go on with")
                raise FormatError(shown.name, number, (fault,))
        return shown.kept


def teacher_for(shown: Sequence[Demonstration], language: Language, words: Lexicon) -> Teacher:
    """Who speaks of these demonstrations."""
    deck = merge_decks([one.deck for one in shown])
    return Teacher(language, shown[0].board, deck, words)


def _before(path: str) -> Before:
    """What an exercise rests on; rules that were told count as answers.

    Raises:
        OSError: the file cannot be read.
        FormatError: it is no exercise that can be taught further.
    """
    exercise = ruled_exercise_in(path)
    evidence = exercise.evidence
    answers = (*_told(exercise), *evidence.answers)
    return Before(evidence.demonstrations, answers, evidence.exams)


def _told(exercise: RuledExercise) -> tuple[Answer, ...]:
    if exercise.status is not LearnStatus.TOLD:
        return ()
    return tuple(Answer(RuleQuestion(rule), Reply.YES) for rule in exercise.conjunction)
