"""Progress: curves with words and tables, replays, files; names for nobody who may not know."""

import csv
import io
import json
import re
import zipfile
from dataclasses import asdict

import pytest

from maestra.coaching.progress import progress
from maestra.language import Language
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.progress.figures import figures, forget
from maestra.web.progress.routes import A_PAGE
from tests.web.played import play
from tests.web.progress.conftest import HERON, As
from tests.web.rooms.exercises import keep_cups


def test_without_sessions_the_pages_say_so(browsing: As) -> None:
    browser = browsing()
    assert "No session has been played yet" in browser.get("/progress/heron").text
    assert "No session has been played yet" in browser.get("/progress/heron/print").text
    assert browser.get("/progress/heron/exercise", params={"name": "x"}).status_code == 404
    assert "There is nobody here yet" in browsing("bob").get("/progress").text


@pytest.mark.parametrize("language", Language)
def test_each_page_shows_what_was_played(
    browsing: As, context: Context, language: Language
) -> None:
    identities = play(context.store, HERON, sessions=5)
    browser = browsing(language=language)
    for path in (
        "/progress",
        "/progress/heron",
        "/progress/heron/exercise?name=ascending",
        "/progress/heron/print",
        f"/progress/heron/sessions/{identities[0]}?at=3",
    ):
        answer = browser.get(path)
        assert answer.status_code == 200
        assert len(answer.content) < 60_000


def test_each_curve_has_a_title_a_description_and_a_table(browsing: As, context: Context) -> None:
    play(context.store, HERON, sessions=4)
    page = browsing().get("/progress/heron/exercise?name=ascending").text
    pictures = re.findall(r'<svg class="curve".*?</svg>', page, re.DOTALL)
    assert len(pictures) == 4
    for picture in pictures:
        named = re.search(r'aria-labelledby="(\S+) (\S+)"', picture)
        assert named is not None
        for identity in named.groups():
            assert re.search(rf'id="{identity}">[^<]+<', picture)
    assert page.count("<tr>") == 1 + 4
    assert "style=" not in page


def test_the_table_of_many_sessions_comes_in_pages(browsing: As, context: Context) -> None:
    play(context.store, HERON, sessions=A_PAGE + 2)
    browser = browsing()
    address = "/progress/heron/exercise?name=ascending"
    assert browser.get(address).text.count("<tr>") == 1 + A_PAGE
    second = browser.get(f"{address}&page=2").text
    assert second.count("<tr>") == 1 + 2
    assert "Newer sessions" in second
    assert browser.get(f"{address}&page=99").text.count("<tr>") == 1 + 2


def test_figures_are_those_of_the_record_also_when_asked_again(
    browsing: As, context: Context
) -> None:
    del browsing
    play(context.store, HERON, sessions=3)
    expected = progress(context.store, HERON)
    assert figures(context.store, HERON) == expected
    assert figures(context.store, HERON) == expected
    play(context.store, HERON)
    assert figures(context.store, HERON) == progress(context.store, HERON)
    forget(context.store, HERON)
    assert figures(context.store, HERON) == progress(context.store, HERON)


def test_who_is_erased_has_no_figures_left(browsing: As, context: Context) -> None:
    play(context.store, HERON, sessions=2)
    browser = browsing()
    assert browser.get("/progress/heron").status_code == 200
    browser.post("/patients/heron/erase")
    assert figures(context.store, HERON) == ()
    assert browser.get("/progress/heron").status_code == 404


def test_a_researcher_sees_everybodys_progress_by_pseudonym_only(
    browsing: As, context: Context
) -> None:
    (identity,) = play(context.store, HERON)
    researcher = browsing("rita", Role.RESEARCHER)
    assert "heron" in researcher.get("/progress").text
    for path in (
        "/progress",
        "/progress/heron",
        "/progress/heron/print",
        "/progress/heron/exercise?name=ascending",
        f"/progress/heron/sessions/{identity}",
        "/api/patients/heron/progress",
        "/api/patients/heron/sessions",
        f"/api/patients/heron/sessions/{identity}",
        "/api/exports/jsonl",
    ):
        answer = researcher.get(path)
        assert answer.status_code == 200
        assert "Rosa" not in answer.text


