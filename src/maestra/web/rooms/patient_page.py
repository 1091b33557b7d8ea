"""The patient's page: the board, the robot and its sentence, and at most three buttons.

It is in the patient's language, whoever has logged in. With script it follows the room's stream;
without, each press is a form, and what the robot is to move is moved when the form comes in.
"""

from __future__ import annotations

import secrets
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from http import HTTPStatus
from types import MappingProxyType
from typing import Annotated, Final, Literal, assert_never

from fastapi import APIRouter, Depends, Form, Request
from fastapi.responses import RedirectResponse, Response

from maestra.coaching.events import (
    Begun,
    DoneSaid,
    Event,
    HelpAsked,
    Resumed,
    RobotDone,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)
from maestra.coaching.ports import PatientId
from maestra.coaching.recording import Start
from maestra.coaching.sitting import known_patient
from maestra.core.state import State
from maestra.core.text import MAX_TEXT
from maestra.core.tokens import TokenId
from maestra.language import Language
from maestra.web.access.devices import Device, OnScreen
from maestra.web.board_press import Held, Moved, Nothing, Released, cell_of, outcome
from maestra.web.board_view import board_view
from maestra.web.context import Context, Here
from maestra.web.language_choice import language_of
from maestra.web.pages import Pages
from maestra.web.paths import PATIENT_PAGE
from maestra.web.rooms.guests import Guest, GuestHere
from maestra.web.rooms.messages import Told
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms, RoomsHere, TakenError
from maestra.web.rooms.stage import RoomState, Scenery
from maestra.web.rooms.telling import Entered, tell

router: Final = APIRouter()

SCREEN_STREAM: Final = "/api/screen/stream"
WISHES: Final[Mapping[str, Event]] = MappingProxyType(
    {"begin": Begun(), "help": HelpAsked(), "done": DoneSaid(), "go-on": Resumed()}
)
"""What the patient's buttons tell."""
AGAIN: Final = "again"
"""The one button that is no event of the session: it begins the next one."""
SCAN_MS: Final = 1_500
"""With one switch: how long each row or cell is offered."""
WAITS_S: Final = 5
"""How often a page without script looks whether something has changed."""


@dataclass(frozen=True, slots=True)
class Press:
    """What was pressed: one of the patient's buttons, or a cell of the board."""

    wish: str
    cell: str
    token: str


def _pressed(
    wish: Annotated[Literal["", "begin", "help", "done", "go-on", "again"], Form()] = "",
    cell: Annotated[str, Form(pattern=r"^(\d{1,3},\d{1,3})?$")] = "",
    token: Annotated[str, Form(max_length=MAX_TEXT)] = "",
) -> Press:
    return Press(wish, cell, token)


Pressing = Annotated[Press, Depends(_pressed)]


@router.get("/rooms/{name}", include_in_schema=False)
def room_page(room: Entered, request: Request) -> Response:
    """The patient's page, for the caregiver's computer."""
    return _page(request, room.state, room.scenery, f"/api/rooms/{room.name}/stream")


@router.post("/rooms/{name}", include_in_schema=False)
def press_in_room(
    room: Entered, rooms: RoomsHere, guest: GuestHere, request: Request, pressed: Pressing
) -> Response:
    """A button or a cell was pressed on a page without script."""
    _press(rooms, room, guest, pressed)
    return RedirectResponse(request.url.path, HTTPStatus.SEE_OTHER)


@router.get(PATIENT_PAGE, include_in_schema=False)
def screen_page(screen: OnScreen, rooms: RoomsHere, context: Here, request: Request) -> Response:
    """The page of a patient's screen: their session wherever it is, else a kind word."""
    room = _of_screen(rooms, screen)
    if room is None or room.scenery is None:
        pages = Pages(request, _language_of(context, screen, request))
        return pages.page("patient/waiting.html", stream=SCREEN_STREAM, waits_s=WAITS_S)
    return _page(request, room.state, room.scenery, SCREEN_STREAM)


