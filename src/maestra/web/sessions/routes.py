"""The pages on sessions: those under way and past, a new one, one to watch and to steer."""

from __future__ import annotations

import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Final

from fastapi import APIRouter, Depends, HTTPException, Query, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.coaching.ports import PatientId, StoredSession
from maestra.coaching.recording import Start
from maestra.coaching.session import Ending
from maestra.core.faults import InvalidError
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.web.access.devices import DeviceKind
from maestra.web.access.guard import Accompanying, Teaching, needs
from maestra.web.access.ownership import demand_patient, patients_of, sees_patient
from maestra.web.access.visitor import Right, Visitor
from maestra.web.board_view import board_view, tokens_by_id
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.patients.addresses import segment_of
from maestra.web.patients.care import Care
from maestra.web.patients.desk import UNPROCESSABLE, name_of, titles
from maestra.web.patients.kinds import LEVEL_WORDS
from maestra.web.patients.whose import CaredFor, Filled, only
from maestra.web.progress.replaying import Moment, recorded
from maestra.web.progress.routes import SessionSegment, local, stored_session
from maestra.web.progress.words import (
    clock_words,
    event_words,
    judged_words,
    verdict_words,
    why_words,
)
from maestra.web.rooms.guests import GuestHere
from maestra.web.rooms.messages import Told
from maestra.web.rooms.patient_page import Pressing, let_happen
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import NoRoomLeftError, Rooms, RoomsHere, TakenError
from maestra.web.rooms.stage import RoomName
from maestra.web.rooms.telling import Entered, tell
from maestra.web.sessions.evidence import draft_of, said_in
from maestra.web.sessions.live import Live, wish
from maestra.web.teach.actions import CannotError
from maestra.web.teach.bench import path_of
from maestra.web.teach.desk import Desk

MOST_PAST: Final = 30
"""Sessions that have ended, in the list; older ones are found under progress."""
LAST: Final = 6
"""Moments beside the board."""
ANY_ROOM: Final = ""
"""The patient's screen is the board; any free room will do."""

router: Final = APIRouter(include_in_schema=False)
ForCaregivers: Final = Depends(needs(Right.ACCOMPANY))
"""Patients' screens and boards are guests too, but not on these pages."""


# ---------------------------------------------------------------- all of them


@dataclass(frozen=True, slots=True)
class Row:
    """A session in a list."""

    patient: PatientId
    name: str
    title: str
    begun: datetime
    address: str
    phase: str


@router.get("/sessions")
def sessions(visitor: Accompanying, context: Here, rooms: RoomsHere, pages: Page) -> HTMLResponse:
    """Those under way, and those past."""
    titled = titles(context, pages.language)
    mine = [
        room
        for room in rooms.all()
        if room.stored is not None
        and room.state.is_under_way
        and sees_patient(context, visitor, room.stored.patient)
    ]
    under_way = [
        _row(context, titled, room.stored, f"/sessions/{room.name}", room.state.phase)
        for room in mine
        if room.stored is not None
    ]
    running = {room.stored.session for room in mine if room.stored is not None}
    past = [
        one
        for patient in patients_of(context, visitor)
        for one in context.store.sessions(patient)[-MOST_PAST:]
        if one.session not in running
    ]
    past.sort(key=lambda one: one.begun_utc, reverse=True)
    return pages.page(
        "sessions/list.html",
        visitor,
        under_way=under_way,
        past=[
            _row(
                context,
                titled,
                one,
                f"/progress/{segment_of(one.patient)}/sessions/{segment_of(one.session)}",
            )
            for one in past[:MOST_PAST]
        ],
    )


def _row(
    context: Context,
    titled: Mapping[str, str],
    stored: StoredSession,
    address: str,
    phase: str = "",
) -> Row:
    return Row(
        stored.patient,
        name_of(context, stored.patient),
        titled.get(stored.exercise, stored.exercise),
        local(stored.begun_utc),
        address,
        phase,
    )


# ---------------------------------------------------------------- a new one


@router.get("/sessions/new-session")
def new(
    visitor: Accompanying,
    context: Here,
    rooms: RoomsHere,
    pages: Page,
    patient: Annotated[str, Query(max_length=6_000)] = "",
) -> HTMLResponse:
    """Choose who plays what, and on which board."""
    return _new(visitor, context, rooms, pages, {"patient": patient}, {})


