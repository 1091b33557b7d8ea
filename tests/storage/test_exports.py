"""What is exported is all there, and programs that are not ours accept it."""

import csv
import io
import json
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import IO, Any, cast

import pytest
from opyenxes.data_in.XUniversalParser import XUniversalParser

from maestra import __version__
from maestra.coaching.ports import PatientId
from maestra.storage.exports.bids import write_bids
from maestra.storage.exports.rows import rows
from maestra.storage.exports.tables import COLUMNS, write_csv, write_json_lines
from maestra.storage.exports.xes import write_xes
from maestra.storage.opening import Place
from maestra.storage.store import SqlStore
from tests.storage.played import keep_session
from tests.storage.samples import OTHER, PATIENT

Opening = Callable[[Place], SqlStore]


@pytest.fixture
def played(sqlite_place: Place, opened: Opening) -> SqlStore:
    store = opened(sqlite_place)
    for number in range(2):
        keep_session(store, PATIENT, number)
    keep_session(store, OTHER, 2)
    return store


def test_there_is_one_row_for_each_event_and_each_command_in_order(played: SqlStore) -> None:
    found = list(rows(played))
    expected = 0
    for entry in played.events.entries():
        payload: list[object] | dict[str, object] = json.loads(entry.payload)
        expected += len(payload) if isinstance(payload, list) else 1
    assert len(found) == expected
    for session in played.sessions():
        mine = [row for row in found if row.session == session.session]
        assert [row.at_ms for row in mine] == sorted(row.at_ms for row in mine)
        assert {(row.exercise, row.version, row.maestra) for row in mine} == {
            ("ascending", 1, __version__)
        }
        assert {row.seed for row in mine} == {int(session.session.rpartition("-")[2])}
    assert {row.patient for row in rows(played, OTHER)} == {OTHER}


def test_a_right_move_tells_token_cell_step_attempt_and_level(played: SqlStore) -> None:
    moves = [row for row in rows(played) if row.type == "move"]
    assert moves
    for row in moves:
        assert None not in (row.token, row.row, row.column, row.step, row.attempt, row.level)
        assert row.by in {"patient", "helper", "caregiver"}
    placed = [row for row in rows(played) if row.type == "placed"]
    assert all(row.row is not None and row.token is not None for row in placed)


def test_csv_reads_back_as_the_same_rows(played: SqlStore) -> None:
    file = io.StringIO(newline="")
    count = write_csv(rows(played), file)
    file.seek(0)
    read = list(csv.DictReader(file))
    assert len(read) == count
    for row, line in zip(rows(played), read, strict=True):
        assert line == {name: _text(getattr(row, name)) for name in COLUMNS}


def _text(value: object) -> str:
    return "" if value is None else str(value)


def test_json_lines_read_back_as_the_same_rows(played: SqlStore) -> None:
    file = io.StringIO()
    count = write_json_lines(rows(played), file)
    read = [json.loads(line) for line in file.getvalue().splitlines()]
    assert len(read) == count
    for row, line in zip(rows(played), read, strict=True):
        assert line == {**asdict(row), "detail": json.loads(row.detail)}


def test_nobody_who_was_erased_is_exported(played: SqlStore) -> None:
    before = list(rows(played, OTHER))
    played.erase(PATIENT)
    assert list(rows(played)) == before


# ---------------------------------------------------------------- BIDS


def issues_of(folder: Path) -> list[dict[str, str]]:
    """What the official validator finds."""
    program = Path(sys.executable).with_name("bids-validator-deno")
    arguments = [str(program), str(folder), "--format", "json", "--max-rows", "-1"]
    done = subprocess.run(arguments, capture_output=True, text=True, check=False, timeout=120)
    found: list[dict[str, str]] = json.loads(done.stdout)["issues"]["issues"]
    return found


