import csv
import json
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from maestra.cli.experiment import ExerciseName
from maestra.cli.program import run
from maestra.rules.paper import PAPER_EXERCISES

CURVE = ["experiment", "curve", "--exercise", "curie", "--runs", "3", "--demonstrations", "4"]


def test_the_curve_is_printed_for_both_choices(capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*CURVE, "--jobs", "1"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("Spell CURIE, vocabulary A")
    labels = [" ".join(line.split()[:2]) for line in lines[2:]]
    assert labels == ["1 chosen", "2 chosen", "1 random", "2 random", "4 random"]
    assert lines[3].split()[2:] == ["3", "100.0", "0.0", "100.0", "100.0"]


def test_the_curve_is_written_as_json_csv_picture_and_runs(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {name: tmp_path / f"curve.{name}" for name in ("csv", "svg", "results")}
    options = [part for name, path in files.items() for part in (f"--{name}", str(path))]
    assert run([*CURVE, "--jobs", "1", "--seed", "5", "--json", *options]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    written = json.loads(line)
    assert (written["exercise"], written["seed"], written["runs"]) == ("curie", 5, 3)
    assert (
        len(list(csv.DictReader(files["csv"].read_text().splitlines())))
        == len(written["points"])
        == 6
    )
    assert ET.parse(files["svg"]).getroot().get("role") == "img"  # noqa: S314 - our own picture
    assert len(files["results"].read_text().splitlines()) == 1 + 2 * 3


def test_a_stopped_experiment_goes_on_with_what_it_has(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    results = tmp_path / "runs.jsonl"
    command = [*CURVE, "--jobs", "1", "--json", "--results", str(results)]
    assert run(command) == 0
    whole = results.read_text()
    first = capsys.readouterr().out
    lines = whole.splitlines(keepends=True)
    results.write_text("".join([*lines[:4], lines[4][:7]]))
    assert run(command) == 0
    assert capsys.readouterr().out == first
    assert results.read_text() == whole


def test_results_of_another_seed_are_refused_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    results = tmp_path / "runs.jsonl"
    assert run([*CURVE, "--jobs", "1", "--results", str(results)]) == 0
    capsys.readouterr()
    assert run([*CURVE, "--jobs", "1", "--seed", "2", "--results", str(results)]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    (line,) = said.err.splitlines()
    assert "runs.jsonl, line 1: seed: 1, expected 2 as in this experiment" in line


@pytest.mark.parametrize(
    ("option", "value"), [("--exercise", "sorting"), ("--runs", "0"), ("--jobs", "0")]
)
def test_an_option_out_of_range_is_refused_in_one_line(
    option: str, value: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run([*CURVE, option, value]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    (line,) = said.err.splitlines()
    assert option in line


def test_the_table_is_printed_and_written_for_one_exercise(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "table.csv"
    command = ["experiment", "table", "--exercise", "curie", "--repeat", "1"]
    assert run([*command, "--csv", str(path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split()[:3] == ["exercise", "learner", "result"]
    assert lines[1].split()[:5] == ["curie", "grounded", "exact", "2", "2"]
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert [row["learner"] for row in rows][:2] == ["grounded", "compiled, clingo"]
    assert run([*command, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rows"][0]["outcome"] == "exact"


def test_the_command_line_knows_just_the_papers_exercises() -> None:
    assert [one.value for one in ExerciseName] == list(PAPER_EXERCISES)


def test_asking_for_help_on_experiments_imports_nothing_heavy() -> None:
    program = (
        "import sys; from maestra.cli.program import run; run(['experiment', '--help']);"
        "print([m for m in ('numpy', 'joblib', 'maestra.rules') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"
