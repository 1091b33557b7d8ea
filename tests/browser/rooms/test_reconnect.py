"""A patient plays on while the way to the server is cut: nothing is lost, nothing said twice.

`make test` cuts for 0.5, 2 and 8 seconds; `make reconnect` also for a minute.
"""

import json
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from maestra.coaching.events import Begun, HelpAsked
from maestra.coaching.settings import Helper, Settings
from maestra.core.board import Cell
from maestra.core.state import Move
from maestra.language import Language
from maestra.web.access.visitor import Role
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from tests.browser.conftest import OpenBrowser
from tests.browser.roles import log_in
from tests.browser.rooms.cutting import Cable, cable_to
from tests.browser.serving import Served, serving
from tests.browser.watching import Watch
from tests.web.rooms.exercises import HERON, prepare, right_move, wrong_move

CUTS_S = [float(one) for one in os.environ.get("MAESTRA_CUTS_S", "0.5 2 8").split()]
BACK_WITHIN_S = 30.0


@pytest.fixture
def server(tmp_path: Path) -> Iterator[Served]:
    with serving(tmp_path) as one:
        yield one


@pytest.fixture
def cable(server: Served) -> Iterator[Cable]:
    with cable_to(server.url) as one:
        yield one


@pytest.fixture
def served(server: Served, cable: Cable) -> Served:
    """The server at the other end of the cable."""
    return replace(server, url=cable.url)


@pytest.fixture
def room(served: Served) -> Room:
    """A session under way, in Spanish, with a robot that puts tokens back."""
    language, helper = Language.ES, Helper.ROBOT
    prepare(served.context.store, Settings(language=language, robot_moves=True, put_back=helper))
    rooms = served.app.state.rooms
    assert isinstance(rooms, Rooms)
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    return room


@pytest.fixture
def page(room: Room, served: Served, watch: Watch, open_browser: OpenBrowser) -> Page:
    """The patient's page, by the cable; the browser itself is English."""
    # The browser itself notes in its console that it cannot connect; the page says nothing.
    watch.tolerate("WebSocket connection|ERR_")
    page = open_browser(language="en").new_page()
    log_in(served, page, Role.ADMINISTRATOR)
    page.goto(f"/rooms/{room.name}")
    expect(page.locator("html")).to_have_attribute("data-ready", "")
    page.evaluate("window.same = true")
    return page


def cell(page: Page, where: Cell) -> None:
    page.locator(f'button.cell[value="{where.row},{where.column}"]').click()


def make(page: Page, move: Move) -> None:
    """Tap, tap."""
    cell(page, move.origin)
    cell(page, move.destination)


def wait_until(is_so: Callable[[], bool], within_s: float = BACK_WITHIN_S) -> None:
    until = time.monotonic() + within_s
    while not is_so():
        assert time.monotonic() < until
        time.sleep(0.05)


def told(room: Room, served: Served) -> list[str]:
    """What has been kept of the session, event by event."""
    assert room.stored is not None
    entries = served.context.store.events.entries(room.stored.session)
    kept = [json.loads(one.payload)["what"] for one in entries if one.kind == "event"]
    return [f"{one['event']} {one.get('token', '')}".strip() for one in kept]


def follows(page: Page, room: Room) -> None:
    """The page shows what the server knows, and is the page that it was."""
    said = room.state.said
    assert said is not None
    expect(page.locator("[data-show=sentence]")).to_have_text(said.text, timeout=30_000)
    for token, where in (room.state.cells or {}).items():
        at = page.locator(
            f'button.cell[value="{where.row},{where.column}"] [data-token="{token}"]'
        )
        expect(at).to_have_count(1)
    assert page.evaluate("window.same") is True
    assert page.locator("html").get_attribute("lang") == "es"


@pytest.mark.parametrize("seconds", CUTS_S)
@pytest.mark.parametrize("silently", [False, True], ids=["closed", "silent"])
def test_what_is_done_in_a_cut_is_told_once_after_it(
    page: Page, room: Room, served: Served, cable: Cable, *, seconds: float, silently: bool
) -> None:
    make(page, right_move(room))
    wait_until(lambda: room.state.moves == 1)
    move = right_move(room)
    cable.cut(silently=silently)
    make(page, move)
    # What the server does meanwhile is not missed, and what the page shows is not in the way.
    room.tell(HelpAsked())
    time.sleep(seconds)
    at = page.locator(f'button.cell[value="{move.destination.row},{move.destination.column}"]')
    expect(at.locator(f'[data-token="{move.token}"]')).to_have_count(1)
    cable.mend()
    wait_until(lambda: room.state.moves == 2)
    follows(page, room)
    kept = told(room, served)
    assert kept.count(f"lifted {move.token}") == kept.count(f"placed {move.token}") == 1
    assert page.locator("html").get_attribute("data-lost") is None


def test_a_token_that_was_to_be_put_back_in_a_cut_is_put_back_once(
    page: Page, room: Room, served: Served, cable: Cable
) -> None:
    move = wrong_move(room)
    cable.cut()
    make(page, move)
    time.sleep(1)
    cable.mend()
    wait_until(lambda: room.session.table.cells.get(move.token) == move.origin)
    wait_until(lambda: "robot-done" in told(room, served))
    follows(page, room)
    time.sleep(1)
    kept = told(room, served)
    assert kept.count(f"placed {move.token}") == 2
    assert kept.count("robot-done") == 1


def test_a_page_opened_twice_puts_a_token_back_once(
    page: Page, room: Room, served: Served
) -> None:
    other = page.context.new_page()
    other.goto(f"/rooms/{room.name}")
    expect(other.locator("html")).to_have_attribute("data-ready", "")
    move = wrong_move(room)
    make(page, move)
    wait_until(lambda: "robot-done" in told(room, served))
    time.sleep(2)
    kept = told(room, served)
    assert kept.count(f"placed {move.token}") == 2
    assert kept.count("robot-done") == 1
    follows(page, room)


def test_the_server_is_stopped_and_started_and_the_page_goes_on(
    page: Page, room: Room, served: Served, cable: Cable
) -> None:
    """The rooms are made anew from the record, as when the server starts."""
    cable.cut()
    move = right_move(room)
    make(page, move)
    served.app.state.rooms = Rooms(served.context.store, served.context.clock, can_speak=True)
    again = served.app.state.rooms.of(HERON)
    assert isinstance(again, Room)
    cable.mend()
    wait_until(lambda: again.session.table.cells.get(move.token) == move.destination)
    assert again.state.phase == "paused"
    follows(page, again)
    page.get_by_role("button", name="Seguir jugando").click()
    wait_until(lambda: again.state.phase == "playing")
