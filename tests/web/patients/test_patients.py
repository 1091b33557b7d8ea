"""Patients: listed, found, made, named, erased, and nobody else's business."""

import json

import pytest

from maestra.coaching.ports import PatientId
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from tests.web.patients.conftest import PROFILE, As, make

HERON = PatientId("heron")


def test_a_new_patient_stands_in_the_list_with_what_was_said(browsing: As) -> None:
    browser = browsing()
    assert "There are no patients yet" in browser.get("/patients").text
    make(browser, "heron", name="Rosa Vidal", mental="mild", language="es")
    listed = browser.get("/patients").text
    assert "heron" in listed
    assert "Rosa Vidal" in listed
    page = browser.get("/patients/heron").text
    assert "mildly impaired" in page
    assert "español" in page


def test_the_form_proposes_a_pseudonym_that_nobody_has(browsing: As) -> None:
    browser = browsing()
    for pseudonym in ("P01", "P02", "P04"):
        assert f'value="{pseudonym}"' in browser.get("/patients/new").text or pseudonym == "P04"
        make(browser, pseudonym)
    assert 'value="P05"' in browser.get("/patients/new").text


@pytest.mark.parametrize("wanted", ["HER", "vidal", " rosa "])
def test_patients_are_found_by_pseudonym_and_by_name(browsing: As, wanted: str) -> None:
    browser = browsing()
    make(browser, "heron", name="Rosa Vidal")
    make(browser, "plover")
    found = browser.get("/patients", params={"q": wanted}).text
    assert "/patients/heron" in found
    assert "/patients/plover" not in found
    assert "Nobody was found" in browser.get("/patients", params={"q": "zzz"}).text


@pytest.mark.parametrize(
    ("form", "line"),
    [
        ({"pseudonym": ""}, "pseudonym of 1 to 60 letters"),
        ({"pseudonym": "x" * 61}, "pseudonym of 1 to 60 letters"),
        ({"pseudonym": "a\x07b"}, "pseudonym of 1 to 60 letters"),
        ({"pseudonym": "Rosa", "name": "rosa"}, "must not be the name"),
        ({"pseudonym": "heron", "name": "a\tb"}, "a name on one line"),
        ({"pseudonym": "heron", "name": "n" * 1_001}, "a name on one line"),
        ({"pseudonym": "heron", "mental": "awful"}, "choose one of these"),
        ({"pseudonym": "heron", "language": "tlh"}, "choose one of these"),
        ({"pseudonym": "taken"}, "This pseudonym is taken"),
    ],
)
def test_a_wrong_field_is_said_and_nothing_is_kept(
    browsing: As, context: Context, form: dict[str, str], line: str
) -> None:
    make(browsing("bob"), "taken")
    answer = browsing().post("/patients", data={"language": "en", **PROFILE, **form})
    assert answer.status_code == 422
    assert line in answer.text
    assert context.store.patients() == ("taken",)


def test_another_caregivers_patient_is_not_there(browsing: As) -> None:
    make(browsing("ann"), "heron")
    bob = browsing("bob")
    assert "heron" not in bob.get("/patients").text
    for path in ("", "/settings", "/preview", "/erase", "/everything.json"):
        assert bob.get(f"/patients/heron{path}").status_code == 404
    assert bob.post("/patients/heron/erase").status_code == 404


def test_researchers_have_no_page_of_patients(browsing: As) -> None:
    make(browsing("ann"), "heron")
    researcher = browsing("rita", Role.RESEARCHER)
    assert researcher.get("/patients").status_code == 403
    assert researcher.get("/patients/heron").status_code == 403


def test_an_administrator_sees_all_patients(browsing: As) -> None:
    make(browsing("ann"), "heron")
    assert "heron" in browsing("root", Role.ADMINISTRATOR).get("/patients").text


def test_a_name_is_kept_later_too_but_never_the_pseudonym(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    answer = browser.post("/patients/heron/name", data={"name": "heron"})
    assert answer.status_code == 422
    assert "other than the pseudonym" in answer.text
    assert "The name is saved" in browser.post("/patients/heron/name", data={"name": "Rosa"}).text
    assert context.store.name(HERON) == "Rosa"


def test_exercises_of_the_library_are_assigned_and_others_are_not(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    make(browser, "heron")
    form = {"exercise": ["ascending", "nowhere"]}
    assert "The exercises are saved" in browser.post("/patients/heron/exercises", data=form).text
    assert json.loads(context.store.plan(HERON))["plan"]["exercises"] == ["ascending"]
    browser.post("/patients/heron/exercises", data={})
    assert json.loads(context.store.plan(HERON))["plan"]["exercises"] == []


@pytest.mark.parametrize("pseudonym", ["a/b", "..", "new", "~x", "ñandú 50% ?#", "a\\b"])
def test_whatever_the_pseudonym_its_pages_are_reached(browsing: As, pseudonym: str) -> None:
    browser = browsing()
    make(browser, pseudonym)
    listed = browser.get("/patients").text
    address = listed.split('<th scope="row"><a href="')[1].split('"')[0]
    page = browser.get(address)
    assert page.status_code == 200
    assert "The exercises are saved" in browser.post(f"{address}/exercises", data={}).text


@pytest.mark.parametrize("segment", ["~", "~%21", "~_w", "nobody", "~" + "A" * 6_000])
def test_an_address_of_nobody_is_not_there(browsing: As, segment: str) -> None:
    assert browsing().get(f"/patients/{segment}").status_code in {404, 422}


def test_everything_of_a_patient_is_a_file(browsing: As) -> None:
    browser = browsing()
    make(browser, "heron", name="Rosa Vidal")
    answer = browser.get("/patients/heron/everything.json")
    assert "attachment" in answer.headers["content-disposition"]
    assert answer.json()["name"] == "Rosa Vidal"


def test_erasing_asks_once_and_leaves_nobody(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron", name="Rosa Vidal")
    asked = browser.get("/patients/heron/erase").text
    assert "cannot be taken back" in asked
    assert context.store.patients() == (HERON,)
    assert "The patient is erased." in browser.post("/patients/heron/erase").text
    assert context.store.patients() == ()
    assert browser.get("/patients/heron").status_code == 404


def test_erasing_while_files_are_read_says_what_remains(
    browsing: As, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    browser = browsing()
    make(browser, "heron")

    def in_use(_: PatientId) -> None:
        raise OSError("somebody is reading")

    monkeypatch.setattr(context.store, "erase", in_use)
    assert "sealed remains" in browser.post("/patients/heron/erase").text


def test_reads_exports_and_erasing_are_noted(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.get("/patients/heron")
    browser.get("/patients/heron/everything.json")
    browser.post("/patients/heron/erase")
    acts = {one.act for one in context.store.custody.audit()}
    assert {"read", "exported", "erased", "changed"} <= acts
