"""Curves as SVG: with a title, a description, and marks that are told apart without colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from markupsafe import Markup

from maestra.coaching.progress import Trend
from maestra.coaching.report import NOTHING, Chart
from maestra.language.reports import decimal
from maestra.web.pages import Pages

MOST_DRAWN: Final = 60
"""Sessions in one picture: more would be a wall of marks."""
WIDTH: Final = 320
HEIGHT: Final = 210
LEFT: Final = 52
RIGHT: Final = 310
TOP: Final = 18
BOTTOM: Final = 168
_TICK: Final = 196
"""Where the numbers of the sessions stand."""


@dataclass(frozen=True, slots=True)
class Curve:
    """A picture and the words that belong to it."""

    title: str
    trend: str
    svg: Markup


def curve(number: str, chart: Chart, trend: Trend, pages: Pages) -> Curve:
    """The picture of a measure over the sessions.

    Args:
        number: tells its parts apart from those of other pictures on the page.
        chart: the measure.
        trend: where it goes.
        pages: says it.
    """
    first = max(len(chart.values) - MOST_DRAWN, 0)
    values = chart.values[first:]
    places = [(x, y) for x, y in _places(values, chart.top) if y is not None]
    parts = _grid(chart.top, pages) + _ticks(first, len(chart.values)) + _line(places)
    said = _description(values, trend, pages)
    svg = _frame(number, chart.title, said, parts + _marks(places))
    return Curve(chart.title, trend_words(trend, pages), svg)


def endings(number: str, completed: Sequence[bool], title: str, pages: Pages) -> Curve:
    """Which sessions were completed: a full mark each, an empty one for the others."""
    first = max(len(completed) - MOST_DRAWN, 0)
    shown = completed[first:]
    done = sum(completed)
    said = pages.say("{done} of {all} sessions were completed.", done=done, all=len(completed))
    marks = Markup("").join(
        Markup(
            '<circle cx="{}" cy="34" r="{}" fill="{}" stroke="#0a4f5c" stroke-width="2"/>'
        ).format(f"{x:.1f}", 6 if one else 4, "#0a4f5c" if one else "#ffffff")
        for one, (x, _) in zip(shown, _places([0.0] * len(shown), 1), strict=True)
    )
    parts = marks + _ticks(first, len(completed), 78)
    return Curve(title, said, _frame(number, title, said, parts, 92))


def trend_words(trend: Trend, pages: Pages) -> str:
    """Where a measure goes."""
    match trend:
        case Trend.RISING:
            return pages.say("It rises.")
        case Trend.FALLING:
            return pages.say("It falls.")
        case Trend.STEADY:
            return pages.say("No clear trend.")
        case Trend.TOO_FEW:
            return pages.say("Too few sessions for a trend.")


def _description(values: Sequence[float | None], trend: Trend, pages: Pages) -> str:
    known = [one for one in values if one is not None]
    if not known:
        return pages.say("There is nothing to measure yet.")

    def written(value: float) -> str:
        return decimal(value, pages.language)

    range_said = pages.say(
        "From {first} in the first session to {last} in the last; lowest {low}, highest {high}.",
        first=written(known[0]),
        last=written(known[-1]),
        low=written(min(known)),
        high=written(max(known)),
    )
    every = ", ".join(NOTHING if one is None else written(one) for one in values)
    return f"{range_said} {trend_words(trend, pages)} {every}"


def _frame(
    number: str, title: str, description: str, parts: Markup, height: int = HEIGHT
) -> Markup:
    """The picture around its parts."""
    return Markup(
        '<svg class="curve" viewBox="0 0 {} {}" role="img" aria-labelledby="{}-t {}-d">'
        '<title id="{}-t">{}</title><desc id="{}-d">{}</desc>{}</svg>'
    ).format(WIDTH, height, number, number, number, title, number, description, parts)


def _grid(top: float, pages: Pages) -> Markup:
    lines: list[Markup] = []
    for share in (0.0, 0.5, 1.0):
        y = BOTTOM - (BOTTOM - TOP) * share
        value = decimal(top * share, pages.language, 0 if float(top * share).is_integer() else 1)
        lines.append(
            Markup(
                '<path d="M{} {} H{}" stroke="{}"/><text x="{}" y="{}" text-anchor="end">{}</text>'
            ).format(
                LEFT,
                f"{y:.1f}",
                RIGHT,
                "#1b2733" if share == 0 else "#d5d9da",
                LEFT - 8,
                f"{y + 6:.1f}",
                value,
            )
        )
    return Markup("").join(lines)


def _ticks(first: int, last: int, y: int = _TICK) -> Markup:
    """The numbers of the first and last session drawn."""
    ends = {first + 1: LEFT + 8, last: RIGHT - 8} if last > first + 1 else {last: LEFT + 8}
    return Markup("").join(
        Markup('<text x="{}" y="{}" text-anchor="middle">{}</text>').format(x, y, number)
        for number, x in ends.items()
    )


def _places(values: Sequence[float | None], top: float) -> list[tuple[float, float | None]]:
    width = RIGHT - LEFT - 16
    return [
        (
            LEFT + 8 + width * k / max(len(values) - 1, 1),
            None if one is None else BOTTOM - (BOTTOM - TOP) * min(one / top, 1),
        )
        for k, one in enumerate(values)
    ]


def _line(places: Sequence[tuple[float, float | None]]) -> Markup:
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    return Markup('<polyline points="{}" fill="none" stroke="#0a4f5c" stroke-width="3"/>').format(
        points
    )


def _marks(places: Sequence[tuple[float, float | None]]) -> Markup:
    return Markup("").join(
        Markup('<circle cx="{}" cy="{}" r="4" fill="#0a4f5c"/>').format(f"{x:.1f}", f"{y:.1f}")
        for x, y in places
    )
