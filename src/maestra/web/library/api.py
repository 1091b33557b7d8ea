"""Exercises for programs: list, read, bring in, save, take away and put back."""

from __future__ import annotations

from datetime import datetime
from http import HTTPStatus
from typing import Annotated, Any, Final

from fastapi import APIRouter, HTTPException, Path, Query, Request
from fastapi.responses import Response
from pydantic import BaseModel, Field
from starlette.concurrency import run_in_threadpool

from maestra.core.faults import InvalidError
from maestra.language import Language
from maestra.rules.exercise import RuledExercise
from maestra.rules.exercise_format import EXERCISE_FORMAT
from maestra.web.library.collection import MOST_SEARCHED, Collection, ExerciseId, Item
from maestra.web.library.desk import AtDesk, Desk
from maestra.web.library.files import (
    ENDING,
    MOST_BYTES,
    MOST_BYTES_BESIDES,
    MOST_TITLE,
    attached,
    pddl_archive,
)
from maestra.web.library.routes import MOST_VERSIONS
from maestra.web.problems import problems

router: Final = APIRouter(prefix="/api/exercises", tags=["exercises"])
WITH_PICTURES: Final = frozenset({router.prefix})
"""Paths whose JSON may be as long as a form with files. It is read when its sender is known."""

_ID: Final = r"^[0-9a-f]{16}$"
Wanted = Annotated[
    str, Path(pattern=_ID, description="The exercise's `id`.", examples=["0123456789abcdef"])
]
Version = Annotated[
    int | None,
    Query(ge=1, le=MOST_VERSIONS, description="Which version; the newest if it is left out."),
]
InLanguage = Annotated[
    Language | None,
    Query(description="In which language it is said; else as the request prefers."),
]


class RuleSaid(BaseModel):
    """A rule in words."""

    id: str = Field(description="A stable name.")
    text: str


class ExerciseSaid(BaseModel):
    """A version of an exercise."""

    id: str = Field(description="What addresses call it.", pattern=_ID)
    name: str = Field(description="What the record and the commands call it.")
    title: str = Field(description="What people call it.")
    version: int = Field(description="From 1.")
    status: str | None = Field(
        description="What learning came to, as in the exercise's file; `null` if it is made of "
        "actions, or cannot be read."
    )
    confidence: float | None = Field(description="How likely it is that just this is meant.")
    rules: list[RuleSaid]
    demonstrations: int = Field(description="How many were shown.")
    answers: int = Field(description="How many questions were answered.")
    agreed: int | None = Field(description="In how many plays of the last exam you agreed.")
    examined: int | None = Field(description="How many plays the last exam had.")
    origin: str | None = Field(
        description="`taught`, `imported`, `copied`, `paper` or `included`; `null` if unknown."
    )
    by: str | None = Field(description="Whose doing it was, if they still have an account.")
    at: datetime | None = Field(description="When.")


class ExercisesSaid(BaseModel):
    """What is in the library."""

    exercises: list[ExerciseSaid]


class ExerciseVersions(ExerciseSaid):
    """The newest version of an exercise, and those before it."""

    earlier: list[ExerciseSaid] = Field(description="The last one first.")


class Kept(BaseModel):
    """What was kept."""

    id: str = Field(pattern=_ID)
    name: str
    version: int


_FILE: Final[dict[str, Any]] = {
    "description": f"The exercise's file, `{EXERCISE_FORMAT}`.",
    "content": {"application/json": {"schema": {"type": "object"}}},
}
_ARCHIVE: Final[dict[str, Any]] = {
    "description": "A zip with `domain.pddl`, `problem.pddl` and `exercise.json`.",
    "content": {"application/zip": {"schema": {"type": "string", "format": "binary"}}},
}
_BODY: Final[dict[str, Any]] = {
    "requestBody": {
        "description": f"An exercise's file, `{EXERCISE_FORMAT}`, of at most "
        f"{MOST_BYTES // 1024} kB, {MOST_BYTES_BESIDES // 1024} kB without its pictures; "
        "docs/schemas has its JSON Schema.",
        "required": True,
        "content": {"application/json": {"schema": {"type": "object"}}},
    }
}


