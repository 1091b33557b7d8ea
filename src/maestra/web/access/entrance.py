"""The first start, logging in and logging out."""

from __future__ import annotations

from http import HTTPStatus
from typing import Final
from urllib.parse import urlencode

from fastapi import APIRouter, Request
from fastapi.responses import Response

from maestra.core.faults import InvalidError
from maestra.language import Language
from maestra.storage.access import Account
from maestra.web.access import logins
from maestra.web.access.audit import Act, note
from maestra.web.access.forms import (
    Faults,
    Typed,
    fault_of_name,
    fault_of_password,
    led_to,
    too_many,
)
from maestra.web.access.gate import address_of
from maestra.web.access.identity import account_with, count_try, has_code, uncount_try
from maestra.web.access.logins import LoginKind
from maestra.web.access.visitor import Role
from maestra.web.context import Context, Here
from maestra.web.language_choice import remember
from maestra.web.pages import Page, Pages
from maestra.web.paths import CODE, HOME, LOGIN, LOGOUT, SET_UP, is_ours
from maestra.web.problems import TooManyError

router: Final = APIRouter(include_in_schema=False)

_NOBODY_YET: Final = "set-up"
"""The name under which tries of the set-up code are counted."""


# ---------------------------------------------------------------- the first start


@router.get(SET_UP)
def set_up_page(context: Here, pages: Page) -> Response:
    """Ask for the code that the server printed, and for who will be the administrator."""
    if not context.doors.is_set_up_open:
        return led_to(LOGIN)
    return pages.page("access/set_up.html", name="", faults={})


@router.post(SET_UP)
def set_up(
    request: Request,
    context: Here,
    pages: Page,
    code: Typed = "",
    name: Typed = "",
    password: Typed = "",
) -> Response:
    """Make the administrator, and log them in."""
    name = name.strip()
    try:
        with context.doors.setting_up:
            faults = _faults_of_set_up(context, pages, address_of(request), code, name, password)
            if not faults:
                made = _made(context, pages, name, password)
                context.doors.close_set_up()
                note(context, made.account, Act.SET_UP)
                return _logged_in(context, request, made, HOME)
    except TooManyError as error:
        faults = {"code": too_many(pages, error)}
    except InvalidError:
        faults = {"name": pages.say("Somebody else has this name.")}
    return pages.refusal(
        HTTPStatus.UNPROCESSABLE_ENTITY, "access/set_up.html", name=name, faults=faults
    )


def _faults_of_set_up(
    context: Context, pages: Pages, address: str, code: str, name: str, password: str
) -> Faults:
    count_try(context, _NOBODY_YET, address)
    if not context.doors.is_set_up_code(code):
        return {"code": pages.say("This is not the code that the server printed.")}
    uncount_try(context, _NOBODY_YET, address)
    return fault_of_name(pages, name) | fault_of_password(pages, password, name)


def _made(context: Context, pages: Pages, name: str, password: str) -> Account:
    account = Account(
        account="",
        name=name,
        role=Role.ADMINISTRATOR.value,
        language=pages.language.value,
        password=context.doors.passwords.hashed(password),
    )
    return context.store.access.add_account(account)


# ---------------------------------------------------------------- in and out


@router.get(LOGIN)
def login_page(request: Request, context: Here, pages: Page, next: str = HOME) -> Response:  # noqa: A002 - as it stands in addresses
    """Ask who it is; who is logged in already goes on."""
    if context.doors.is_set_up_open and not context.store.access.has_accounts():
        return led_to(SET_UP)
    target = next if is_ours(next) else HOME
    if logins.current(context, request, LoginKind.ACCOUNT) is not None:
        return led_to(target)
    return pages.page("access/login.html", name="", next=target, fault=None)


@router.post(LOGIN)
def login(
    request: Request,
    context: Here,
    pages: Page,
    name: Typed = "",
    password: Typed = "",
    next: Typed = HOME,  # noqa: A002 - the same
) -> Response:
    """Log in, or go on to the second factor."""
    target = next if is_ours(next) else HOME
    try:
        account = account_with(context, name, password, address_of(request))
    except TooManyError as error:
        fault = too_many(pages, error)
        status = HTTPStatus.TOO_MANY_REQUESTS
    else:
        if account is not None:
            return _after_password(context, request, account, target)
        fault = pages.say("Name or password is not right.")
        status = HTTPStatus.UNPROCESSABLE_ENTITY
    return pages.refusal(status, "access/login.html", name=name, next=target, fault=fault)


def _after_password(context: Context, request: Request, account: Account, target: str) -> Response:
    if account.secret is None:
        return _logged_in(context, request, account, target)
    answer = led_to(f"{CODE}?{urlencode({'next': target})}")
    logins.begin(context, answer, LoginKind.HALF, account.account)
    return answer


@router.get(CODE)
def code_page(request: Request, context: Here, pages: Page, next: str = HOME) -> Response:  # noqa: A002 - the same
    """Ask for the code of the second factor."""
    if logins.current(context, request, LoginKind.HALF) is None:
        return led_to(LOGIN)
    return pages.page("access/code.html", next=next if is_ours(next) else HOME, fault=None)


@router.post(CODE)
def code(
    request: Request,
    context: Here,
    pages: Page,
    code: Typed = "",
    next: Typed = HOME,  # noqa: A002 - the same
) -> Response:
    """Log in with the second factor."""
    half = logins.current(context, request, LoginKind.HALF)
    if half is None:
        return led_to(LOGIN)
    target = next if is_ours(next) else HOME
    account = context.store.access.account(half.holder)
    try:
        if has_code(context, account, code, address_of(request)) and not account.is_disabled:
            return _logged_in(context, request, account, target)
    except TooManyError as error:
        fault = too_many(pages, error)
        status = HTTPStatus.TOO_MANY_REQUESTS
    else:
        fault = pages.say("This code is not right, or was used before.")
        status = HTTPStatus.UNPROCESSABLE_ENTITY
    return pages.refusal(status, "access/code.html", next=target, fault=fault)


@router.post(LOGOUT)
def logout(request: Request, context: Here) -> Response:
    """End this login, here and wherever its cookie may be."""
    ended = logins.current(context, request, LoginKind.ACCOUNT)
    answer = led_to(LOGIN)
    logins.end(context, request, answer, LoginKind.ACCOUNT)
    if ended is not None:
        note(context, ended.holder, Act.LOGGED_OUT)
    return answer


def _logged_in(context: Context, request: Request, account: Account, target: str) -> Response:
    answer = led_to(target)
    # What this browser held until now opens nothing any more.
    logins.end(context, request, answer, LoginKind.ACCOUNT)
    logins.begin(context, answer, LoginKind.ACCOUNT, account.account)
    remember(answer, Language(account.language))
    note(context, account.account, Act.LOGGED_IN)
    return answer
