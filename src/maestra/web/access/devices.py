"""Boards, robots and patients' screens: each has a token of its own, which opens little."""

from __future__ import annotations

import secrets
from dataclasses import dataclass, replace
from enum import Enum
from typing import Annotated, Final, NewType, TypeAlias

from fastapi import Depends, HTTPException
from starlette.requests import HTTPConnection

from maestra.coaching.ports import PatientId
from maestra.storage import access
from maestra.web.access.audit import Act, audit
from maestra.web.access.guard import visitor_of
from maestra.web.access.logins import DEVICE_COOKIE, LoginKind, cookie, current, now_ms
from maestra.web.access.passwords import as_typed, digest, new_code, new_token
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, context_of

DeviceId = NewType("DeviceId", str)
_ID_BYTES: Final = 16
_BEARER: Final = "bearer "


class DeviceKind(Enum):
    """What a device is, and so what its token opens."""

    BOARD = "board"
    """One room, as a board."""
    ROBOT = "robot"
    """One room, as a robot."""
    SCREEN = "screen"
    """One patient's page, in the browser that was made the screen, after its PIN."""


@dataclass(frozen=True, slots=True)
class Device:
    """A device that has shown its token."""

    device: DeviceId
    kind: DeviceKind
    label: str
    room: str | None
    """The one room that a board or a robot may join."""
    patient: PatientId | None
    """The one patient whom a screen is for."""


Participant: TypeAlias = Visitor | Device
"""Whoever may come to the stream."""


def device_of(connection: HTTPConnection) -> Device:
    """Which board or robot this is, by ``Authorization: Bearer TOKEN``.

    Raises:
        HTTPException: 401, none that has a token here.
    """
    header = connection.headers.get("authorization", "")
    if header.lower().startswith(_BEARER):
        found = context_of(connection).store.access.device_with(digest(header[len(_BEARER) :]))
        # A screen's code is typed by people, so it opens nothing without the PIN.
        if found is not None and found.kind != DeviceKind.SCREEN.value:
            return _as_device(found)
    raise HTTPException(401, "no device has this token", {"WWW-Authenticate": "Bearer"})


def screen_of(connection: HTTPConnection) -> Device:
    """Which patient's screen this is, while it is open.

    Raises:
        HTTPException: 401, it is none, or its PIN has not been typed today.
    """
    context = context_of(connection)
    login = current(context, connection, LoginKind.SCREEN)
    found = None if login is None else context.store.access.device(login.holder)
    if found is None:
        raise HTTPException(401, "no patient's screen is open here")
    return _as_device(found)


def participant_of(connection: HTTPConnection) -> Participant:
    """Who wants to join a room: a device by its token, a caregiver, or a patient's screen.

    Raises:
        HTTPException: 401, none of them.
    """
    if "authorization" in connection.headers:
        return device_of(connection)
    context = context_of(connection)
    if current(context, connection, LoginKind.ACCOUNT) is not None:
        return visitor_of(connection)
    return screen_of(connection)


OnScreen = Annotated[Device, Depends(screen_of)]


def make_program(
    context: Context, visitor: Visitor, kind: DeviceKind, label: str, room: str
) -> str:
    """Let a board or a robot join one room; its token, which nobody can see again.

    Raises:
        InvalidError: label or room cannot be printed.
    """
    token = f"maestra-{kind.value}-{new_token()}"
    _keep(context, visitor, replace(_new(context, visitor, kind, label, token), room=room))
    return token


def make_screen(
    context: Context, visitor: Visitor, label: str, patient: PatientId, pin: str
) -> str:
    """Let a browser become one patient's screen; its code, which nobody can see again.

    Raises:
        KeyError: nobody has this pseudonym.
        InvalidError: the label cannot be printed.
    """
    code = new_code()
    new = _new(context, visitor, DeviceKind.SCREEN, label, code)
    hashed = context.doors.passwords.hashed(pin)
    _keep(context, visitor, replace(new, patient=patient, pin=hashed))
    return code


def screen_with(context: Context, code: str) -> access.Device | None:
    """Which screen has this code, however it was typed."""
    found = context.store.access.device_with(digest(as_typed(code)))
    return found if found is not None and found.kind == DeviceKind.SCREEN.value else None


def screen_here(context: Context, connection: HTTPConnection) -> access.Device | None:
    """Which screen this browser is, open or not."""
    code = cookie(context, connection, DEVICE_COOKIE)
    return None if code is None else screen_with(context, code)


def _new(
    context: Context, visitor: Visitor, kind: DeviceKind, label: str, token: str
) -> access.Device:
    return access.Device(
        device=secrets.token_hex(_ID_BYTES),
        digest=digest(token),
        kind=kind.value,
        label=label,
        room=None,
        patient=None,
        pin=None,
        account=visitor.account,
        made_ms=now_ms(context),
    )


def _keep(context: Context, visitor: Visitor, device: access.Device) -> None:
    context.store.access.add_device(device)
    audit(context, visitor, Act.DEVICE_MADE, device.patient, device.kind)


def _as_device(found: access.Device) -> Device:
    return Device(
        DeviceId(found.device), DeviceKind(found.kind), found.label, found.room, found.patient
    )
