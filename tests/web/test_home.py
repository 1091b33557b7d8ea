from collections.abc import Callable

import pytest
from fastapi.testclient import TestClient

from maestra.web.access.visitor import Role
from maestra.web.headers import HEADERS

Login = Callable[[Role], TestClient]


def test_the_first_page_offers_what_the_role_may_do(somebody: Login) -> None:
    assert "Set up a patient" in somebody(Role.CAREGIVER).get("/").text
    assert "Set up a patient" not in somebody(Role.RESEARCHER).get("/").text


@pytest.mark.parametrize("path", ["/", "/static/maestra.css", "/nowhere"])
def test_every_answer_carries_the_headers(somebody: Login, path: str) -> None:
    answer = somebody(Role.CAREGIVER).get(path)
    assert {name: answer.headers[name] for name in HEADERS} == HEADERS


def test_the_language_is_the_browsers_until_another_is_chosen(somebody: Login) -> None:
    browser = somebody(Role.CAREGIVER)
    browser.headers["accept-language"] = "fr-FR, es-ES;q=0.9"
    assert '<html lang="es">' in browser.get("/").text
    assert '<html lang="ca">' in browser.post("/language", data={"language": "ca"}).text


@pytest.mark.parametrize(
    "back", ["//elsewhere.example", "https://elsewhere.example", "/\\x.example"]
)
def test_choosing_a_language_never_leads_elsewhere(somebody: Login, back: str) -> None:
    browser = somebody(Role.CAREGIVER)
    answer = browser.post(
        "/language", data={"language": "es", "back": back}, follow_redirects=False
    )
    assert answer.headers["location"] == "/"
