"""The pages on progress: everybody, one patient, one exercise, on paper, one session."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import datetime
from math import ceil
from typing import Annotated, Final

from fastapi import APIRouter, Depends, HTTPException, Path, Query
from fastapi.responses import HTMLResponse

from maestra.coaching.ports import PatientId, SessionId, StoredSession
from maestra.coaching.progress import ExerciseProgress, SessionProgress
from maestra.coaching.report import Chart, Report
from maestra.core.faults import InvalidError
from maestra.language.report_keys import ReportKey
from maestra.language.reports import report_words
from maestra.web.access.guard import Following
from maestra.web.access.ownership import patients_of, sees_names
from maestra.web.access.visitor import Right, Visitor
from maestra.web.board_view import NO_PICTURES, board_view, tokens_by_id
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.patients.addresses import MOST_IN_ADDRESS, name_at, segment_of
from maestra.web.patients.desk import name_of, titles
from maestra.web.patients.whose import Followed
from maestra.web.progress.curves import Curve, curve, endings
from maestra.web.progress.exporting import Form
from maestra.web.progress.figures import figures
from maestra.web.progress.replaying import Moment, Recorded, recorded
from maestra.web.progress.words import (
    clock_words,
    event_words,
    judged_words,
    verdict_words,
    why_words,
)
from maestra.web.sessions.evidence import said_in
from maestra.web.teach.pictures import shown_in

A_PAGE: Final = 20
"""Sessions in the table of a page: its weight has a limit, and so has patience."""
ON_PAPER: Final = 12
"""The last sessions of each exercise that are printed."""
MOST_ON_PAPER: Final = 12
"""Exercises that are printed with curves."""
MOST_NOTABLE: Final = 120
"""Moments in the list beside the time line; of a longer session those around the one shown."""

router: Final = APIRouter(include_in_schema=False)


@dataclass(frozen=True, slots=True)
class Reader:
    """One patient's progress, and who reads it."""

    visitor: Visitor
    patient: PatientId
    context: Context
    pages: Pages

    def figures(self) -> tuple[ExerciseProgress, ...]:
        """In each exercise."""
        return figures(self.context.store, self.patient)

    def titles(self) -> dict[str, str]:
        """What exercises are called; those that are gone by their name."""
        return titles(self.context, self.pages.language)

    def page(self, template: str, **parts: object) -> HTMLResponse:
        """A page that also has `patient`, `name`, `at` and `segment`."""
        segment = segment_of(self.patient)
        named = sees_names(self.visitor)
        return self.pages.page(
            template,
            self.visitor,
            patient=self.patient,
            name=name_of(self.context, self.patient) if named else "",
            at=f"/progress/{segment}",
            segment=segment,
            accompanies=self.visitor.may(Right.ACCOMPANY),
            **parts,
        )


def _reader(visitor: Following, patient: Followed, context: Here, pages: Page) -> Reader:
    return Reader(visitor, patient, context, pages)


SessionSegment = Annotated[str, Path(max_length=MOST_IN_ADDRESS)]
AtReader = Annotated[Reader, Depends(_reader)]
"""Of a patient whose progress the visitor may see."""


# ---------------------------------------------------------------- everybody


@dataclass(frozen=True, slots=True)
class Row:
    """A patient in the list."""

    patient: PatientId
    name: str
    sessions: int
    last: datetime | None
    segment: str


@router.get("/progress")
def everybody(visitor: Following, context: Here, pages: Page) -> HTMLResponse:
    """All whose progress the visitor may see."""
    rows = [_row(visitor, context, one) for one in patients_of(context, visitor)]
    return pages.page(
        "progress/list.html", visitor, rows=rows, names=sees_names(visitor), forms=list(Form)
    )


def _row(visitor: Visitor, context: Context, patient: PatientId) -> Row:
    played = context.store.sessions(patient)
    last = local(played[-1].begun_utc) if played else None
    name = name_of(context, patient) if sees_names(visitor) else ""
    return Row(patient, name, len(played), last, segment_of(patient))


# ---------------------------------------------------------------- one patient


@router.get("/progress/{pseudonym}")
def patient(reader: AtReader) -> HTMLResponse:
    """How a patient gets on: a line for each exercise."""
    found, titled = reader.figures(), reader.titles()
    report = _report(reader, found, titled)
    return reader.page(
        "progress/patient.html",
        heads=report.summary().heads,
        rows=list(zip(found, report.summary().rows, strict=True)),
        how_to_read=report.how_to_read,
        first=_summary_curve(reader, found),
        recent=_recent(reader, titled),
        forms=list(Form),
    )


