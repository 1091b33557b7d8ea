"""What the pages of access have in common: faults at fields, and how answers lead on."""

from __future__ import annotations

import math
from http import HTTPStatus
from typing import Annotated, Final

from fastapi import Form
from fastapi.responses import RedirectResponse

from maestra.core.text import faults_of_name
from maestra.web.access.passwords import LEAST_LETTERS, is_weak
from maestra.web.pages import Pages
from maestra.web.problems import TooManyError

MOST_TYPED: Final = 300
"""Letters in a field: names and codes are far shorter, passwords have a limit of their own."""
MOST_OF_NAME: Final = 60
"""Letters of a name, which stands at the top of every page."""

Typed = Annotated[str, Form(max_length=MOST_TYPED)]
Faults = dict[str, str]
"""A line for each field that is wrong."""


def led_to(path: str) -> RedirectResponse:
    """On to another page, by GET."""
    return RedirectResponse(path, 303)


def status_with(faults: object) -> HTTPStatus:
    """Of a page: 422 if something was wrong in the form."""
    return HTTPStatus.UNPROCESSABLE_ENTITY if faults else HTTPStatus.OK


def fault_of_name(pages: Pages, name: str) -> Faults:
    """What is wrong with an account's name."""
    if faults_of_name("name", name) or len(name) > MOST_OF_NAME:
        return {"name": pages.say("Please write a name, of at most 60 letters.")}
    return {}


def fault_of_password(pages: Pages, password: str, name: str) -> Faults:
    """What is wrong with a new password."""
    if is_weak(password, name):
        line = pages.say(
            "Please take at least {count} letters, not all alike, and not your name.",
            count=LEAST_LETTERS,
        )
        return {"password": line}
    return {}


def too_many(pages: Pages, error: TooManyError) -> str:
    """How long to wait, in words."""
    minutes = math.ceil(error.wait_ms / 60_000)
    if minutes == 1:
        return pages.say("Too many tries. Please wait a minute.")
    return pages.say("Too many tries. Please wait {minutes} minutes.", minutes=minutes)
