"""Somebody is always asked to put back what lies wrong, and another one when nothing comes of it.

The first is the helper that the settings name; then the others, round and round: the robot, the
patient, the caregiver. A robot that once failed to move a token is left out from then on.
"""

from __future__ import annotations

from typing import assert_never

from maestra.coaching.commands import Matter, MoveToken, View
from maestra.coaching.fields import Milliseconds
from maestra.coaching.notes import Note
from maestra.coaching.session import Waiting
from maestra.coaching.settings import Helper
from maestra.coaching.turn import Turn
from maestra.core.tokens import TokenId
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.phrases import Place


def request(turn: Turn) -> None:
    """Ask the first helper."""
    _ask(turn, _helpers(turn)[0])


def ask_next(turn: Turn) -> None:
    """Ask the one after whoever was asked last."""
    helpers, waiting = _helpers(turn), turn.session.waiting
    asked = None if waiting is None else waiting.helper
    place = helpers.index(asked) + 1 if asked in helpers else 0
    _ask(turn, helpers[place % len(helpers)])


def ask_caregiver(turn: Turn) -> None:
    """Ask the caregiver at once."""
    _ask(turn, Helper.CAREGIVER)


def remind(turn: Turn) -> None:
    """Say it again to whoever sits at the board."""
    _ask(turn, Helper.PATIENT)


def _helpers(turn: Turn) -> tuple[Helper, ...]:
    """Who can be asked now, in turn."""
    token = _first(turn)
    able = turn.session.robot_able and token in turn.session.table.cells and _is_free(turn, token)
    return tuple(
        one for one in turn.game.settings.ready_helpers if able or one is not Helper.ROBOT
    )


def _ask(turn: Turn, helper: Helper) -> None:
    token = _first(turn)
    home = turn.session.position.now.cells[token]
    lies = turn.session.table.cells.get(token, home)
    turn.note(Note.PUT_BACK_ASKED, helper=helper.value, token=token)
    number: int | None = None
    named = turn.named(token)
    match helper:
        case Helper.ROBOT:
            number = turn.number()
            turn.say(CoachKey.I_PUT_BACK, token=named)
            turn.command(MoveToken(number, token, lies, home))
        case Helper.PATIENT:
            turn.say(CoachKey.PLEASE_PUT_BACK, token=named, place=Place(home))
            turn.point(dict.fromkeys((lies, home)))
            turn.show(View.PUT_BACK, (token,))
        case Helper.CAREGIVER:
            turn.say(CoachKey.HELP_COMES)
            number = turn.ask(Matter.PUT_BACK, AskKey.PUT_BACK, turn.astray)
        case _:
            assert_never(helper)
    until = Milliseconds(turn.session.now + turn.game.settings.patience)
    turn.change(waiting=Waiting(helper, until, number), prompt_at=None)


def _first(turn: Turn) -> TokenId:
    """A token that lies wrong; one whose cell is free, if there is any."""
    astray = turn.astray
    return next((token for token in astray if _is_free(turn, token)), astray[0])


def _is_free(turn: Turn, token: TokenId) -> bool:
    """Whether the cell where `token` belongs is empty."""
    home = turn.session.position.now.cells[token]
    return home not in turn.session.table.cells.values()
