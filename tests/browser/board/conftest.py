"""The table's app instead of the real one, and pages on it in which nothing may go wrong."""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Protocol

import pytest
from playwright.sync_api import Browser, Locator, Page

from tests.browser.board.table import Table, table_app
from tests.browser.serving import listening
from tests.browser.watching import Watch

PATIENCE_MS = 20_000
WIDTH, HEIGHT = 1280, 1000


@pytest.fixture
def table() -> Table:
    return Table()


@pytest.fixture
def address(table: Table) -> Iterator[str]:
    with listening(table_app(table)) as url:
        yield url


@pytest.fixture
def watch(address: str) -> Iterator[Watch]:
    """What goes wrong in any page; the test fails for it unless it tolerates it."""
    watch = Watch(address)
    yield watch
    assert watch.found() == []


@dataclass(frozen=True)
class Seat:
    """A page in front of the table."""

    page: Page

    def cell(self, row: int, column: int) -> Locator:
        """One of the board's cells."""
        return self.page.locator(f'button.cell[value="{row},{column}"]')

    def token(self, name: str) -> Locator:
        """One of the board's tokens."""
        return self.page.locator(f'[data-board] [data-token="{name}"]')

    def middle(self, row: int, column: int) -> tuple[float, float]:
        """The middle of a cell on the screen."""
        box = self.cell(row, column).bounding_box()
        assert box is not None
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def lies_on(self, name: str) -> str:
        """The cell on which a token is shown."""
        return self.token(name).locator("..").get_attribute("value") or ""

    def until(self, is_so: Callable[[], bool]) -> None:
        """Wait until the table is so; the test fails if it never is."""
        patience = time.monotonic() + PATIENCE_MS / 1000
        while not is_so():
            assert time.monotonic() < patience
            self.page.wait_for_timeout(20)


class TakeSeat(Protocol):
    """Opens a page of the table in a browser of its own."""

    def __call__(
        self,
        path: str = "/",
        *,
        script: bool = True,
        touch: bool = False,
        still: bool = False,
        size: tuple[int, int] = (WIDTH, HEIGHT),
    ) -> Seat: ...


@pytest.fixture
def sit(browser: Browser, address: str, watch: Watch) -> Iterator[TakeSeat]:
    opened: list[Page] = []

    def take(
        path: str = "/",
        *,
        script: bool = True,
        touch: bool = False,
        still: bool = False,
        size: tuple[int, int] = (WIDTH, HEIGHT),
    ) -> Seat:
        context = browser.new_context(
            base_url=address,
            viewport={"width": size[0], "height": size[1]},
            java_script_enabled=script,
            has_touch=touch,
            reduced_motion="reduce" if still else "no-preference",
            locale="en",
        )
        context.set_default_timeout(PATIENCE_MS)
        watch.over(context)
        page = context.new_page()
        opened.append(page)
        page.goto(path)
        if script:
            page.wait_for_selector("html[data-ready]")
        return Seat(page)

    yield take
    for page in opened:
        page.context.close()