@router.get("/progress/{pseudonym}/exercise")
def exercise(
    reader: AtReader,
    name: Annotated[str, Query(max_length=1_000)],
    page: Annotated[int, Query(ge=1, le=1_000_000)] = 1,
) -> HTMLResponse:
    """One exercise: curves over all sessions, and a table of them, the newest first."""
    found = next((one for one in reader.figures() if one.exercise == name), None)
    if found is None:
        raise HTTPException(404, "this exercise was not played")
    titled = reader.titles()
    last_page = ceil(len(found.sessions) / A_PAGE)
    shown = min(page, last_page)
    part = tuple(reversed(found.sessions))[(shown - 1) * A_PAGE : shown * A_PAGE]
    return reader.page(
        "progress/exercise.html",
        exercise=name,
        title=titled.get(name, name),
        page=shown,
        last_page=last_page,
        **_drawn(reader, found, part, titled),
    )


@router.get("/progress/{pseudonym}/print")
def on_paper(reader: AtReader) -> HTMLResponse:
    """All of it on one page to print: each exercise with its curves and its last sessions."""
    found, titled = reader.figures(), reader.titles()
    report = _report(reader, found, titled)
    newest = sorted(found, key=lambda one: one.sessions[-1].begun_utc, reverse=True)
    drawn = [
        (titled.get(one.exercise, one.exercise), _drawn(reader, one, last, titled, f"p{number}"))
        for number, one in enumerate(newest[:MOST_ON_PAPER])
        for last in [tuple(reversed(one.sessions))[:ON_PAPER]]
    ]
    return reader.page(
        "progress/print.html",
        heads=report.summary().heads,
        rows=report.summary().rows,
        drawn=drawn,
        how_to_read=report.how_to_read,
        today=reader.context.clock.utc().astimezone(),
    )


def _report(reader: Reader, found: tuple[ExerciseProgress, ...], titled: dict[str, str]) -> Report:
    named = tuple(replace(one, exercise=titled.get(one.exercise, one.exercise)) for one in found)
    return Report(reader.patient, named, reader.pages.language)


def _drawn(
    reader: Reader,
    found: ExerciseProgress,
    shown: tuple[SessionProgress, ...],
    titled: dict[str, str],
    number: str = "c",
) -> dict[str, object]:
    """The curves of an exercise, and a table of the sessions `shown`."""
    report = _report(reader, (found,), titled)
    table = report.sessions(ExerciseProgress(found.exercise, shown))
    trends, charts = found.trends, report.charts(found)
    moves = (trends.first_attempts, trends.reaction, trends.assistance)
    curves = [
        endings(
            f"{number}-0",
            [one.completed for one in found.sessions],
            report_words(ReportKey.COMPLETION, reader.pages.language),
            reader.pages,
        ),
        *(
            curve(f"{number}-{k}", chart, trend, reader.pages)
            for k, (chart, trend) in enumerate(zip(charts, moves, strict=True), 1)
        ),
    ]
    return {
        "curves": curves,
        "heads": table.heads,
        "sessions": [
            (local(one.begun_utc), segment_of(one.session), row[1:])
            for one, row in zip(shown, table.rows, strict=True)
        ],
        "how_to_read": report.how_to_read,
        "count": len(found.sessions),
    }


def _summary_curve(reader: Reader, found: tuple[ExerciseProgress, ...]) -> Curve | None:
    """Right at once over all sessions of the exercise that was played most."""
    if not found:
        return None
    most = max(found, key=lambda one: len(one.sessions))
    shares = tuple(
        None if one.first_attempt_share is None else 100 * one.first_attempt_share
        for one in most.sessions
    )
    words = report_words(ReportKey.FIRST_ATTEMPTS, reader.pages.language)
    title = reader.titles().get(most.exercise, most.exercise)
    trend = most.trends.first_attempts
    return curve("s", Chart(f"{title}: {words} (%)", shares, 100.0), trend, reader.pages)


def _recent(reader: Reader, titled: dict[str, str]) -> list[tuple[datetime, str, str]]:
    """The last sessions of all exercises."""
    played = reader.context.store.sessions(reader.patient)[-5:]
    return [
        (local(one.begun_utc), titled.get(one.exercise, one.exercise), segment_of(one.session))
        for one in reversed(played)
    ]


# ---------------------------------------------------------------- one session


