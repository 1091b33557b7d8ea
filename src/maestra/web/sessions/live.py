"""A session under way as its caregiver sees it: what can be done now, and why things are so."""

from __future__ import annotations

from dataclasses import dataclass

from maestra.coaching.commands import AskCaregiver, Matter
from maestra.coaching.events import (
    Answered,
    Begun,
    EndOrdered,
    Event,
    HintOrdered,
    Paused,
    Resumed,
    Skipped,
    VerdictOverridden,
)
from maestra.coaching.session import Judged, Phase, Session
from maestra.core.state import Move
from maestra.rules.answers import Reply


@dataclass(frozen=True, slots=True)
class Overridable:
    """The last move that was judged, while it can still be judged otherwise."""

    move: Move
    was_allowed: bool


@dataclass(frozen=True, slots=True)
class Live:
    """What the page offers, worked out of the session as it is."""

    session: Session
    question: AskCaregiver | None

    @property
    def is_played(self) -> bool:
        """Whether moves are judged now."""
        return self.session.phase is Phase.PLAYING and self.session.connected

    @property
    def levels(self) -> range:
        """The levels of help that the settings allow."""
        limits = self.session.game.limits
        return range(limits.least, limits.most + 1)

    @property
    def can_hint(self) -> bool:
        """Whether the robot can help now: not while a token is being put back."""
        return self.is_played and self.session.waiting is None

    @property
    def can_skip(self) -> bool:
        """Whether the move that is being tried can be made in the patient's place."""
        return self.can_hint and self.session.asked_move is None

    @property
    def overridable(self) -> Overridable | None:
        """The last judged move, if the caregiver may still judge it otherwise."""
        judged = self.session.judged
        if not self.is_played or judged is None:
            return None
        fits = _still_last if judged.allowed else _still_lies
        return Overridable(judged.move, judged.allowed) if fits(self.session, judged) else None

    @property
    def wants_yes_or_no(self) -> bool:
        """Whether the question is one; the others are settled by doing what is asked."""
        return self.question is not None and self.question.matter is Matter.LONG_SILENCE


def wish(live: Live, wanted: str) -> Event | None:
    """The event that a button stands for; None if there is no such button."""
    name, _, detail = wanted.partition(":")
    match name:
        case "begin":
            return Begun()
        case "pause":
            return Paused()
        case "resume":
            return Resumed()
        case "skip":
            return Skipped()
        case "end":
            return EndOrdered()
        case "right" | "wrong":
            return VerdictOverridden(allowed=name == "right")
        case "hint" if detail in {str(level) for level in live.levels}:
            return HintOrdered(int(detail))
        case "yes" | "no" if detail.isascii() and detail.isdigit():
            return Answered(int(detail), Reply(name))
        case _:
            return None


def _still_last(session: Session, judged: Judged) -> bool:
    """A right move that nobody has built upon."""
    return session.position.moves[-1:] == (judged.move,)


def _still_lies(session: Session, judged: Judged) -> bool:
    """A refused token that lies where it was refused, its own cell and that one not in use."""
    move, now = judged.move, session.position.now
    lies_there = session.table.cells.get(move.token) == move.destination
    is_free = move.destination not in now.tokens
    return lies_there and is_free and now.cells[move.token] == move.origin