@router.post(PATIENT_PAGE, include_in_schema=False)
def press_on_screen(
    screen: OnScreen, guest: GuestHere, rooms: RoomsHere, pressed: Pressing
) -> Response:
    """A button or a cell was pressed on a screen without script."""
    room = _of_screen(rooms, screen)
    if room is not None:
        _press(rooms, room, guest, pressed)
    return RedirectResponse(PATIENT_PAGE, HTTPStatus.SEE_OTHER)


# ---------------------------------------------------------------- within


def _language_of(context: Context, screen: Device, request: Request) -> Language:
    """The patient's, as far as it is known."""
    try:
        patient = screen.patient or PatientId("")
        return known_patient(context.store, patient).settings.language
    except KeyError:
        return language_of(request)


def _of_screen(rooms: Rooms, screen: Device) -> Room | None:
    return None if screen.patient is None else rooms.of(screen.patient)


def _page(request: Request, state: RoomState, scenery: Scenery | None, stream: str) -> Response:
    if scenery is None:
        pages = Pages(request, language_of(request))
        return pages.page("patient/waiting.html", stream=stream, waits_s=WAITS_S)
    start, settings = scenery.start, scenery.start.settings
    view = board_view(
        start.state.board,
        start.deck,
        state.cells or {},
        language=settings.language,
        lexicon=scenery.lexicon,
        pictures=scenery.pictures,
        held=state.held[-1] if state.held else None,
        pointed=state.pointed,
    )
    return Pages(request, settings.language).page(
        "patient/room.html",
        state=state,
        facts=_facts(state),
        view=view,
        stream=stream,
        waits_s=WAITS_S,
        scan_ms=SCAN_MS if settings.one_switch else 0,
        show_score=settings.show_score,
    )


def _facts(state: RoomState) -> frozenset[str]:
    """What `data-when` asks for; maestra.js works the same out of each new state."""
    facts = {state.phase, f"view-{state.shown.view.value}" if state.shown else ""}
    if state.speaks and state.said is not None:
        facts.add("speech")
    if not state.connected:
        facts.add("lost")
    if state.another_round:
        facts.add("another-round")
    return frozenset(facts)


def _press(rooms: Rooms, room: Room, guest: Guest, pressed: Press) -> None:
    if pressed.wish == AGAIN:
        with suppress(TakenError):  # pressed twice: it has begun
            rooms.once_more(room)
    else:
        let_happen(room, guest, pressed)


def let_happen(room: Room, guest: Guest, pressed: Press) -> None:
    """Tell the room what was pressed, and move what the robot is to move."""
    for event in _events(room.state, room.start, pressed):
        _tell(room, guest, event)
    for command in room.state.awaiting:
        # This page is the robot's hand as well, and has nobody else to move the token.
        _tell(room, guest, TokenPlaced(command.token, command.destination))
        _tell(room, guest, RobotDone(command.number))


def _tell(room: Room, guest: Guest, event: Event) -> None:
    tell(room, guest, Told(id=secrets.token_hex(12), event=event))


def _events(state: RoomState, start: Start | None, pressed: Press) -> list[Event]:
    if pressed.wish:
        return [WISHES[pressed.wish]]
    if start is None or state.cells is None or not pressed.cell:
        return []
    held = state.held[-1] if state.held else None
    lying = State(start.state.board, state.cells)
    pressed_cell = cell_of(pressed.cell)
    match outcome(lying, held, pressed_cell, pressed.token):
        case Held(token):
            back: list[Event] = [] if held is None else [TokenPutBack(held)]
            return [*back, TokenLifted(token)]
        case Released():
            return [TokenPutBack(held or TokenId(pressed.token))]
        case Moved(move):
            return [TokenPlaced(move.token, move.destination)]
        case Nothing():
            return []
        case _ as unknown:
            assert_never(unknown)
