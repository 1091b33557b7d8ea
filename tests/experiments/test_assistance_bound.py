"""What would be enough, if the patient were known: the same as what is played, and less help."""

from __future__ import annotations

import json
from statistics import fmean

import pytest

from maestra.cli.program import run
from maestra.coaching.chance import Chance
from maestra.coaching.patients import Patient, patient_of
from maestra.coaching.settings import Mental, Profile
from maestra.experiments import assistance_bound
from maestra.experiments.assistance_bound import Oracle, State, bound_rows
from maestra.experiments.coaching import patient_sessions

CLEVER = Patient(1.0, 1.0, 1_000, 0.0, 4.0, 10**9)
FRAIL = Patient(0.3, 0.7, 1_000, 0.1, 1.0, 10**9)


def test_whoever_knows_everything_needs_no_help() -> None:
    assert Oracle(CLEVER, 4, 0.001).worth() == pytest.approx((1.0, 1.0, 0.0))
    assert Oracle(CLEVER, 4, 0.0, fixed=5).worth() == pytest.approx((1.0, 1.0, 25.0))


@pytest.mark.parametrize("level", [0, 4])
def test_what_is_reckoned_is_what_is_played(level: int) -> None:
    number = 3
    patient = patient_of(Profile(Mental.SEVERE), Chance(1).split(number))
    worth = Oracle(patient, 2, 0.0, fixed=level).worth()
    sat = [
        one
        for seed in range(1, 4)
        for one in patient_sessions("severe", f"fixed-{level}", number, seed)
        if patient_of(Profile(Mental.SEVERE), Chance(seed).split(number)) == patient
    ]
    assert abs(fmean(one.complete for one in sat) - worth.complete) < 0.4
    assert abs(fmean(one.levels for one in sat) / worth.levels - 1) < 0.4


def test_dearer_help_is_given_less() -> None:
    free, dear = (Oracle(FRAIL, 2, price).worth() for price in (0.0, 0.1))
    assert free.complete > dear.complete
    assert free.levels > dear.levels


def test_what_is_given_is_what_the_coach_makes_of_it() -> None:
    always = Oracle(CLEVER, 4, 0.0, fixed=0)
    assert always.worth(State(attempt=9)).levels == 4.0


def test_the_bound_completes_as_often_with_less(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(assistance_bound, "PRICES", (0.5, 0.001))

    def frail(*_: object) -> Patient:
        return FRAIL

    monkeypatch.setattr(assistance_bound, "patient_of", frail)
    (row,) = bound_rows(1, 1, [Mental.NONE])
    assert row.complete >= row.complete_with_most
    assert row.saved > 0.2


def test_the_command_prints_the_bound(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [assistance_bound.BoundRow("mild", 1, 0.98, 28.0, 0.99, 7.0)]

    def known(*_: object) -> list[assistance_bound.BoundRow]:
        return rows

    monkeypatch.setattr(assistance_bound, "bound_rows", known)
    assert run(["experiment", "assistance-bound", "--patients", "1"]) == 0
    assert "75" in capsys.readouterr().out
    assert run(["experiment", "assistance-bound", "--patients", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["rows"][0]["levels"] == 7.0
