"""A whole session of a simulated patient, with a simulated robot and caregiver, in no time.

The clock is the session's own: it jumps to whatever happens next. Everything follows from the
game, the patient and the seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from maestra.coaching.chance import Chance
from maestra.coaching.commands import AskCaregiver, Command, Commands, Matter, MoveToken
from maestra.coaching.events import (
    Begun,
    EndOrdered,
    Event,
    RobotDone,
    TimedEvent,
    TimePassed,
    TokenLifted,
    TokenPlaced,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.patients import (
    Mind,
    Patient,
    attends,
    decide,
    has_had_enough,
    perceive,
    unanswered,
)
from maestra.coaching.playing import step
from maestra.coaching.policies import Policy
from maestra.coaching.session import Game, Phase, Session, due, new_session
from maestra.coaching.settings import Helper
from maestra.core.state import Move

ROBOT_MS: Final = 6_000
"""A robot's arm takes so long for a move: an assumption."""
CAREGIVER_MS: Final = 8_000
"""And a caregiver who is asked to, in the same room."""
MOST_EVENTS: Final = 5_000
"""Of one session; far more than any has."""


@dataclass(frozen=True, slots=True)
class Played:
    """What became of a session."""

    session: Session
    events: tuple[TimedEvent, ...]


class Simulation:
    """One session under way."""

    def __init__(
        self, game: Game, patient: Patient, seed: int, policy: Policy | None = None
    ) -> None:
        """Begin; `seed` is the patient's, the game has the coach's."""
        self._patient = patient
        self._chance = Chance(seed)
        self._mind = Mind()
        self._session = new_session(game, policy)
        self._events: list[TimedEvent] = []
        self._now = 0

    def play(self) -> Played:
        """Play to the end."""
        self._happen(Begun(), 0)
        while self._session.phase is not Phase.ENDED and len(self._events) < MOST_EVENTS:
            if has_had_enough(self._patient, self._mind, self._now):
                self._happen(EndOrdered(), 0)
            elif self._session.waiting is not None:
                self._put_back(self._session.waiting.helper)
            else:
                self._act()
        return Played(self._session, tuple(self._events))

    def _happen(self, event: Event, after_ms: int, tried: Move | None = None) -> Commands:
        self._now += after_ms
        at = Milliseconds(self._now)
        self._session, commands = step(self._session, event, at)
        self._events.append(TimedEvent(at, event))
        self._mind = perceive(self._mind, commands, tried)
        self._obey(commands)
        return commands

    def _obey(self, commands: Sequence[Command]) -> None:
        """The robot moves tokens at once; so does the caregiver in the patient's place."""
        for command in commands:
            match command:
                case MoveToken(number, token, origin, destination):
                    self._move(Move(token, origin, destination), ROBOT_MS)
                    self._happen(RobotDone(number), 0)
                case AskCaregiver(_, Matter.PUT_BACK):
                    self._caregiver_puts_back()
                case _:
                    pass

    def _move(self, move: Move, after_ms: int) -> None:
        self._happen(TokenLifted(move.token), after_ms // 2)
        self._happen(TokenPlaced(move.token, move.destination), after_ms - after_ms // 2, move)

    def _caregiver_puts_back(self) -> None:
        session = self._session
        for token in session.table.astray(session.position.now):
            home = session.position.now.cells[token]
            self._move(Move(token, session.table.cells[token], home), CAREGIVER_MS)

    def _put_back(self, helper: Helper) -> None:
        """The patient puts back what was asked for, or the time goes by."""
        session = self._session
        willing, self._chance = attends(self._patient, self._chance)
        if helper is Helper.PATIENT and willing:
            token = session.table.astray(session.position.now)[0]
            home = session.position.now.cells[token]
            self._move(Move(token, session.table.cells[token], home), self._patient.reaction_ms)
        else:
            self._wait()

    def _act(self) -> None:
        session = self._session
        deed, self._chance = decide(
            self._patient,
            self._mind,
            session.game.referee,
            session.position,
            self._chance,
        )
        prompt = due(session)
        ready = self._now + deed.after_ms
        if deed.move is None or (prompt is not None and ready > prompt):
            self._wait()
        else:
            self._move(deed.move, deed.after_ms)

    def _wait(self) -> None:
        """Nothing is done until the coach speaks again."""
        prompt = due(self._session)
        pause = 0 if prompt is None else max(prompt - self._now, 0)
        self._mind = unanswered(self._mind)
        self._happen(TimePassed(), pause)
