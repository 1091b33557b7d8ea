"""A patient's whole way: made, set up, accompanied, looked at, erased; on each of the screens."""

import json
import re

from playwright.sync_api import Locator, Page, expect

from maestra.coaching.ports import PatientId
from maestra.coaching.session import Phase
from maestra.core.board import Cell
from maestra.core.state import Move
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from tests.browser.conftest import PATIENCE_MS
from tests.browser.lint import Reader, lint
from tests.browser.serving import Served
from tests.web.rooms.exercises import right_move, wrong_move

HERON = PatientId("heron")
expect.set_options(timeout=PATIENCE_MS)


def room_of(served: Served) -> Room:
    rooms = served.app.state.rooms
    assert isinstance(rooms, Rooms)
    found = rooms.of(HERON)
    assert found is not None
    return found


def at(page: Page, cell: Cell) -> Locator:
    return page.locator(f'#board [value="{cell.row},{cell.column}"]')


def make(page: Page, room: Room, move: Move) -> None:
    """Tap the token, tap the cell; done once the server knows."""
    before = room.state.sequence
    at(page, room.state.cells[move.token] if room.state.cells else move.origin).click()
    at(page, move.destination).click()
    expect(page.locator("[data-refresh]")).not_to_have_attribute("data-refresh", str(before))
    expect(at(page, move.destination).locator(".token")).to_have_count(1)


def make_a_patient(page: Page) -> None:
    page.goto("/patients")
    page.get_by_role("link", name="New patient").click()
    page.get_by_label("Pseudonym").fill("heron")
    page.get_by_label("Name, if you like").fill("Rosa Vidal")
    page.get_by_label("Thinking and remembering").select_option("mild")
    page.get_by_role("button", name="Make this patient").click()
    expect(page.get_by_text("The patient is ready.")).to_be_visible()
    page.get_by_label("Five numbers, ascending").check()
    page.get_by_role("button", name="Save the exercises").click()
    expect(page.get_by_text("The exercises are saved.")).to_be_visible()


def change_settings(page: Page) -> None:
    page.get_by_role("link", name="Settings", exact=True).click()
    with page.expect_response(re.compile("/settings/draft")) as kept:
        page.get_by_label("Loudness").fill("33")
    assert kept.value.status == 204
    # Nothing typed is lost by a reload.
    page.reload()
    expect(page.get_by_label("Loudness")).to_have_value("33")
    expect(page.get_by_text("typed and is not in use yet")).to_be_visible()
    page.get_by_label("Loudness").fill("101")
    page.get_by_role("button", name="Save the settings").click()
    page.get_by_label("Loudness").fill("60")
    page.get_by_role("button", name="Save the settings").click()
    expect(page.get_by_text("Saved. It is in use")).to_be_visible()
    page.get_by_role("button", name="Take the last change back").click()
    expect(page.get_by_label("Loudness")).to_have_value("80")
    page.get_by_label("Moving").select_option("slight")
    page.get_by_role("button", name="See what follows from this").click()
    expect(page.get_by_text("These settings would follow")).to_be_visible()
    page.get_by_role("button", name="Take what is ticked").click()
    expect(page.get_by_role("spinbutton", name="Patience")).to_have_value("20")


def hear_the_robot(page: Page) -> None:
    page.get_by_role("link", name="What the robot says").click()
    expect(page.get_by_text("After a wrong move")).to_be_visible()
    before = page.locator("#lines").inner_text()
    page.get_by_role("button", name="Say it in another way").click()
    expect(page.locator("#lines")).not_to_have_text(before)


def accompany(page: Page, served: Served) -> None:
    """With an error, a hint, putting back, another word, a pause; to the end."""
    page.goto("/patients/heron")
    page.get_by_role("link", name="Start a session").click()
    page.get_by_role("button", name="Lay the tokens out").click()
    page.get_by_role("button", name="Begin the session").click()
    expect(page.get_by_text("The session is under way.")).to_be_visible()
    room = room_of(served)
    wrong = wrong_move(room)
    make(page, room, wrong)
    expect(page.get_by_role("button", name="That was right")).to_be_visible()
    expect(page.locator("#why")).to_contain_text("The patient is asked to put it back.")
    assert lint(page, Reader.CAREGIVER) == []
    make(page, room, Move(wrong.token, wrong.destination, wrong.origin))
    expect(page.get_by_role("button", name="That was right")).to_have_count(0)
    page.get_by_label("Have the robot help").select_option("hint:4")
    page.get_by_role("button", name="Help now").click()
    expect(page.locator("#why")).to_contain_text("Help at level 4 of 5")
    make(page, room, right_move(room))
    page.get_by_role("button", name="That was wrong").click()
    expect(page.locator("#why")).to_contain_text("A token lies wrong.")
    page.get_by_role("button", name="That was right").click()
    expect(page.get_by_role("button", name="That was wrong")).to_be_visible()
    page.get_by_role("button", name="Pause", exact=True).click()
    expect(page.get_by_text("The session is paused.")).to_be_visible()
    page.get_by_role("button", name="Go on playing").click()
    expect(page.get_by_text("The session is under way.")).to_be_visible()
    play_on(page, room)
    expect(page.get_by_text("The exercise is complete.")).to_be_visible()


def play_on(page: Page, room: Room) -> None:
    while room.session.phase is not Phase.ENDED:
        make(page, room, right_move(room))


def replay(page: Page) -> None:
    """By buttons, by the slider with the keyboard, by the moments."""
    page.get_by_role("link", name="See it again").click()
    expect(page.get_by_text("Moment 0 of")).to_be_visible()
    page.get_by_role("button", name="Forward").click()
    expect(page.get_by_text("Moment 1 of")).to_be_visible()
    page.locator("#at").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_text("Moment 2 of")).to_be_visible()
    page.get_by_role("row", name=re.compile("refused")).get_by_role("link").first.click()
    expect(page.get_by_text("The move was refused.")).to_be_visible()
    expect(page.locator("#board [data-wrong]")).to_have_count(1)
    assert lint(page, Reader.CAREGIVER) == []


def look_at_progress(page: Page) -> None:
    page.goto("/progress")
    page.get_by_role("link", name="heron").click()
    page.get_by_role("link", name="Five numbers, ascending", exact=True).click()
    expect(page.get_by_role("img")).to_have_count(4)
    page.goto("/progress/heron/print")
    expect(page.get_by_role("heading", name="How heron gets on")).to_be_visible()
    page.goto("/progress/heron")
    with page.expect_download() as download:
        page.get_by_role("link", name="JSONL").click()
    lines = download.value.path().read_text("utf-8").splitlines()
    assert {json.loads(line)["patient"] for line in lines} == {"heron"}
    assert "Rosa" not in "".join(lines)


def erase(page: Page) -> None:
    page.goto("/patients/heron")
    page.get_by_role("link", name="Erase this patient").click()
    expect(page.get_by_text("It cannot be taken back.")).to_be_visible()
    page.get_by_role("button", name="Erase for ever").click()
    expect(page.get_by_text("The patient is erased.")).to_be_visible()
    expect(page.get_by_role("link", name="heron")).to_have_count(0)


def test_a_patient_is_made_accompanied_looked_at_and_erased(
    caregiver_at: Page, served: Served
) -> None:
    page = caregiver_at
    make_a_patient(page)
    change_settings(page)
    hear_the_robot(page)
    accompany(page, served)
    replay(page)
    look_at_progress(page)
    erase(page)
    assert served.context.store.patients() == ()
