"""The help: one page in each language, the same for everybody, also before logging in."""

from __future__ import annotations

from typing import Final

from fastapi import APIRouter, Request
from fastapi.responses import HTMLResponse

from maestra.web.access.present import perhaps
from maestra.web.pages import Page

router: Final = APIRouter(include_in_schema=False)


@router.get("/help")
def help_page(request: Request, pages: Page) -> HTMLResponse:
    """How to teach, how to set up a patient, how to lead a session."""
    return pages.page(f"help/{pages.language.value}.html", perhaps(request))
