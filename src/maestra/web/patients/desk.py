"""What every page of one patient works with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Final

from fastapi import Depends
from fastapi.responses import HTMLResponse, RedirectResponse

from maestra.coaching.ports import PatientId, StoredSession
from maestra.language import Language
from maestra.web.access.audit import Act, audit
from maestra.web.access.guard import Accompanying
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.library.collection import titles as titles_of
from maestra.web.pages import Page, Pages
from maestra.web.patients.addresses import segment_of
from maestra.web.patients.care import Care
from maestra.web.patients.whose import CaredFor

UNPROCESSABLE: Final = 422
"""The status of a form that is shown again because of what stands in it."""


@dataclass(frozen=True, slots=True)
class Desk:
    """One patient, and who asks for a page."""

    visitor: Visitor
    patient: PatientId
    context: Context
    pages: Pages

    @property
    def care(self) -> Care:
        """What is set and intended."""
        return Care(self.context.store)

    @property
    def at(self) -> str:
        """The address of the patient's page."""
        return f"/patients/{segment_of(self.patient)}"

    @property
    def name(self) -> str:
        """Who the pseudonym is; empty if nobody said."""
        return name_of(self.context, self.patient)

    def sessions(self) -> tuple[StoredSession, ...]:
        """The patient's, the earliest first."""
        return self.context.store.sessions(self.patient)

    def page(self, template: str, status: int = 200, **parts: object) -> HTMLResponse:
        """A page that also has `patient`, `name`, `at` and `segment`."""
        page = self.pages.page(
            template,
            self.visitor,
            patient=self.patient,
            name=self.name,
            at=self.at,
            segment=segment_of(self.patient),
            **parts,
        )
        page.status_code = status
        return page

    def to(self, rest: str = "") -> RedirectResponse:
        """Lead to a page of the patient."""
        return RedirectResponse(f"{self.at}{rest}", 303)

    def note(self, act: Act, detail: str) -> None:
        """Keep in the audit what is done to the patient."""
        audit(self.context, self.visitor, act, self.patient, detail)


def _desk(visitor: Accompanying, patient: CaredFor, context: Here, pages: Page) -> Desk:
    return Desk(visitor, patient, context, pages)


AtDesk = Annotated[Desk, Depends(_desk)]
"""Of a patient whom the visitor cares for."""


def titles(context: Context, language: Language = Language.EN) -> dict[str, str]:
    """The exercises of the library by name, each with what people call it, in that order."""
    found = titles_of(context.store, language)
    return dict(sorted(found.items(), key=lambda pair: pair[1].casefold()))


def name_of(context: Context, patient: PatientId) -> str:
    """Who the pseudonym is; empty if nobody said."""
    try:
        return context.store.name(patient)
    except KeyError:
        return ""
