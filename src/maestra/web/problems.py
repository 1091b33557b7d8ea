"""What is said when something cannot be done: a page to people, JSON to programs."""

from __future__ import annotations

import math
from http import HTTPStatus
from typing import Any, Final, cast
from urllib.parse import urlencode

from fastapi import FastAPI, HTTPException
from fastapi.exceptions import RequestValidationError
from fastapi.responses import HTMLResponse, JSONResponse, RedirectResponse, Response
from pydantic import BaseModel, Field
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException as StarletteHTTPException
from starlette.requests import Request
from starlette.websockets import WebSocketClose

from maestra.coaching.fields import Milliseconds
from maestra.core.faults import InvalidError
from maestra.web.access import logins
from maestra.web.access.present import perhaps
from maestra.web.context import context_of
from maestra.web.headers import HEADERS
from maestra.web.language_choice import language_of
from maestra.web.pages import Pages
from maestra.web.paths import API, HOME, LOGIN, NEW_PASSWORD, SCREEN

PROBLEM_JSON: Final = "application/problem+json"
"""RFC 9457."""
POLICY_VIOLATION: Final = 1008
"""The code with which a stream is closed (RFC 6455, 7.4.1)."""
MOST_SHOWN: Final = 100
"""Letters of what was found that are shown again."""


class FaultFound(BaseModel):
    """What is wrong in what was sent."""

    where: str = Field(description="The field, with dots for what is inside another.")
    found: str
    expected: str


class Problem(BaseModel):
    """Why something was not done."""

    status: int
    title: str
    faults: list[FaultFound] = Field(default=[], description="Each thing that is wrong.")


class TooManyError(HTTPException):
    """Tried too often."""

    def __init__(self, wait: Milliseconds) -> None:
        """Say how long to wait."""
        super().__init__(429, "too many tries", {"Retry-After": str(math.ceil(wait / 1000))})
        self.wait_ms: Milliseconds = wait


class PasswordDueError(HTTPException):
    """The visitor must choose a password of their own first."""

    def __init__(self) -> None:
        """Say so to programs; browsers are led to the page."""
        super().__init__(403, "choose a password of your own first")


def problems(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """For the OpenAPI document: the answers other than success that a route may give."""
    return {
        status: {
            "description": HTTPStatus(status).phrase,
            "content": {PROBLEM_JSON: {"schema": {"$ref": "#/components/schemas/Problem"}}},
            "model": Problem,
        }
        for status in statuses
    }


def install(app: FastAPI) -> None:
    """Have `app` answer so."""
    app.add_exception_handler(StarletteHTTPException, _refused)
    app.add_exception_handler(RequestValidationError, _invalid)
    app.add_exception_handler(InvalidError, _invalid)
    app.add_exception_handler(OSError, _cannot_keep)
    app.add_exception_handler(Exception, _failed)


def answer(
    request: Request, error: StarletteHTTPException, faults: list[FaultFound] | None = None
) -> Response:
    """The answer to a request that cannot be done."""
    if request.url.path.startswith(API):
        problem = Problem(status=error.status_code, title=error.detail, faults=faults or [])
        return JSONResponse(
            problem.model_dump(), error.status_code, error.headers, media_type=PROBLEM_JSON
        )
    pages = Pages(request, language_of(request))
    visitor = getattr(request.state, "visitor", None)
    text = pages.text("access/problem.html", visitor=visitor, status=error.status_code)
    return HTMLResponse(text, error.status_code, error.headers)


async def _refused(request: Request, error: Exception) -> Response:
    if not isinstance(error, StarletteHTTPException):
        raise error
    if request.scope["type"] == "websocket":
        # Before it was accepted this is told as 403; Starlette runs it as any answer.
        return cast("Response", WebSocketClose(POLICY_VIOLATION, error.detail))
    if request.url.path.startswith(API):
        return answer(request, error)
    if error.status_code == HTTPStatus.UNAUTHORIZED:
        return RedirectResponse(_entrance(request), HTTPStatus.SEE_OTHER)
    if error.status_code == HTTPStatus.METHOD_NOT_ALLOWED and request.method == "GET":
        # What a form was sent to, asked for again by a reload: the page stands above it.
        return RedirectResponse(request.url.path.rpartition("/")[0] or HOME, HTTPStatus.SEE_OTHER)
    if isinstance(error, PasswordDueError):
        return RedirectResponse(NEW_PASSWORD, HTTPStatus.SEE_OTHER)
    return await run_in_threadpool(_answer_with_way_on, request, error)


def _answer_with_way_on(request: Request, error: StarletteHTTPException) -> Response:
    """The page, with the way to all others for who is logged in."""
    if getattr(request.state, "visitor", None) is None:
        request.state.visitor = perhaps(request)
    return answer(request, error)


def _entrance(request: Request) -> str:
    """Where to log in, and from there back to the page."""
    if logins.cookie(context_of(request), request, logins.DEVICE_COOKIE) is not None:
        return SCREEN
    if request.method != "GET" or request.url.path == HOME:
        return LOGIN
    path = request.url.path + (f"?{request.url.query}" if request.url.query else "")
    return f"{LOGIN}?{urlencode({'next': path})}"


async def _invalid(request: Request, error: Exception) -> Response:
    faults: list[FaultFound] = []
    if isinstance(error, RequestValidationError):
        faults = [_as_fault(one) for one in error.errors()]
    elif isinstance(error, InvalidError):
        faults = [
            FaultFound(where=one.where, found=one.found, expected=one.expected)
            for one in error.faults
        ]
    refusal = HTTPException(HTTPStatus.UNPROCESSABLE_ENTITY, "not as expected")
    return await run_in_threadpool(answer, request, refusal, faults)


def _as_fault(error: dict[str, Any]) -> FaultFound:
    where = ".".join(str(part) for part in error["loc"][1:])
    found = "nothing" if error["type"] == "missing" else repr(error["input"])[:MOST_SHOWN]
    return FaultFound(where=where, found=found, expected=str(error["msg"]))


async def _cannot_keep(request: Request, _error: Exception) -> Response:
    refusal = HTTPException(HTTPStatus.SERVICE_UNAVAILABLE, "nothing can be kept now")
    return await run_in_threadpool(answer, request, refusal)


async def _failed(request: Request, _error: Exception) -> Response:
    """A fault of ours; this is answered outside of everything that adds headers."""
    refusal = HTTPException(HTTPStatus.INTERNAL_SERVER_ERROR, "a fault of Maestra", dict(HEADERS))
    return await run_in_threadpool(answer, request, refusal)
