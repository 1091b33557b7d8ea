"""The pages about patients: all of them, a new one, one of them, erasing."""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Final

from fastapi import APIRouter, Query
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.coaching.ports import PatientId
from maestra.coaching.settings import Profile, encode_settings
from maestra.core.faults import InvalidError
from maestra.core.text import faults_of_name
from maestra.language import Language
from maestra.language.coach_settings import setting_name
from maestra.web.access.audit import Act, audit
from maestra.web.access.guard import Accompanying
from maestra.web.access.ownership import own_patient, patients_of
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.patients import fields, kinds
from maestra.web.patients.addresses import segment_of
from maestra.web.patients.care import Care
from maestra.web.patients.desk import UNPROCESSABLE, AtDesk, Desk, name_of, titles
from maestra.web.patients.plan import MOST_EXERCISES, Typed
from maestra.web.patients.whose import Filled, only
from maestra.web.progress import figures
from maestra.web.rooms.rooms import Rooms, RoomsHere

MOST_IN_PSEUDONYM: Final = 60
"""Letters of a pseudonym made here: it stands in tables and on buttons."""
_SUMMED_UP: Final = ("mental", "physical", "hand", "reach", "language", "policy", "put_back")
"""What of the settings stands on the patient's first page."""

router: Final = APIRouter(include_in_schema=False)

Done = Annotated[str, Query(max_length=40)]
"""What has just been done, to be said on the page."""


@dataclass(frozen=True, slots=True)
class Row:
    """A patient in the list."""

    patient: PatientId
    name: str
    """Empty if nobody said."""
    exercises: int
    last: datetime | None
    """When the last session began."""
    segment: str


@router.get("/patients")
def patients(
    visitor: Accompanying,
    context: Here,
    pages: Page,
    q: Annotated[str, Query(max_length=200)] = "",
    done: Done = "",
) -> HTMLResponse:
    """Those whom the visitor cares for; `q` narrows them down."""
    rows = [_row(context, one) for one in patients_of(context, visitor)]
    wanted = q.strip().casefold()
    found = [one for one in rows if wanted in f"{one.patient}\0{one.name}".casefold()]
    return pages.page("patients/list.html", visitor, rows=found, any=bool(rows), q=q, done=done)


@router.get("/patients/new")
def new(visitor: Accompanying, context: Here, pages: Page) -> HTMLResponse:
    """A form for a new patient."""
    return _new(visitor, pages, {"pseudonym": (_free(context),)}, {})


@router.post("/patients")
def begin(visitor: Accompanying, context: Here, pages: Page, typed: Filled) -> Response:
    """Keep a new patient."""
    pseudonym, name = only(typed, "pseudonym").strip(), only(typed, "name").strip()
    profile, language = fields.profile_of(typed), _language(only(typed, "language"))
    faults = _new_faults(pseudonym, name, pages)
    for field, meant in (("mental", profile), ("language", language)):
        if meant is None:
            faults[field] = pages.say("Please choose one of these.")
    if not faults and profile is not None and language is not None:
        try:
            patient = own_patient(context, visitor, pseudonym)
        except InvalidError:
            faults["pseudonym"] = pages.say("This pseudonym is taken. Please choose another one.")
        else:
            Care(context.store).begin(patient, profile, language)
            if name:
                context.store.save_name(patient, name)
            return RedirectResponse(f"/patients/{segment_of(patient)}?done=begun", 303)
    return _new(visitor, pages, typed, faults)


@router.get("/patients/{pseudonym}")
def patient(desk: AtDesk, done: Done = "") -> HTMLResponse:
    """What is known of a patient, and where to go from here."""
    return _patient(desk, done=done)


@router.post("/patients/{pseudonym}/exercises")
def assign(desk: AtDesk, typed: Filled) -> Response:
    """Let these be the exercises that the patient plays."""
    there = titles(desk.context)
    wanted = [one for one in typed.get("exercise", ()) if one in there]
    desk.care.assign(desk.patient, wanted[:MOST_EXERCISES])
    desk.note(Act.CHANGED, "exercises")
    return desk.to("?done=assigned")


@router.post("/patients/{pseudonym}/name")
def rename(desk: AtDesk, typed: Filled) -> Response:
    """Keep who the pseudonym is."""
    name = only(typed, "name").strip()
    if faults_of_name("name", name) or name == desk.patient:
        return _patient(desk, name=name, fault=_name_fault(desk.pages))
    desk.context.store.save_name(desk.patient, name)
    desk.note(Act.CHANGED, "name")
    return desk.to("?done=named")