@router.post("/sessions")
def begin(
    visitor: Accompanying, context: Here, rooms: RoomsHere, pages: Page, typed: Filled
) -> Response:
    """Begin a session; nobody has sat down yet."""
    chosen = {name: only(typed, name) for name in ("patient", "exercise", "board")}
    known = {segment_of(one): one for one in patients_of(context, visitor)}
    faults: dict[str, str] = {}
    if chosen["patient"] not in known:
        faults["patient"] = pages.say("Please choose a patient.")
    if chosen["exercise"] not in titles(context):
        faults["exercise"] = pages.say("Please choose an exercise.")
    if chosen["board"] not in _boards(context):
        faults["board"] = pages.say("Please choose a board.")
    if not faults:
        patient = demand_patient(context, visitor, known[chosen["patient"]])
        room, fault = _begin(rooms, patient, chosen, pages)
        if room is not None:
            return RedirectResponse(f"/sessions/{room.name}", 303)
        faults |= fault
    return _new(visitor, context, rooms, pages, chosen, faults)


def _begin(
    rooms: Rooms, patient: PatientId, chosen: Mapping[str, str], pages: Pages
) -> tuple[Room | None, dict[str, str]]:
    """The room where the session begins; or what is wrong, by field."""
    place = RoomName(chosen["board"]) if chosen["board"] else None
    try:
        room = rooms.begin(patient, chosen["exercise"], room=place, language=pages.language)
    except TakenError:
        line = pages.say("This patient or this board is in a session already.")
        return None, {"patient": line}
    except NoRoomLeftError:
        return None, {"board": pages.say("Too many sessions are under way.")}
    except InvalidError:
        line = pages.say("This exercise cannot be played on its board. Please choose another one.")
        return None, {"exercise": line}
    return room, {}


def _new(
    visitor: Accompanying,
    context: Context,
    rooms: Rooms,
    pages: Pages,
    chosen: Mapping[str, str],
    faults: Mapping[str, str],
) -> HTMLResponse:
    known = {segment_of(one): one for one in patients_of(context, visitor)}
    whose = known.get(chosen["patient"])
    titled = titles(context, pages.language)
    assigned = () if whose is None else Care(context.store).plan(whose).exercises
    page = pages.page(
        "sessions/new.html",
        visitor,
        patients=[(seg, one, name_of(context, one)) for seg, one in known.items()],
        patient=chosen["patient"],
        assigned=[(one, titled[one]) for one in assigned if one in titled],
        others=[(one, title) for one, title in titled.items() if one not in assigned],
        exercise=chosen.get("exercise", ""),
        boards=list(_boards(context).items()),
        board=chosen.get("board", ANY_ROOM),
        faults=faults,
        can_speak=rooms.can_speak,
    )
    page.status_code = UNPROCESSABLE if faults else 200
    return page


def _boards(context: Context) -> dict[str, str]:
    """The boards that have a token, by their rooms; first of all the patient's screen."""
    boards = {ANY_ROOM: ""}
    for device in context.store.access.devices():
        if device.kind == DeviceKind.BOARD.value and device.room:
            boards.setdefault(device.room, device.label)
    return boards


# ---------------------------------------------------------------- one of them


@router.get("/sessions/{name}")
def watch(visitor: Accompanying, room: Entered, context: Here, pages: Page) -> HTMLResponse:
    """A session to watch and to steer."""
    stored, start = room.stored, room.start
    if stored is None or start is None:
        raise HTTPException(404, "nobody plays here")
    return pages.page(
        "sessions/watch.html",
        visitor,
        **_heading(context, stored, pages.language),
        room=room.name,
        state=room.state,
        live=_live(room),
        ending=None if room.session.ending is None else room.session.ending is Ending.COMPLETE,
        tally=room.session.tally,
        levels=[pages.say(words) for words in LEVEL_WORDS],
        board=_board(room, start, pages),
        stream=f"/api/rooms/{room.name}/stream",
        **_lately(context, stored, start, pages),
        judged=_judged_in(visitor, room, context, pages),
        last_move=_last_move(room, start, pages),
    )


