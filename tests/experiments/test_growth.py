import csv
from xml.etree import ElementTree as ET

import pytest

from maestra.experiments import growth
from maestra.experiments.growth import (
    GOALS,
    GROWTHS,
    ODD,
    RISING,
    Size,
    estimates,
    estimates_table,
    growth_rows,
    growth_svg,
    lesson_of,
    speed_of,
    speed_table,
)
from maestra.experiments.running import rows_csv
from maestra.rules.rule import holds
from maestra.rules.setting import play_of


class Ticking:
    """A clock that goes on by one second each time it is read."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        self.now += 1.0
        return self.now


@pytest.mark.parametrize("size", [Size(6, 5), Size(10, 5, 2), Size(100, 10, rows=20)])
def test_a_lesson_of_any_size_shows_odd_numbers_rising(size: Size) -> None:
    shown = lesson_of(size)
    assert len(shown) == size.demonstrations
    for one in shown:
        play = play_of(one)
        assert not play.free
        assert holds(ODD, play)
        assert holds(RISING, play)
    assert lesson_of(size) == shown


def test_every_curve_holds_lessons_that_can_be_made() -> None:
    for sizes in GROWTHS.values():
        for size in sizes:
            assert len(lesson_of(size)) == size.demonstrations


def test_learning_and_asking_are_timed_apart() -> None:
    speed = speed_of(Size(6, 3, 1), 2, Ticking(), lambda: 64.0)
    assert (speed.learn_s, speed.fastest_s, speed.slowest_s) == (1.0, 1.0, 1.0)
    assert speed.question_s == 1.0
    assert speed.memory_mb == 64.0


def test_speeds_are_held_against_what_was_wanted() -> None:
    speed = speed_of(Size(6, 3, 1), 1, Ticking(), lambda: 64.0)
    first, second = speed_table([(GOALS[0], speed), (GOALS[1], speed)]).rows
    assert first[1:] == ("120", "1.0 s", "1.0 s", "under 50 ms", "1.0 s", "under 100 ms", "64 MB")
    assert second[4] == "under 2.0 s"
    assert second[6] == ""


def test_listed_sizes_are_exact() -> None:
    found = list(estimates(Size(8, 3), 1))
    assert [one.rule for one in found] == [
        "any row",
        "odd numbers",
        "rising",
        "odd numbers, rising",
    ]
    assert [one.true for one in found] == [336, 24, 56, 4]
    assert all(one.most == 0 for one in found)
    assert estimates_table(found).rows[0][2:] == ("3.4e+02", "0.0 %", "0.0 %")


def test_of_sampled_rows_all_are_counted_within_a_tenth() -> None:
    found = {one.rule: one for one in estimates(Size(20, 5), 2)}
    assert found["any row"].true == 1_860_480
    assert 0 < found["any row"].most < 0.1


@pytest.mark.parametrize("what", GROWTHS)
def test_a_curve_is_drawn_and_written(what: str) -> None:
    speeds = [
        growth.Speed(size, 0.3 * k, 0.2 * k, 0.7 * k, 0.01, 60.0)
        for k, size in enumerate(GROWTHS[what], start=1)
    ]
    root = ET.fromstring(growth_svg(what, speeds))  # noqa: S314 - our own picture
    (line,) = (one for one in root if one.tag.endswith("polyline"))
    assert len((line.get("points") or "").split()) == len(speeds)
    rows = list(csv.DictReader(rows_csv(list(growth_rows(what, speeds))).splitlines()))
    assert [row["learn_s"] for row in rows[:2]] == ["0.3", "0.6"]
    assert {row["by"] for row in rows} == {what}
