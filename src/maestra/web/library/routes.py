"""The library's pages."""

from __future__ import annotations

from http import HTTPStatus
from typing import Annotated, Final
from urllib.parse import urlencode

from fastapi import APIRouter, File, Form, HTTPException, Path, Query, UploadFile
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.core.faults import InvalidError
from maestra.core.text import MAX_TEXT
from maestra.language import Language
from maestra.web.library.collection import MOST_SEARCHED, ExerciseId
from maestra.web.library.desk import AtDesk
from maestra.web.library.files import (
    ENDING,
    MOST_BYTES,
    attached,
    lines_of,
    pddl_archive,
    title_of,
)
from maestra.web.library.thumbnails import rule_picture, thumbnail

router: Final = APIRouter(prefix="/library", include_in_schema=False)

MOST_TYPED: Final = 300
"""Letters of a field; what is longer is no title."""
MOST_VERSIONS: Final = 2**31 - 1
"""What the database counts to."""

Wanted = Annotated[str, Path(max_length=32)]
Version = Annotated[int | None, Query(ge=1, le=MOST_VERSIONS)]


@router.get("")
def library(
    desk: AtDesk,
    search: Annotated[str, Query(max_length=MOST_SEARCHED)] = "",
    removed: Annotated[str, Query(max_length=32)] = "",
) -> HTMLResponse:
    """All exercises, or those that match; after a removal, with a way back."""
    return desk.list(search, removed)


@router.post("/files")
def bring_in(desk: AtDesk, file: Annotated[UploadFile, File()]) -> Response:
    """Keep the exercise in a file."""
    name = file.filename or "-"
    try:
        made = desk.changes.bring_in(file.file.read(MOST_BYTES + 1), name)
    except InvalidError as error:
        return _refused(desk.list(file=title_of(name) or name, faults=lines_of(error)))
    return _led_to(made)


@router.get("/{wanted}")
def exercise(desk: AtDesk, wanted: Wanted, version: Version = None) -> HTMLResponse:
    """One exercise: its rules, where it comes from, its versions, and what can be done."""
    return desk.one(wanted, version)


@router.post("/{wanted}/title")
def retitle(
    desk: AtDesk, wanted: Wanted, title: Annotated[str, Form(max_length=MOST_TYPED)] = ""
) -> Response:
    """Call it so."""
    try:
        desk.changes.retitle(desk.name(wanted), title)
    except InvalidError as error:
        say = desk.pages.say
        is_taken = any(fault.found == "taken" for fault in error.faults)
        fault = (
            say("Another exercise has this name.")
            if is_taken
            else say("Please write a name, of at most 100 letters.")
        )
        return _refused(desk.one(wanted, typed=title, fault=fault))
    return _led_to(ExerciseId(wanted))


@router.post("/{wanted}/copy")
def duplicate(desk: AtDesk, wanted: Wanted) -> Response:
    """Keep it once more, to be changed."""
    latest = desk.item(wanted)
    return _led_to(desk.changes.duplicate(latest.name, latest.title))


@router.post("/{wanted}/again")
def go_back(
    desk: AtDesk, wanted: Wanted, version: Annotated[int, Form(ge=1, le=MOST_VERSIONS)]
) -> Response:
    """Make an earlier version the newest."""
    earlier = desk.item(wanted, version)
    desk.changes.go_back(earlier.name, earlier.version)
    return _led_to(earlier.id)


@router.post("/{wanted}/removal")
def remove(desk: AtDesk, wanted: Wanted) -> Response:
    """Take it from the library."""
    desk.changes.remove(desk.name(wanted))
    return RedirectResponse(f"/library?{urlencode({'removed': wanted})}", HTTPStatus.SEE_OTHER)


@router.post("/{wanted}/return")
def restore(desk: AtDesk, wanted: Wanted) -> Response:
    """Put it back."""
    desk.changes.restore(desk.name(wanted))
    return _led_to(ExerciseId(wanted))


@router.get("/{wanted}/file")
def save_file(desk: AtDesk, wanted: Wanted, version: Version = None) -> Response:
    """The exercise as a file, to keep or to share."""
    item = desk.item(wanted, version)
    headers = attached(item.title, ENDING)
    return Response(desk.file(item), media_type="application/json", headers=headers)


@router.get("/{wanted}/picture")
def picture(
    desk: AtDesk,
    wanted: Wanted,
    version: Version = None,
    language: Language = Language.EN,
    rule: Annotated[str, Query(max_length=MAX_TEXT)] = "",
) -> Response:
    """The exercise's board with what is right there, or one of its rules."""
    text = desk.text(desk.item(wanted, version))
    try:
        drawing = rule_picture(text, rule, language) if rule else thumbnail(text, language)
    except KeyError:
        raise HTTPException(HTTPStatus.NOT_FOUND, "no such rule") from None
    # A version never changes, so its drawing changes with the program alone.
    headers = {"Cache-Control": "private, max-age=86400"}
    return Response(drawing, media_type="image/svg+xml", headers=headers)


@router.get("/{wanted}/pddl")
def save_pddl(desk: AtDesk, wanted: Wanted, version: Version = None) -> Response:
    """The exercise as PDDL for planners, if preconditions can say it."""
    item = desk.item(wanted, version)
    try:
        archive = pddl_archive(desk.text(item))
    except InvalidError as error:
        return _refused(desk.one(wanted, version, no_pddl=lines_of(error)))
    return Response(archive, media_type="application/zip", headers=attached(item.title, ".zip"))


def _refused(page: HTMLResponse) -> HTMLResponse:
    page.status_code = HTTPStatus.UNPROCESSABLE_ENTITY
    return page


def _led_to(wanted: ExerciseId) -> RedirectResponse:
    return RedirectResponse(f"/library/{wanted}", HTTPStatus.SEE_OTHER)
