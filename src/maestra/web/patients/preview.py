"""What the robot will say with these settings: the coach itself, led through a short session.

Nothing is made up for the preview, so it cannot differ from what the patient will hear. One
exercise, one seed; another seed gives other ways to say the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final

from maestra.coaching.chance import Chance
from maestra.coaching.commands import (
    AskCaregiver,
    Commands,
    Gesture,
    LookAt,
    MoveToken,
    PointAt,
    Say,
)
from maestra.coaching.events import (
    Begun,
    EndOrdered,
    Event,
    HintOrdered,
    Paused,
    TimePassed,
    TokenLifted,
    TokenPlaced,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.playing import step
from maestra.coaching.policies import policy_for
from maestra.coaching.recording import Start
from maestra.coaching.referee import Refused
from maestra.coaching.session import Phase, Session, due
from maestra.coaching.settings import Settings
from maestra.coaching.sitting import laid_out
from maestra.core.board import Cell
from maestra.core.state import Move
from maestra.core.tokens import TokenId
from maestra.rules.exercise import Exercise

A_MOMENT: Final = Milliseconds(1_000)
"""Between two events of the rehearsal."""
MOST_MOVES: Final = 40
"""Of a play that is led to its end: more than a board has goal cells."""


class Moment(Enum):
    """When something is said."""

    GREETING = "greeting"
    PRAISE = "praise"
    PROMPT = "prompt"
    SILENCE = "silence"
    REFUSAL = "refusal"
    CORRECTED = "corrected"
    PAUSE = "pause"
    COMPLETE = "complete"
    GOODBYE = "goodbye"


@dataclass(frozen=True, slots=True)
class Line:
    """What the robot does at one moment."""

    moment: Moment
    level: int | None
    """Of a prompt."""
    said: tuple[str, ...]
    """Nothing where neither speech nor text is wanted."""
    asked: tuple[str, ...] = ()
    """What the caregiver is asked for then."""
    points: bool = False
    looks: bool = False
    gestures: bool = False
    moves: bool = False
    """Whether the robot moves a token."""


def rehearse(exercise: Exercise, settings: Settings, seed: int) -> tuple[Line, ...]:
    """Everything the robot says in a session: greeting, help at each level allowed, praise, end.

    Args:
        exercise: an example to speak about.
        settings: of the patient, in whose language it is.
        seed: decides the tokens, and which of several ways to say a thing is taken.

    Raises:
        InvalidError: the exercise cannot be played on its board.
    """
    deck, state = laid_out(exercise, settings, Chance(seed))
    ready = Start(exercise, deck, state, settings, seed, policy_for(settings)).session()
    rehearsal = _Rehearsal()
    begun = rehearsal.hear(Moment.GREETING, ready, Begun())
    moved = _after_a_right_move(rehearsal, begun)
    for level in range(settings.least_level, settings.most_level + 1):
        rehearsal.hear(Moment.PROMPT, moved, HintOrdered(level), level)
    rehearsal.wait(moved)
    _be_wrong(rehearsal, moved)
    rehearsal.hear(Moment.PAUSE, moved, Paused())
    _complete(rehearsal, moved)
    rehearsal.hear(Moment.GOODBYE, moved, EndOrdered())
    return tuple(rehearsal.lines)


class _Rehearsal:
    """What has been heard so far."""

    def __init__(self) -> None:
        self.lines: list[Line] = []

    def hear(
        self, moment: Moment, session: Session, event: Event, level: int | None = None
    ) -> Session:
        """Let `event` happen a moment later, and keep what the robot does then."""
        after, commands = step(session, event, Milliseconds(session.now + A_MOMENT))
        self.keep(moment, commands, level)
        return after

    def wait(self, session: Session) -> None:
        """Let nothing happen for as long as the patience lasts."""
        at = due(session)
        if at is not None:
            self.keep(Moment.SILENCE, step(session, TimePassed(), at)[1])

    def keep(self, moment: Moment, commands: Commands, level: int | None = None) -> None:
        """Keep what these commands come to."""
        line = Line(
            moment,
            level,
            tuple(one.text for one in commands if isinstance(one, Say)),
            tuple(one.text for one in commands if isinstance(one, AskCaregiver)),
            points=any(isinstance(one, PointAt) and one.cells for one in commands),
            looks=any(isinstance(one, LookAt) and one.cells for one in commands),
            gestures=any(isinstance(one, Gesture) for one in commands),
            moves=any(isinstance(one, MoveToken) for one in commands),
        )
        self.lines.append(line)


def _after_a_right_move(rehearsal: _Rehearsal, session: Session) -> Session:
    """The session after the first move that is right; as it was where none is."""
    right = session.game.referee.right_moves(session.position)
    if not right or session.phase is not Phase.PLAYING:
        return session
    after, commands = _moved(session, right[0].token, right[0].destination)
    # A play of one move is over with it; then the rest is heard as before the move.
    if after.phase is Phase.ENDED:
        return session
    rehearsal.keep(Moment.PRAISE, commands)
    return after


def _be_wrong(rehearsal: _Rehearsal, session: Session) -> None:
    """A move that is refused, and the same token put back."""
    wrong = _wrong_move(session)
    if wrong is None:
        return
    after, commands = _moved(session, wrong.token, wrong.destination)
    rehearsal.keep(Moment.REFUSAL, commands)
    _, commands = _moved(after, wrong.token, wrong.origin)
    rehearsal.keep(Moment.CORRECTED, commands)


def _wrong_move(session: Session) -> Move | None:
    """Some token put into the goal row against a rule; else one that leads into a dead end."""
    now, referee = session.position.now, session.game.referee
    free = [cell for cell in now.board.goal_cells if cell not in now.tokens]
    dead_end: Move | None = None
    for token, origin in now.cells.items():
        for cell in free if origin.row != now.board.goal_row else ():
            move = Move(token, origin, cell)
            ruling = referee.judge(session.position, move)
            if isinstance(ruling, Refused):
                if ruling.broken:
                    return move
                dead_end = dead_end or move
    return dead_end


def _complete(rehearsal: _Rehearsal, session: Session) -> None:
    """Play on until the exercise is complete."""
    for _ in range(MOST_MOVES):
        right = session.game.referee.right_moves(session.position)
        if not right:
            return
        session, commands = _moved(session, right[0].token, right[0].destination)
        if session.phase is Phase.ENDED:
            rehearsal.keep(Moment.COMPLETE, commands)
            return


def _moved(session: Session, token: TokenId, cell: Cell) -> tuple[Session, Commands]:
    """The session once a token was lifted and placed, and what was done at the placing."""
    lifted, _ = step(session, TokenLifted(token), Milliseconds(session.now + A_MOMENT))
    return step(lifted, TokenPlaced(token, cell), Milliseconds(lifted.now + A_MOMENT))
