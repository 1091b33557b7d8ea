import csv
import json
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from maestra.cli.experiment import ExerciseName, GrowthName, PartName
from maestra.cli.program import run
from maestra.experiments import growth
from maestra.experiments.fewshot_runs import Part
from maestra.experiments.growth import Goal, Size
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


def places(*names: str) -> str:
    """A page with a place for each of these tables."""
    return "".join(f"<!-- table {name} -->\n<!-- end {name} -->\n" for name in names)


FEWSHOT = ["experiment", "fewshot", "--exercises", "1", "--seed", "1001", "--jobs", "1"]


def test_few_shot_learning_is_printed_part_by_part(capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*FEWSHOT, "--part", "no-slip", "--part", "slip"]) == 0
    said = capsys.readouterr().out
    assert "Pointed out as a likely mistake in 3 demonstrations" in said
    assert "some demonstration where none is wrong" in said


def test_few_shot_learning_is_kept_and_written_as_json_csv_and_tables_of_a_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {name: tmp_path / f"found.{name}" for name in ("csv", "results", "page")}
    names = ("exact", "learned", "families", "persons", "calibration")
    files["page"].write_text(places(*names))
    options = [part for name, path in files.items() for part in (f"--{name}", str(path))]
    command = [*FEWSHOT, "--part", "language", "--demonstrations", "2", "--json", *options]
    assert run(command) == 0
    written = json.loads(capsys.readouterr().out)
    assert (written["seed"], written["exercises"]) == (1001, 1)
    assert [table["name"] for table in written["tables"]] == list(names)
    lines = list(csv.DictReader(files["csv"].read_text().splitlines()))
    assert [(line["seed"], line["questions"]) for line in lines] == [
        ("1001", "0"),
        ("1001", "3"),
        ("1001", "5"),
    ]
    exact = written["tables"][0]["rows"][0][3]
    assert exact["count"] == int(lines[0]["exact"])
    page = files["page"].read_text()
    assert "| 2 | 0 | 0.0 |" in page
    assert len(files["results"].read_text().splitlines()) == 2
    assert run(command) == 0
    assert json.loads(capsys.readouterr().out) == written
    assert files["page"].read_text() == page


def test_a_page_without_places_for_the_tables_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.md"
    page.write_text("# By hand\n")
    assert run([*FEWSHOT, "--part", "no-slip", "--page", str(page)]) == 2
    assert "slips: missing" in capsys.readouterr().err
    assert page.read_text() == "# By hand\n"


def test_no_processes_do_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*FEWSHOT[:-1], "0"]) == 2
    assert "0 processes do nothing" in capsys.readouterr().err


def test_learners_are_compared_and_written_into_a_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.md"
    page.write_text(places("compared"))
    options = ["--exercise", "curie", "--draws", "1", "--repeat", "1", "--page", str(page)]
    assert run(["experiment", "compare", *options]) == 0
    assert "fewshot" in capsys.readouterr().out
    assert "| `curie` | grounded | 2 chosen | 0 | exact |" in page.read_text()
    assert run(["experiment", "compare", *options, "--json"]) == 0
    written = json.loads(capsys.readouterr().out)
    assert (written["experiment"], written["name"]) == ("compare", "compared")


def test_growth_is_printed_drawn_and_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    small = Size(6, 3, 1)
    monkeypatch.setattr(growth, "GOALS", (Goal("small", small, 0.05, 0.1),))
    monkeypatch.setattr(growth, "ESTIMATED", (small,))
    monkeypatch.setitem(growth.GROWTHS, "cells", (small, Size(8, 4, 1)))
    page = tmp_path / "page.md"
    page.write_text(places("speed", "estimates"))
    options = ["--repeat", "1", "--by", "cells", "--folder", str(tmp_path), "--page", str(page)]
    assert run(["experiment", "growth", *options]) == 0
    assert "small" in capsys.readouterr().out
    assert "| small | 120 |" in page.read_text()
    rows = list(csv.DictReader((tmp_path / "growth.csv").read_text().splitlines()))
    assert [(row["by"], row["tokens"], row["cells"]) for row in rows] == [
        ("cells", "6", "3"),
        ("cells", "8", "4"),
    ]
    picture = ET.parse(tmp_path / "growth-cells.svg")  # noqa: S314 - our own picture
    assert picture.getroot().get("role") == "img"
    assert run(["experiment", "growth", "--repeat", "1", "--by", "cells", "--json"]) == 0
    written = json.loads(capsys.readouterr().out)
    assert [table["name"] for table in written["tables"]] == ["speed", "estimates"]
    assert len(written["rows"]) == 2


def test_the_command_line_knows_every_part_and_every_curve() -> None:
    assert [one.value for one in PartName] == [one.value for one in Part]
    assert [one.value for one in GrowthName] == list(growth.GROWTHS)


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
