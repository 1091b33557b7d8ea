"""The stream of a room: whoever follows it has the state at once, and each change after it.

Every message to a client is the whole state, so that a lost one does no harm. What a client tells
is acknowledged once it is on the disk; what was not acknowledged can be told again under the same
id, and happens once.
"""

from __future__ import annotations

import asyncio
import json
from typing import Any, Final

from anyio import to_thread
from fastapi import APIRouter, WebSocket, WebSocketDisconnect

from maestra.core.faults import InvalidError
from maestra.web.rooms.guests import Guest, GuestHere, Part
from maestra.web.rooms.listeners import LeftError, Listener
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import RoomsHere
from maestra.web.rooms.telling import Entered, read, tell

PING_S: Final = 10.0
"""Of silence, after which the server says that it is there. Browsers do not tell pages of the
protocol's own pings; a page that hears nothing for three times as long comes anew."""
CHECKED_S: Final = 30.0
"""How long somebody who was logged out, or whose token was revoked, may still follow."""
OVER: Final = 4404
"""Close code: what was followed is over, or not for this client any more; coming anew tells."""
NO_TEXT: Final = 1003
"""Close code for bytes (RFC 6455, 7.4.1)."""
PING: Final = '{"type":"ping"}'

router: Final = APIRouter()


@router.websocket("/api/rooms/{name}/stream")
async def stream(socket: WebSocket, room: Entered, guest: GuestHere) -> None:
    """Follow a room and tell it what happens."""
    await _follow(socket, room, guest)


@router.websocket("/api/screen/stream")
async def screen_stream(socket: WebSocket, guest: GuestHere, rooms: RoomsHere) -> None:
    """Follow the patient of this screen, wherever they play; between sessions, wait."""
    if guest.patient is None:
        await socket.close(OVER)
        return
    room = await to_thread.run_sync(rooms.of, guest.patient)
    await _follow(socket, room or rooms.lobby, guest)


async def _follow(socket: WebSocket, room: Room, guest: Guest) -> None:
    listener = Listener(
        for_caregiver=guest.part is Part.CAREGIVER,
        is_board=guest.part is Part.BOARD,
        follows=guest.follows(room),
    )
    await socket.accept()
    await to_thread.run_sync(room.join, listener)
    telling = asyncio.create_task(_tell(socket, listener, guest, room))
    try:
        await _hear(socket, room, guest)
    finally:
        telling.cancel()
        await asyncio.gather(telling, return_exceptions=True)
        await to_thread.run_sync(room.leave, listener)


async def _tell(socket: WebSocket, listener: Listener, guest: Guest, room: Room) -> None:
    """Send what there is to tell, until there is nothing more for this client."""
    clock = asyncio.get_running_loop().time
    check_at = clock() + CHECKED_S
    try:
        while True:
            message = await listener.next(PING_S)
            await socket.send_text(PING if message is None else message)
            if clock() >= check_at:
                await to_thread.run_sync(_check, guest, room)
                check_at = clock() + CHECKED_S
    except LeftError:
        await socket.close(OVER)
    except (WebSocketDisconnect, RuntimeError):
        pass  # it has gone; the other direction says so too


def _check(guest: Guest, room: Room) -> None:
    """Refuse whoever may not be here any more.

    Raises:
        LeftError: they may not.
    """
    if not (guest.is_still_welcome() and guest.may_enter(room)):
        raise LeftError


async def _hear(socket: WebSocket, room: Room, guest: Guest) -> None:
    """Take what the client tells, one thing after the other, until it goes."""
    while True:
        message = await socket.receive()
        if message["type"] == "websocket.disconnect":
            return
        text = message.get("text")
        if text is None:
            await socket.close(NO_TEXT)
            return
        answer = await to_thread.run_sync(_answer, room, guest, text)
        await socket.send_text(json.dumps(answer, ensure_ascii=False))


def _answer(room: Room, guest: Guest, text: str) -> dict[str, Any]:
    told_id: str | None = None
    try:
        told = read(text)
        told_id = told.id
        tell(room, guest, told)
    except InvalidError as error:
        faults = [
            {"where": one.where, "found": one.found, "expected": one.expected}
            for one in error.faults
        ]
        return {"type": "fault", "id": told_id, "faults": faults}
    except OSError:
        fault = {"where": "", "found": "nothing can be kept now", "expected": "tell it again"}
        return {"type": "fault", "id": told_id, "again": True, "faults": [fault]}
    return {"type": "ack", "id": told_id}
