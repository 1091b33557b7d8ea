"""What a caregiver judged otherwise in a session, as evidence for the exercise's rules."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from maestra.coaching.commands import Commands, Record
from maestra.coaching.events import TimedEvent, VerdictOverridden
from maestra.coaching.notes import Note
from maestra.coaching.recording import Start, replay
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import Move
from maestra.core.tokens import Deck
from maestra.rules.answers import Answer, MoveQuestion, Reply
from maestra.rules.position import Position
from maestra.rules.setting import play_of


@dataclass(frozen=True, slots=True)
class Override:
    """A move whose verdict the caregiver changed."""

    deck: Deck
    position: Position
    """The play before it."""
    move: Move
    allowed: bool
    """What the caregiver said."""
    broken: tuple[str, ...]
    """The rules by which it had been refused, by their ids; none for a dead end."""

    @property
    def answer(self) -> Answer | None:
        """The same as an answer to a question; None where no question could be asked.

        Rules speak of placing tokens from storage on the goal row, and of nothing else.
        """
        start, move = self.position.start, self.move
        try:
            play = play_of(Demonstration(self.deck, start, self.position.moves))
            # As a move of a play of its own it shows whether rules can speak of it.
            play_of(Demonstration(self.deck, self.position.now, (move,)))
        except InvalidError:
            return None
        token = play.setting.number_of[move.token]
        question = MoveQuestion(play, token, move.destination.column - 1)
        return Answer(question, Reply.YES if self.allowed else Reply.NO)


def overrides(start: Start, events: Iterable[TimedEvent]) -> tuple[Override, ...]:
    """What was judged otherwise in a session, in its order; of the same move the last word.

    Args:
        start: what the session follows from.
        events: all that happened in it.

    Raises:
        InvalidError: the deck or the board does not fit the exercise.
    """
    found: dict[tuple[Position, Move], Override] = {}
    for one in _overrides(start, events):
        key = one.position, one.move
        found.pop(key, None)
        found[key] = one
    return tuple(found.values())


def _overrides(start: Start, events: Iterable[TimedEvent]) -> Iterator[Override]:
    timed = list(events)
    before = start.session()
    refused: tuple[str, ...] = ()
    for event, (after, commands) in zip(timed, replay(before, timed), strict=True):
        for note in (one for one in commands if isinstance(one, Record)):
            if note.note == Note.REFUSED.value:
                refused = tuple(one for one in str(note.fields["broken"]).split(",") if one)
        judged, said = before.judged, event.what
        if isinstance(said, VerdictOverridden) and judged and _was_changed(commands):
            position = before.position if said.allowed else before.position.without_last()
            broken = refused if said.allowed else ()
            yield Override(start.deck, position, judged.move, said.allowed, broken)
        before = after


def _was_changed(commands: Commands) -> bool:
    """Whether there was a verdict that could still be changed."""
    return any(isinstance(one, Record) and one.note == Note.OVERRIDDEN.value for one in commands)
