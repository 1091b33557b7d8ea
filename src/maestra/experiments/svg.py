"""Curves as an SVG picture: readable without colour, described for who cannot see it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from itertools import cycle
from typing import Final

WIDTH: Final = 760
HEIGHT: Final = 460
LEFT: Final = 70
RIGHT: Final = 20
TOP: Final = 48
BOTTOM: Final = 64
"""Space around the plot, in the picture's units, for the axes' words."""
TICKS: Final = 8
"""Marks on the horizontal axis at most."""

# Okabe and Ito's blue and vermilion: apart for every kind of colour vision; dashes besides.
_STYLES: Final = (("#0072b2", ""), ("#d55e00", "8 5"), ("#009e73", "2 4"))


@dataclass(frozen=True, slots=True)
class Point:
    """One place on a curve, with its spread; x counts from 1, the rest up to the picture's top."""

    x: int
    mean: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Series:
    """One curve."""

    label: str
    points: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Picture:
    """Curves over a number, and the words around them."""

    title: str
    description: str
    horizontal: str
    vertical: str
    series: tuple[Series, ...]
    top: float = 100.0
    """The upper end of the vertical axis, which begins at 0: percent if not said."""


def draw(picture: Picture) -> str:
    """The picture as an SVG document."""
    last = max((point.x for one in picture.series for point in one.points), default=1)
    drawn = [_in_percent(one, picture.top) for one in picture.series]
    styles = list(zip(drawn, cycle(_STYLES), strict=False))
    size = f"0 0 {WIDTH} {HEIGHT}"
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{size}" role="img"',
            ' aria-labelledby="title desc" font-family="sans-serif" font-size="14">',
            f'<title id="title">{escape(picture.title)}</title>',
            f'<desc id="desc">{escape(picture.description)}</desc>',
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
            _text(WIDTH / 2, 26, picture.title, 'text-anchor="middle" font-size="17"'),
            *_axes(picture, last),
            *(_band(one, colour, last) for one, (colour, _) in styles),
            *(_line(one, colour, dashes, last) for one, (colour, dashes) in styles),
            *(
                piece
                for place, (one, style) in enumerate(styles)
                for piece in _key(place, one, style)
            ),
            "</svg>",
            "",
        ]
    )


def _in_percent(series: Series, top: float) -> Series:
    scale = 100 / top
    points = (Point(p.x, p.mean * scale, p.low * scale, p.high * scale) for p in series.points)
    return Series(series.label, tuple(points))


def _x(value: float, last: int) -> float:
    return LEFT + (WIDTH - LEFT - RIGHT) * value / last


def _y(percent: float) -> float:
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * percent / 100


def _text(x: float, y: float, words: str, attributes: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" fill="#1a1a1a" {attributes}>{escape(words)}</text>'


def _axes(picture: Picture, last: int) -> list[str]:
    pieces: list[str] = []
    for percent in range(0, 101, 20):
        y = _y(percent)
        pieces.append(
            f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#d0d0d0"/>'
        )
        value = f"{percent * picture.top / 100:g}"
        pieces.append(_text(LEFT - 8, y + 5, value, 'text-anchor="end"'))
    for place in range(0, last + 1, _step(last)):
        x = _x(place, last)
        pieces.append(
            f'<line x1="{x:.1f}" y1="{_y(0):.1f}" x2="{x:.1f}" y2="{_y(0) + 6:.1f}"'
            ' stroke="#1a1a1a"/>'
        )
        pieces.append(_text(x, _y(0) + 22, str(place), 'text-anchor="middle"'))
    middle = (LEFT + WIDTH - RIGHT) / 2
    pieces.append(_text(middle, HEIGHT - 16, picture.horizontal, 'text-anchor="middle"'))
    turned = f'text-anchor="middle" transform="rotate(-90 20 {_y(50):.1f})"'
    pieces.append(_text(20, _y(50), picture.vertical, turned))
    return pieces


def _step(last: int) -> int:
    """The distance of marks: 1, 2 or 5 times a power of ten, so that there are not too many."""
    power = 1
    while True:
        for factor in (1, 2, 5):
            if last <= TICKS * factor * power:
                return factor * power
        power *= 10


def _path(places: Sequence[tuple[float, float]]) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in places)


def _band(series: Series, colour: str, last: int) -> str:
    above = [(_x(point.x, last), _y(point.high)) for point in series.points]
    below = [(_x(point.x, last), _y(point.low)) for point in reversed(series.points)]
    return f'<polygon points="{_path(above + below)}" fill="{colour}" fill-opacity="0.18"/>'


def _line(series: Series, colour: str, dashes: str, last: int) -> str:
    places = _path([(_x(point.x, last), _y(point.mean)) for point in series.points])
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return (
        f'<polyline points="{places}" fill="none" stroke="{colour}" stroke-width="2.5"{dashed}/>'
    )


def _key(place: int, series: Series, style: tuple[str, str]) -> list[str]:
    """The line of the legend that names a curve."""
    colour, dashes = style
    y = _y(8) - 22 * place
    x = WIDTH - RIGHT - 250
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    ends = f'x1="{x}" y1="{y:.1f}" x2="{x + 40}" y2="{y:.1f}"'
    return [
        f'<line {ends} stroke="{colour}" stroke-width="2.5"{dashed}/>',
        _text(x + 48, y + 5, series.label, ""),
    ]
