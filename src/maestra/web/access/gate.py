"""What is refused before any route sees it: requests from other sites, too many, too large."""

from __future__ import annotations

from typing import Final
from urllib.parse import urlsplit

from fastapi import HTTPException
from starlette.requests import HTTPConnection, Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketClose

from maestra.web.access.throttle import NO_WAIT
from maestra.web.context import Context, context_of
from maestra.web.problems import POLICY_VIOLATION, TooManyError, answer

SAFE_METHODS: Final = frozenset({"GET", "HEAD", "OPTIONS", "TRACE"})
"""Those that change nothing (RFC 9110, 9.2.1)."""
MOST_BYTES: Final = 1024 * 1024
"""Of a form or JSON: the longest lesson is a tenth of it."""
MOST_BYTES_WITH_FILES: Final = 16 * 1024 * 1024
"""Of a form with files: a few photographs of a telephone."""


def is_unsafe(scope: Scope) -> bool:
    """Whether it may change something: also a stream, which then carries what does."""
    return scope["type"] == "websocket" or scope["method"] not in SAFE_METHODS


def is_from_elsewhere(connection: HTTPConnection, *, over_tls: bool) -> bool:
    """Whether a browser was made to ask by another site's page.

    Browsers say so, one way or the other (Fetch Metadata, and Origin with whatever may change
    something). Who sends neither header is a program, which has no cookies to be abused.
    """
    site = connection.headers.get("sec-fetch-site")
    if site not in {None, "same-origin", "none"}:
        return True
    origin = connection.headers.get("origin")
    if origin is None:
        return False
    ours = f"{'https' if over_tls else 'http'}://{connection.headers.get('host', '')}"
    return origin.lower() != ours.lower()


class Gate:
    """Lets through what may come in."""

    def __init__(self, app: ASGIApp, *, with_files: frozenset[str] = frozenset()) -> None:
        """Stand before `app`, the JSON of some of whose paths may carry files."""
        self._app = app
        self._with_files = with_files

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer what is refused; pass on the rest, reading no more than is allowed."""
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        connection = HTTPConnection(scope)
        most = self._most_bytes(connection)
        refused = _refusal(context_of(connection), connection, most)
        if refused is None:
            limited = receive if scope["type"] == "websocket" else _limited(receive, most)
            await self._app(scope, limited, send)
        elif scope["type"] == "websocket":
            await WebSocketClose(POLICY_VIOLATION, str(refused.detail))(scope, receive, send)
        else:
            await answer(Request(scope), refused)(scope, receive, send)

    def _most_bytes(self, connection: HTTPConnection) -> int:
        kind = connection.headers.get("content-type", "")
        with_files = kind.startswith("multipart/form-data")
        with_files = with_files or connection.url.path in self._with_files
        return MOST_BYTES_WITH_FILES if with_files else MOST_BYTES


def _refusal(context: Context, connection: HTTPConnection, most: int) -> HTTPException | None:
    doors = context.doors
    if doors.hosts is not None and _host(connection) not in doors.hosts:
        # A name of another site that leads to this computer (DNS rebinding).
        return HTTPException(421, "this server has another name")
    if not is_unsafe(connection.scope):
        return None
    if is_from_elsewhere(connection, over_tls=context.over_tls):
        return HTTPException(403, "asked by a page of another site")
    limit, now = doors.limits.requests, context.clock.monotonic()
    wait = doors.throttle.take("address", address_of(connection), limit, now)
    if wait != NO_WAIT:
        return TooManyError(wait)
    length = connection.headers.get("content-length", "0")
    if not length.isdigit() or int(length) > most:
        return HTTPException(413, "too large")
    return None


def address_of(connection: HTTPConnection) -> str:
    """From where somebody asks; behind a proxy, as the proxy says."""
    return "" if connection.client is None else connection.client.host


def _host(connection: HTTPConnection) -> str:
    """The name asked for, without the port."""
    parts = urlsplit(f"//{connection.headers.get('host', '')}")
    name = parts.hostname or ""
    return f"[{name}]" if ":" in name else name


def _limited(receive: Receive, most: int) -> Receive:
    """The body, cut off with 413 where it is longer than its sender said or than is allowed."""
    left = most

    async def limited() -> Message:
        nonlocal left
        message = await receive()
        left -= len(message.get("body", b""))
        if left < 0:
            raise HTTPException(413, "too large")
        return message

    return limited
