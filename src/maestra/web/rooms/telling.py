"""Somebody tells a room what happened: the same checks, whichever way it comes."""

from __future__ import annotations

from typing import Annotated, Final

from fastapi import Depends, HTTPException, Path
from pydantic import ValidationError

from maestra.core.faults import Fault, InvalidError
from maestra.core.json_faults import faults_of_validation
from maestra.web.rooms.guests import Guest, GuestHere
from maestra.web.rooms.messages import MOST_CHARACTERS, Told
from maestra.web.rooms.room import NobodyPlaysError, Room, TooManyEventsError
from maestra.web.rooms.rooms import Rooms, RoomsHere
from maestra.web.rooms.stage import ROOM_PATTERN, RoomName, RoomState

NO_SUCH_ROOM: Final = "no such room"


def enter(rooms: Rooms, guest: Guest, name: str) -> Room:
    """The room of this name, if it is there for this guest.

    Raises:
        HTTPException: 404, it is not.
    """
    try:
        room = rooms.named(RoomName(name))
    except KeyError:
        if guest.room is None or guest.room != name:
            raise HTTPException(404, NO_SUCH_ROOM) from None
        # A board that stands where nobody has played yet waits for the first session.
        room = rooms.place(guest.room)
    if not guest.may_enter(room):
        raise HTTPException(404, NO_SUCH_ROOM)
    return room


def entered(
    name: Annotated[str, Path(pattern=ROOM_PATTERN, description="The room's name.")],
    rooms: RoomsHere,
    guest: GuestHere,
) -> Room:
    """The room that the address names."""
    return enter(rooms, guest, name)


Entered = Annotated[Room, Depends(entered)]


def read(message: str) -> Told:
    """What a message to the stream says.

    Raises:
        InvalidError: it is too long or says nothing of the kind; with every fault.
    """
    if len(message) > MOST_CHARACTERS:
        found = f"{len(message)} characters"
        raise InvalidError([Fault("", found, f"at most {MOST_CHARACTERS}")])
    try:
        return Told.model_validate_json(message)
    except ValidationError as error:
        raise InvalidError(faults_of_validation(error, Told)) from None


def tell(room: Room, guest: Guest, told: Told) -> RoomState:
    """Let it happen; when this returns it is on the disk.

    Raises:
        InvalidError: it is not this guest's to tell, or cannot happen here any more.
        OSError: it cannot be kept now; it can be told again.
    """
    if not guest.may_tell(told.event):
        found = f"{told.event.event} from a {guest.part.value}"
        raise InvalidError([Fault("event", found, "an event of your own")])
    try:
        return room.tell(told.event, told.id)
    except NobodyPlaysError:
        raise InvalidError([Fault("room", "nobody plays", "a session that has begun")]) from None
    except TooManyEventsError:
        raise InvalidError([Fault("room", "too many events", "another session")]) from None
