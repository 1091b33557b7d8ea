"""The results in the docs are those of the program as it is."""

import csv
from pathlib import Path
from typing import Final

import pytest

from maestra.experiments.curve import CurveSettings, curve_points
from maestra.experiments.fewshot_findings import Finding, findings, findings_from_csv
from maestra.experiments.fewshot_runs import Part, Run, fewshot_runs
from maestra.experiments.fewshot_tables import tables
from maestra.experiments.pages import filled
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


def published_findings() -> list[Finding]:
    return findings_from_csv((PUBLISHED / "fewshot.csv").read_text(encoding="utf-8"))


def test_the_published_tables_of_few_shot_learning_are_those_of_the_published_findings() -> None:
    page = (PUBLISHED.parent / "fewshot.md").read_text(encoding="utf-8")
    made = tables(published_findings())
    assert len(made) == 10
    assert filled(page, made) == page


@pytest.mark.parametrize("part", Part)
def test_the_published_findings_of_few_shot_learning_begin_as_it_learns_now(part: Part) -> None:
    published = [one for one in published_findings() if one.part is part]
    first = published[0]
    measured = list(findings(fewshot_runs([Run(part, first.seed, first.demonstrations)])))
    assert measured == published[: len(measured)]
