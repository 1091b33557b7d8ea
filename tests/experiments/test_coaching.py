"""Policies compared on simulated patients: resumable, and the same again from the same seed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from maestra.cli.program import run
from maestra.core.json_lines import FormatError
from maestra.experiments import coaching
from maestra.experiments.coaching import (
    Mean,
    Sat,
    coaching_json,
    coaching_runs,
    comparisons,
    patient_sessions,
    policy_rows,
)


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(coaching, "SESSIONS_EACH", 2)
    monkeypatch.setattr(coaching, "POLICIES", ("fixed-5", "adaptive"))


def test_a_patient_plays_the_same_again() -> None:
    first = patient_sessions("moderate", "adaptive", 1, 1)
    assert patient_sessions("moderate", "adaptive", 1, 1) == first
    assert len(first) == coaching.SESSIONS_EACH
    assert patient_sessions("moderate", "adaptive", 2, 1) != first


@pytest.mark.usefixtures("few")
def test_finished_patients_are_kept_and_not_played_again(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    runs = coaching_runs(1, 1, 1, kept)
    lines = kept.read_text().splitlines()
    assert len(lines) == 1 + len(runs) == 11
    kept.write_text("".join(f"{line}\n" for line in lines[:5]))
    done: list[int] = []
    assert coaching_runs(1, 1, 1, kept, done.append) == runs
    assert done[0] == 4
    assert coaching_runs(1, 1, 1, kept) == runs
    assert coaching_runs(1, 1, 1) == runs


@pytest.mark.usefixtures("few")
def test_a_file_with_something_else_is_refused(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    coaching_runs(1, 1, 1, kept)
    with kept.open("a") as file:
        file.write('{"profile": "none"}\n')
    with pytest.raises(FormatError, match="line 12"):
        coaching_runs(1, 1, 1, kept)
    with pytest.raises(FormatError, match="seed"):
        coaching_runs(1, 2, 1, kept)


def sat(levels: int, *, complete: bool) -> Sat:
    return Sat(complete, 1, levels, 5, 4, 0, 60_000)


def test_rows_and_comparisons_say_what_was_counted() -> None:
    runs = {
        ("mild", "fixed-5", 1): (sat(20, complete=True), sat(20, complete=True)),
        ("mild", "adaptive", 1): (sat(5, complete=True), sat(5, complete=False)),
    }
    rows = policy_rows(runs)
    assert [(row.policy, row.complete.count, row.complete.of) for row in rows] == [
        ("fixed-5", 2, 2),
        ("adaptive", 1, 2),
    ]
    assert (rows[0].first_time.count, rows[0].first_time.of) == (8, 10)
    mild, everybody = comparisons(runs)
    assert mild.saved == Mean(0.75, 0.75, 0.75)
    assert mild.completed_more.value == -0.5
    assert everybody.profile == "all"
    assert coaching_json(1, 1, runs)["patients"] == 1


def test_a_mean_has_an_interval() -> None:
    mean = Mean.of([1.0, 2.0, 3.0])
    assert mean.low < 2.0 == mean.value < mean.high


@pytest.mark.usefixtures("few")
def test_the_command_prints_tables_or_json(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["experiment", "coaching", "--patients", "1", "--jobs", "1"]
    assert run(command) == 0
    out = capsys.readouterr().out
    assert "adaptive against the most helpful" in out
    assert run([*command, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["experiment"] == "coaching"
    assert run([*command[:-1], "0"]) == 2
