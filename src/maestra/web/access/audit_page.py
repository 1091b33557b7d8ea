"""The audit, for administrators: who did what, to whom, when."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated, Final

from fastapi import APIRouter, Query
from fastapi.responses import Response

from maestra.web.access.guard import Administering
from maestra.web.context import Here
from maestra.web.pages import Page

router: Final = APIRouter(include_in_schema=False)

ON_A_PAGE: Final = 100
MOST_NUMBER: Final = 2**53
"""More lines than there will ever be, and still a number in every database."""


@router.get("/audit")
def audit_page(
    visitor: Administering,
    context: Here,
    pages: Page,
    before: Annotated[int | None, Query(ge=1, le=MOST_NUMBER)] = None,
) -> Response:
    """A hundred lines, the newest first."""
    lines = context.store.custody.audit(before, ON_A_PAGE)
    names = {one.account: one.name for one in context.store.access.accounts()}
    return pages.page(
        "access/audit.html",
        visitor,
        lines=lines,
        names=names,
        moment=datetime.fromisoformat,
        older=lines[-1].number if len(lines) == ON_A_PAGE else None,
        is_first=before is None,
    )
