"""The record on the command line: looked after, exported, reported."""

import contextlib
import json
from pathlib import Path

import pytest

from maestra.coaching.ports import PatientId
from maestra.storage.opening import DATA_VARIABLE, KEYS_VARIABLE, open_store, place
from tests.cli.running import GROUNDED, learned, maestra
from tests.storage.played import keep_session


@pytest.fixture(autouse=True)
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A record with the sessions of two patients, where the environment says."""
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.setenv(DATA_VARIABLE, str(tmp_path / "data"))
    monkeypatch.setenv(KEYS_VARIABLE, str(tmp_path / "keys"))
    with contextlib.closing(open_store(place())) as store:
        for number in range(4):
            keep_session(store, PatientId("heron"), number)
        keep_session(store, PatientId("plover"), 9)
        store.save_settings(PatientId("wren"), "{}")
    return tmp_path


def test_a_sound_record_is_said_to_be(kept: Path) -> None:
    ran = maestra("store", "verify")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith("sound: ")
    found = json.loads(maestra("store", "verify", "--json").out)
    assert found["sound"] is True
    assert found["events"] == found["signed"]
    (heads,) = kept.glob("keys/*/heads.jsonl")
    heads.write_text("".join(heads.read_text().splitlines(keepends=True)[:-1]))
    with contextlib.closing(open_store(place())):
        pass
    assert "only after a crash" in maestra("store", "verify").out


def test_a_spoilt_record_is_said_to_be_with_exit_code_1(kept: Path) -> None:
    (heads,) = kept.glob("keys/*/heads.jsonl")
    heads.unlink()
    ran = maestra("store", "verify")
    assert (ran.code, ran.out) == (1, "not sound: signed heads are missing (at 1)\n")
    found = maestra("store", "verify", "--json")
    assert (found.code, json.loads(found.out)["sound"]) == (1, False)


def test_a_backup_is_restored_elsewhere(kept: Path) -> None:
    ran = maestra("store", "backup", kept / "backup", "--keys-file", kept / "all.keys")
    assert ran.code == 0, ran
    maestra("patients", "erase", "heron", "--yes")
    new = ("--data", kept / "new", "--keys", kept / "keys")
    ran = maestra("store", "restore", kept / "backup", *new)
    assert ran.code == 0, ran
    assert "rows of erased patients left out" in ran.out
    assert maestra("patients", "list", *new).out == "plover\nwren\n"
    new = ("--data", kept / "third", "--keys", kept / "third-keys")
    ran = maestra("store", "restore", kept / "backup", "--keys-file", kept / "all.keys", *new)
    # Keys that were written before the erasing still open what was backed up before it.
    assert (ran.code, "left out" in ran.out) == (0, False), ran


@pytest.mark.parametrize("form", ["csv", "jsonl", "xes"])
def test_the_record_is_exported_as_a_file(kept: Path, form: str) -> None:
    ran = maestra("store", "export", "--format", form, "-o", kept / "out")
    assert ran.code == 0, ran
    text = (kept / "out").read_text()
    assert "heron-0" in text
    assert "plover-9" in text
    alone = maestra("store", "export", "--format", form, "--patient", "plover", "-o", "-")
    assert "heron" not in alone.out
    assert "plover-9" in alone.out


def test_the_record_is_exported_as_bids(kept: Path) -> None:
    assert maestra("store", "export", "--format", "bids", "-o", kept / "bids").code == 0
    assert len(list((kept / "bids").rglob("*_events.tsv"))) == 5


def test_patients_are_listed_with_their_names_only_when_asked() -> None:
    assert maestra("patients", "name", "heron", typed=b"Anna Puig\n").code == 0
    assert maestra("patients", "list").out == "heron\nplover\nwren\n"
    assert maestra("patients", "list", "--names").out == "heron\tAnna Puig\nplover\nwren\n"
    assert json.loads(maestra("patients", "list", "--names", "--json").out) == [
        {"patient": "heron", "name": "Anna Puig"},
        {"patient": "plover", "name": None},
        {"patient": "wren", "name": None},
    ]
    assert json.loads(maestra("patients", "list", "--json").out)[0] == {"patient": "heron"}


def test_everything_of_a_patient_is_written(kept: Path) -> None:
    assert maestra("patients", "everything", "heron", "-o", kept / "heron.json").code == 0
    found = json.loads((kept / "heron.json").read_text())
    assert len(found["sessions"]) == 4
    assert found["settings"] is None


def test_a_patient_is_erased_once_it_is_confirmed() -> None:
    assert maestra("patients", "erase", "heron", typed=b"n\n").code != 0
    assert "heron" in maestra("patients", "list").out
    ran = maestra("patients", "erase", "heron", typed=b"y\n")
    assert ran.code == 0, ran
    assert maestra("patients", "list").out == "plover\nwren\n"
    assert maestra("store", "verify").code == 0


@pytest.mark.parametrize(("lang", "no", "yes"), [("es", b"y\n", "Sí\n"), ("ca", b"\n", "s\n")])
def test_the_record_speaks_the_users_language(
    kept: Path, monkeypatch: pytest.MonkeyPatch, lang: str, no: bytes, yes: str
) -> None:
    monkeypatch.setenv("LC_ALL", f"{lang}_ES.UTF-8")
    assert maestra("store", "verify").out.startswith("ínte")
    assert maestra("store", "verify", "--lang", "en").out.startswith("sound")
    where = {"es": ("filas", "sucesos", "Nombre"), "ca": ("files", "esdeveniments", "Nom")}[lang]
    assert where[0] in maestra("store", "backup", kept / "backup").out
    assert where[2] in maestra("patients", "name", "heron", typed=b"Anna\n").err
    refused = maestra("patients", "erase", "heron", typed=no)
    assert refused.code != 0
    assert "heron" in refused.err
    assert maestra("patients", "erase", "heron", typed=yes.encode()).code == 0
    new = ("--data", kept / "new", "--keys", kept / "keys")
    assert where[1] in maestra("store", "restore", kept / "backup", *new).out
    (heads,) = kept.glob("keys/*/heads.jsonl")
    heads.unlink()
    spoilt = maestra("store", "verify")
    assert spoilt.code == 1
    assert "sound" not in spoilt.out


@pytest.mark.parametrize(
    "arguments",
    [
        ("patients", "erase", "nobody", "--yes"),
        ("patients", "everything", "nobody", "-o", "-"),
        ("store", "export", "--patient", "nobody", "-o", "-"),
        ("report", "nobody"),
    ],
)
def test_a_pseudonym_that_nobody_has_is_named(arguments: tuple[str, ...]) -> None:
    ran = maestra(*arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        "maestra: patient: nobody, expected a pseudonym that `patients list` shows\n"
    )


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ("elsewhere", "no record, expected one that Maestra has begun"),
        ("postgresql://nobody@127.0.0.1:1/nothing", "postgresql://nobody@127.0.0.1:1/nothing"),
        ("postgresql://a:b:c@d:e/f", "no address of a database"),
    ],
)
def test_a_record_that_cannot_be_read_is_said_in_one_line(
    kept: Path, data: str, said: str
) -> None:
    where = data if "://" in data else kept / data
    ran = maestra("store", "verify", "--data", where)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert said in ran.err


# ---------------------------------------------------------------- report


def test_a_report_tells_each_exercise_and_session() -> None:
    ran = maestra("report", "heron")
    assert ran.code == 0, ran
    assert "Progress of heron" in ran.out
    assert "ascending" in ran.out
    assert ran.out.count("2026-05-0") == 4
    assert "Progreso de heron" in maestra("report", "heron", "--lang", "es").out


def test_a_report_on_somebody_who_has_not_played_says_so() -> None:
    ran = maestra("report", "wren")
    assert (ran.code, ran.out) == (0, "Progress of wren\n\nNo session has been played yet.\n")


def test_a_report_is_written_as_page_pictures_and_data(kept: Path) -> None:
    ran = maestra(
        "report", "heron", "--html", kept / "page.html", "--svg", kept / "pictures", "--json"
    )
    assert ran.code == 0, ran
    assert (kept / "page.html").read_text().count("<svg") == 3
    assert sorted(path.name for path in (kept / "pictures").iterdir()) == [
        "1-assistance.svg",
        "1-first-attempts.svg",
        "1-reaction.svg",
    ]
    (exercise,) = json.loads(ran.out)["exercises"]
    assert len(exercise["sessions"]) == 4
    assert set(exercise["trends"]) == {"first_attempts", "reaction", "assistance"}


def test_a_session_that_was_played_is_verified_reported_exported_and_erased(kept: Path) -> None:
    exercise = learned(kept, "ascending", *GROUNDED)
    arguments = ("play", exercise, "--patient", "dunlin", "--seed", "3", "--quiet")
    ran = maestra(*arguments, typed=b"19\n23\n34\nhint\nquit\n")
    assert ran.err == ""
    assert maestra("store", "verify").code == 0
    (found,) = json.loads(maestra("report", "dunlin", "--json").out)["exercises"]
    assert (found["exercise"], found["sessions"][0]["steps"]) == ("ascending", 3)
    exported = maestra("store", "export", "--format", "jsonl", "--patient", "dunlin", "-o", "-")
    rows = [json.loads(line) for line in exported.out.splitlines()]
    assert [row["row"] for row in rows if row["type"] == "move"] == [1, 1, 1]
    assert {row["seed"] for row in rows} == {3}
    assert maestra("patients", "erase", "dunlin", "--yes").code == 0
    assert "dunlin" not in maestra("store", "export", "-o", "-").out
