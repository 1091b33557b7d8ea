"""What people ask of a session besides moving: to begin, help, pause, skip, judge, end."""

from __future__ import annotations

from dataclasses import replace

from maestra.coaching import helping, moving, putting_back
from maestra.coaching.assistance import ThisMove
from maestra.coaching.commands import Expression, GestureName, Matter, MoveToken, View
from maestra.coaching.events import Event
from maestra.coaching.notes import Note
from maestra.coaching.session import AskedMove, Ending, Judged, Phase, Step
from maestra.coaching.situation import Outcome
from maestra.coaching.turn import Turn
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.phrases import Phrase, Place


def begin(turn: Turn) -> None:
    """Somebody sits down: greet, show the rules, give the turn."""
    turn.change(phase=Phase.PLAYING)
    turn.note(Note.BEGUN)
    turn.express(Expression.HAPPY)
    turn.gesture(GestureName.GREET)
    turn.say(CoachKey.WELCOME)
    turn.show(View.RULES, lines=turn.game.referee.rules)
    moving.settle(turn)


def help_asked(turn: Turn, event: Event) -> None:
    """The patient asks for help."""
    if not turn.is_played:
        _not_now(turn, event)
    elif turn.session.waiting is not None:
        putting_back.remind(turn)
    else:
        helping.more(turn)


def hint_ordered(turn: Turn, event: Event, level: int) -> None:
    """The caregiver has the robot help at a level, within the settings' limits."""
    if not turn.is_played or turn.session.waiting is not None:
        _not_now(turn, event)
    else:
        helping.give(turn, turn.game.limits.clamp(level), helping.ORDERED)


def done_said(turn: Turn, event: Event) -> None:
    """The patient says that this is all."""
    if not turn.is_played:
        _not_now(turn, event)
    elif turn.astray:
        putting_back.remind(turn)
    elif turn.game.referee.may_end(turn.session.position):
        moving.finish(turn, Ending.COMPLETE)
    else:
        turn.say(CoachKey.NOT_YET)
        helping.more(turn)


def pause(turn: Turn, event: Event) -> None:
    """Halt: moves are seen, but not judged."""
    if turn.session.phase is Phase.PAUSED:
        _not_now(turn, event)
        return
    turn.change(phase=Phase.PAUSED, waiting=None, prompt_at=None)
    turn.note(Note.PAUSED)
    turn.say(CoachKey.PAUSED)
    turn.show(View.PAUSED)


def resume(turn: Turn, event: Event) -> None:
    """Go on from what lies on the board; what was moved meanwhile is put back."""
    if turn.session.phase is not Phase.PAUSED:
        _not_now(turn, event)
        return
    turn.change(phase=Phase.PLAYING)
    turn.note(Note.RESUMED)
    turn.say(CoachKey.RESUMED)
    turn.show(View.YOUR_TURN)
    if turn.is_played:
        moving.settle(turn)


def skip(turn: Turn, event: Event) -> None:
    """Spare the patient this move: the robot or the caregiver makes it."""
    if not turn.is_played:
        _not_now(turn, event)
        return
    if turn.astray:
        putting_back.ask_caregiver(turn)
        return
    found = helping.hint_now(turn, helping.SHOWN_LEVEL)
    if isinstance(found, ThisMove):
        _have_moved(turn, found)
    else:
        helping.no_way_on(turn)


def stop(turn: Turn) -> None:
    """The caregiver ends the session."""
    moving.finish(turn, Ending.STOPPED)


def override(turn: Turn, event: Event, *, allowed: bool) -> None:
    """The caregiver judges the last move otherwise."""
    judged = turn.session.judged
    if not turn.is_played or judged is None or judged.allowed is allowed:
        _not_now(turn, event)
    elif allowed:
        _grant(turn, event, judged)
    else:
        _veto(turn, event, judged)


def robot_failed(turn: Turn, number: int, why: str) -> None:
    """A robot that cannot move a token is not asked to again in this session."""
    turn.note(Note.ROBOT_FAILED, command=number, why=why)
    waiting, asked = turn.session.waiting, turn.session.asked_move
    turn.change(robot_able=False)
    if waiting is not None and waiting.number == number:
        turn.say(CoachKey.I_CANNOT)
        putting_back.ask_next(turn)
    elif asked is not None and asked.number == number:
        turn.change(asked_move=None)
        turn.say(CoachKey.I_CANNOT)
        if turn.is_played and turn.session.waiting is None:
            if asked.skips:
                _have_moved(turn, ThisMove(asked.move, offered=True))
            else:
                level = turn.game.limits.clamp(helping.SHOWN_LEVEL)
                helping.give(turn, level, helping.POLICY)


def time_passed(turn: Turn) -> None:
    """Nothing happened: someone else is asked to put back, or the patient is prompted."""
    session = turn.session
    if not turn.is_played:
        return
    waiting = session.waiting
    if waiting is not None:
        if session.now >= waiting.until:
            putting_back.ask_next(turn)
    elif session.prompt_at is not None and session.now >= session.prompt_at:
        helping.silence(turn)


def _not_now(turn: Turn, event: Event) -> None:
    """It means nothing here: note it, and show where we are."""
    turn.unexpected(event)
    session = turn.session
    if session.phase is Phase.PAUSED:
        turn.show(View.PAUSED)
    elif not session.connected:
        turn.show(View.NO_BOARD)
    else:
        turn.show(View.PUT_BACK if turn.astray else View.YOUR_TURN, turn.astray)


def _have_moved(turn: Turn, found: ThisMove) -> None:
    """Have a move made in the patient's place."""
    move = found.move
    parts: dict[str, Phrase] = {"token": turn.named(move.token), "place": Place(move.destination)}
    turn.note(Note.SKIPPED, token=move.token)
    if turn.game.settings.robot_moves and turn.session.robot_able:
        number = turn.number()
        turn.say(CoachKey.I_PLACE, **parts)
        turn.command(MoveToken(number, move.token, move.origin, move.destination))
    else:
        turn.say(CoachKey.LET_US_GO_ON)
        number = turn.ask(Matter.PLACE, AskKey.PLACE, (), **parts)
    turn.change(asked_move=AskedMove(move, number, skips=True))


def _grant(turn: Turn, event: Event, judged: Judged) -> None:
    """A refused move counts, if its token still lies where it was refused."""
    session, move = turn.session, judged.move
    now = session.position.now
    lies_there = session.table.cells.get(move.token) == move.destination
    if not lies_there or now.cells[move.token] != move.origin or move.destination in now.tokens:
        _not_now(turn, event)
        return
    turn.note(Note.OVERRIDDEN, token=move.token, allowed=True)
    tally = session.tally
    turn.change(tally=replace(tally, errors=tally.errors - 1))
    moving.accept(turn, move, moving.GRANTED)


def _veto(turn: Turn, event: Event, judged: Judged) -> None:
    """The last right move does not count, and is put back."""
    session, move = turn.session, judged.move
    if session.position.moves[-1:] != (move,):
        _not_now(turn, event)
        return
    turn.note(Note.OVERRIDDEN, token=move.token, allowed=False)
    tally = session.tally
    turn.change(
        position=session.position.without_last(),
        step=Step(
            attempt=2,
            last=Outcome.WRONG,
            wrong=1,
            vetoed=frozenset({move}),
        ),
        consulted=False,
        judged=replace(judged, allowed=False),
        tally=replace(
            tally,
            moves=tally.moves - judged.own,
            first_time=tally.first_time - judged.first,
            errors=tally.errors + 1,
        ),
    )
    turn.say(CoachKey.REFUSED_BY_CAREGIVER)
    moving.settle(turn)
