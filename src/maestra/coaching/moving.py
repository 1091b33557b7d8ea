"""What the board tells: tokens lifted, placed and returned, a board lost and back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final, assert_never

from maestra.coaching import helping, putting_back
from maestra.coaching.commands import Expression, GestureName, Matter, View
from maestra.coaching.events import SeveralTokens, TokenLifted, TokenPlaced, TokenPutBack
from maestra.coaching.notes import Note
from maestra.coaching.referee import Refused, Right
from maestra.coaching.session import Ending, Judged, Phase, Step
from maestra.coaching.situation import Outcome
from maestra.coaching.table import Table
from maestra.coaching.turn import Turn
from maestra.core.board import Cell
from maestra.core.state import IllegalMoveError, Move
from maestra.core.tokens import TokenId
from maestra.language.coach_keys import AskKey, CoachKey

OWN: Final = "patient"
OTHERS: Final = "helper"
GRANTED: Final = "caregiver"


def told(turn: Turn, event: TokenLifted | TokenPlaced | TokenPutBack | SeveralTokens) -> None:
    """A token was lifted, placed or returned, or several were lifted."""
    match event:
        case TokenLifted(token):
            if _is_known(turn, token):
                _lift(turn, token)
        case TokenPlaced(token, cell):
            if _is_known(turn, token) and _is_on_board(turn, cell):
                _place(turn, token, cell)
        case TokenPutBack(token):
            if _is_known(turn, token):
                table = turn.session.table
                origin = table.air.get(token, table.cells.get(token))
                _place(
                    turn,
                    token,
                    turn.session.position.now.cells[token] if origin is None else origin,
                )
        case SeveralTokens(tokens):
            known = [token for token in tokens if _is_known(turn, token)]
            for token in known:
                if token in turn.session.table.cells:
                    turn.change(table=turn.session.table.lifted(token))
            _one_at_a_time(turn)
        case _:
            assert_never(event)


def settle(turn: Turn) -> None:
    """Go on from what lies on the board: put back, finish, or help with the next move."""
    if turn.astray:
        putting_back.request(turn)
        return
    turn.change(waiting=None)
    referee, position = turn.game.referee, turn.session.position
    may_end = referee.may_end(position)
    open_moves = set(referee.right_moves(position)) - turn.session.step.vetoed
    if may_end and not open_moves:
        finish(turn, Ending.COMPLETE)
        return
    if may_end and not turn.session.told_it_may_end:
        turn.change(told_it_may_end=True)
        turn.say(CoachKey.MAY_STOP)
    helping.consult(turn)


def accept(turn: Turn, move: Move, by: str) -> None:
    """A right move: note it, praise, go on."""
    session = turn.session
    step, own = session.step, by == OWN
    made = len(session.position.moves)
    if own:
        helping.learn_from(turn, Outcome.RIGHT)
    turn.note(Note.MOVE, **_fields(move, made + 1, step), by=by)
    tally = session.tally
    first = own and step.wrong == 0
    turn.change(
        position=session.position.after(move),
        step=Step(),
        consulted=False,
        asked_move=None,
        question=None,
        judged=Judged(move, allowed=True, own=own, first=first),
        tally=replace(
            tally,
            moves=tally.moves + own,
            first_time=tally.first_time + first,
            by_others=tally.by_others + (not own),
        ),
    )
    _praise(turn, by, corrected=step.wrong > 0)
    settle(turn)


def finish(turn: Turn, ending: Ending) -> None:
    """The session is over."""
    session = turn.session
    complete = ending is Ending.COMPLETE
    turn.change(phase=Phase.ENDED, ending=ending, waiting=None, prompt_at=None, asked_move=None)
    turn.say(CoachKey.COMPLETE if complete else CoachKey.GOODBYE)
    turn.express(Expression.HAPPY)
    turn.gesture(GestureName.CHEER if complete else GestureName.GREET)
    turn.show(View.ENDED)
    if turn.astray:
        turn.ask(Matter.PUT_BACK, AskKey.PUT_BACK, turn.astray)
    tally = session.tally
    turn.note(
        Note.ENDED,
        ending=ending.value,
        moves=tally.moves,
        first_time=tally.first_time,
        errors=tally.errors,
        silences=tally.silences,
        helps=tally.helps,
        levels=tally.levels,
        by_others=tally.by_others,
        ms=session.now,
    )


def lose_board(turn: Turn) -> None:
    """The board does not answer: nothing is judged until it does."""
    turn.change(connected=False, waiting=None)
    turn.say(CoachKey.BOARD_LOST)
    turn.show(View.NO_BOARD)
    turn.note(Note.BOARD_LOST)


def find_board(turn: Turn, cells: Mapping[TokenId, Cell]) -> None:
    """The board says what lies where; no move is made up for what happened unseen."""
    session = turn.session
    board, expected = session.position.now.board, session.position.now
    lying = {token: cell for token, cell in cells.items() if cell in board}
    strangers = [token for token in lying if token not in expected.cells]
    was_lost = not session.connected
    turn.change(connected=True, table=Table.seen(lying, expected), waiting=None)
    if was_lost:
        turn.say(CoachKey.BOARD_BACK)
    turn.note(Note.BOARD_BACK, astray=len(turn.astray), missing=len(turn.session.table.air))
    if strangers or len(lying) < len(cells):
        turn.ask(Matter.CHECK_BOARD, AskKey.CHECK_BOARD)
    if turn.is_played:
        settle(turn)


def _is_known(turn: Turn, token: TokenId) -> bool:
    if token in turn.session.position.now.cells:
        return True
    turn.note(Note.UNKNOWN_TOKEN, token=token)
    turn.say(CoachKey.UNKNOWN_TOKEN)
    return False


def _is_on_board(turn: Turn, cell: Cell) -> bool:
    if cell in turn.session.position.now.board:
        return True
    turn.note(Note.UNEXPECTED, event="placed")
    turn.ask(Matter.CHECK_BOARD, AskKey.CHECK_BOARD)
    return False


def _lift(turn: Turn, token: TokenId) -> None:
    table = turn.session.table
    if token in table.air:
        turn.note(Note.UNEXPECTED, event="lifted")
        return
    turn.change(table=table.lifted(token))
    turn.look((table.cells[token],))
    if len(turn.session.table.air) > 1:
        _one_at_a_time(turn)
    helping.stir(turn)


def _one_at_a_time(turn: Turn) -> None:
    air = tuple(turn.session.table.air)
    turn.note(Note.UNCLEAR, token=air[-1] if air else None)
    turn.say(CoachKey.ONE_AT_A_TIME)
    turn.show(View.ONE_AT_A_TIME, air)


def _place(turn: Turn, token: TokenId, cell: Cell) -> None:
    session = turn.session
    home = session.position.now.cells[token]
    left = session.table.air.get(token, session.table.cells.get(token))
    turn.change(table=session.table.placed(token, cell))
    if not turn.is_played:
        view = View.NO_BOARD if session.phase is Phase.PLAYING else View.PAUSED
        turn.note(Note.UNCLEAR, token=token)
        turn.show(view)
    elif cell != home:
        _try(turn, Move(token, home, cell))
    else:
        turn.note(Note.RETURNED, token=token)
        _returned(turn, was_astray=left != home)


def _returned(turn: Turn, *, was_astray: bool) -> None:
    """A token is where it should be."""
    if turn.session.waiting is None:
        helping.stir(turn)
        turn.look(())
    elif was_astray:
        turn.say(CoachKey.THANKS_FOR_PUTTING_BACK)
        settle(turn)


def _try(turn: Turn, move: Move) -> None:
    """Judge a token that lies elsewhere than it did."""
    session = turn.session
    try:
        ruling = session.game.referee.judge(session.position, move)
    except IllegalMoveError:
        _one_at_a_time(turn)
        putting_back.request(turn)
        return
    if move in session.step.vetoed:
        ruling = Refused("", ())
    match ruling:
        case Right():
            asked = session.asked_move
            accept(turn, move, OTHERS if asked and asked.move == move else OWN)
        case Refused():
            refuse(turn, move, ruling)
        case _:
            assert_never(ruling)


def refuse(turn: Turn, move: Move, ruling: Refused) -> None:
    """A wrong move: a kind word and the reason, then have it put back."""
    session = turn.session
    step, made = session.step, len(session.position.moves)
    helping.learn_from(turn, Outcome.WRONG)
    fields = _fields(move, made + 1, step)
    turn.note(Note.REFUSED, **fields, broken=",".join(ruling.broken))
    first = step.wrong == 0
    turn.change(
        step=replace(step, attempt=step.attempt + 1, wrong=step.wrong + 1, last=Outcome.WRONG),
        judged=Judged(move, allowed=False, own=True, first=first),
        tally=replace(session.tally, errors=session.tally.errors + 1),
    )
    turn.express(Expression.CARING)
    if ruling.reason:
        turn.say(CoachKey.REFUSED, reason=ruling.reason)
    else:
        turn.say(CoachKey.REFUSED_BY_CAREGIVER)
    putting_back.request(turn)


def _praise(turn: Turn, by: str, *, corrected: bool) -> None:
    turn.express(Expression.HAPPY)
    if by == GRANTED:
        turn.say(CoachKey.ACCEPTED)
    elif by == OTHERS:
        turn.say(CoachKey.LET_US_GO_ON)
    elif corrected:
        turn.say(CoachKey.PRAISE_OWN_CORRECTION)
        turn.gesture(GestureName.CHEER)
    else:
        turn.say(CoachKey.PRAISE)
        turn.gesture(GestureName.NOD)


def _fields(move: Move, number: int, step: Step) -> dict[str, int | bool | str | None]:
    return {
        "token": move.token,
        "from_row": move.origin.row,
        "from_column": move.origin.column,
        "row": move.destination.row,
        "column": move.destination.column,
        "step": number,
        "attempt": step.attempt,
        "level": step.most,
    }
