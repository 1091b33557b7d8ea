"""Whatever happens in a session stands in its replay, with the board as it was."""

import html

from fastapi import FastAPI

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
from maestra.rules.answers import Reply
from maestra.web.context import Context
from maestra.web.progress.replaying import recorded
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from tests.web.progress.conftest import HERON, As
from tests.web.rooms.exercises import right_move, wrong_move


def begun(app: FastAPI) -> Room:
    rooms = app.state.rooms
    assert isinstance(rooms, Rooms)
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    return room


def test_every_event_is_told_in_words(browsing: As, app: FastAPI) -> None:
    browser, room = browsing(), begun(app)
    assert room.stored is not None
    right, wrong = right_move(room), wrong_move(room)
    lying = dict(room.session.table.cells)
    told: list[tuple[Event, str]] = [
        (TokenLifted(right.token), "was lifted."),
        (TokenPutBack(right.token), "was put back."),
        (TokenPlaced(right.token, right.destination), "The move was right."),
        (VerdictOverridden(allowed=False), "The caregiver said: that was wrong."),
        (VerdictOverridden(allowed=True), "The caregiver said: that was right."),
        (TokenPlaced(wrong.token, wrong.destination), "was put on row"),
        (TokenPlaced(wrong.token, wrong.origin), "lay where it belongs again"),
        (SeveralTokens((wrong.token,)), "Several tokens"),
        (BoardLost(), "did not answer any more"),
        (BoardBack(lying), "The board answered."),
        (HelpAsked(), "asked for help."),
        (DoneSaid(), "said that this was all."),
        (Paused(), "was paused."),
        (Resumed(), "went on."),
        (HintOrdered(3), "asked for help at level 3."),
        (Skipped(), "skipped this move."),
        (Answered(1, Reply.YES), "answered yes."),
        (Answered(1, Reply.NO), "answered no."),
        (Answered(1, Reply.UNSURE), "did not know."),
        (TimePassed(), "Time passed."),
        (RobotDone(1), "did what it was told."),
        (RobotFailed(1, "no hand"), "could not do what it was told."),
        (EndOrdered(), "The caregiver ended the session."),
    ]
    for event, _ in told:
        room.tell(event)
    address = f"/progress/heron/sessions/{room.stored.session}"
    for number, (_, words) in enumerate(told, 2):
        page = html.unescape(browser.get(address, params={"at": number}).text)
        assert words in page, words
    assert "The tokens lie ready." in browser.get(address).text


def test_a_move_that_was_taken_back_lies_wrong_afterwards(
    browsing: As, app: FastAPI, context: Context
) -> None:
    del browsing
    room = begun(app)
    assert room.stored is not None
    move = right_move(room)
    for event in (TokenLifted(move.token), TokenPlaced(move.token, move.destination)):
        room.tell(event)
    room.tell(VerdictOverridden(allowed=False))
    whole = recorded(context.store.events.entries(room.stored.session))
    assert whole is not None
    placed, vetoed = whole.moments[-2:]
    assert (placed.wrong, vetoed.wrong) == ((), (move.destination,))
    assert vetoed.cells[move.token] == move.destination


def test_a_session_that_was_cut_off_ends_with_what_was_kept(
    browsing: As, app: FastAPI, context: Context
) -> None:
    del browsing
    room = begun(app)
    assert room.stored is not None
    entries = list(context.store.events.entries(room.stored.session))
    for kept, moments in ((0, None), (1, 1), (2, 2), (3, 2)):
        whole = recorded(entries[:kept])
        assert (None if whole is None else len(whole.moments)) == moments