def test_the_official_validator_accepts_the_bids_export(played: SqlStore, tmp_path: Path) -> None:
    assert write_bids(rows(played), tmp_path / "bids") == 3
    issues = issues_of(tmp_path / "bids")
    assert [one for one in issues if one["severity"] == "error"] == []
    files = sorted(path.name for path in (tmp_path / "bids").rglob("*_events.tsv"))
    assert files == [
        "sub-heron_ses-001_task-ascending_events.tsv",
        "sub-heron_ses-002_task-ascending_events.tsv",
        "sub-plover_ses-001_task-ascending_events.tsv",
    ]
    # Columns that no side file describes would be among these.
    codes = {one["code"] for one in issues}
    assert codes <= {
        "JSON_KEY_RECOMMENDED",
        "NO_AUTHORS",
        "README_FILE_SMALL",
        "SIDECAR_KEY_RECOMMENDED",
        "TOO_FEW_AUTHORS",
    }


def test_the_official_validator_does_find_errors(played: SqlStore, tmp_path: Path) -> None:
    folder = tmp_path / "bids"
    write_bids(rows(played), folder)
    (events, *_) = folder.rglob("*_events.tsv")
    events.write_text(events.read_text().replace("onset\t", "start\t"))
    assert "error" in {one["severity"] for one in issues_of(folder)}


def test_labels_stay_apart_whatever_the_names_are(played: SqlStore, tmp_path: Path) -> None:
    folder = tmp_path / "bids"
    (first, *_) = rows(played)
    names = ("a-b", "ab", "a b", "àb", "ñ", "abx2")
    made = [replace(first, patient=name, session=name, text="a\tb\nc") for name in names]
    write_bids(made, folder)
    folders = {path.name for path in folder.glob("sub-*")}
    assert len(folders) == len(names)
    lines = (folder / "participants.tsv").read_text().splitlines()
    assert {line.split("\t")[1] for line in lines[1:]} == set(names)
    assert [one for one in issues_of(folder) if one["severity"] == "error"] == []


# ---------------------------------------------------------------- XES


def parsed(path: Path) -> list[tuple[str, list[tuple[str, str]]]]:
    """Traces and events as OpenXES reads them: name and resource of each event."""
    with path.open(encoding="utf-8") as file:
        parse = cast("Callable[[IO[str]], Sequence[Any]]", XUniversalParser().parse)  # pyright: ignore[reportUnknownMemberType]
        (log,) = parse(file)
    return [
        (
            _attribute(trace, "concept:name"),
            [_named(event) for event in cast("Iterable[Any]", trace)],
        )
        for trace in cast("Iterable[Any]", log)
    ]


def _named(event: Any) -> tuple[str, str]:  # noqa: ANN401 - the library has no types
    assert event.get_attributes()["time:timestamp"].get_value() is not None
    return _attribute(event, "concept:name"), _attribute(event, "org:resource")


def _attribute(element: Any, key: str) -> str:  # noqa: ANN401 - the library has no types
    return str(element.get_attributes()[key].get_value())


@pytest.mark.filterwarnings("ignore:invalid escape sequence")
def test_a_parser_that_is_not_ours_reads_the_xes_export(played: SqlStore, tmp_path: Path) -> None:
    path = tmp_path / "log.xes"
    with path.open("w", encoding="utf-8") as file:
        assert write_xes(rows(played), file) == 3
    traces = dict(parsed(path))
    for session in played.sessions():
        mine = [row for row in rows(played) if row.session == session.session]
        assert [name for name, _ in traces[session.session]] == [row.type for row in mine]
    assert {who for _, events in traces.items() for _, who in events} >= {"robot", "patient"}


@pytest.mark.filterwarnings("ignore:invalid escape sequence")
def test_xes_carries_any_sign(played: SqlStore, tmp_path: Path) -> None:
    (first, *_) = rows(played)
    odd = replace(first, type='<"&\x07ñ\n😀>', token="\x00'", seed=None)
    path = tmp_path / "log.xes"
    with path.open("w", encoding="utf-8") as file:
        write_xes([odd], file)
    assert parsed(path) == [(odd.session, [('<"& ñ 😀>', "patient")])]


def test_an_empty_record_is_exported_too(
    sqlite_place: Place, opened: Opening, tmp_path: Path
) -> None:
    store = opened(sqlite_place)
    assert list(rows(store, PatientId("nobody"))) == []
    assert write_bids(rows(store), tmp_path / "bids") == 0
    file = io.StringIO()
    assert write_xes(rows(store), file) == 0
    assert file.getvalue().endswith("</log>\n")
