from xml.etree import ElementTree as ET

import pytest

from maestra.experiments.svg import Picture, Point, Series, draw

SVG = "{http://www.w3.org/2000/svg}"


def picture(points: int, label: str = "random") -> ET.Element:
    series = Series(label, tuple(Point(x, 50.0, 40.0, 60.0) for x in range(1, points + 1)))
    drawn = draw(Picture("A <title>", "What & why", "shown", "right, %", (series, series)))
    return ET.fromstring(drawn)  # noqa: S314 - our own picture


def texts(root: ET.Element) -> list[str]:
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def test_the_picture_has_a_title_and_a_description_that_are_announced() -> None:
    root = picture(3)
    named = {element.get("id"): element.text for element in root if element.get("id")}
    assert named == {"title": "A <title>", "desc": "What & why"}
    assert root.get("aria-labelledby") == "title desc"
    assert root.get("role") == "img"


def test_axes_and_curves_are_labelled() -> None:
    words = texts(picture(3, "random & more"))
    assert {"A <title>", "shown", "right, %", "random & more"} <= set(words)
    assert {"0", "20", "40", "60", "80", "100"} <= set(words)


@pytest.mark.parametrize(
    ("points", "marks"),
    [
        (1, ["0", "1"]),
        (12, ["0", "2", "4", "6", "8", "10", "12"]),
        (100, ["0", "20", "40", "60", "80", "100"]),
        (400, ["0", "50", "100", "150", "200", "250", "300", "350", "400"]),
    ],
)
def test_marks_are_round_numbers_and_not_too_many(points: int, marks: list[str]) -> None:
    ticks = [t for t in texts(picture(points))[7:] if t.isdecimal()]
    assert ticks == marks


def test_curves_differ_in_dashes_and_not_only_in_colour() -> None:
    lines = list(picture(4).iter(f"{SVG}polyline"))
    assert len(lines) == 2
    assert len({line.get("stroke-dasharray") for line in lines}) == 2
    assert len({line.get("stroke") for line in lines}) == 2


def test_a_curve_goes_through_its_means_within_its_band() -> None:
    root = picture(2)
    line = next(root.iter(f"{SVG}polyline")).get("points", "").split()
    band = next(root.iter(f"{SVG}polygon")).get("points", "").split()
    assert len(line) == 2
    assert len(band) == 4
    y = [float(place.split(",")[1]) for place in line]
    edges = [float(place.split(",")[1]) for place in band]
    assert all(min(edges) < one < max(edges) for one in y)


def test_nothing_to_draw_still_is_a_picture() -> None:
    drawn = draw(Picture("Empty", "Nothing", "x", "y", ()))
    assert ET.fromstring(drawn).get("role") == "img"  # noqa: S314 - our own picture
