"""What a patient's session is at one moment: everything that `playing.step` decides by."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Final

from maestra.coaching.chance import Chance
from maestra.coaching.commands import Matter
from maestra.coaching.fields import Milliseconds
from maestra.coaching.policies import Policy, policy_for, rested
from maestra.coaching.referee import Referee
from maestra.coaching.settings import Helper, Persona, Settings
from maestra.coaching.situation import Limits, Outcome
from maestra.coaching.table import Table
from maestra.coaching.voice import Voice
from maestra.core.state import Move, State
from maestra.rules.position import Position

BEGINNING: Final = Milliseconds(0)


class Phase(Enum):
    """How far a session is."""

    READY = "ready"
    """Nobody has sat down yet."""
    PLAYING = "playing"
    PAUSED = "paused"
    ENDED = "ended"


class Ending(Enum):
    """How a session ended."""

    COMPLETE = "complete"
    """The exercise is finished."""
    STOPPED = "stopped"
    """The caregiver ended it."""


@dataclass(frozen=True)
class Game:
    """What stays the same through a session."""

    referee: Referee = field(compare=False)
    settings: Settings
    start: State
    seed: int
    """Decides everything that is left to chance."""

    @property
    def limits(self) -> Limits:
        """How much the caregiver lets the robot help."""
        settings = self.settings
        waits = settings.persona is Persona.HUMAN_CENTRED
        return Limits(settings.least_level, settings.most_level, waits)

    @property
    def length(self) -> int:
        """About how many moves a play has: as many as the goal row has free cells."""
        goal = self.start.board.goal_cells
        return max(1, sum(cell not in self.start.tokens for cell in goal))


@dataclass(frozen=True, slots=True)
class Step:
    """One move that the patient is to find."""

    attempt: int = 1
    """From 1; each wrong or unanswered attempt counts."""
    last: Outcome = Outcome.RIGHT
    level: int = 0
    """The last level that was helped with."""
    most: int = 0
    """The highest."""
    standing: int = 0
    """The last one above 0: level 0 after a silence lets stand what was said."""
    wrong: int = 0
    silent: int = 0
    vetoed: frozenset[Move] = frozenset()
    """Right moves that the caregiver has judged wrong."""


@dataclass(frozen=True, slots=True)
class Waiting:
    """Somebody was asked to put tokens back."""

    helper: Helper
    until: Milliseconds
    """Then the next one is asked."""
    number: int | None
    """Of the robot's command."""


@dataclass(frozen=True, slots=True)
class AskedMove:
    """A move that the robot or the caregiver was asked to make in the patient's place."""

    move: Move
    number: int
    """Of the command or the question."""
    skips: bool
    """Because the caregiver skipped the step."""


@dataclass(frozen=True, slots=True)
class Judged:
    """The last move that was judged."""

    move: Move
    allowed: bool
    own: bool
    """The patient's."""
    first: bool
    """Their first attempt at the step."""


@dataclass(frozen=True, slots=True)
class Tally:
    """What is counted through a session, for its record."""

    moves: int = 0
    """The patient's own right ones."""
    first_time: int = 0
    """Of these, right at the first attempt."""
    errors: int = 0
    silences: int = 0
    helps: int = 0
    """Hints above level 0."""
    levels: int = 0
    """The sum of their levels."""
    by_others: int = 0
    """Moves that the robot or the caregiver made."""


@dataclass(frozen=True, slots=True)
class Session:
    """A patient's session at one moment."""

    game: Game
    position: Position
    table: Table
    policy: Policy
    voice: Voice
    phase: Phase = Phase.READY
    connected: bool = True
    """Whether the board answers."""
    now: Milliseconds = BEGINNING
    step: Step = Step()
    consulted: bool = False
    """Whether the policy chose help for this attempt and waits for the outcome."""
    prompt_at: Milliseconds | None = None
    """When silence becomes a prompt."""
    waiting: Waiting | None = None
    asked_move: AskedMove | None = None
    judged: Judged | None = None
    question: tuple[int, Matter] | None = None
    """The last question to the caregiver."""
    numbers: int = 0
    """Commands numbered so far."""
    told_it_may_end: bool = False
    robot_able: bool = True
    """Whether the robot has not yet failed to move a token."""
    tally: Tally = Tally()
    ending: Ending | None = None


def new_session(game: Game, policy: Policy | None = None) -> Session:
    """A session that has not begun.

    Args:
        game: the exercise, the tokens as they lie, the settings, the seed.
        policy: one that knows the patient from earlier sessions; else the settings' own.
    """
    return Session(
        game,
        Position.begin(game.start),
        Table.of(game.start),
        policy_for(game.settings) if policy is None else rested(policy),
        Voice(Chance(game.seed)),
    )


def due(session: Session) -> Milliseconds | None:
    """When `TimePassed` will next change something; None if only an event can."""
    if session.phase is not Phase.PLAYING or not session.connected:
        return None
    return session.prompt_at if session.waiting is None else session.waiting.until
