"""The first day with Maestra, on every screen: from the set-up code to a patient's erasure."""

import json
import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import OpenBrowser
from tests.browser.serving import Served
from tests.browser.sizes import Size
from tests.web.people import PASSWORD

WORD = "CURIE"


@pytest.fixture
def day(open_browser: OpenBrowser, size: Size) -> Page:
    return open_browser(size).new_page()


def test_a_whole_day_from_the_first_start_to_an_erasure(day: Page, served: Served) -> None:
    set_up(day, served.context.doors.open_set_up())
    make_patient(day)
    room = begin_session(day)
    play(day, room)
    see_progress(day)
    take_everything_and_erase(day, served)
    log_out(day)


def set_up(page: Page, code: str) -> None:
    page.goto("/")
    expect(page.get_by_role("heading", name="Welcome to Maestra")).to_be_visible()
    page.get_by_label("Code").fill(code)
    page.get_by_label("Your name").fill("Ana")
    page.get_by_label("Your new password").fill(PASSWORD)
    page.get_by_role("button", name="Begin").click()
    expect(page.get_by_role("heading", name="What would you like to do?")).to_be_visible()


def make_patient(page: Page) -> None:
    page.get_by_role("link", name="Set up a patient").click()
    page.get_by_role("link", name="New patient").click()
    page.get_by_label("Pseudonym", exact=True).fill("heron")
    page.get_by_label("Name, if you like").fill("Montserrat Pujol")
    page.get_by_role("button", name="Make this patient").click()
    page.get_by_label("Spell CURIE").check()
    page.get_by_role("button", name="Save the exercises").click()
    expect(page.get_by_text("The exercises are saved.")).to_be_visible()


def begin_session(page: Page) -> str:
    page.get_by_role("link", name="Start a session").click()
    expect(page.get_by_label("Spell CURIE")).to_be_checked()
    page.get_by_role("button", name="Lay the tokens out").click()
    page.wait_for_url(re.compile(r"/sessions/\d+$"))
    return page.url.rsplit("/", 1)[-1]


def press(page: Page, cell: str) -> None:
    page.locator(f'button.cell[value="{cell}"]').click()


def cell_of(page: Page, token: str) -> str:
    return page.locator(f'[data-token="{token}"]').locator("..").get_attribute("value") or ""


def move(page: Page, token: str, cell: str) -> None:
    press(page, cell_of(page, token))
    page.locator(
        f'.board[data-held="{token}"], .cell[data-held] [data-token="{token}"]'
    ).first.wait_for()
    press(page, cell)


def lies_on(page: Page, token: str, cell: str) -> None:
    at = f'button.cell[value="{cell}"] [data-token="{token}"]'
    expect(page.locator(at)).to_be_visible()


def play(caregiver: Page, room: str) -> None:
    """With two mistakes that are put back, and help in between; the caregiver watches."""
    patient = caregiver.context.new_page()
    patient.goto(f"/rooms/{room}")
    patient.get_by_role("button", name="Let us begin").click()
    expect(patient.locator(".said[data-show]")).not_to_be_empty()
    home = cell_of(patient, "A")
    move(patient, "A", "1,1")
    place = "row {}, column {}".format(*home.split(","))
    expect(patient.locator(".said[data-show]")).to_contain_text(place)
    move(patient, "A", home)
    lies_on(patient, "A", home)
    move(patient, "C", "1,1")
    lies_on(patient, "C", "1,1")
    said = patient.locator(".said[data-show]").inner_text()
    patient.get_by_role("button", name="Help me").click()
    expect(patient.locator(".said[data-show]")).not_to_have_text(said)
    for column, letter in enumerate(WORD[1:], start=2):
        move(patient, letter, f"1,{column}")
        lies_on(patient, letter, f"1,{column}")
    expect(patient.locator("main")).to_have_attribute("data-phase", "ended")
    expect(caregiver.get_by_text("The exercise is complete.")).to_be_visible()
    expect(caregiver.get_by_text("Refused moves: 1")).to_be_visible()
    patient.close()


def see_progress(page: Page) -> None:
    page.get_by_role("link", name="See it again, step by step").click()
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    page.goto("/progress/heron")
    expect(page.get_by_text("Spell CURIE").first).to_be_visible()
    page.goto("/progress/heron/print")
    expect(page.get_by_text("Spell CURIE").first).to_be_visible()


def take_everything_and_erase(page: Page, served: Served) -> None:
    page.goto("/patients/heron")
    with page.expect_download() as taken:
        page.get_by_role("link", name="Download everything").click()
    everything = json.loads(taken.value.path().read_text("utf-8"))
    assert everything["patient"] == "heron"
    assert everything["name"] == "Montserrat Pujol"
    assert len(everything["sessions"]) == 1
    page.get_by_role("link", name="Erase this patient").click()
    page.get_by_role("button", name="Erase for ever").click()
    expect(page.get_by_role("heading", level=1)).to_have_text("Patients")
    assert served.context.store.patients() == ()
    page.goto("/patients")
    expect(page.get_by_text("heron")).to_have_count(0)
    expect(page.get_by_text(re.compile("Montserrat"))).to_have_count(0)


def log_out(page: Page) -> None:
    page.goto("/account")
    page.get_by_role("button", name="Log out").click()
    page.goto("/patients")
    expect(page.get_by_role("heading", name="Log in")).to_be_visible()