@router.get("")
def exercises(
    desk: AtDesk,
    search: Annotated[
        str, Query(max_length=MOST_SEARCHED, description="Words that must all be said of it.")
    ] = "",
    language: InLanguage = None,
) -> ExercisesSaid:
    """All exercises of the library, or those that match."""
    items = _collection(desk, language).items(search)
    return ExercisesSaid(exercises=[_said(one) for one in items])


@router.get("/{exercise}", responses=problems(404))
def one_exercise(desk: AtDesk, exercise: Wanted, language: InLanguage = None) -> ExerciseVersions:
    """One exercise with all its versions, also one that was removed."""
    desk.name(exercise)
    newest, *earlier = _collection(desk, language).versions(ExerciseId(exercise))
    said = _said(newest).model_dump()
    return ExerciseVersions(**said, earlier=[_said(one) for one in earlier])


@router.get("/{exercise}/file", responses={200: _FILE, **problems(404)}, response_class=Response)
def exercise_file(desk: AtDesk, exercise: Wanted, version: Version = None) -> Response:
    """The exercise's file."""
    item = desk.item(exercise, version)
    headers = attached(item.title, ENDING)
    return Response(desk.file(item), media_type="application/json", headers=headers)


@router.get(
    "/{exercise}/pddl", responses={200: _ARCHIVE, **problems(404, 409)}, response_class=Response
)
def exercise_pddl(desk: AtDesk, exercise: Wanted, version: Version = None) -> Response:
    """The exercise for planners; 409 if preconditions of single cells cannot say its rules."""
    item = desk.item(exercise, version)
    try:
        archive = pddl_archive(desk.text(item))
    except InvalidError as error:
        raise HTTPException(HTTPStatus.CONFLICT, str(error)) from None
    return Response(archive, media_type="application/zip", headers=attached(item.title, ".zip"))


@router.post("", status_code=HTTPStatus.CREATED, responses=problems(413, 422), openapi_extra=_BODY)
async def bring_in(
    desk: AtDesk,
    request: Request,
    title: Annotated[
        str,
        Query(max_length=MOST_TITLE, description="What to call it; a number is added if need be."),
    ] = "",
) -> Kept:
    """Keep the exercise that is sent."""
    content = await request.body()
    return await run_in_threadpool(_kept, desk, content, title)


@router.delete("/{exercise}", status_code=HTTPStatus.NO_CONTENT, responses=problems(404))
def remove(desk: AtDesk, exercise: Wanted) -> None:
    """Take it from the library; its versions are kept for the sessions played with it."""
    desk.changes.remove(desk.name(exercise))


@router.post("/{exercise}/return", status_code=HTTPStatus.NO_CONTENT, responses=problems(404))
def restore(desk: AtDesk, exercise: Wanted) -> None:
    """Put it back."""
    desk.changes.restore(desk.name(exercise))


def _kept(desk: Desk, content: bytes, title: str) -> Kept:
    made = desk.item(desk.changes.bring_in(content, "exercise", title))
    return Kept(id=made.id, name=made.name, version=made.version)


def _collection(desk: Desk, language: Language | None) -> Collection:
    return Collection(desk.context.store, language or desk.pages.language)


def _said(item: Item) -> ExerciseSaid:
    exam = item.learned.exam
    ruled = item.exercise if isinstance(item.exercise, RuledExercise) else None
    return ExerciseSaid(
        id=item.id,
        name=item.name,
        title=item.title,
        version=item.version,
        status=ruled.status.value if ruled else None,
        confidence=ruled.confidence if ruled else None,
        rules=[RuleSaid(id=one.id, text=one.text) for one in item.sentences],
        demonstrations=item.learned.demonstrations,
        answers=item.learned.answers,
        agreed=exam[0] if exam else None,
        examined=exam[1] if exam else None,
        origin=item.origin.value if item.origin else None,
        by=item.by,
        at=item.at,
    )
