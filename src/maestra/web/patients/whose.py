"""Whom an address means, and what stands in a form: FastAPI's dependencies for these pages."""

from __future__ import annotations

from typing import Annotated, Final

from fastapi import Depends, HTTPException, Path, Request

from maestra.coaching.ports import PatientId
from maestra.web.access.guard import Accompanying, Following
from maestra.web.access.ownership import demand_patient
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.patients.addresses import MOST_IN_ADDRESS, name_at
from maestra.web.patients.plan import Typed

MOST_FIELDS: Final = 500
"""Of a form: the settings have thirty, a list of exercises to tick may have hundreds."""

Segment = Annotated[
    str,
    Path(
        max_length=MOST_IN_ADDRESS,
        description="The pseudonym; what an address cannot hold in base64url after a tilde.",
    ),
]


def _cared_for(pseudonym: Segment, visitor: Accompanying, context: Here) -> PatientId:
    return _demanded(context, visitor, pseudonym)


def _followed(pseudonym: Segment, visitor: Following, context: Here) -> PatientId:
    return _demanded(context, visitor, pseudonym)


def _demanded(context: Context, visitor: Visitor, segment: str) -> PatientId:
    patient = name_at(segment)
    if patient is None:
        raise HTTPException(404, "no such patient")
    return demand_patient(context, visitor, patient)


CaredFor = Annotated[PatientId, Depends(_cared_for)]
"""A patient of the visitor's."""
Followed = Annotated[PatientId, Depends(_followed)]
"""A patient whose progress the visitor may see."""


async def _typed(request: Request) -> Typed:
    found: dict[str, tuple[str, ...]] = {}
    async with request.form(max_files=0, max_fields=MOST_FIELDS) as form:
        for name, value in form.multi_items():
            if isinstance(value, str):
                found[name] = (*found.get(name, ()), value)
    return found


Filled = Annotated[Typed, Depends(_typed)]
"""What stands in the form that was sent."""


def only(typed: Typed, name: str) -> str:
    """What stands in a field that has one value; empty where there is none."""
    return next(iter(typed.get(name, ())), "")
