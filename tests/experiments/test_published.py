"""The results in the docs are those of the program as it is."""

import csv
from pathlib import Path
from typing import Final

import pytest

from maestra.experiments.curve import CurveSettings, curve_points
from maestra.experiments.running import curve_csv, curve_runs
from maestra.experiments.table import GROUNDED
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.strips.vocabulary import Level

PUBLISHED: Final = Path(__file__).parents[2] / "docs" / "reference" / "experiments"
SEED: Final = 1
RUNS: Final = 100


@pytest.mark.parametrize("level", Level)
def test_the_published_curve_begins_as_it_is_measured_now(level: Level) -> None:
    text = (PUBLISHED / f"ascending-{level.value}.csv").read_text(encoding="utf-8")
    published = list(csv.DictReader(text.splitlines()))
    settings = CurveSettings("ascending", level, 5, SEED)
    points = curve_points(settings, curve_runs(settings, RUNS, jobs=1))
    measured = list(csv.DictReader(curve_csv(points).splitlines()))
    assert len(measured) == 10
    assert all(row in published for row in measured)


def test_the_published_table_has_each_exercise_learned_exactly_with_the_papers_number() -> None:
    text = (PUBLISHED / "table.csv").read_text(encoding="utf-8")
    rows = [row for row in csv.DictReader(text.splitlines()) if row["learner"] == GROUNDED]
    assert [row["exercise"] for row in rows] == list(PAPER_EXERCISES)
    for row in rows:
        assert row["outcome"] == "exact"
        assert row["demonstrations"] == row["lower_bound"] == row["fewest_in_paper"]
