"""The same for programs."""

import pytest

from maestra.coaching.ports import PatientId
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from tests.web.patients.conftest import As

HERON = {"pseudonym": "heron", "name": "Rosa Vidal", "profile": {"mental": "mild"}}


def test_a_patient_is_made_read_and_erased(browsing: As) -> None:
    browser = browsing()
    made = browser.post("/api/patients", json=HERON)
    expected: dict[str, object] = {
        "pseudonym": "heron",
        "name": "Rosa Vidal",
        "exercises": [],
        "sessions": 0,
    }
    assert (made.status_code, made.json()) == (201, expected)
    assert browser.get("/api/patients").json() == [expected]
    assert browser.get("/api/patients/heron").json() == expected
    assert browser.get("/api/patients/heron/everything").json()["name"] == "Rosa Vidal"
    assert browser.delete("/api/patients/heron").json() == {"cleaned": True}
    assert browser.get("/api/patients").json() == []


def test_a_researcher_sees_pseudonyms_and_no_names(browsing: As) -> None:
    browsing().post("/api/patients", json=HERON)
    researcher = browsing("rita", Role.RESEARCHER)
    (found,) = researcher.get("/api/patients").json()
    assert (found["pseudonym"], found["name"]) == ("heron", None)
    assert researcher.get("/api/patients/heron").json()["name"] is None
    for path in ("everything", "settings", "exercises"):
        assert researcher.get(f"/api/patients/heron/{path}").status_code == 403
    assert researcher.delete("/api/patients/heron").status_code == 403


def test_another_caregivers_patient_is_not_there(browsing: As) -> None:
    browsing("ann").post("/api/patients", json=HERON)
    bob = browsing("bob")
    assert bob.get("/api/patients").json() == []
    for path in ("", "/settings", "/exercises", "/everything"):
        assert bob.get(f"/api/patients/heron{path}").status_code == 404
    assert bob.delete("/api/patients/heron").status_code == 404


@pytest.mark.parametrize(
    ("new", "where"),
    [
        ({}, "pseudonym"),
        ({"pseudonym": ""}, "pseudonym"),
        ({"pseudonym": "x" * 61}, "pseudonym"),
        ({"pseudonym": "a\tb"}, "pseudonym"),
        ({"pseudonym": "Rosa", "name": "rosa"}, "pseudonym"),
        ({"pseudonym": "a", "name": ""}, "name"),
        ({"pseudonym": "a", "profile": {"mental": "odd"}}, "profile.mental"),
        ({"pseudonym": "a", "more": 1}, "more"),
    ],
)
def test_who_cannot_be_a_patient_is_refused_at_the_field(
    browsing: As, context: Context, new: dict[str, object], where: str
) -> None:
    answer = browsing().post("/api/patients", json=new)
    assert answer.status_code == 422
    assert answer.json()["faults"][0]["where"] == where
    assert context.store.patients() == ()


def test_a_pseudonym_is_taken_once(browsing: As) -> None:
    browsing("ann").post("/api/patients", json=HERON)
    assert browsing("bob").post("/api/patients", json=HERON).status_code == 422


def test_settings_are_read_and_changed(browsing: As) -> None:
    browser = browsing()
    browser.post("/api/patients", json=HERON)
    read = browser.get("/api/patients/heron/settings").json()
    assert read["settings"]["speech_wpm"] == 140
    read["settings"]["speech_wpm"] = 120
    changed = browser.put("/api/patients/heron/settings", json=read)
    assert changed.json() == read == browser.get("/api/patients/heron/settings").json()


@pytest.mark.parametrize(
    ("settings", "where"),
    [
        ({"speech_wpm": 1}, "settings.speech_wpm"),
        ({"level": 0, "least_level": 1}, "settings.level"),
        ({"shoe": 1}, "settings.shoe"),
    ],
)
def test_wrong_settings_are_refused_at_the_field(
    browsing: As, settings: dict[str, int], where: str
) -> None:
    browser = browsing()
    browser.post("/api/patients", json=HERON)
    body = {"format": "maestra.settings/1", "settings": settings}
    answer = browser.put("/api/patients/heron/settings", json=body)
    assert answer.status_code == 422
    assert answer.json()["faults"][0]["where"] == where


def test_settings_of_a_newer_format_are_refused(browsing: As) -> None:
    browser = browsing()
    browser.post("/api/patients", json=HERON)
    body: dict[str, object] = {"format": "maestra.settings/2", "settings": {}}
    assert browser.put("/api/patients/heron/settings", json=body).status_code == 422


def test_exercises_of_the_library_are_assigned(browsing: As) -> None:
    browser = browsing()
    browser.post("/api/patients", json=HERON)
    body = {"exercises": ["ascending", "ascending"]}
    answer = browser.put("/api/patients/heron/exercises", json=body)
    assert answer.json() == {"exercises": ["ascending"]}
    assert browser.get("/api/patients/heron/exercises").json() == answer.json()
    wrong = browser.put("/api/patients/heron/exercises", json={"exercises": ["nowhere"]})
    assert wrong.json()["faults"][0]["where"] == "exercises[0]"


def test_what_a_program_does_is_noted(browsing: As, context: Context) -> None:
    browser = browsing()
    browser.post("/api/patients", json=HERON)
    browser.get("/api/patients/heron/everything")
    noted = {(one.act, one.patient) for one in context.store.custody.audit()}
    assert {("read", "heron"), ("exported", "heron"), ("changed", "heron")} <= noted
    assert context.store.patients() == (PatientId("heron"),)
