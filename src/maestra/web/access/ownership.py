"""Whose is what: to everybody else it is as if it were not there."""

from __future__ import annotations

from fastapi import HTTPException

from maestra.coaching.ports import PatientId
from maestra.web.access.audit import Act, audit
from maestra.web.access.visitor import AccountId, Right, Role, Visitor
from maestra.web.context import Context


def demand_patient(context: Context, visitor: Visitor, pseudonym: str) -> PatientId:
    """The patient, if the visitor may see them; that is noted as a read.

    Caregivers see their own, researchers and administrators all. That a researcher sees no name
    is the page's part: what a page shows follows from the visitor's rights.

    Raises:
        HTTPException: 404, there is none, or it is somebody else's.
    """
    patient = PatientId(pseudonym)
    if not sees_patient(context, visitor, patient):
        audit(context, visitor, Act.DENIED, patient, "patient")
        raise HTTPException(404, "no such patient")
    audit(context, visitor, Act.READ, patient)
    return patient


def sees_patient(context: Context, visitor: Visitor, patient: PatientId) -> bool:
    """Whether there is such a patient whom the visitor may see."""
    try:
        cares = context.store.custody.cares(visitor.account, patient)
    except KeyError:
        return False
    return cares or visitor.may(Right.STUDY)


def patients_of(context: Context, visitor: Visitor) -> tuple[PatientId, ...]:
    """All whom the visitor may see, in order."""
    if visitor.may(Right.STUDY):
        return context.store.patients()
    return context.store.custody.patients_of(visitor.account)


def own_patient(context: Context, visitor: Visitor, pseudonym: str) -> PatientId:
    """Make a new patient the visitor's; call it before anything of the patient is kept.

    Raises:
        InvalidError: the pseudonym cannot be one, or is taken.
    """
    patient = PatientId(pseudonym)
    context.store.custody.own(patient, visitor.account)
    audit(context, visitor, Act.CHANGED, patient, "new patient")
    return patient


def own_draft(visitor: Visitor, account: str | AccountId) -> None:
    """Refuse what belongs to another account, also to administrators: a draft is private.

    Raises:
        HTTPException: 404, it is somebody else's.
    """
    if visitor.account != account:
        raise HTTPException(404, "no such draft")


def sees_names(visitor: Visitor) -> bool:
    """Whether the visitor may know who a pseudonym is."""
    return visitor.role is not Role.RESEARCHER
