"""What a route demands of its visitor, as FastAPI's dependencies."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Final

from fastapi import Depends, HTTPException
from starlette.requests import HTTPConnection

from maestra.web.access.audit import Act, audit, where
from maestra.web.access.gate import is_unsafe
from maestra.web.access.present import account_of, as_visitor
from maestra.web.access.throttle import NO_WAIT
from maestra.web.access.visitor import Right, Visitor
from maestra.web.context import context_of
from maestra.web.paths import LOGOUT, NEW_PASSWORD
from maestra.web.problems import PasswordDueError, TooManyError

_WITHOUT_OWN_PASSWORD: Final = frozenset({NEW_PASSWORD, LOGOUT})
"""What can be done before a password that somebody else made has been replaced."""


def visitor_of(connection: HTTPConnection) -> Visitor:
    """Who is logged in.

    Raises:
        HTTPException: 401, nobody is; 403, they must choose a password first; 429, too much.
    """
    context = context_of(connection)
    account = account_of(context, connection)
    if account is None:
        raise HTTPException(401, "nobody is logged in")
    is_due = account.temporary_until_ms is not None
    if is_due and connection.url.path not in _WITHOUT_OWN_PASSWORD:
        raise PasswordDueError
    visitor = as_visitor(account)
    # For the page that says what went wrong.
    connection.state.visitor = visitor
    if is_unsafe(connection.scope):
        limit, now = context.doors.limits.requests, context.clock.monotonic()
        wait = context.doors.throttle.take("account", visitor.account, limit, now)
        if wait != NO_WAIT:
            raise TooManyError(wait)
    return visitor


def needs(*rights: Right) -> Callable[[HTTPConnection, Visitor], Visitor]:
    """The visitor, if their role gives one of `rights`; else 403."""

    def allowed(
        connection: HTTPConnection, visitor: Annotated[Visitor, Depends(visitor_of)]
    ) -> Visitor:
        if not any(visitor.may(right) for right in rights):
            audit(context_of(connection), visitor, Act.DENIED, detail=where(connection))
            wanted = " or ".join(right.value for right in rights)
            raise HTTPException(403, f"a {visitor.role.value} may not {wanted}")
        return visitor

    return allowed


Anybody = Annotated[Visitor, Depends(visitor_of)]
Teaching = Annotated[Visitor, Depends(needs(Right.TEACH))]
Accompanying = Annotated[Visitor, Depends(needs(Right.ACCOMPANY))]
Following = Annotated[Visitor, Depends(needs(Right.ACCOMPANY, Right.STUDY))]
"""Who may see progress: of their own patients, or of all by pseudonym."""
Administering = Annotated[Visitor, Depends(needs(Right.ADMINISTER))]
