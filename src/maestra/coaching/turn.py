"""One step of a session while it is worked out: the session so far and the commands so far.

Lives only as long as one call of `playing.step`, which is pure to whoever calls it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TypedDict, Unpack

from maestra.coaching.chance import Chance
from maestra.coaching.commands import (
    AskCaregiver,
    Command,
    Commands,
    Express,
    Expression,
    Gesture,
    GestureName,
    LookAt,
    Matter,
    PointAt,
    Record,
    Show,
    View,
)
from maestra.coaching.events import Event
from maestra.coaching.fields import Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.policies import Policy
from maestra.coaching.session import (
    AskedMove,
    Ending,
    Game,
    Judged,
    Phase,
    Session,
    Step,
    Tally,
    Waiting,
)
from maestra.coaching.settings import Modality
from maestra.coaching.table import Table
from maestra.coaching.voice import Voice
from maestra.core.board import Cell
from maestra.core.tokens import TokenId
from maestra.language.coach import question_to_caregiver
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.phrases import Joint, Listing, Named, Phrase
from maestra.rules.position import Position


class Changes(TypedDict, total=False):
    """What a step can change of a session."""

    position: Position
    table: Table
    policy: Policy
    voice: Voice
    phase: Phase
    connected: bool
    step: Step
    consulted: bool
    prompt_at: Milliseconds | None
    waiting: Waiting | None
    asked_move: AskedMove | None
    judged: Judged | None
    question: tuple[int, Matter] | None
    numbers: int
    told_it_may_end: bool
    robot_able: bool
    tally: Tally
    ending: Ending | None


class Turn:
    """The session and the commands so far."""

    def __init__(self, session: Session, now: Milliseconds) -> None:
        """Begin where `session` is; time never runs backwards."""
        self.session = replace(session, now=max(now, session.now))
        self._commands: list[Command] = []

    @property
    def commands(self) -> Commands:
        """What is to be done, in order."""
        return tuple(self._commands)

    @property
    def game(self) -> Game:
        """What stays the same."""
        return self.session.game

    @property
    def astray(self) -> tuple[TokenId, ...]:
        """The tokens that lie elsewhere than they should."""
        return self.session.table.astray(self.session.position.now)

    @property
    def is_played(self) -> bool:
        """Whether moves are judged now: not in a pause, nor while the board does not answer."""
        return self.session.phase is Phase.PLAYING and self.session.connected

    def change(self, **changes: Unpack[Changes]) -> None:
        """Let these be so from now on."""
        self.session = replace(self.session, **changes)

    def draw_with(self, chance: Chance) -> None:
        """The chance after something was drawn."""
        voice = self.session.voice
        self.change(voice=Voice(chance, voice.recent))

    def say(self, key: CoachKey, **parts: Phrase | str) -> None:
        """Say a phrase in a way that was not used lately, if words are a modality at all."""
        said, voice = self.session.voice.say(key, self.game.referee, **parts)
        self.change(voice=voice)
        if {Modality.SPEECH, Modality.TEXT} & set(self.game.settings.modalities):
            self._commands.append(said)

    def look(self, cells: Iterable[Cell]) -> None:
        """Look at cells, or at the person."""
        if self._gestures:
            self._commands.append(LookAt(tuple(cells)))

    def point(self, cells: Iterable[Cell]) -> None:
        """Point at cells; on the screen also where the robot makes no gestures."""
        self._commands.append(PointAt(tuple(cells)))

    def express(self, expression: Expression) -> None:
        """Show an expression."""
        self._commands.append(Express(expression))

    def gesture(self, gesture: GestureName) -> None:
        """Make a gesture, if gestures are a modality."""
        if self._gestures:
            self._commands.append(Gesture(gesture))

    def show(self, view: View, tokens: Iterable[TokenId] = (), lines: Iterable[str] = ()) -> None:
        """Show something on the screen."""
        self._commands.append(Show(view, tuple(tokens), tuple(lines)))

    def command(self, command: Command) -> None:
        """Any other command."""
        self._commands.append(command)

    def note(self, note: Note, **fields: int | bool | str | None) -> None:
        """Keep a note beside the events."""
        self._commands.append(Record(note.value, fields))

    def unexpected(self, event: Event) -> None:
        """Note that something happened that means nothing here."""
        self.note(Note.UNEXPECTED, event=event.event)

    def number(self) -> int:
        """A number for the next command that has one."""
        number = self.session.numbers + 1
        self.change(numbers=number)
        return number

    def ask(
        self, matter: Matter, key: AskKey, tokens: Iterable[TokenId] = (), **parts: Phrase
    ) -> int:
        """Ask the caregiver; returns the question's number."""
        named = tuple(tokens)
        filled: dict[str, Phrase | str] = dict(parts)
        if named:
            filled["tokens"] = self.listed(named, Joint.AND)
        referee = self.game.referee
        text = question_to_caregiver(key, referee.language, referee.speaker, filled)
        number = self.number()
        self.change(question=(number, matter))
        self._commands.append(AskCaregiver(number, matter, text, named))
        return number

    def named(self, token: TokenId) -> Named:
        """A token, as it is spoken of."""
        return Named(self.game.referee.deck.by_id[token].attributes)

    def listed(self, tokens: Iterable[TokenId], joint: Joint) -> Listing:
        """Several tokens, as they are spoken of."""
        return Listing(tuple(map(self.named, tokens)), joint)

    @property
    def _gestures(self) -> bool:
        return Modality.GESTURE in self.game.settings.modalities
