import csv
import json
from pathlib import Path

import pytest

from maestra.cli.program import run
from maestra.experiments.fewshot_sweep import Share, sweep

SWEEP = ["experiment", "fewshot", "--exercises", "2", "--demonstrations", "1", "--jobs", "1"]


def test_a_share_has_wilsons_interval() -> None:
    # Wilson 1927, as computed by statsmodels' proportion_confint(8, 10, method="wilson").
    share = Share.of_all([True] * 8 + [False] * 2)
    assert (share.count, share.of) == (8, 10)
    assert (share.low, share.high) == (0.4902, 0.9433)


@pytest.mark.parametrize(("hits", "bounds"), [([], (0.0, 1.0)), ([True] * 20, (0.8389, 1.0))])
def test_a_share_never_leaves_0_to_1(hits: list[bool], bounds: tuple[float, float]) -> None:
    share = Share.of_all(hits)
    assert (share.low, share.high) == bounds


def test_a_sweep_counts_every_sample_of_every_setting() -> None:
    advanced: list[int] = []
    rows, outcomes = sweep([1000, 1001], [1, 2], [0, 1], advance=advanced.append)
    assert [(row.demonstrations, row.questions) for row in rows] == [
        (1, 0),
        (2, 0),
        (1, 1),
        (2, 1),
    ]
    assert [one.seed for one in outcomes] == [1000, 1001] * 4
    assert sum(advanced) == 8
    for row in rows:
        assert row.exact.of == row.learned.of == 2
        assert row.wrongly_learned.count == row.learned.count - row.exact_of_learned.count


def test_the_sweep_is_printed_with_intervals(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(SWEEP) == 0
    heading, line = capsys.readouterr().out.splitlines()
    assert heading.split()[:3] == ["demonstrations", "questions", "exact"]
    assert line.split()[:2] == ["1", "0"]
    assert "/2 (" in line


def test_the_sweep_is_written_as_json_and_csv(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "outcomes.csv"
    assert run([*SWEEP, "--seed", "5", "--json", "--csv", str(file)]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert (answer["seed"], answer["exercises"], len(answer["rows"])) == (5, 2, 1)
    lines = list(csv.DictReader(file.read_text().splitlines()))
    assert [line["seed"] for line in lines] == ["5", "6"]
    exact = sum(line["exact"] == "True" for line in lines)
    assert answer["rows"][0]["exact"]["count"] == exact


def test_no_processes_do_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    assert run([*SWEEP, "--jobs", "0"]) == 2
    assert "0 processes do nothing" in capsys.readouterr().err
