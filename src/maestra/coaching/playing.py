"""A patient's session as a state machine: event in, commands out.

Whatever happens in whatever state is answered and recorded. What lies on the board is compared
with what should lie there (`Table.astray`): a token that is placed elsewhere is a move and is
judged; one that was refused is astray until it lies where it was taken from, or is moved on to
where it is right. Somebody is always asked to put back what is astray: the helper that the
settings name, and when nothing comes of it in time, the next one, round and round.
"""

from __future__ import annotations

from typing import assert_never

from maestra.coaching import caregiving, moving
from maestra.coaching.commands import Commands, Matter, View
from maestra.coaching.events import (
    Answered,
    Begun,
    BoardBack,
    BoardLost,
    DoneSaid,
    EndOrdered,
    Event,
    HelpAsked,
    HintOrdered,
    Paused,
    Resumed,
    RobotDone,
    RobotFailed,
    SeveralTokens,
    Skipped,
    TimePassed,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    VerdictOverridden,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.session import Phase, Session
from maestra.coaching.turn import Turn
from maestra.rules.answers import Reply


def step(session: Session, event: Event, now: Milliseconds) -> tuple[Session, Commands]:
    """The session after `event`, and what the robot, the screen and the record do now.

    Args:
        session: the session before it.
        event: what happened; any event may come at any time.
        now: since the session began; earlier than the event before counts as the same time.
    """
    turn = Turn(session, now)
    if session.phase is Phase.ENDED:
        turn.unexpected(event)
        turn.show(View.ENDED)
    else:
        begins = session.phase is Phase.READY
        if begins:
            caregiving.begin(turn)
        if not (begins and isinstance(event, Begun)):
            _answer(turn, event)
    if not turn.commands and not isinstance(event, TimePassed):
        turn.note(Note.HEARD, event=event.event)
    return turn.session, turn.commands


def _answer(turn: Turn, event: Event) -> None:  # noqa: C901, PLR0912 - one case for each event
    match event:
        case Begun():
            turn.unexpected(event)
        case TokenLifted() | TokenPlaced() | TokenPutBack() | SeveralTokens():
            moving.told(turn, event)
        case BoardLost():
            moving.lose_board(turn)
        case BoardBack(cells):
            moving.find_board(turn, cells)
        case HelpAsked():
            caregiving.help_asked(turn, event)
        case DoneSaid():
            caregiving.done_said(turn, event)
        case Paused():
            caregiving.pause(turn, event)
        case Resumed():
            caregiving.resume(turn, event)
        case Skipped():
            caregiving.skip(turn, event)
        case HintOrdered(level):
            caregiving.hint_ordered(turn, event, level)
        case EndOrdered():
            caregiving.stop(turn)
        case VerdictOverridden(allowed):
            caregiving.override(turn, event, allowed=allowed)
        case Answered(question, reply):
            _caregiver_answered(turn, event, question, reply)
        case TimePassed():
            caregiving.time_passed(turn)
        case RobotDone(number):
            turn.note(Note.ROBOT_DONE, command=number)
        case RobotFailed(number, why):
            caregiving.robot_failed(turn, number, why)
        case _:
            assert_never(event)


def _caregiver_answered(turn: Turn, event: Event, question: int, reply: Reply) -> None:
    """Whether to pause is the one thing that a caregiver is asked to say yes or no to."""
    turn.note(Note.ANSWERED, question=question, reply=reply.value)
    if turn.session.question == (question, Matter.LONG_SILENCE) and reply is Reply.YES:
        caregiving.pause(turn, event)