def _judged_in(visitor: Visitor, room: Room, context: Context, pages: Pages) -> list[str]:
    """What can go back to the exercise once the session has ended."""
    stored = room.stored
    if stored is None or room.state.is_under_way or not visitor.may(Right.TEACH):
        return []
    return judged_words(said_in(context.store.events.entries(stored.session)), pages)


@router.post("/progress/{pseudonym}/sessions/{session}/teach")
def take_back(
    visitor: Teaching, patient: CaredFor, session: SessionSegment, context: Here
) -> RedirectResponse:
    """Begin a draft of the exercise with what was judged otherwise in the session."""
    stored = stored_session(context, patient, session)
    said = said_in(context.store.events.entries(stored.session))
    if said is None:
        raise HTTPException(404, "nothing was judged otherwise")
    try:
        kept = Desk(context, visitor).add(draft_of(context, stored, said))
    except KeyError:
        raise HTTPException(404, "no such exercise") from None
    except CannotError as error:
        return RedirectResponse(f"/teach?why={error.why.value}", 303)
    return RedirectResponse(path_of(kept.id), 303)


@router.post("/sessions/{name}", dependencies=[ForCaregivers])
def press(
    room: Entered, guest: GuestHere, request: Request, pressed: Pressing
) -> RedirectResponse:
    """A cell of the board was pressed on a page without script."""
    let_happen(room, guest, pressed)
    return RedirectResponse(request.url.path, 303)


@router.post("/sessions/{name}/do", dependencies=[ForCaregivers])
def do(room: Entered, guest: GuestHere, typed: Filled) -> RedirectResponse:
    """One of the caregiver's buttons was pressed."""
    if room.stored is None:
        raise HTTPException(404, "nobody plays here")
    event = wish(_live(room), only(typed, "do"))
    if event is None:
        raise HTTPException(422, "no such button")
    tell(room, guest, Told(id=secrets.token_hex(12), event=event))
    return RedirectResponse(f"/sessions/{room.name}", 303)


def _live(room: Room) -> Live:
    return Live(room.session, room.state.question)


def _heading(context: Context, stored: StoredSession, language: Language) -> dict[str, object]:
    titled = titles(context, language)
    return {
        "patient": stored.patient,
        "name": name_of(context, stored.patient),
        "segment": segment_of(stored.patient),
        "session": segment_of(stored.session),
        "title": titled.get(stored.exercise, stored.exercise),
    }


def _board(room: Room, start: Start, pages: Pages) -> object:
    session, state = room.session, room.state
    astray = set(session.table.astray(session.position.now)) & set(session.table.cells)
    return board_view(
        start.state.board,
        start.deck,
        state.cells or {},
        language=pages.language,
        held=state.held[-1] if state.held else None,
        pointed=state.pointed,
        wrong=[session.table.cells[token] for token in astray],
        pictures={} if room.scenery is None else room.scenery.pictures,
    )


def _lately(
    context: Context, stored: StoredSession, start: Start, pages: Pages
) -> dict[str, object]:
    """The last moments in words, the newest first, and why the robot helped as it did."""
    whole = recorded(context.store.events.entries(stored.session))
    moments = () if whole is None else whole.moments
    names = _names(start, pages)
    reasons = (why_words(one, pages) for one in reversed(moments))
    return {
        "why": next((one for one in reasons if one), ""),
        "lately": [_line(one, names, pages) for one in moments[: -LAST - 1 : -1]],
    }


def _line(
    moment: Moment, names: Mapping[TokenId, str], pages: Pages
) -> tuple[str, str, str, tuple[str, ...]]:
    happened = event_words(moment.event, names, pages)
    return clock_words(moment.at), happened, verdict_words(moment, pages), moment.said


def _last_move(room: Room, start: Start, pages: Pages) -> str:
    """The move that can still be judged otherwise, in words."""
    found = _live(room).overridable
    if found is None:
        return ""
    place, token = found.move.destination, _names(start, pages)[found.move.token]
    said = "Token {token} on row {row}, column {column} was refused."
    if found.was_allowed:
        said = "Token {token} on row {row}, column {column} was right."
    return pages.say(said, token=token, row=place.row, column=place.column)


def _names(start: Start, pages: Pages) -> dict[TokenId, str]:
    views = tokens_by_id(start.deck, start.state.board, pages.language)
    return {token: view.name for token, view in views.items()}
