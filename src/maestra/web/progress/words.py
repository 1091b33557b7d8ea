"""What happened in a session, in words for whoever looks at it later."""

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

from maestra.coaching import events
from maestra.coaching.events import Event
from maestra.coaching.fields import Milliseconds
from maestra.core.tokens import TokenId
from maestra.rules.answers import Reply
from maestra.web.board_view import tokens_by_id
from maestra.web.pages import Pages
from maestra.web.progress.replaying import Moment, Why
from maestra.web.sessions.evidence import Said


def clock_words(at: Milliseconds) -> str:
    """Minutes and seconds since the beginning: ``3:07``."""
    minutes, seconds = divmod(at // 1000, 60)
    return f"{minutes}:{seconds:02}"


def event_words(event: Event | None, names: Mapping[TokenId, str], pages: Pages) -> str:  # noqa: C901, PLR0912 - one case for each event
    """What happened.

    Args:
        event: None at the start.
        names: what is said of each token.
        pages: says it.
    """
    match event:
        case None:
            return pages.say("The tokens lie ready.")
        case events.Begun():
            return pages.say("Somebody sat down.")
        case events.TokenLifted(token):
            return pages.say("Token {token} was lifted.", token=_name(token, names))
        case events.TokenPlaced(token, cell):
            return pages.say(
                "Token {token} was put on row {row}, column {column}.",
                token=_name(token, names),
                row=cell.row,
                column=cell.column,
            )
        case events.TokenPutBack(token):
            return pages.say("Token {token} was put back.", token=_name(token, names))
        case events.SeveralTokens():
            return pages.say("Several tokens were lifted at once.")
        case events.BoardLost():
            return pages.say("The board did not answer any more.")
        case events.BoardBack():
            return pages.say("The board answered.")
        case events.HelpAsked():
            return pages.say("The patient asked for help.")
        case events.DoneSaid():
            return pages.say("The patient said that this was all.")
        case events.Paused():
            return pages.say("The session was paused.")
        case events.Resumed():
            return pages.say("The session went on.")
        case events.Skipped():
            return pages.say("The caregiver skipped this move.")
        case events.HintOrdered(level):
            return pages.say("The caregiver asked for help at level {level}.", level=level)
        case events.EndOrdered():
            return pages.say("The caregiver ended the session.")
        case events.VerdictOverridden(allowed):
            if allowed:
                return pages.say("The caregiver said: that was right.")
            return pages.say("The caregiver said: that was wrong.")
        case events.Answered(_, reply):
            return _answer_words(reply, pages)
        case events.TimePassed():
            return pages.say("Time passed.")
        case events.RobotDone():
            return pages.say("The robot did what it was told.")
        case events.RobotFailed():
            return pages.say("The robot could not do what it was told.")
        case _:
            assert_never(event)


def why_words(moment: Moment, pages: Pages) -> str:
    """Why the robot did what it did then; empty where there is nothing to explain."""
    asked = next((fields for note, fields in moment.notes if note == "put-back-asked"), None)
    if asked is not None:
        return _helper_words(str(asked["helper"]), pages)
    return "" if moment.help is None else _help_words(moment.help, pages)


def _helper_words(helper: str, pages: Pages) -> str:
    said = {
        "robot": pages.say("A token lies wrong. The robot puts it back."),
        "patient": pages.say("A token lies wrong. The patient is asked to put it back."),
        "caregiver": pages.say("A token lies wrong. The caregiver is asked to put it back."),
    }
    return said[helper]


def _help_words(why: Why, pages: Pages) -> str:
    said = pages.say(
        "Help at level {level} of 5, at attempt {attempt} of move {step}.",
        level=why.level,
        attempt=why.attempt,
        step=why.step,
    )
    reasons = {
        "policy": pages.say("That was enough by what is known of the patient."),
        "silence": pages.say("Nobody had moved for a while."),
        "asked": pages.say("The patient had asked."),
        "ordered": pages.say("The caregiver had asked."),
    }
    return f"{said} {reasons[why.why]}"


def verdict_words(moment: Moment, pages: Pages) -> str:
    """What came of a move; empty where none was judged."""
    kinds = [note for note, _ in moment.notes]
    if "refused" in kinds:
        return pages.say("The move was refused.")
    if "move" in kinds:
        return pages.say("The move was right.")
    if "returned" in kinds:
        return pages.say("The token lay where it belongs again.")
    return ""


def judged_words(said: Said | None, pages: Pages) -> list[str]:
    """Each move that the caregiver judged otherwise, in a sentence."""
    if said is None:
        return []
    board, deck = said.start.state.board, said.start.deck
    views = tokens_by_id(deck, board, pages.language)
    sentences = {
        True: "Token {token} on row {row}, column {column}: you said that was right.",
        False: "Token {token} on row {row}, column {column}: you said that was wrong.",
    }
    return [
        pages.say(
            sentences[one.allowed],
            token=views[one.move.token].name,
            row=one.move.destination.row,
            column=one.move.destination.column,
        )
        for one in said.overrides
    ]


def _answer_words(reply: Reply, pages: Pages) -> str:
    match reply:
        case Reply.YES:
            return pages.say("The caregiver answered yes.")
        case Reply.NO:
            return pages.say("The caregiver answered no.")
        case _:
            return pages.say("The caregiver did not know.")


def _name(token: TokenId, names: Mapping[TokenId, str]) -> str:
    return names.get(token, token)
