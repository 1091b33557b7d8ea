"""`maestra play`: a patient's session on a terminal, or on what is piped into it.

At a terminal the clock is the real one, so the coach speaks up after a silence. Piped lines come
a second apart, and `wait 20` lets twenty seconds pass, so that a transcript is the same each time.
A sitting has as many plays as the settings say, each a session of its own, with a rest between.
"""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from maestra.app import record_at
from maestra.boards.simulated import SimulatedBoard
from maestra.cli.demo_words import Command, Unclear, Wish, Word, understand
from maestra.cli.drawing import label
from maestra.cli.loading import exercise_in
from maestra.cli.outputs import Drawn, Said, Tone
from maestra.cli.own_language import own_language
from maestra.cli.screen import Screen
from maestra.cli.streams import named, read_whole, write_file
from maestra.coaching.chance import Chance
from maestra.coaching.events import (
    Begun,
    DoneSaid,
    EndOrdered,
    Event,
    HelpAsked,
    Skipped,
    TimePassed,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import (
    Entry,
    EventStore,
    NewEntry,
    PatientId,
    Robot,
    SessionId,
    Store,
)
from maestra.coaching.remembered import Remembered, read_remembered
from maestra.coaching.running import Running
from maestra.coaching.session import due
from maestra.coaching.settings import Modality, Profile, settings_for
from maestra.coaching.sitting import Chosen, known_patient, rise, sit_down
from maestra.core.board import Cell, Column
from maestra.core.state import State
from maestra.core.tokens import Deck, TokenId
from maestra.language import Language, read_words
from maestra.language.terminal import TerminalKey, terminal_sentence
from maestra.robots.screen import ScreenRobot
from maestra.robots.speech import SpeechRobot
from maestra.rules.exercise import Exercise
from maestra.rules.exercise_format import encode_exercise

PIPED_MS: Final = 1_000
"""Between two piped lines."""
_WAIT: Final = re.compile(r"wait (\d{1,5})")


@dataclass(frozen=True, slots=True)
class Wanted:
    """What was asked for on the command line."""

    exercise: str
    patient: str
    settings: str | None
    language: str | None
    seed: int | None
    record: str | None
    data: str | None
    keys: str | None
    speak: bool
    words: str | None = None


class Tee:
    """An event store that also collects the lines of a session's file."""

    def __init__(self, store: EventStore) -> None:
        self._store = store
        self.lines: list[str] = []

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        """Keep them, then remember their lines."""
        kept = self._store.append(entries)
        self.lines += [entry.payload for entry in kept if entry.kind != "commands"]
        return kept

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        """What has been kept."""
        return self._store.entries(session)


def play(wanted: Wanted) -> bool:
    """Play one sitting, and keep it; whether all plays of it were completed.

    Raises:
        FormatError: a file holds something else.
        InvalidError: the exercise cannot be played on its board.
        OSError: a file cannot be read, or a session cannot be kept.
    """
    return accompany(exercise_in(wanted.exercise), wanted)


def accompany(exercise: Exercise, wanted: Wanted) -> bool:
    """The same with an exercise that need not be in a file; `wanted` names it.

    Raises:
        FormatError: a file holds something else.
        InvalidError: the exercise cannot be played on its board.
        OSError: a file cannot be read, or a session cannot be kept.
    """
    store = record_at(wanted.data, wanted.keys)
    try:
        return _sitting(exercise, wanted, store)
    finally:
        store.close()


def _sitting(exercise: Exercise, wanted: Wanted, store: Store) -> bool:
    """Play after play until all are done, one is not completed, or the patient has enough."""
    seed = time.time_ns() % 2**64 if wanted.seed is None else wanted.seed
    session = _Session(wanted, exercise, store, seed)
    for number in range(2, session.rounds + 1):
        if not session.play():
            return False
        if not session.rest(number - 1):
            return True
        own = Chance(seed).split(number).state
        session = _Session(_next(wanted, number), exercise, store, own)
    return session.play()


def _next(wanted: Wanted, number: int) -> Wanted:
    """What is wanted of a later play: the settings are the patient's by now."""
    record = None
    if wanted.record is not None:
        path = Path(wanted.record)
        record = str(path.with_name(f"{path.stem}-{number}{path.suffix}"))
    return replace(wanted, settings=None, language=None, record=record)


class _Session:
    """One session at the terminal."""

    def __init__(self, wanted: Wanted, exercise: Exercise, store: Store, seed: int) -> None:
        self._wanted, self._store = wanted, store
        self._patient = PatientId(wanted.patient)
        name = Path(wanted.exercise).stem or "exercise"
        version = store.save_exercise(name, encode_exercise(exercise))
        identity = SessionId(f"{wanted.patient}-{seed:016x}-{time.time_ns():x}")
        sitting = sit_down(
            identity,
            self._patient,
            Chosen(name, version, exercise, _words(wanted.words)),
            self._known(),
            seed=seed,
            utc=_utc(),
        )
        sitting.keep(store)
        self._start, self._stored = sitting.start, sitting.stored
        self._board = SimulatedBoard(self._start.state)
        self._screen = Screen(terminal_sentence(TerminalKey.GOAL, self._start.settings.language))
        self._record = Tee(store.events)
        self._running = Running(
            identity, self._start, self._board, self._robots(), self._record, _utc()
        )

    @property
    def rounds(self) -> int:
        """How many plays the sitting has."""
        return self._start.settings.rounds

    def rest(self, number: int) -> bool:
        """After play `number`: rest until Enter is typed; whether the patient goes on."""
        language = self._start.settings.language
        leave = terminal_sentence(TerminalKey.TYPE_QUIT, language)
        self._say(TerminalKey.REST, number=number, count=self.rounds, quit=leave)
        line = next(self._screen.lines(), None)
        return line is not None and understand(line, language) != Command(Word.QUIT)

    def play(self) -> bool:
        """Lead the session to its end or the end of what is typed."""
        lines = at_terminal if sys.stdin.isatty() else _piped
        self._running.feed(Begun(), Milliseconds(0), _utc())
        self._draw()
        for line, now in lines(self._screen, self._running):
            moved = self._answer(line, Milliseconds(now))
            if moved and not self._running.has_ended:
                self._draw()
            if self._running.has_ended:
                break
        if not self._running.has_ended:
            self._running.feed(EndOrdered(), self._running.session.now, _utc())
        return self._finish()

    def _answer(self, line: str | None, now: Milliseconds) -> bool:
        """Do what was typed; whether the board may look different."""
        if line is None:
            return bool(self._running.poll(now, _utc()))
        if _WAIT.fullmatch(line.strip()) is not None:
            self._running.feed(TimePassed(), now, _utc())
            return False
        event = self._meant(line)
        if event is not None:
            self._running.feed(event, now, _utc())
        told = self._board.events()
        for each in told:
            self._running.feed(each, now, _utc())
        return bool(told)

    def _meant(self, line: str) -> Event | None:
        """The event that a line stands for; moves are made on the board, which tells of them."""
        language = self._start.settings.language
        match understand(line, language):
            case Command(Word.HINT):
                return HelpAsked()
            case Command(Word.DONE):
                return DoneSaid()
            case Command(Word.SHOW):
                return Skipped()
            case Command(Word.QUIT):
                return EndOrdered()
            case Command(Word.UNDO):
                self._put_back()
            case Wish(token, column):
                self._move(token, column)
            case Command() | Unclear():
                self._help()
        return None

    def _move(self, typed: str, column: int | None) -> None:
        board = self._start.state.board
        token = _token(self._start.deck, typed)
        taken = set(self._board.cells.values())
        free = [cell for cell in board.goal_cells if cell not in taken]
        if token is None:
            self._say(TerminalKey.UNKNOWN_TOKEN, token=typed)
        elif column is None and not free:
            self._say(TerminalKey.ROW_IS_FULL)
        elif column is not None and not 1 <= column <= board.columns:
            self._say(TerminalKey.NO_SUCH_COLUMN, last=board.columns)
        else:
            cell = free[0] if column is None else Cell(board.goal_row, Column(column))
            if cell in taken and self._board.cells[token] != cell:
                self._say(TerminalKey.TAKEN, column=cell.column)
            else:
                self._board.move(token, cell)

    def _put_back(self) -> None:
        """Put back everything that lies wrong."""
        session = self._running.session
        for token in session.table.astray(session.position.now):
            self._board.move(token, session.position.now.cells[token])

    def _help(self) -> None:
        language = self._start.settings.language
        words = {
            "token": label(self._start.deck.tokens[0]),
            "hint": terminal_sentence(TerminalKey.TYPE_HINT, language),
            "undo": terminal_sentence(TerminalKey.TYPE_UNDO, language),
            "done": terminal_sentence(TerminalKey.TYPE_DONE, language),
            "show": terminal_sentence(TerminalKey.TYPE_SHOW, language),
            "quit": terminal_sentence(TerminalKey.TYPE_QUIT, language),
        }
        self._say(TerminalKey.HELP_SESSION, **words)

    def _say(self, key: TerminalKey, **parts: object) -> None:
        text = terminal_sentence(key, self._start.settings.language, **parts)
        self._screen.show((Said(text, Tone.ASIDE),))

    def _draw(self) -> None:
        state = State(self._start.state.board, self._board.cells)
        self._screen.show((Drawn(state, self._start.deck),))

    def _robots(self) -> list[Robot]:
        settings = self._start.settings
        robots: list[Robot] = [
            ScreenRobot(lambda text: self._screen.show((Said(text),)), self._board.move)
        ]
        if self._wanted.speak and Modality.SPEECH in settings.modalities:
            robots.append(SpeechRobot(settings))
        return robots

    def _known(self) -> Remembered:
        """The settings that were named, else the patient's own, else the defaults."""
        wanted = self._wanted
        try:
            known = known_patient(self._store, self._patient)
        except KeyError:
            known = Remembered(settings_for(Profile(), own_language()))
        if wanted.settings is not None:
            named_ones = read_remembered(read_whole(wanted.settings), named(wanted.settings))
            known = replace(named_ones, policy=named_ones.policy or known.policy)
        if wanted.language is not None:
            settings = replace(known.settings, language=Language(wanted.language))
            known = replace(known, settings=settings)
        return known

    def _finish(self) -> bool:
        """Keep what was learned of the patient, and the session's file."""
        session = self._running.session
        rise(self._store, self._stored, session, _utc())
        if self._wanted.record is not None:
            write_file(self._wanted.record, "".join(f"{one}\n" for one in self._record.lines))
        return session.ending is not None and session.ending.value == "complete"


def _words(path: str | None) -> str | None:
    """The text of a caregiver's file of words.

    Raises:
        FormatError: it holds something else.
        OSError: it cannot be read.
    """
    if path is None:
        return None
    content = read_whole(path)
    read_words(content, named(path))
    return content.decode()


def _token(deck: Deck, typed: str) -> TokenId | None:
    """The token that is labelled as it was typed; other tokens may have been dealt for its id."""
    return next((one.id for one in deck.tokens if label(one).casefold() == typed), None)


def _piped(screen: Screen, _running: Running) -> Iterator[tuple[str | None, int]]:
    """Each line with its time: a second later than the one before, or as long as is waited."""
    now = 0
    for line in screen.lines():
        waited = _WAIT.fullmatch(line.strip())
        now += 1_000 * int(waited[1]) if waited else PIPED_MS
        yield line, now


def at_terminal(screen: Screen, running: Running) -> Iterator[tuple[str | None, int]]:
    """Each line as it is typed; None whenever something is due."""
    begun = time.monotonic()

    def now() -> int:
        return round(1_000 * (time.monotonic() - begun))

    while True:
        at = due(running.session)
        patience_s = None if at is None else max(at - now(), 0) / 1_000
        try:
            line = screen.line_within(patience_s)
        except EOFError:
            return
        yield line, now()


def _utc() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")
