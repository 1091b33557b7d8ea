"""Patients for programs: JSON, described in the OpenAPI document."""

from __future__ import annotations

from typing import Annotated, Any, Final

from fastapi import APIRouter
from pydantic import BaseModel, ConfigDict, Field

from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import SETTINGS_FORMAT
from maestra.coaching.settings import Profile, decode_settings, encode_settings
from maestra.core.faults import Fault, InvalidError
from maestra.core.text import PLAIN
from maestra.language import Language
from maestra.web.access.audit import Act, audit
from maestra.web.access.guard import Accompanying, Following
from maestra.web.access.ownership import own_patient, patients_of, sees_names
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.patients.care import Care
from maestra.web.patients.desk import name_of, titles
from maestra.web.patients.plan import MOST_EXERCISES
from maestra.web.patients.routes import MOST_IN_PSEUDONYM, erase_for_ever
from maestra.web.patients.whose import CaredFor, Followed
from maestra.web.rooms.rooms import RoomsHere

router: Final = APIRouter(prefix="/api/patients", tags=["patients"])

_STRICT: Final = ConfigDict(extra="forbid", frozen=True)
Pseudonym = Annotated[str, Field(min_length=1, max_length=MOST_IN_PSEUDONYM, pattern=PLAIN)]
Name = Annotated[str, Field(min_length=1, max_length=200, pattern=PLAIN)]


class NewPatient(BaseModel):
    """Who is to be kept."""

    model_config = _STRICT

    pseudonym: Annotated[Pseudonym, Field(description="Stands everywhere instead of the name.")]
    name: Annotated[Name | None, Field(description="Kept encrypted, apart.")] = None
    language: Language = Language.EN
    profile: Annotated[Profile, Field(description="The settings follow from it.")] = Profile()


class PatientJson(BaseModel):
    """A patient."""

    pseudonym: str
    name: Annotated[str | None, Field(description="None where nobody said, and to researchers.")]
    exercises: Annotated[list[str], Field(description="Assigned, by name.")]
    sessions: Annotated[int, Field(description="How many were played.")]


class SettingsJson(BaseModel):
    """How the robot treats a patient, as `maestra.settings/1` has it."""

    model_config = _STRICT

    format: Annotated[str, Field(pattern="^maestra\\.settings/1$")] = SETTINGS_FORMAT
    settings: Annotated[
        dict[str, Any], Field(description="By name; what is not there keeps its default.")
    ]


class AssignedJson(BaseModel):
    """The exercises that a patient plays."""

    model_config = _STRICT

    exercises: Annotated[
        list[Annotated[str, Field(max_length=1_000)]], Field(max_length=MOST_EXERCISES)
    ]


class ErasedJson(BaseModel):
    """What came of erasing."""

    cleaned: Annotated[
        bool,
        Field(description="False: sealed remains stay in files until the next erasing."),
    ]


@router.get("")
def list_patients(visitor: Following, context: Here) -> list[PatientJson]:
    """All whom you may see."""
    return [_json(context, visitor, one) for one in patients_of(context, visitor)]


@router.post("", status_code=201)
def begin(visitor: Accompanying, context: Here, new: NewPatient) -> PatientJson:
    """Keep a new patient, who is then yours."""
    if new.name is not None and new.name.casefold() == new.pseudonym.casefold():
        raise InvalidError([Fault("pseudonym", "the name", "something else than the name")])
    patient = own_patient(context, visitor, new.pseudonym)
    Care(context.store).begin(patient, new.profile, new.language)
    if new.name is not None:
        context.store.save_name(patient, new.name)
    return _json(context, visitor, patient)


@router.get("/{pseudonym}")
def patient(visitor: Following, patient: Followed, context: Here) -> PatientJson:
    """One of them."""
    return _json(context, visitor, patient)


@router.delete("/{pseudonym}")
def erase(visitor: Accompanying, patient: CaredFor, context: Here, rooms: RoomsHere) -> ErasedJson:
    """Erase a patient for ever: the key is destroyed, so no backup brings them back."""
    done = erase_for_ever(context, rooms, visitor, patient)
    return ErasedJson(cleaned=done == "erased")


@router.get("/{pseudonym}/settings")
def settings(patient: CaredFor, context: Here) -> SettingsJson:
    """How the robot treats the patient."""
    now = Care(context.store).remembered(patient).settings
    return SettingsJson(settings=encode_settings(now))


@router.put("/{pseudonym}/settings")
def change_settings(
    visitor: Accompanying, patient: CaredFor, context: Here, wanted: SettingsJson
) -> SettingsJson:
    """Use these from the next session on."""
    try:
        settings = decode_settings(wanted.settings)
    except InvalidError as error:
        raise InvalidError([fault.under("settings") for fault in error.faults]) from None
    Care(context.store).change(patient, settings)
    audit(context, visitor, Act.CHANGED, patient, "settings")
    return SettingsJson(settings=encode_settings(settings))


@router.get("/{pseudonym}/exercises")
def exercises(patient: CaredFor, context: Here) -> AssignedJson:
    """What the patient plays."""
    return AssignedJson(exercises=list(Care(context.store).plan(patient).exercises))


@router.put("/{pseudonym}/exercises")
def assign(
    visitor: Accompanying, patient: CaredFor, context: Here, wanted: AssignedJson
) -> AssignedJson:
    """Let the patient play these."""
    there = titles(context)
    faults = [
        Fault(f"exercises[{number}]", name, "an exercise of the library")
        for number, name in enumerate(wanted.exercises)
        if name not in there
    ]
    if faults:
        raise InvalidError(faults)
    care = Care(context.store)
    care.assign(patient, set(wanted.exercises))
    audit(context, visitor, Act.CHANGED, patient, "exercises")
    return AssignedJson(exercises=list(care.plan(patient).exercises))


@router.get("/{pseudonym}/everything")
def everything(visitor: Accompanying, patient: CaredFor, context: Here) -> dict[str, Any]:
    """All that is kept of a patient, `maestra.patient/1`: theirs to have."""
    audit(context, visitor, Act.EXPORTED, patient, "everything")
    return context.store.everything(patient)


def _json(context: Context, visitor: Visitor, patient: PatientId) -> PatientJson:
    name = name_of(context, patient) if sees_names(visitor) else ""
    return PatientJson(
        pseudonym=patient,
        name=name or None,
        exercises=list(Care(context.store).plan(patient).exercises),
        sessions=len(context.store.sessions(patient)),
    )
