"""Rooms for programs, without a stream: begin, look, tell, end."""

from __future__ import annotations

from http import HTTPStatus
from typing import Annotated, Any, Final, cast

from fastapi import APIRouter, Depends, HTTPException, Path
from fastapi.responses import JSONResponse, Response
from starlette.requests import HTTPConnection

from maestra.coaching.events import EndOrdered
from maestra.robots.phrases import NoVoiceError, Phrases
from maestra.web.access.guard import Accompanying
from maestra.web.access.ownership import demand_patient
from maestra.web.context import Here
from maestra.web.problems import problems
from maestra.web.rooms.guests import GuestHere, Part
from maestra.web.rooms.messages import Beginning, StateJson, Told
from maestra.web.rooms.room import NobodyPlaysError, Room
from maestra.web.rooms.rooms import NoRoomLeftError, RoomsHere, TakenError
from maestra.web.rooms.stage import RoomName
from maestra.web.rooms.telling import Entered, tell

WAV: Final = "audio/wav"


def phrases_of(connection: HTTPConnection) -> Phrases:
    """The spoken phrases of the application that is asked."""
    return cast("Phrases", connection.app.state.phrases)


PhrasesHere = Annotated[Phrases, Depends(phrases_of)]

router: Final = APIRouter(prefix="/api/rooms", tags=["rooms"])


@router.get("", responses={200: {"model": list[StateJson]}, **problems(401, 403)})
def list_rooms(rooms: RoomsHere, guest: GuestHere) -> JSONResponse:
    """The rooms that you may enter, as they are now."""
    mine = [room for room in rooms.all() if guest.may_enter(room)]
    return JSONResponse([_state(room, guest.part) for room in mine])


@router.post(
    "",
    status_code=HTTPStatus.CREATED,
    responses={201: {"model": StateJson}, **problems(401, 403, 404, 409, 422, 503)},
)
def begin(
    beginning: Beginning, rooms: RoomsHere, context: Here, visitor: Accompanying
) -> JSONResponse:
    """Begin a session of one of your patients; nobody has sat down yet."""
    patient = demand_patient(context, visitor, beginning.patient)
    try:
        room = rooms.begin(
            patient,
            beginning.exercise,
            version=beginning.version,
            room=None if beginning.room is None else RoomName(beginning.room),
            language=visitor.language,
        )
    except KeyError:
        raise HTTPException(404, "no such exercise") from None
    except (TakenError, NoRoomLeftError):
        raise HTTPException(409, "the room or the patient is taken") from None
    return JSONResponse(_state(room, Part.CAREGIVER), HTTPStatus.CREATED)


@router.get("/{name}", responses={200: {"model": StateJson}, **problems(401, 403, 404, 422)})
def look(room: Entered, guest: GuestHere) -> JSONResponse:
    """A room as it is now."""
    return JSONResponse(_state(room, guest.part))


@router.post(
    "/{name}/events",
    responses={200: {"model": StateJson}, **problems(401, 403, 404, 422, 503)},
)
def happen(room: Entered, guest: GuestHere, told: Told) -> JSONResponse:
    """Tell what happened; the answer comes when it is on the disk, and is the state after it."""
    tell(room, guest, told)
    return JSONResponse(_state(room, guest.part))


@router.post(
    "/{name}/end",
    responses={200: {"model": StateJson}, **problems(401, 403, 404, 409, 422, 503)},
)
def end(room: Entered, guest: GuestHere) -> JSONResponse:
    """End the session; ending one that has ended changes nothing."""
    if guest.part is not Part.CAREGIVER:
        raise HTTPException(403, f"a {guest.part.value} may not end a session")
    if not room.state.is_under_way:
        return JSONResponse(_state(room, guest.part))
    try:
        room.tell(EndOrdered())
    except NobodyPlaysError:
        raise HTTPException(409, "nobody plays here") from None
    return JSONResponse(_state(room, guest.part))


@router.get(
    "/{name}/speech/{number}",
    response_class=Response,
    responses={
        200: {"content": {WAV: {"schema": {"type": "string", "format": "binary"}}}},
        **problems(401, 403, 404, 422),
    },
)
def speech(
    room: Entered,
    number: Annotated[int, Path(ge=0, le=2**31 - 1, description="As the state has it.")],
    phrases: PhrasesHere,
) -> Response:
    """One of the last things that the robot said, to be heard."""
    try:
        text, settings = room.sentence(number)
        return Response(phrases.spoken(text, settings), media_type=WAV)
    except KeyError:
        raise HTTPException(404, "nothing was said under this number lately") from None
    except NoVoiceError:
        raise HTTPException(404, "there is no voice: espeak-ng is missing or has failed") from None


def _state(room: Room, part: Part) -> dict[str, Any]:
    return room.state.as_json(for_caregiver=part is Part.CAREGIVER)
