"""In which language a visitor reads: as chosen, else as their browser asks, else English."""

from __future__ import annotations

from typing import Annotated, Final

from fastapi import APIRouter, Form
from fastapi.responses import RedirectResponse, Response
from starlette.requests import HTTPConnection

from maestra.language import Language
from maestra.web.paths import HOME, is_ours

COOKIE: Final = "maestra-language"
A_YEAR_S: Final = 365 * 24 * 3600

router: Final = APIRouter(include_in_schema=False)


def language_of(connection: HTTPConnection) -> Language:
    """The language for this visitor."""
    wanted = [connection.cookies.get(COOKIE, "")]
    # Browsers list what is liked best first; weights would hardly ever change the order.
    accepted = connection.headers.get("accept-language", "")
    wanted += [part.split(";")[0].strip()[:2].lower() for part in accepted.split(",")]
    known = {one.value: one for one in Language}
    return next((known[code] for code in wanted if code in known), Language.EN)


@router.post("/language")
def choose(
    language: Annotated[Language, Form()], back: Annotated[str, Form(max_length=300)] = "/"
) -> RedirectResponse:
    """Read in another language from now on, on the same page."""
    answer = RedirectResponse(back if is_ours(back) else HOME, 303)
    remember(answer, language)
    return answer


def remember(answer: Response, language: Language) -> None:
    """Have the browser say next time that this language was chosen."""
    answer.set_cookie(COOKIE, language.value, max_age=A_YEAR_S, httponly=True, samesite="strict")
