import csv
import io
import json
from pathlib import Path

import pytest

from maestra import __version__
from maestra.core.json_lines import FormatError
from maestra.experiments import running
from maestra.experiments.curve import Choice, CurveRun, CurveSettings, curve_points
from maestra.experiments.running import (
    curve_csv,
    curve_json,
    curve_runs,
    curve_svg,
    table_csv,
    table_json,
)
from maestra.experiments.table import TableRow
from maestra.rules.strips.vocabulary import Level

SETTINGS = CurveSettings("odd-ascending", Level.A, 4, seed=3)


def test_runs_are_numbered_for_each_choice() -> None:
    runs = curve_runs(SETTINGS, 2, jobs=1)
    assert [(run.choice, run.number) for run in runs] == [
        (Choice.CHOSEN, 1),
        (Choice.CHOSEN, 2),
        (Choice.RANDOM, 1),
        (Choice.RANDOM, 2),
    ]


def test_runs_in_two_processes_come_out_as_in_one() -> None:
    assert curve_runs(SETTINGS, 3, jobs=2) == curve_runs(SETTINGS, 3, jobs=1)


def test_finished_runs_are_not_run_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "runs.jsonl"
    before = curve_runs(SETTINGS, 2, 1, path)
    ran: list[int] = []

    def count(settings: CurveSettings, choice: Choice, number: int) -> CurveRun:
        ran.append(number)
        return CurveRun(choice, number, (settings.seed,))

    monkeypatch.setattr(running, "run_curve", count)
    advanced: list[int] = []
    after = curve_runs(SETTINGS, 3, 1, path, advanced.append)
    assert ran == [3, 3]
    assert [run for run in after if run.number < 3] == before
    assert advanced == [4, 1, 1]
    assert curve_runs(SETTINGS, 3, 1, path) == after
    assert ran == [3, 3]


def test_the_results_name_command_seed_and_version(tmp_path: Path) -> None:
    path = tmp_path / "runs.jsonl"
    curve_runs(SETTINGS, 1, 1, path)
    header = json.loads(path.read_text().splitlines()[0])
    assert header["seed"] == 3
    assert header["version"] == __version__
    assert header["command"].startswith("maestra experiment curve --exercise odd-ascending")


@pytest.mark.parametrize(
    "line",
    [
        '{"choice": "lucky", "run": 1, "exact": [1]}',
        '{"choice": "random", "run": 1, "exact": [1, 2, 3, 4, 5]}',
        '{"choice": "random", "run": 1, "exact": ["x"]}',
        '{"choice": "random", "run": 1, "exact": []}',
        "{}",
    ],
)
def test_a_line_that_is_no_run_is_refused_with_its_number(tmp_path: Path, line: str) -> None:
    path = tmp_path / "runs.jsonl"
    curve_runs(SETTINGS, 1, 1, path)
    with path.open("a") as file:
        file.write(f"{line}\n")
    with pytest.raises(FormatError) as refused:
        curve_runs(SETTINGS, 1, 1, path)
    assert refused.value.line == 4


def points_and_runs() -> tuple[CurveRun, ...]:
    return (CurveRun(Choice.CHOSEN, 1, (2, 5)), CurveRun(Choice.RANDOM, 1, (1, 2, 4)))


def test_the_curves_as_csv_have_a_line_for_each_point() -> None:
    written = curve_csv(curve_points(SETTINGS, points_and_runs()))
    rows = list(csv.DictReader(io.StringIO(written)))
    assert len(rows) == 5
    assert rows[0]["choice"] == "chosen"
    assert rows[0]["mean"] == "40.0"


def test_no_points_are_an_empty_csv() -> None:
    assert curve_csv([]) == "\n"


def test_the_curves_as_json_say_what_they_were_measured_with() -> None:
    points = curve_points(SETTINGS, points_and_runs())
    written = json.loads(json.dumps(curve_json(SETTINGS, 1, points)))
    assert written["actions"] == 5
    assert written["seed"] == 3
    assert written["points"][-1] == {
        "choice": "random",
        "demonstrations": 3,
        "runs": 1,
        "mean": 80.0,
        "deviation": 0.0,
        "low": 80.0,
        "high": 80.0,
    }


def test_the_picture_names_both_curves_and_where_they_end() -> None:
    drawn = curve_svg(SETTINGS, curve_points(SETTINGS, points_and_runs()))
    assert "chosen, mean of 1 runs" in drawn
    assert "random, mean of 1 runs: 80.0 % after 3 demonstrations" in drawn


def test_a_choice_without_runs_has_no_curve() -> None:
    drawn = curve_svg(SETTINGS, curve_points(SETTINGS, points_and_runs()[:1]))
    assert "random" not in drawn


def test_the_table_is_written_with_times_and_without() -> None:
    rows = [
        TableRow("curie", "grounded", 2, 2, 2, "exact", 0.00012345, 0.01),
        TableRow("curie", "compiled, x", 2, 2, 2, "no engine", None, None),
    ]
    lines = table_csv(rows).splitlines()
    assert lines[1] == "curie,grounded,2,2,2,exact,0.0001,0.01"
    assert lines[2] == 'curie,"compiled, x",2,2,2,no engine,,'
    assert json.loads(json.dumps(table_json(rows)))["rows"][1]["learn_s"] is None
