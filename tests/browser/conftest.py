"""A server and a browser for each test, and nothing that goes wrong unseen."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Final, Protocol

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, Playwright, sync_playwright

from maestra.web.access.visitor import Role
from tests.browser.roles import log_in
from tests.browser.serving import Served, serving
from tests.browser.sizes import Size
from tests.browser.watching import Watch

CHROMIUM = "/usr/bin/chromium"
ARGUMENTS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)
PATIENCE_MS = 20_000
"""Two cores may be busy with other tests."""

WHOLE: Final = "MAESTRA_BROWSER"
"""Set to anything, all tests here are run, as `make browser` does."""
EACH_TIME: Final = (
    "test_board_moves.py",
    "test_no_page_is_forgotten_here",
    "test_every_caregivers_page_is_for_everybody[desktop]",
    "test_every_patients_page_is_for_everybody[desktop]",
    "test_policy.py",
    "test_shell.py",
    "test_a_newcomer_teaches_ascending_by_drag",
    "test_a_whole_day_from_the_first_start_to_an_erasure[desktop]",
)
"""What `make test` runs of them: all would take longer than all other tests together."""


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what takes too long for each time; count no lines while a page waits for them."""
    here = Path(__file__).parent
    for item in items:
        if item.path.is_relative_to(here):
            item.add_marker(pytest.mark.no_cover)
    if os.environ.get(WHOLE):
        return
    long = [
        item
        for item in items
        if item.path.is_relative_to(here) and not any(one in item.nodeid for one in EACH_TIME)
    ]
    config.hook.pytest_deselected(items=long)
    items[:] = [item for item in items if item not in set(long)]


# Of a module, not of the session: while Playwright runs, no other event loop may run in this
# thread, and other tests have loops of their own.
@pytest.fixture(scope="module")
def playwright() -> Iterator[Playwright]:
    with sync_playwright() as running:
        yield running


@pytest.fixture(scope="module")
def browser(playwright: Playwright) -> Iterator[Browser]:
    browser = playwright.chromium.launch(executable_path=CHROMIUM, args=[*ARGUMENTS])
    yield browser
    browser.close()


@pytest.fixture
def served(tmp_path: Path) -> Iterator[Served]:
    """The app on a server of this test alone."""
    with serving(tmp_path) as one:
        yield one


@pytest.fixture
def watch(served: Served) -> Iterator[Watch]:
    """What goes wrong in any page; the test fails for it unless it tolerates it."""
    watch = Watch(served.url)
    yield watch
    assert watch.found() == []


class OpenBrowser(Protocol):
    """Opens a browser of its own: with its own cookies, at a size."""

    def __call__(self, size: Size = Size.DESKTOP, *, language: str = "en") -> BrowserContext: ...


@pytest.fixture
def open_browser(browser: Browser, served: Served, watch: Watch) -> Iterator[OpenBrowser]:
    opened: list[BrowserContext] = []

    def open_one(size: Size = Size.DESKTOP, *, language: str = "en") -> BrowserContext:
        context = browser.new_context(
            base_url=served.url,
            viewport={"width": size.width, "height": size.height},
            has_touch=size.is_touched,
            is_mobile=size.is_touched,
            locale=language,
        )
        context.set_default_timeout(PATIENCE_MS)
        watch.over(context)
        opened.append(context)
        return context

    yield open_one
    for context in opened:
        context.close()


@pytest.fixture(params=Size, ids=lambda one: one.name.lower())
def size(request: pytest.FixtureRequest) -> Size:
    """Each of the screens."""
    asked: object = request.param
    assert isinstance(asked, Size)
    return asked


@pytest.fixture
def page(open_browser: OpenBrowser) -> Page:
    """A page on a desktop; nobody is logged in."""
    return open_browser().new_page()


@pytest.fixture
def caregiver(page: Page, served: Served) -> Page:
    """A page on a desktop, of a caregiver who has logged in."""
    return log_in(served, page, Role.CAREGIVER)


@pytest.fixture
def caregiver_at(open_browser: OpenBrowser, served: Served, size: Size) -> Page:
    """The same on each of the screens."""
    return log_in(served, open_browser(size).new_page(), Role.CAREGIVER)
