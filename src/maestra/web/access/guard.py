"""What a route demands of its visitor, as FastAPI's dependencies."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated

from fastapi import Depends, HTTPException, Request

from maestra.web.access.visitor import Right, Visitor


def visitor_of(request: Request) -> Visitor:
    """Who is logged in.

    Raises:
        HTTPException: 401, nobody is.
    """
    raise HTTPException(401, f"nobody is logged in at {request.url.path}")


def needs(right: Right) -> Callable[[Visitor], Visitor]:
    """The visitor, if their role gives `right`; else 403."""

    def allowed(visitor: Annotated[Visitor, Depends(visitor_of)]) -> Visitor:
        if not visitor.may(right):
            raise HTTPException(403, f"a {visitor.role.value} may not {right.value}")
        return visitor

    return allowed


Anybody = Annotated[Visitor, Depends(visitor_of)]
Teaching = Annotated[Visitor, Depends(needs(Right.TEACH))]
Accompanying = Annotated[Visitor, Depends(needs(Right.ACCOMPANY))]
Studying = Annotated[Visitor, Depends(needs(Right.STUDY))]
Administering = Annotated[Visitor, Depends(needs(Right.ADMINISTER))]
