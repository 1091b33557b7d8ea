"""A caregiver teaches on the pages, as a browser without script sends them."""

import re
from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient

from maestra.web.access.visitor import Role

Login = Callable[[Role], TestClient]


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


def begun(browser: TestClient, deck: str = "numbers") -> str:
    answer = browser.post("/teach", data={"deck": deck}, follow_redirects=False)
    assert answer.status_code == 303
    return answer.headers["location"]


def place_of(page: str, token: str) -> str:
    """The cell where a token lies, as its button has it."""
    found = re.search(rf'value="(\d+,\d+)" aria-label="[^"]*token {token}"', page)
    assert found, token
    return found[1]


def press(browser: TestClient, root: str, cell: str) -> str:
    answer = browser.post(f"{root}/move", data={"cell": cell})
    assert answer.status_code == 200
    return answer.text


def show_row(browser: TestClient, root: str, tokens: str) -> str:
    page = browser.get(f"{root}?more=yes").text
    for column, token in enumerate(tokens.split(), start=1):
        press(browser, root, place_of(page, token))
        page = press(browser, root, f"1,{column}")
    return page


def test_a_newcomer_teaches_ascending_and_saves_it(caregiver: TestClient) -> None:
    root = begun(caregiver)
    page = show_row(caregiver, root, "19 32 46 57 68")
    assert "Fill the whole of the top row." in page
    page = caregiver.post(f"{root}/reply", data={"said": "yes"}).text
    assert "I am 9" in page
    page = caregiver.post(f"{root}/save", data={"name": "Ascending"}).text
    assert "Saved as “Ascending”, version 1." in page


PLACES = ["", "/tokens", "/features", "/words", "/try", "/exam"]


@pytest.mark.parametrize("language", ["en", "es", "ca"])
def test_each_page_is_there_from_the_start_in_each_language(
    caregiver: TestClient, language: str
) -> None:
    caregiver.post("/language", data={"language": language})
    root = begun(caregiver)
    for place in PLACES:
        assert f'<html lang="{language}">' in caregiver.get(f"{root}{place}").text


@pytest.mark.parametrize("deck", ["letters", "words", "shapes"])
def test_each_deck_has_its_pages(caregiver: TestClient, deck: str) -> None:
    root = begun(caregiver, deck)
    for place in PLACES:
        assert caregiver.get(f"{root}{place}").status_code == 200
