"""How tests come to be logged in."""

from fastapi import FastAPI, HTTPException, Request
from playwright.sync_api import Page

from maestra.language import Language
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import AccountId, Role, Visitor
from tests.browser.serving import Served

COOKIE = "test-role"


def prepare(app: FastAPI) -> None:
    """Take whoever has the cookie for somebody of that role."""

    def visitor(request: Request) -> Visitor:
        role = request.cookies.get(COOKIE)
        if role is None:
            raise HTTPException(401)
        return Visitor(AccountId(role), role.title(), Role(role), Language.EN)

    app.dependency_overrides[visitor_of] = visitor


def log_in(served: Served, page: Page, role: Role) -> Page:
    """The page, on the first page of somebody with this role."""
    page.context.add_cookies([{"name": COOKIE, "value": role.value, "url": served.url}])
    page.goto("/")
    return page
