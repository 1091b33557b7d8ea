"""What a caregiver's lesson is at one moment: everything that `teaching.step` decides by."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from maestra.coaching.chance import Chance
from maestra.coaching.fields import Milliseconds
from maestra.coaching.session import BEGINNING
from maestra.coaching.table import Table
from maestra.coaching.teachers import Teacher
from maestra.coaching.voice import Voice
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.language import Language
from maestra.language.languages import speaker_for
from maestra.language.speaker import Speaker


class Stage(Enum):
    """How far a lesson is."""

    READY = "ready"
    SHOWING = "showing"
    """A play is being shown."""
    ASKING = "asking"
    """A question was asked about what is understood."""
    CLEARING = "clearing"
    """The row is to be cleared for the next play."""
    ENDED = "ended"


@dataclass(frozen=True)
class Lesson:
    """A caregiver's lesson at one moment."""

    deck: Deck
    language: Language
    teacher: Teacher = field(compare=False)
    start: State
    """How the play that is being shown began."""
    table: Table
    voice: Voice
    moves: tuple[Move, ...] = ()
    plays: tuple[Demonstration, ...] = ()
    """All that were shown and learned from."""
    stage: Stage = Stage.READY
    is_paused: bool = False
    is_connected: bool = True
    is_clear: bool = False
    """Whether what was shown and answered leaves no doubt."""
    unclear: bool = False
    """Whether recording waits until the board is as it was."""
    question: int | None = None
    numbers: int = 0
    now: Milliseconds = BEGINNING

    @property
    def speaker(self) -> Speaker:
        """Says things about the tokens."""
        return speaker_for(self.language, self.start.board, self.deck)

    @property
    def expected(self) -> State:
        """What lies where by the moves that count."""
        state = self.start
        for move in self.moves:
            state = state.after(move)
        return state

    @property
    def in_row(self) -> tuple[TokenId, ...]:
        """The tokens that lie in the goal row in truth."""
        goal_row = self.start.board.goal_row
        return tuple(token for token, cell in self.table.cells.items() if cell.row == goal_row)


def new_lesson(
    deck: Deck, start: State, teacher: Teacher, language: Language, seed: int
) -> Lesson:
    """A lesson that has not begun."""
    return Lesson(deck, language, teacher, start, Table.of(start), Voice(Chance(seed)))