@router.get("/patients/{pseudonym}/everything.json")
def everything(desk: AtDesk) -> Response:
    """All that is kept of a patient, as a file: theirs to have."""
    desk.note(Act.EXPORTED, "everything")
    kept = desk.context.store.everything(desk.patient)
    text = json.dumps(kept, ensure_ascii=False, indent=1)
    headers = {"Content-Disposition": 'attachment; filename="everything.json"'}
    return Response(f"{text}\n", media_type="application/json", headers=headers)


@router.get("/patients/{pseudonym}/erase")
def ask_to_erase(desk: AtDesk) -> HTMLResponse:
    """Say what erasing means, and ask once."""
    return desk.page("patients/erase.html", sessions=len(desk.sessions()))


@router.post("/patients/{pseudonym}/erase")
def erase(desk: AtDesk, rooms: RoomsHere) -> Response:
    """Erase a patient for ever."""
    done = erase_for_ever(desk.context, rooms, desk.visitor, desk.patient)
    return RedirectResponse(f"/patients?done={done}", 303)


def erase_for_ever(context: Context, rooms: Rooms, visitor: Visitor, patient: PatientId) -> str:
    """Erase a patient; what came of it: "erased", or "erased-late" where files remain.

    What remains is sealed with a key that is no more, and goes with the next erasing.
    """
    audit(context, visitor, Act.ERASED, patient)
    rooms.forget(patient)
    figures.forget(context.store, patient)
    try:
        context.store.erase(patient)
    except OSError:
        return "erased-late"
    return "erased"


# ---------------------------------------------------------------- within


def _row(context: Context, patient: PatientId) -> Row:
    played = context.store.sessions(patient)
    last = datetime.fromisoformat(played[-1].begun_utc) if played else None
    plan = Care(context.store).plan(patient)
    name = name_of(context, patient)
    return Row(patient, name, len(plan.exercises), last, segment_of(patient))


def _new(visitor: Visitor, pages: Pages, typed: Typed, faults: dict[str, str]) -> HTMLResponse:
    chosen = {**fields.profile_typed(Profile()), "language": (pages.language.value,), **typed}
    asked = {"language": kinds.KINDS["language"], **kinds.PROFILE}
    page = pages.page(
        "patients/new.html",
        visitor,
        typed={name: only(typed, name) for name in ("pseudonym", "name")},
        faults=faults,
        fields=fields.fields(asked, chosen, faults, pages),
    )
    page.status_code = UNPROCESSABLE if faults else 200
    return page


def _new_faults(pseudonym: str, name: str, pages: Pages) -> dict[str, str]:
    faults: dict[str, str] = {}
    if faults_of_name("pseudonym", pseudonym) or len(pseudonym) > MOST_IN_PSEUDONYM:
        faults["pseudonym"] = pages.say(
            "Please write a pseudonym of 1 to {most} letters.", most=MOST_IN_PSEUDONYM
        )
    elif pseudonym.casefold() == name.casefold():
        faults["pseudonym"] = pages.say("A pseudonym must not be the name.")
    if name and faults_of_name("name", name):
        faults["name"] = _name_fault(pages)
    return faults


def _name_fault(pages: Pages) -> str:
    return pages.say("Please write a name on one line, other than the pseudonym.")


def _free(context: Context) -> str:
    """A pseudonym that nobody has, to begin with."""
    taken = set(context.store.patients())
    number = len(taken) + 1
    while f"P{number:02}" in taken:
        number += 1
    return f"P{number:02}"


def _language(text: str) -> Language | None:
    return next((one for one in Language if one.value == text), None)


def _patient(
    desk: Desk, *, done: str = "", name: str | None = None, fault: str = ""
) -> HTMLResponse:
    now, plan = desk.care.remembered(desk.patient).settings, desk.care.plan(desk.patient)
    written = encode_settings(now)
    played = desk.sessions()
    return desk.page(
        "patients/patient.html",
        UNPROCESSABLE if fault else 200,
        done=done,
        typed_name=desk.name if name is None else name,
        name_fault=fault,
        exercises=[
            (one, title, one in plan.exercises)
            for one, title in titles(desk.context, desk.pages.language).items()
        ],
        summary=[
            (setting_name(one, desk.pages.language), kinds.words_of(one, value, desk.pages))
            for one, value in [*written["profile"].items(), *written.items()]
            if one in _SUMMED_UP
        ],
        has_draft=plan.draft is not None or plan.profile is not None,
        sessions=len(played),
        last=datetime.fromisoformat(played[-1].begun_utc) if played else None,
    )
