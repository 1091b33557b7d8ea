"""Accounts as administrators see them: make, disable, give a new password, entrust patients."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Final

from fastapi import APIRouter, Form, HTTPException
from fastapi.responses import Response

from maestra.coaching.ports import PatientId
from maestra.core.faults import InvalidError
from maestra.storage.access import Account
from maestra.web.access.audit import Act, audit
from maestra.web.access.forms import Faults, Typed, fault_of_name, led_to, status_with
from maestra.web.access.guard import Administering
from maestra.web.access.logins import HOUR_MS, now_ms
from maestra.web.access.passwords import new_code
from maestra.web.access.visitor import Role, Visitor
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages

router: Final = APIRouter(prefix="/accounts", include_in_schema=False)

TEMPORARY_MS: Final = 7 * 24 * HOUR_MS
"""How long a password counts that an administrator made: to be handed over within a week."""
MOST_PATIENTS: Final = 10_000
"""Ticked in one form."""


@router.get("")
def accounts_page(visitor: Administering, context: Here, pages: Page) -> Response:
    """All accounts, and a form for another one."""
    return _page(visitor, context, pages, "", {})


def _page(visitor: Visitor, context: Context, pages: Pages, name: str, faults: Faults) -> Response:
    return pages.refusal(
        status_with(faults),
        "access/accounts.html",
        visitor=visitor,
        accounts=context.store.access.accounts(),
        roles=tuple(Role),
        name=name,
        faults=faults,
    )


@router.post("")
def make(
    visitor: Administering,
    context: Here,
    pages: Page,
    role: Annotated[Role, Form()],
    name: Typed = "",
) -> Response:
    """Make an account with a password that its owner replaces; it is shown once, on this page."""
    name = name.strip()
    faults = fault_of_name(pages, name)
    password = new_code()
    if not faults:
        account = Account(
            account="",
            name=name,
            role=role.value,
            language=pages.language.value,
            password=context.doors.passwords.hashed(password),
            temporary_until_ms=now_ms(context) + TEMPORARY_MS,
        )
        try:
            made = context.store.access.add_account(account)
        except InvalidError:
            faults = {"name": pages.say("Somebody else has this name.")}
        else:
            audit(context, visitor, Act.ACCOUNT_MADE, detail=f"{made.name}, {role.value}")
            return pages.page("access/handed_over.html", visitor, name=name, password=password)
    return _page(visitor, context, pages, name, faults)


@router.get("/{account}")
def one_page(account: str, visitor: Administering, context: Here, pages: Page) -> Response:
    """One account."""
    found = _demanded(context, account)
    return pages.page(
        "access/one_account.html",
        visitor,
        account=found,
        roles=tuple(Role),
        patients=context.store.patients(),
        own=frozenset(context.store.custody.patients_of(account)),
    )


@router.post("/{account}/role")
def change_role(
    account: str, visitor: Administering, context: Here, role: Annotated[Role, Form()]
) -> Response:
    """Give another role. Not to oneself: so there is always an administrator left."""
    found = _demanded_other(context, visitor, account)
    context.store.access.change_account(account, lambda now: replace(now, role=role.value))
    audit(context, visitor, Act.ACCOUNT_CHANGED, detail=f"{found.name}, {role.value}")
    return led_to(f"/accounts/{account}")


@router.post("/{account}/disable")
def disable(account: str, visitor: Administering, context: Here) -> Response:
    """Let nobody log in with it, and log out who is. Can be undone."""
    found = _demanded_other(context, visitor, account)
    context.store.access.change_account(account, lambda now: replace(now, is_disabled=True))
    context.store.access.end_logins(account)
    audit(context, visitor, Act.ACCOUNT_CHANGED, detail=f"{found.name}, disabled")
    return led_to(f"/accounts/{account}")


@router.post("/{account}/enable")
def enable(account: str, visitor: Administering, context: Here) -> Response:
    """Let its owner log in again."""
    found = _demanded_other(context, visitor, account)
    context.store.access.change_account(account, lambda now: replace(now, is_disabled=False))
    audit(context, visitor, Act.ACCOUNT_CHANGED, detail=f"{found.name}, enabled")
    return led_to(f"/accounts/{account}")


@router.post("/{account}/reset")
def reset(account: str, visitor: Administering, context: Here, pages: Page) -> Response:
    """Make a new password for somebody who forgot theirs, and turn off their second factor."""
    found = _demanded_other(context, visitor, account)
    password = new_code()
    hashed = context.doors.passwords.hashed(password)
    until = now_ms(context) + TEMPORARY_MS

    def renewed(now: Account) -> Account:
        return replace(
            now, password=hashed, temporary_until_ms=until, secret=None, offered_secret=None
        )

    context.store.access.change_account(account, renewed)
    context.store.access.end_logins(account)
    audit(context, visitor, Act.ACCOUNT_CHANGED, detail=f"{found.name}, new password")
    return pages.page("access/handed_over.html", visitor, name=found.name, password=password)


@router.post("/{account}/patients")
def entrust(
    account: str,
    visitor: Administering,
    context: Here,
    patient: Annotated[list[str], Form(max_length=MOST_PATIENTS)] = [],  # noqa: B006 - FastAPI copies
) -> Response:
    """Say for whom they care."""
    _demanded(context, account)
    custody = context.store.custody
    wanted, before = {PatientId(one) for one in patient}, set(custody.patients_of(account))
    for one in (wanted - before) & set(context.store.patients()):
        custody.entrust(one, account)
        audit(context, visitor, Act.ENTRUSTED, one)
    for one in before - wanted:
        custody.release(one, account)
        audit(context, visitor, Act.RELEASED, one)
    return led_to(f"/accounts/{account}")


def _demanded(context: Context, account: str) -> Account:
    try:
        return context.store.access.account(account)
    except KeyError:
        raise HTTPException(404, "no such account") from None


def _demanded_other(context: Context, visitor: Visitor, account: str) -> Account:
    if account == visitor.account:
        raise HTTPException(403, "not to one's own account")
    return _demanded(context, account)
