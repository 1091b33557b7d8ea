"""`maestra tell` and `maestra edit`: rules said in words."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import assert_never

import typer

from maestra.cli.lesson import Speech
from maestra.cli.lesson_of_rules import ruled_json, ruled_lines
from maestra.cli.loading import plays_in, words_in
from maestra.cli.ruled_file import ruled_exercise_in
from maestra.cli.streams import STANDARD, named, print_json, print_lines, write_file
from maestra.core.board import Board
from maestra.core.faults import Fault, InvalidError
from maestra.core.json_lines import FormatError
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.language import Language
from maestra.language.terminal import TerminalKey
from maestra.language.understanding import (
    Listener,
    Several,
    Understood,
    Unknown,
    listener_for,
)
from maestra.rules.exercise import RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.telling import clash, dealt, told_exercise, with_length


@dataclass(frozen=True, slots=True)
class Change:
    """What is to become of an exercise's rules."""

    rule: tuple[str, str] | None = None
    """The id of a rule, and the sentence that takes its place."""
    add: str | None = None
    """A sentence."""
    remove: str | None = None
    """The id of a rule."""


@dataclass(frozen=True, slots=True)
class _Desk:
    """Where sentences are understood and answers are printed."""

    speech: Speech
    listener: Listener
    as_json: bool

    def rules(self, sentence: str) -> tuple[Rule, ...]:
        """The rules that a sentence says.

        Raises:
            InvalidError: it is too long.
            typer.Exit: it is not understood; that has been said.
        """
        found = self.listener.understand(sentence)
        if isinstance(found, Understood):
            return found.rules
        if self.as_json:
            print_json(_json_of(found))
        else:
            print_lines(self._lines_of(found))
        raise typer.Exit(1)

    def _lines_of(self, found: Several | Unknown) -> Iterator[str]:
        match found:
            case Several(sentences):
                yield self.speech.say(TerminalKey.SEVERAL_MEANINGS)
                yield from (f"- {sentence}" for sentence in sentences)
            case Unknown(quotes):
                for quote in quotes:
                    yield self.speech.say(TerminalKey.NOT_UNDERSTOOD, text=quote.text)
                    yield self.speech.say(TerminalKey.COULD_SAY)
                    yield from (f"- {sentence}" for sentence in quote.nearest)
            case _:
                assert_never(found)

    def save(self, exercise: RuledExercise, start: State, output: str | None) -> None:
        """Write the exercise and say its rules, if these can be kept together.

        Raises:
            typer.Exit: they cannot; that has been said.
        """
        apart = clash(exercise.conjunction, Setting(exercise.deck, start))
        if apart:
            self._refuse(apart)
        if output is not None:
            write_file(output, encode_exercise(exercise))
        if output == STANDARD:
            return
        if self.as_json:
            print_json(ruled_json(exercise, self.speech))
            return
        print_lines(ruled_lines(exercise, self.speech))
        if output is not None:
            print_lines([self.speech.say(TerminalKey.WRITTEN, file=output)])

    def _refuse(self, rules: tuple[Rule, ...]) -> None:
        said = [self.listener.says(rule) for rule in rules]
        if self.as_json:
            print_json({"status": "contradictory", "rules": said})
        else:
            heading = self.speech.say(TerminalKey.CANNOT_KEEP)
            print_lines([heading, *(f"- {sentence}" for sentence in said)])
        raise typer.Exit(1)


def tell(
    sentence: str,
    deck_file: str,
    output: str | None,
    board_size: str | None,
    speech: tuple[str, str | None],
    *,
    as_json: bool,
) -> None:
    """Make an exercise of what a sentence says, for the tokens of a file's first play."""
    deck, start = _first_deck(deck_file)
    if board_size is not None:
        start = dealt(deck, _board(board_size))
    desk = _desk(start.board, deck, speech, as_json=as_json)
    rules = with_length(desk.rules(sentence))
    desk.save(told_exercise(rules, start.board, deck), start, output)


def edit(
    exercise_file: str,
    change: Change,
    output: str,
    speech: tuple[str, str | None],
    *,
    as_json: bool,
) -> None:
    """Replace, add or remove a rule of an exercise; what was shown for it stays with it."""
    exercise = ruled_exercise_in(exercise_file)
    desk = _desk(exercise.board, exercise.deck, speech, as_json=as_json)
    rules = list(exercise.conjunction)
    if change.remove is not None:
        del rules[_index(exercise, change.remove, exercise_file)]
    if change.rule is not None:
        name, sentence = change.rule
        kept = exercise.conjunction[_index(exercise, name, exercise_file)]
        place = rules.index(kept) if kept in rules else len(rules)
        rules[place : place + 1] = desk.rules(sentence)
    if change.add is not None:
        rules += desk.rules(change.add)
    evidence = exercise.evidence
    shown = next((one.start for one in evidence.demonstrations), None)
    start = shown or dealt(exercise.deck, exercise.board)
    changed = told_exercise(rules, exercise.board, exercise.deck, evidence)
    desk.save(changed, start, output)


def _desk(board: Board, deck: Deck, speech: tuple[str, str | None], *, as_json: bool) -> _Desk:
    code, words_file = speech
    spoken = Speech(Language(code), words_in(words_file))
    listener = listener_for(spoken.language, board, deck, spoken.words)
    return _Desk(spoken, listener, as_json)


def _first_deck(path: str) -> tuple[Deck, State]:
    _, play = next(plays_in(path))
    return play.deck, play.start


def _board(size: str) -> Board:
    rows, found, columns = size.partition("x")
    if not (found and rows.isdigit() and columns.isdigit()):
        raise InvalidError([Fault("--board", size, "ROWSxCOLUMNS, such as 4x5")])
    return Board(int(rows), int(columns))


def _index(exercise: RuledExercise, name: str, file: str) -> int:
    ids = [one.id for one in exercise.rules]
    if name not in ids:
        expected = f"one of {', '.join(ids)}" if ids else "an exercise that has rules"
        raise FormatError(named(file), 1, (Fault("rule", name, expected),))
    return ids.index(name)


def _json_of(found: Several | Unknown) -> dict[str, object]:
    match found:
        case Several(sentences):
            return {"status": "several", "readings": list(sentences)}
        case Unknown(quotes):
            return {
                "status": "unknown",
                "quotes": [{"text": one.text, "nearest": list(one.nearest)} for one in quotes],
            }
        case _:
            assert_never(found)
