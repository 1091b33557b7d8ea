"""The page of devices: make a token, see what there is, revoke it."""

from __future__ import annotations

import re
from typing import Annotated, Final, Literal

from fastapi import APIRouter, Form, HTTPException
from fastapi.responses import Response

from maestra.coaching.ports import PatientId
from maestra.core.text import faults_of_name
from maestra.storage.access import Device
from maestra.web.access.audit import Act, audit
from maestra.web.access.devices import DeviceKind, make_program, make_screen
from maestra.web.access.forms import Faults, Typed, led_to, status_with
from maestra.web.access.guard import Accompanying, Administering
from maestra.web.access.logins import moment
from maestra.web.access.ownership import patients_of, sees_patient
from maestra.web.access.visitor import Right, Visitor
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.rooms.stage import ROOM_PATTERN

router: Final = APIRouter(prefix="/devices", include_in_schema=False)

LEAST_DIGITS: Final = 4
MOST_DIGITS: Final = 8
"""Of a PIN: it only counts on the screen that has the code, and few tries are let through."""
MOST_OF_LABEL: Final = 60
"""Letters of a device's name or a room's."""


@router.get("")
def devices_page(visitor: Accompanying, context: Here, pages: Page) -> Response:
    """The visitor's devices, and forms for more."""
    return _page(visitor, context, pages, {})


def _page(visitor: Visitor, context: Context, pages: Pages, faults: Faults) -> Response:
    return pages.refusal(
        status_with(faults),
        "access/devices.html",
        visitor=visitor,
        devices=[
            one for one in context.store.access.devices() if _is_theirs(context, visitor, one)
        ],
        patients=patients_of(context, visitor),
        moment=moment,
        faults=faults,
    )


@router.post("/screens")
def make_a_screen(
    visitor: Accompanying,
    context: Here,
    pages: Page,
    patient: Typed = "",
    label: Typed = "",
    pin: Typed = "",
) -> Response:
    """Make a screen for one patient; its code is shown once, on this page."""
    faults = _fault_of_label(pages, label, "screen_label")
    if not sees_patient(context, visitor, PatientId(patient)):
        faults["patient"] = pages.say("Please choose one of your patients.")
    if not (pin.isascii() and pin.isdigit() and LEAST_DIGITS <= len(pin) <= MOST_DIGITS):
        faults["pin"] = pages.say("Please take 4 to 8 digits.")
    if faults:
        return _page(visitor, context, pages, faults)
    code = make_screen(context, visitor, label, PatientId(patient), pin)
    return pages.page("access/device_made.html", visitor, label=label, code=code, token=None)


@router.post("/programs")
def make_a_program(
    visitor: Administering,
    context: Here,
    pages: Page,
    kind: Annotated[Literal["board", "robot"], Form()],
    label: Typed = "",
    room: Typed = "",
) -> Response:
    """Make a token for a board or a robot; it is shown once, on this page."""
    faults, room = _fault_of_label(pages, label, "label"), room.strip().lower()
    if re.fullmatch(ROOM_PATTERN, room) is None:
        faults["room"] = pages.say("Please write a short name: letters from a to z, and digits.")
    if faults:
        return _page(visitor, context, pages, faults)
    token = make_program(context, visitor, DeviceKind(kind), label, room)
    return pages.page("access/device_made.html", visitor, label=label, code=None, token=token)


@router.post("/{device}/remove")
def remove(device: str, visitor: Accompanying, context: Here) -> Response:
    """Revoke: its token opens nothing from now on."""
    found = context.store.access.device(device)
    if found is None or not _is_theirs(context, visitor, found):
        raise HTTPException(404, "no such device")
    context.store.access.remove_device(device)
    audit(context, visitor, Act.DEVICE_REMOVED, found.patient, found.kind)
    return led_to("/devices")


def _is_theirs(context: Context, visitor: Visitor, device: Device) -> bool:
    """Administrators see all; caregivers the screens of their patients."""
    if visitor.may(Right.ADMINISTER):
        return True
    return device.patient is not None and sees_patient(context, visitor, device.patient)


def _fault_of_label(pages: Pages, text: str, field: str) -> Faults:
    if faults_of_name("label", text.strip()) or len(text) > MOST_OF_LABEL:
        return {field: pages.say("Please write a name, of at most 60 letters.")}
    return {}
