"""Being logged in: a random token in a cookie, of which the store keeps the digest."""

from __future__ import annotations

from datetime import UTC, datetime
from enum import Enum
from typing import Final

from starlette.requests import HTTPConnection
from starlette.responses import Response

from maestra.storage.access import Login
from maestra.web.access.passwords import digest, new_token
from maestra.web.context import Context

MINUTE_MS: Final = 60_000
HOUR_MS: Final = 60 * MINUTE_MS
IDLE_MS: Final = 2 * HOUR_MS
"""A session with a patient that is only watched may take that long."""
LONGEST_MS: Final = 12 * HOUR_MS
"""A working day; what was being typed is kept as a draft."""
SECOND_FACTOR_MS: Final = 5 * MINUTE_MS
"""To fetch the telephone and read a code."""
SCREEN_MS: Final = 24 * HOUR_MS
"""A patient's screen: nothing may be lost after 20 hours, and the next day begins with the PIN."""
USED_MS: Final = MINUTE_MS
"""How exactly the last use is kept; more would be a write for each page."""
A_YEAR_S: Final = 365 * 24 * 3600


class LoginKind(Enum):
    """What somebody who is logged in has shown."""

    ACCOUNT = "account"
    """All that is needed."""
    HALF = "half"
    """The password; the code of the second factor is still to come."""
    SCREEN = "screen"
    """A patient's screen, opened with its PIN."""


LIMITS_MS: Final = {
    LoginKind.ACCOUNT: (IDLE_MS, LONGEST_MS),
    LoginKind.HALF: (SECOND_FACTOR_MS, SECOND_FACTOR_MS),
    LoginKind.SCREEN: (SCREEN_MS, SCREEN_MS),
}
"""Each kind ends after so long without use, and after so long in any case."""

_COOKIES: Final = {
    LoginKind.ACCOUNT: "maestra",
    LoginKind.HALF: "maestra",
    LoginKind.SCREEN: "maestra-screen",
}
DEVICE_COOKIE: Final = "maestra-device"
"""Holds the token of a patient's screen: this browser is that screen."""


def now_ms(context: Context) -> int:
    """The time of day: it goes on while the server is off, as limits do."""
    return int(context.clock.utc().timestamp() * 1000)


def begin(context: Context, response: Response, kind: LoginKind, holder: str) -> None:
    """Log somebody in, with a token that nobody had before."""
    token, now = new_token(), now_ms(context)
    context.store.access.add_login(Login(digest(token), kind.value, holder, now, now))
    set_cookie(context, response, _COOKIES[kind], token)
    for one, (idle, longest) in LIMITS_MS.items():
        context.store.access.forget_logins([one.value], now - longest, now - idle)


def current(context: Context, connection: HTTPConnection, kind: LoginKind) -> Login | None:
    """The login of this browser, if it is of this kind and has not ended; it is used by this."""
    token = cookie(context, connection, _COOKIES[kind])
    found = None if token is None else context.store.access.login(digest(token))
    if found is None or found.kind != kind.value:
        return None
    now, (idle, longest) = now_ms(context), LIMITS_MS[kind]
    if now - found.used_ms > idle or now - found.begun_ms > longest:
        context.store.access.end_login(found.digest)
        return None
    if now - found.used_ms > USED_MS:
        context.store.access.use_login(found.digest, now)
    return found


def end(context: Context, connection: HTTPConnection, response: Response, kind: LoginKind) -> None:
    """Log this browser out: its token opens nothing any more, wherever it is."""
    token = cookie(context, connection, _COOKIES[kind])
    if token is not None:
        context.store.access.end_login(digest(token))
    drop_cookie(context, response, _COOKIES[kind])


def cookie(context: Context, connection: HTTPConnection, name: str) -> str | None:
    """What this browser holds under a name of ours."""
    return connection.cookies.get(_full(context, name))


def set_cookie(
    context: Context, response: Response, name: str, value: str, max_age_s: int | None = None
) -> None:
    """Have the browser hold it, for this server alone and for no script."""
    response.set_cookie(
        _full(context, name),
        value,
        max_age=max_age_s,
        path="/",
        secure=context.over_tls,
        httponly=True,
        samesite="strict",
    )


def drop_cookie(context: Context, response: Response, name: str) -> None:
    """Have the browser forget it."""
    response.delete_cookie(
        _full(context, name),
        path="/",
        secure=context.over_tls,
        httponly=True,
        samesite="strict",
    )


def _full(context: Context, name: str) -> str:
    """Over TLS with the prefix that keeps other hosts and plain HTTP from setting it.

    It is RFC 6265bis's; browsers refuse it without TLS.
    """
    return f"__Host-{name}" if context.over_tls else name


def moment(at_ms: int) -> datetime:
    """A moment as it is kept, as a page shows it."""
    return datetime.fromtimestamp(at_ms / 1000, UTC)
