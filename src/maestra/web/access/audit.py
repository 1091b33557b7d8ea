"""What is noted of who did what: reads of patients, log-ins, exports, denials, changes."""

from __future__ import annotations

from enum import Enum
from typing import Final

from starlette.requests import HTTPConnection
from starlette.routing import Route

from maestra.coaching.ports import PatientId
from maestra.web.access.throttle import NO_WAIT, Limit
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context

READ_AGAIN: Final = Limit(1, 5 * 60_000)
"""Reads of one patient by one account: a page that follows a session reads every second."""


class Act(Enum):
    """What was done."""

    SET_UP = "set-up"
    LOGGED_IN = "logged-in"
    LOGGED_OUT = "logged-out"
    LOG_IN_REFUSED = "log-in-refused"
    DENIED = "denied"
    READ = "read"
    CHANGED = "changed"
    EXPORTED = "exported"
    ERASED = "erased"
    ENTRUSTED = "entrusted"
    RELEASED = "released"
    ACCOUNT_MADE = "account-made"
    ACCOUNT_CHANGED = "account-changed"
    PASSWORD_CHANGED = "password-changed"
    SECOND_FACTOR_ON = "second-factor-on"
    SECOND_FACTOR_OFF = "second-factor-off"
    DEVICE_MADE = "device-made"
    DEVICE_REMOVED = "device-removed"
    SCREEN_OPENED = "screen-opened"


def audit(
    context: Context,
    visitor: Visitor | None,
    act: Act,
    patient: PatientId | None = None,
    detail: str = "",
) -> None:
    """Note that `visitor` did something; `detail` holds no secret and no pseudonym."""
    account = None if visitor is None else str(visitor.account)
    note(context, account, act, patient, detail)


def note(
    context: Context,
    account: str | None,
    act: Act,
    patient: PatientId | None = None,
    detail: str = "",
) -> None:
    """The same by the account's id."""
    doors, now = context.doors, context.clock.monotonic()
    limit = {Act.READ: READ_AGAIN, Act.DENIED: doors.limits.noted}.get(act)
    if limit is not None:
        key = f"{account}\0{patient}\0{detail}"
        if doors.throttle.take(f"audit {act.value}", key, limit, now) != NO_WAIT:
            return
    utc = context.clock.utc().isoformat(timespec="seconds")
    context.store.custody.note(utc, account, act.value, patient, detail[:300])


def where(connection: HTTPConnection) -> str:
    """Which page, without what stands in its gaps: a pseudonym may."""
    route = connection.scope.get("route")
    return route.path if isinstance(route, Route) else ""