def test_a_replay_shows_pictures_to_those_who_know_the_patient(
    browsing: As, context: Context
) -> None:
    picture = keep_cups(context.store)
    (identity,) = play(context.store, HERON, "cups")
    path = f"/progress/heron/sessions/{identity}"
    assert browsing().get(path).text.count(f'<img src="{picture}"') == 10
    page = browsing("rita", Role.RESEARCHER).get(path).text
    assert picture not in page
    assert "cup" in page


def test_a_caregiver_sees_names_and_nobody_elses_patients(browsing: As, context: Context) -> None:
    (identity,) = play(context.store, HERON)
    assert "Rosa Vidal" in browsing("ann").get("/progress").text
    bob = browsing("bob")
    assert "heron" not in bob.get("/progress").text
    for path in (
        "/progress/heron",
        "/progress/heron/print",
        f"/progress/heron/sessions/{identity}",
        "/api/patients/heron/progress",
        "/api/exports/csv?patient=heron",
    ):
        assert bob.get(path).status_code == 404
    assert bob.get("/api/exports/jsonl").text == ""


def test_another_patients_session_is_not_there(browsing: As, context: Context) -> None:
    (identity,) = play(context.store, HERON)
    browser = browsing()
    browser.post("/api/patients", json={"pseudonym": "plover"})
    assert browser.get(f"/progress/plover/sessions/{identity}").status_code == 404
    assert browser.get("/progress/heron/sessions/nothing").status_code == 404
    assert browser.get("/api/patients/heron/sessions/~").status_code == 404


# ---------------------------------------------------------------- for programs


def test_progress_and_sessions_are_there_for_programs(browsing: As, context: Context) -> None:
    identities = play(context.store, HERON, sessions=2)
    browser = browsing()
    (found,) = browser.get("/api/patients/heron/progress").json()["exercises"]
    (expected,) = progress(context.store, HERON)
    assert found["first_attempt_share"] == expected.first_attempt_share
    assert [one["session"] for one in found["sessions"]] == list(identities)
    listed = browser.get("/api/patients/heron/sessions").json()
    stored = context.store.sessions(HERON)
    assert [one["ended_utc"] for one in listed] == [asdict(one)["ended_utc"] for one in stored]
    whole = browser.get(f"/api/patients/heron/sessions/{identities[0]}").json()
    assert whole["events"][0]["kind"] == "start"
    assert whole["events"][1]["payload"]["what"]["event"] == "begun"


def test_the_record_is_written_in_each_form(browsing: As, context: Context) -> None:
    play(context.store, HERON, sessions=2)
    browser = browsing()
    table = list(csv.DictReader(io.StringIO(browser.get("/api/exports/csv").text)))
    lines = browser.get("/api/exports/jsonl?patient=heron").text.splitlines()
    assert len(table) == len(lines) > 20
    assert {one["patient"] for one in table} == {"heron"}
    assert json.loads(lines[0])["source"] == "start"
    assert browser.get("/api/exports/xes").text.count("<trace>") == 2
    packed = zipfile.ZipFile(io.BytesIO(browser.get("/api/exports/bids").content))
    assert "participants.tsv" in packed.namelist()
    assert len([one for one in packed.namelist() if one.endswith("_events.tsv")]) == 2
    assert browser.get("/api/exports/doc").status_code == 422


def test_a_file_is_sent_to_be_kept_and_noted(browsing: As, context: Context) -> None:
    answer = browsing().get("/api/exports/csv?patient=heron")
    assert answer.headers["content-disposition"] == 'attachment; filename="maestra.csv"'
    noted = [one for one in context.store.custody.audit() if one.act == "exported"]
    assert [(one.patient, one.detail) for one in noted] == [("heron", "csv of 1")]


def test_what_cannot_be_read_is_no_file(
    browsing: As, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(_: object) -> None:
        raise OSError("the disk")

    monkeypatch.setattr(context.store, "sessions", broken)
    assert browsing("rita", Role.RESEARCHER).get("/api/exports/csv").status_code == 503
