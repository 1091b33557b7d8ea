"""Progress, sessions and exports for programs."""

from __future__ import annotations

import json
from typing import Annotated, Any, Final

from fastapi import APIRouter, Path, Query
from fastapi.responses import StreamingResponse
from pydantic import BaseModel, Field

from maestra.coaching.ports import PatientId, StoredSession
from maestra.coaching.progress import ExerciseProgress, SessionProgress, Trend
from maestra.web.access.audit import Act, audit
from maestra.web.access.guard import Following
from maestra.web.access.ownership import demand_patient, patients_of
from maestra.web.context import Here
from maestra.web.patients.addresses import MOST_IN_ADDRESS
from maestra.web.patients.whose import Followed
from maestra.web.progress.exporting import Form, exported, pieces
from maestra.web.progress.figures import figures
from maestra.web.progress.routes import stored_session

router: Final = APIRouter(prefix="/api", tags=["progress"])

Share = Annotated[float, Field(ge=0, le=1)]


class SessionFigures(BaseModel):
    """One session in figures."""

    session: str
    begun_utc: str
    completed: bool
    steps: int
    first_attempts: Annotated[int, Field(description="Steps right without a refused attempt.")]
    refused: int
    reactions_ms: list[int]
    assistance: Annotated[float | None, Field(description="Mean level of help, 0 to 5.")]
    lasted_ms: int


class ExerciseFigures(BaseModel):
    """All sessions of one exercise, the earliest first, and what they come to."""

    exercise: str
    completion: Share
    first_attempt_share: Share | None
    reaction_ms: Annotated[float | None, Field(description="The median.")]
    assistance: float | None
    trends: Annotated[
        dict[str, Trend], Field(description="Of first_attempts, reaction and assistance.")
    ]
    sessions: list[SessionFigures]


class ProgressJson(BaseModel):
    """How a patient gets on."""

    patient: str
    exercises: list[ExerciseFigures]


class SessionJson(BaseModel):
    """A session that was played or is under way."""

    session: str
    exercise: str
    version: int
    begun_utc: str
    ended_utc: str | None


class RecordedJson(SessionJson):
    """The same with everything that happened."""

    events: Annotated[
        list[dict[str, Any]],
        Field(description="The start, each event, and the commands that it led to."),
    ]


@router.get("/patients/{pseudonym}/progress")
def progress(patient: Followed, context: Here) -> ProgressJson:
    """How a patient gets on, exercise by exercise."""
    found = figures(context.store, patient)
    return ProgressJson(patient=patient, exercises=[_exercise(one) for one in found])


@router.get("/patients/{pseudonym}/sessions")
def sessions(patient: Followed, context: Here) -> list[SessionJson]:
    """A patient's sessions, the earliest first."""
    return [SessionJson(**_session(one)) for one in context.store.sessions(patient)]


@router.get("/patients/{pseudonym}/sessions/{session}")
def session(
    patient: Followed,
    context: Here,
    session: Annotated[str, Path(max_length=MOST_IN_ADDRESS)],
) -> RecordedJson:
    """A session, event by event."""
    found = stored_session(context, patient, session)
    events: list[dict[str, Any]] = [
        {"kind": one.kind, "at_ms": one.at, "utc": one.utc, "payload": json.loads(one.payload)}
        for one in context.store.events.entries(found.session)
    ]
    return RecordedJson(**_session(found), events=events)


@router.get(
    "/exports/{form}",
    response_class=StreamingResponse,
    responses={
        200: {
            "description": "The file.",
            "content": {
                form.media_type.partition(";")[0]: {"schema": {"type": "string"}} for form in Form
            },
        }
    },
)
def export(
    visitor: Following,
    context: Here,
    form: Form,
    patient: Annotated[
        str | None,
        Query(max_length=1_000, description="A pseudonym; all whom you may see, if none."),
    ] = None,
) -> StreamingResponse:
    """The record for another program: pseudonyms only, nobody's name. BIDS comes as a ZIP."""
    whose: tuple[PatientId, ...] = (
        patients_of(context, visitor)
        if patient is None
        else (demand_patient(context, visitor, patient),)
    )
    audit(
        context,
        visitor,
        Act.EXPORTED,
        None if patient is None else whose[0],
        f"{form.value} of {len(whose)}",
    )
    file = exported(context.store, whose, form)
    headers = {"Content-Disposition": f'attachment; filename="{form.file_name}"'}
    return StreamingResponse(pieces(file), media_type=form.media_type, headers=headers)


def _exercise(found: ExerciseProgress) -> ExerciseFigures:
    trends = found.trends
    return ExerciseFigures(
        exercise=found.exercise,
        completion=found.completion,
        first_attempt_share=found.first_attempt_share,
        reaction_ms=found.reaction,
        assistance=found.assistance,
        trends={
            "first_attempts": trends.first_attempts,
            "reaction": trends.reaction,
            "assistance": trends.assistance,
        },
        sessions=[_figures(one) for one in found.sessions],
    )


def _figures(one: SessionProgress) -> SessionFigures:
    return SessionFigures(
        session=one.session,
        begun_utc=one.begun_utc,
        completed=one.completed,
        steps=one.steps,
        first_attempts=one.first_attempts,
        refused=one.refused,
        reactions_ms=list(one.reactions),
        assistance=one.assistance,
        lasted_ms=one.lasted,
    )


def _session(one: StoredSession) -> dict[str, Any]:
    return {
        "session": one.session,
        "exercise": one.exercise,
        "version": one.version,
        "begun_utc": one.begun_utc,
        "ended_utc": one.ended_utc,
    }
