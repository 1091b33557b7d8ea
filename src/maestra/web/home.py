"""The first page: what somebody can do here."""

from __future__ import annotations

from typing import Final

from fastapi import APIRouter
from fastapi.responses import HTMLResponse

from maestra.web.access.guard import Anybody
from maestra.web.pages import Page

router: Final = APIRouter(include_in_schema=False)


@router.get("/")
def home(visitor: Anybody, pages: Page) -> HTMLResponse:
    """What the visitor's role lets them do."""
    return pages.page("home.html", visitor)
