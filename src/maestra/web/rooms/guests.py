"""Who is in a room, and what they may tell: caregivers, patients' screens, boards, robots."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Annotated, Final

from fastapi import Depends, HTTPException
from starlette.requests import HTTPConnection

from maestra.coaching.events import (
    Begun,
    BoardBack,
    BoardLost,
    DoneSaid,
    Event,
    HelpAsked,
    Resumed,
    RobotDone,
    RobotFailed,
    SeveralTokens,
    TimePassed,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
)
from maestra.coaching.ports import PatientId
from maestra.web.access.devices import Device, DeviceKind, participant_of
from maestra.web.access.ownership import sees_patient
from maestra.web.access.visitor import Right, Visitor
from maestra.web.context import Context, context_of
from maestra.web.rooms.room import Room
from maestra.web.rooms.stage import RoomName


class Part(Enum):
    """What somebody is in a room."""

    CAREGIVER = "caregiver"
    SCREEN = "screen"
    """The patient's page: a board and a robot in one, and the patient's own wishes."""
    BOARD = "board"
    ROBOT = "robot"


_OF_BOARDS: Final = (
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    SeveralTokens,
    BoardLost,
    BoardBack,
)
_OF_ROBOTS: Final = (RobotDone, RobotFailed)
_OF_PATIENTS: Final = (Begun, HelpAsked, DoneSaid, Resumed)
MAY_TELL: Final[Mapping[Part, tuple[type[Event], ...]]] = MappingProxyType(
    {
        Part.BOARD: _OF_BOARDS,
        Part.ROBOT: _OF_ROBOTS,
        Part.SCREEN: (*_OF_BOARDS, *_OF_ROBOTS, *_OF_PATIENTS),
    }
)
"""Which events each part tells. Caregivers tell all but that time has passed, as nobody does."""
_PARTS: Final = MappingProxyType(
    {
        DeviceKind.BOARD: Part.BOARD,
        DeviceKind.ROBOT: Part.ROBOT,
        DeviceKind.SCREEN: Part.SCREEN,
    }
)


def _always() -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Guest:
    """Somebody who comes to a room."""

    part: Part
    may_see: Callable[[PatientId], bool]
    """Whose sessions they may follow; caregivers and screens only."""
    room: RoomName | None = None
    """Of a board or a robot: the one room it stands in."""
    patient: PatientId | None = None
    """Of a screen: the one patient it is for."""
    is_still_welcome: Callable[[], bool] = _always
    """Whether they are still logged in, or their token still counts."""

    def may_enter(self, room: Room) -> bool:
        """Whether the room is there for them; an empty one shows nothing."""
        if self.room is not None:
            return room.name == self.room
        return room.patient is None or self.may_see(room.patient)

    def may_tell(self, event: Event) -> bool:
        """Whether an event of this kind is theirs to tell."""
        if self.part is Part.CAREGIVER:
            return not isinstance(event, TimePassed)
        return isinstance(event, MAY_TELL[self.part])

    def follows(self, room: Room) -> PatientId | None:
        """Whose sessions they follow there; None: whoever plays."""
        return None if self.room is not None else self.patient or room.patient or PatientId("")


def guest_of(connection: HTTPConnection) -> Guest:
    """Who asks: a caregiver, a patient's screen, or a program with its token.

    Raises:
        HTTPException: 401, nobody whom a room is for; 403, their role has no business there.
    """
    context, participant = context_of(connection), participant_of(connection)

    def is_still_welcome() -> bool:
        try:
            return participant_of(connection) == participant
        except HTTPException:
            return False

    if isinstance(participant, Visitor):
        return as_guest(context, participant, is_still_welcome)
    return _device_as_guest(participant, is_still_welcome)


def as_guest(
    context: Context, visitor: Visitor, is_still_welcome: Callable[[], bool] = _always
) -> Guest:
    """A visitor as a guest: a caregiver, of their own patients.

    Raises:
        HTTPException: 403, their role has no business in rooms.
    """
    if not visitor.may(Right.ACCOMPANY):
        raise HTTPException(403, f"a {visitor.role.value} may not accompany")
    return Guest(
        Part.CAREGIVER,
        lambda patient: sees_patient(context, visitor, patient),
        is_still_welcome=is_still_welcome,
    )


def _device_as_guest(device: Device, is_still_welcome: Callable[[], bool]) -> Guest:
    part = _PARTS[device.kind]
    room = None if device.room is None else RoomName(device.room)
    return Guest(
        part, lambda patient: patient == device.patient, room, device.patient, is_still_welcome
    )


GuestHere = Annotated[Guest, Depends(guest_of)]
