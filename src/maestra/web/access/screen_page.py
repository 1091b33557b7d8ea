"""How a browser becomes a patient's screen: with the screen's code once, with its PIN each day."""

from __future__ import annotations

from http import HTTPStatus
from typing import Final

from fastapi import APIRouter, Request
from fastapi.responses import Response

from maestra.storage.access import Device
from maestra.web.access import logins
from maestra.web.access.audit import Act, note
from maestra.web.access.devices import screen_here, screen_with
from maestra.web.access.forms import Typed, led_to, too_many
from maestra.web.access.gate import address_of
from maestra.web.access.identity import count_try, uncount_try
from maestra.web.access.logins import DEVICE_COOKIE, LoginKind
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.paths import PATIENT_PAGE, SCREEN
from maestra.web.problems import TooManyError

router: Final = APIRouter(prefix=SCREEN, include_in_schema=False)

A_SCREEN_STAYS_S: Final = 400 * 24 * 3600
"""As long as browsers keep a cookie at most."""


@router.get("")
def screen_page(request: Request, context: Here, pages: Page) -> Response:
    """Ask for the PIN; in a browser that is no screen yet, also for the code."""
    is_open = logins.current(context, request, LoginKind.SCREEN) is not None
    is_known = screen_here(context, request) is not None
    return pages.page("access/screen.html", is_open=is_open, is_known=is_known, fault=None)


@router.post("")
def open_screen(
    request: Request, context: Here, pages: Page, code: Typed = "", pin: Typed = ""
) -> Response:
    """Open the patient's page."""
    try:
        found = _screen_opened(request, context, code, pin)
    except TooManyError as error:
        return _again(request, context, pages, too_many(pages, error))
    if found is None:
        return _again(request, context, pages, pages.say("Code or PIN is not right."))
    answer = led_to(PATIENT_PAGE)
    # Whoever set the screen up does not leave their own account open on it.
    logins.end(context, request, answer, LoginKind.ACCOUNT)
    logins.end(context, request, answer, LoginKind.SCREEN)
    logins.begin(context, answer, LoginKind.SCREEN, found.device)
    if code:
        logins.set_cookie(context, answer, DEVICE_COOKIE, code, A_SCREEN_STAYS_S)
    note(context, None, Act.SCREEN_OPENED, found.patient)
    return answer


@router.post("/close")
def close_screen(request: Request, context: Here) -> Response:
    """Ask for the PIN again before the patient's page is shown."""
    answer = led_to(SCREEN)
    logins.end(context, request, answer, LoginKind.SCREEN)
    return answer


@router.post("/leave")
def leave(request: Request, context: Here, pages: Page, pin: Typed = "") -> Response:
    """Let this browser be no screen any more, with the PIN."""
    try:
        found = _screen_opened(request, context, "", pin)
    except TooManyError as error:
        return _again(request, context, pages, too_many(pages, error))
    if found is None:
        return _again(request, context, pages, pages.say("Code or PIN is not right."))
    answer = led_to(SCREEN)
    logins.end(context, request, answer, LoginKind.SCREEN)
    logins.drop_cookie(context, answer, DEVICE_COOKIE)
    return answer


def _screen_opened(request: Request, context: Context, code: str, pin: str) -> Device | None:
    """The screen that this browser is, or is to be, if the PIN is right."""
    found = screen_with(context, code) if code else screen_here(context, request)
    address = address_of(request)
    key = "no screen" if found is None else found.device
    count_try(context, key, address)
    kept = None if found is None else found.pin
    if not context.doors.passwords.matches(kept, pin):
        note(context, None, Act.LOG_IN_REFUSED, None if found is None else found.patient, "PIN")
        return None
    uncount_try(context, key, address)
    return found


def _again(request: Request, context: Context, pages: Pages, fault: str) -> Response:
    is_known = screen_here(context, request) is not None
    return pages.refusal(
        HTTPStatus.UNPROCESSABLE_ENTITY,
        "access/screen.html",
        is_open=False,
        is_known=is_known,
        fault=fault,
    )
