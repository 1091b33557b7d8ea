"""Every page there is, with something to show: for everybody, on every screen, in its budget."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Final

import pytest
from fastapi.routing import APIRoute
from playwright.sync_api import Page, Request

from maestra.coaching.ports import SessionId
from maestra.language import Language
from maestra.storage.access import Account
from maestra.web.access.second_factor import new_secret
from maestra.web.access.visitor import Role
from maestra.web.application import ROUTERS
from tests.browser.axe import findings
from tests.browser.conftest import OpenBrowser
from tests.browser.lint import Reader, lint, too_wide
from tests.browser.roles import log_in
from tests.browser.serving import Served
from tests.browser.sizes import Size
from tests.browser.world import PIN, World, populate
from tests.web.people import PASSWORD, add_account

MOST_BYTES: Final = 60_000
"""Of a page with its style and module, as they are sent; pictures are not counted."""
MOST_REQUESTS: Final = 3

NOBODY: Final = ("/set-up", "/login", "/help", "/screen")
CAREGIVERS: Final = (
    *("/", "/account", "/devices"),
    *("/library", "/library/{wanted}"),
    *("/patients", "/patients/new", "/patients/{pseudonym}", "/patients/{pseudonym}/settings"),
    *("/patients/{pseudonym}/preview", "/patients/{pseudonym}/erase"),
    *("/progress", "/progress/{pseudonym}", "/progress/{pseudonym}/exercise"),
    *("/progress/{pseudonym}/print", "/progress/{pseudonym}/sessions/{session}"),
    *("/sessions", "/sessions/new-session", "/sessions/{name}"),
    *("/teach", "/teach/{draft}", "/teach/{draft}/tokens", "/teach/{draft}/words"),
    *("/teach/{draft}/try", "/teach/{draft}/exam", "/teach/{draft}/features"),
)
ADMINISTRATORS: Final = ("/accounts", "/accounts/{account}", "/audit")
PATIENTS: Final = ("/rooms/{name}", "/patient")
ON_THE_WAY: Final = ("/login/code", "/account/new-password", "/account/second-factor")
"""Only there for who has an account as in `STATES`; others are led on."""
NO_PAGES: Final = (
    *("/library/{wanted}/file", "/library/{wanted}/picture", "/library/{wanted}/pddl"),
    *("/patients/{pseudonym}/everything.json", "/patients/{pseudonym}/preview/heard"),
    "/pictures/{digest}",
)
NEXT_CENTURY_MS: Final = 4_102_444_800_000
STATES: Final[Mapping[str, Callable[[Account], Account]]] = {
    "/login/code": lambda one: replace(one, secret=new_secret()),
    "/account/new-password": lambda one: replace(one, temporary_until_ms=NEXT_CENTURY_MS),
    "/account/second-factor": lambda one: replace(one, offered_secret=new_secret()),
}
"""What an account must be like for whoever logs in with it to get to each page on the way."""
QUERIES: Final = {"/progress/{pseudonym}/exercise": "?name=Five+numbers%2C+ascending"}


def test_no_page_is_forgotten_here() -> None:
    there = {
        route.path
        for router in ROUTERS
        for route in router.routes
        if isinstance(route, APIRoute) and "GET" in (route.methods or ())
    }
    named = (NOBODY, CAREGIVERS, ADMINISTRATORS, PATIENTS, ON_THE_WAY, NO_PAGES)
    listed = {path for paths in named for path in paths}
    assert {path for path in there if not path.startswith("/api/")} == listed


@dataclass
class Sent:
    """What a page costs: its bytes as they were sent, and its requests, without pictures."""

    bytes: int = 0
    requests: int = 0

    def count(self, request: Request) -> None:
        """Count what has come."""
        if request.resource_type in {
            "document",
            "stylesheet",
            "script",
        }:
            sizes = request.sizes()
            self.bytes += sizes["responseBodySize"] + sizes["responseHeadersSize"]
            self.requests += 1


@dataclass
class Visit:
    """A walk through pages; each is opened, looked at, and what is wrong there is noted."""

    page: Page
    world: World
    reader: Reader

    def look(self, paths: tuple[str, ...]) -> list[str]:
        """What is wrong on these pages."""
        return [f"{path}: {fault}" for path in paths for fault in self._faults(path)]

    def _faults(self, path: str) -> list[str]:
        address = self.world.filled(path) + QUERIES.get(path, "")
        answer = self.page.goto(address)
        assert answer is not None
        assert answer.status == 200, (address, answer.status)
        # What is folded away must keep the limits, too.
        self.page.evaluate(
            "document.querySelectorAll('details').forEach((one) => one.open = true)"
        )
        faults = [f"{one['rule']}: {one['html']}" for one in findings(self.page)]
        return faults + lint(self.page, self.reader) + too_wide(self.page)


def test_every_page_is_small(served: Served, page: Page) -> None:
    world = populate(served, page)
    # As if nobody had been here before: asked through here, the browser's cache is left aside.
    page.route("**/*", lambda route: route.continue_())
    costs: dict[str, Sent] = {}
    for path in (*CAREGIVERS, "/rooms/{name}"):
        sent = Sent()
        page.on("requestfinished", sent.count)
        page.goto(world.filled(path) + QUERIES.get(path, ""), wait_until="load")
        page.remove_listener("requestfinished", sent.count)
        costs[path] = sent
    assert {
        path: sent
        for path, sent in costs.items()
        if sent.bytes > MOST_BYTES or sent.requests > MOST_REQUESTS
    } == {}


@pytest.mark.parametrize("language", [Language.ES, Language.CA])
def test_every_page_is_there_in_each_language(
    served: Served, open_browser: OpenBrowser, language: Language
) -> None:
    page = open_browser(language=language.value).new_page()
    world = populate(served, page, language)
    for path in (*CAREGIVERS, "/rooms/{name}"):
        answer = page.goto(world.filled(path) + QUERIES.get(path, ""))
        assert answer is not None
        assert answer.status == 200, path
        assert page.locator("html").get_attribute("lang") == language.value


@pytest.fixture
def page_at(open_browser: OpenBrowser, size: Size) -> Page:
    return open_browser(size).new_page()


def test_every_caregivers_page_is_for_everybody(served: Served, page_at: Page) -> None:
    world = populate(served, page_at)
    assert Visit(page_at, world, Reader.CAREGIVER).look(CAREGIVERS) == []


def test_every_patients_page_is_for_everybody(
    served: Served, page_at: Page, open_browser: OpenBrowser, size: Size
) -> None:
    world = populate(served, page_at)
    found = Visit(page_at, world, Reader.PATIENT).look(("/rooms/{name}",))
    tablet = open_browser(size).new_page()
    tablet.goto("/screen")
    tablet.locator("#code").fill(world.screen_code)
    tablet.locator("#pin").fill(PIN)
    tablet.locator("main form button").first.click()
    tablet.wait_for_url("**/patient")
    found += Visit(tablet, world, Reader.PATIENT).look(("/patient",))
    assert found == []


def test_every_administrators_page_is_for_everybody(
    served: Served, page_at: Page, open_browser: OpenBrowser, size: Size
) -> None:
    world = populate(served, page_at)
    administrator = log_in(served, open_browser(size).new_page(), Role.ADMINISTRATOR)
    assert Visit(administrator, world, Reader.CAREGIVER).look(ADMINISTRATORS) == []


def test_every_page_for_who_is_not_logged_in_is_for_everybody(
    served: Served, page_at: Page
) -> None:
    served.context.doors.open_set_up()
    world = World("", "", SessionId(""), "", "")
    found = Visit(page_at, world, Reader.CAREGIVER).look(NOBODY)
    assert found == []


def test_every_page_on_the_way_is_for_everybody(
    served: Served, open_browser: OpenBrowser, size: Size
) -> None:
    world = World("", "", SessionId(""), "", "")
    found: list[str] = []
    for path in ON_THE_WAY:
        page = open_browser(size).new_page()
        name = path.rpartition("/")[2]
        own = add_account(served.context, name)
        served.context.store.access.change_account(own.account, STATES[path])
        page.goto("/login")
        page.locator("#name").fill(name)
        page.locator("#password").fill(PASSWORD)
        page.locator("main form button").click()
        page.wait_for_url(lambda url: not url.endswith("/login"))
        found += Visit(page, world, Reader.CAREGIVER).look((path,))
        assert page.url == f"{served.url}{path}"
    assert found == []