@router.get("/progress/{pseudonym}/sessions/{session}")
def replay(
    reader: AtReader,
    session: SessionSegment,
    at: Annotated[int, Query(ge=0, le=1_000_000)] = 0,
) -> HTMLResponse:
    """A session moment by moment: the board as it was, what was said, and why."""
    stored, whole = session_of(reader, session)
    moment = whole.nearest(at)
    start, pages = whole.start, reader.pages
    views = tokens_by_id(start.deck, start.exercise.board, pages.language)
    names = {token: view.name for token, view in views.items()}
    board = board_view(
        start.exercise.board,
        start.deck,
        moment.cells,
        language=pages.language,
        held=moment.held,
        pointed=moment.pointed,
        wrong=moment.wrong,
        pictures=_pictures(reader, stored),
    )
    return reader.page(
        "progress/replay.html",
        title=reader.titles().get(stored.exercise, stored.exercise),
        begun=local(stored.begun_utc),
        session=segment_of(stored.session),
        is_ended=stored.ended_utc is not None,
        board=board,
        moment=moment,
        last=len(whole.moments) - 1,
        clock=clock_words(moment.at),
        lasted=clock_words(whole.moments[-1].at),
        happened=event_words(moment.event, names, pages),
        verdict=verdict_words(moment, pages),
        why=why_words(moment, pages),
        language_said=start.settings.language.value,
        judged=_judged(reader, stored),
        line=_time_line(whole, moment),
        notable=[
            (one.number, clock_words(one.at), _mark(one), event_words(one.event, names, pages))
            for one in _around(whole.notable, moment.number)
        ],
    )


def _pictures(reader: Reader, stored: StoredSession) -> Mapping[str, str]:
    """What stood on the tokens, for those who know the patient: family may be in the pictures."""
    if not sees_names(reader.visitor):
        return NO_PICTURES
    return shown_in(reader.context.store, stored.exercise, stored.version)


def _judged(reader: Reader, stored: StoredSession) -> list[str]:
    """What was judged otherwise, if the reader may take it back to the exercise."""
    visitor = reader.visitor
    if not (visitor.may(Right.ACCOMPANY) and visitor.may(Right.TEACH)) or not stored.ended_utc:
        return []
    entries = reader.context.store.events.entries(stored.session)
    return judged_words(said_in(entries), reader.pages)


def session_of(reader: Reader, segment: str) -> tuple[StoredSession, Recorded]:
    """A session of the reader's patient.

    Raises:
        HTTPException: 404, there is none.
    """
    found = stored_session(reader.context, reader.patient, segment)
    try:
        whole = recorded(reader.context.store.events.entries(found.session))
    except InvalidError:
        whole = None
    if whole is None:
        raise HTTPException(404, "nothing of this session can be read")
    return found, whole


def stored_session(context: Context, patient: PatientId, segment: str) -> StoredSession:
    """The patient's session that an address means.

    Raises:
        HTTPException: 404, there is none.
    """
    identity = SessionId(name_at(segment) or "")
    found = next((one for one in context.store.sessions(patient) if one.session == identity), None)
    if found is None:
        raise HTTPException(404, "no such session")
    return found


def _around(notable: tuple[Moment, ...], number: int) -> tuple[Moment, ...]:
    """Those that are listed: as many as may be, around the one that is shown."""
    before = sum(one.number < number for one in notable)
    first = min(max(before - MOST_NOTABLE // 2, 0), max(len(notable) - MOST_NOTABLE, 0))
    return notable[first : first + MOST_NOTABLE]


@dataclass(frozen=True, slots=True)
class Tick:
    """A mark on the time line."""

    x: float
    """0 to 1000."""
    mark: str
    is_now: bool


def _time_line(whole: Recorded, now: Moment) -> list[Tick]:
    """The notable moments by time, and the one that is shown last, so that it lies on top."""
    end = max(whole.moments[-1].at, 1)
    ticks = [Tick(1000 * one.at / end, _mark(one), is_now=False) for one in whole.notable]
    return [*ticks, Tick(1000 * now.at / end, _mark(now), is_now=True)]


def _mark(moment: Moment) -> str:
    """How a moment is drawn: right, wrong, help or other."""
    kinds = {note for note, _ in moment.notes}
    if "refused" in kinds:
        return "wrong"
    if "move" in kinds:
        return "right"
    if kinds & {"silence", "help"} and "begun" not in kinds:
        return "help"
    return "other"


def local(utc: str) -> datetime:
    """A time of the record as the server's own clocks show it."""
    return datetime.fromisoformat(utc).astimezone()
