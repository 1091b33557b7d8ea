"""Somebody's own account: language, password, second factor, where else they are logged in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from http import HTTPStatus
from typing import Annotated, Final

from fastapi import APIRouter, Form, Query, Request
from fastapi.responses import Response

from maestra.language import Language
from maestra.storage.access import Account
from maestra.web.access import logins, second_factor
from maestra.web.access.audit import Act, audit
from maestra.web.access.forms import (
    MOST_TYPED,
    Faults,
    Typed,
    fault_of_password,
    led_to,
    status_with,
    too_many,
)
from maestra.web.access.gate import address_of
from maestra.web.access.guard import Anybody
from maestra.web.access.identity import account_with
from maestra.web.access.logins import LoginKind
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.language_choice import remember
from maestra.web.pages import Page, Pages
from maestra.web.paths import ACCOUNT, HOME, NEW_PASSWORD
from maestra.web.problems import TooManyError

router: Final = APIRouter(include_in_schema=False)

_SECOND_FACTOR: Final = f"{ACCOUNT}/second-factor"


@router.get(ACCOUNT)
def account_page(
    request: Request,
    visitor: Anybody,
    context: Here,
    pages: Page,
    saved: Annotated[str, Query(max_length=MOST_TYPED)] = "",
) -> Response:
    """What somebody can change about their own account."""
    return _page(request, visitor, context, pages, saved=saved)


def _page(
    request: Request,
    visitor: Visitor,
    context: Context,
    pages: Pages,
    faults: Faults | None = None,
    saved: str = "",
) -> Response:
    account = context.store.access.account(visitor.account)
    here = logins.current(context, request, LoginKind.ACCOUNT)
    others = [
        one
        for one in context.store.access.logins(visitor.account)
        if one.kind == LoginKind.ACCOUNT.value and (here is None or one.digest != here.digest)
    ]
    return pages.refusal(
        status_with(faults),
        "access/account.html",
        visitor=visitor,
        account=account,
        others=[logins.moment(one.used_ms) for one in others],
        faults=faults or {},
        saved=saved,
    )


@router.post(f"{ACCOUNT}/language")
def choose_language(
    visitor: Anybody, context: Here, language: Annotated[Language, Form()]
) -> Response:
    """Read in this language wherever they log in."""
    _change(context, visitor, lambda now: replace(now, language=language.value))
    answer = led_to(ACCOUNT)
    remember(answer, language)
    return answer


# ---------------------------------------------------------------- the password


@router.post(f"{ACCOUNT}/password")
def change_password(
    request: Request,
    visitor: Anybody,
    context: Here,
    pages: Page,
    current: Typed = "",
    password: Typed = "",
) -> Response:
    """Change the password; whoever else is logged in with the old one is so no more."""
    faults = _fault_of_current(request, visitor, context, pages, current, "current")
    faults |= fault_of_password(pages, password, visitor.name)
    if faults:
        return _page(request, visitor, context, pages, faults)
    _keep_password(request, visitor, context, password)
    return led_to(f"{ACCOUNT}?saved=password")


@router.get(NEW_PASSWORD)
def new_password_page(visitor: Anybody, pages: Page) -> Response:
    """Ask for a password in place of the one that an administrator made."""
    return pages.page("access/new_password.html", visitor, faults={})


@router.post(NEW_PASSWORD)
def new_password(
    request: Request, visitor: Anybody, context: Here, pages: Page, password: Typed = ""
) -> Response:
    """Keep it. Only in place of one that somebody else made: else the old one is asked for."""
    account = context.store.access.account(visitor.account)
    if account.temporary_until_ms is None:
        return led_to(ACCOUNT)
    faults = fault_of_password(pages, password, visitor.name)
    if context.doors.passwords.matches(account.password, password):
        faults = {"password": pages.say("Please take another one than you were given.")}
    if faults:
        return pages.refusal(
            HTTPStatus.UNPROCESSABLE_ENTITY,
            "access/new_password.html",
            visitor=visitor,
            faults=faults,
        )
    _keep_password(request, visitor, context, password)
    return led_to(HOME)


def _keep_password(request: Request, visitor: Visitor, context: Context, password: str) -> None:
    hashed = context.doors.passwords.hashed(password)
    _change(context, visitor, lambda now: replace(now, password=hashed, temporary_until_ms=None))
    _end_others(request, visitor, context)
    audit(context, visitor, Act.PASSWORD_CHANGED)


# ---------------------------------------------------------------- the second factor


@router.post(f"{_SECOND_FACTOR}/offer")
def offer_second_factor(
    request: Request, visitor: Anybody, context: Here, pages: Page, current: Typed = ""
) -> Response:
    """Make a secret that counts once a code from the telephone has confirmed it."""
    faults = _fault_of_current(request, visitor, context, pages, current, "factor")
    if faults:
        return _page(request, visitor, context, pages, faults)
    secret = second_factor.new_secret()
    _change(context, visitor, lambda now: replace(now, offered_secret=secret))
    return led_to(_SECOND_FACTOR)


@router.get(_SECOND_FACTOR)
def second_factor_page(visitor: Anybody, context: Here, pages: Page) -> Response:
    """Show the secret to the telephone."""
    return _offered(visitor, context, pages, None)


@router.post(_SECOND_FACTOR)
def confirm_second_factor(
    visitor: Anybody, context: Here, pages: Page, code: Typed = ""
) -> Response:
    """Turn it on, if the telephone has the secret."""
    utc = context.clock.utc()
    is_on = False

    def confirm(now: Account) -> Account:
        nonlocal is_on
        offered = now.offered_secret
        step = None if offered is None else second_factor.step_of(offered, code, utc, 0)
        is_on = step is not None
        if step is None:
            return now
        return replace(now, secret=offered, offered_secret=None, last_step=step)

    _change(context, visitor, confirm)
    if not is_on:
        return _offered(visitor, context, pages, pages.say("This code is not right."))
    audit(context, visitor, Act.SECOND_FACTOR_ON)
    return led_to(f"{ACCOUNT}?saved=second-factor")


def _offered(visitor: Visitor, context: Context, pages: Pages, fault: str | None) -> Response:
    offered = context.store.access.account(visitor.account).offered_secret
    if offered is None:
        return led_to(ACCOUNT)
    return pages.refusal(
        status_with(fault),
        "access/second_factor.html",
        visitor=visitor,
        drawing=second_factor.drawing(offered, visitor.name),
        secret=second_factor.in_groups(offered),
        fault=fault,
    )


@router.post(f"{_SECOND_FACTOR}/off")
def second_factor_off(
    request: Request, visitor: Anybody, context: Here, pages: Page, current: Typed = ""
) -> Response:
    """Turn it off, with the password."""
    faults = _fault_of_current(request, visitor, context, pages, current, "factor")
    if faults:
        return _page(request, visitor, context, pages, faults)
    _change(context, visitor, lambda now: replace(now, secret=None, offered_secret=None))
    audit(context, visitor, Act.SECOND_FACTOR_OFF)
    return led_to(f"{ACCOUNT}?saved=second-factor-off")


# ---------------------------------------------------------------- other browsers


@router.post(f"{ACCOUNT}/logins/end")
def end_other_logins(request: Request, visitor: Anybody, context: Here) -> Response:
    """Log out everywhere but here."""
    _end_others(request, visitor, context)
    audit(context, visitor, Act.LOGGED_OUT, detail="elsewhere")
    return led_to(f"{ACCOUNT}?saved=logins")


def _end_others(request: Request, visitor: Visitor, context: Context) -> None:
    here = logins.current(context, request, LoginKind.ACCOUNT)
    context.store.access.end_logins(visitor.account, but="" if here is None else here.digest)


def _fault_of_current(
    request: Request,
    visitor: Visitor,
    context: Context,
    pages: Pages,
    current: str,
    field: str,
) -> Faults:
    """Whether the password that was typed to be sure is theirs; counted as log-ins are."""
    try:
        if account_with(context, visitor.name, current, address_of(request)) is not None:
            return {}
    except TooManyError as error:
        return {field: too_many(pages, error)}
    return {field: pages.say("This is not your password.")}


def _change(context: Context, visitor: Visitor, change: Callable[[Account], Account]) -> None:
    context.store.access.change_account(visitor.account, change)
