"""What stands on drawings of rules besides the board: marks of sets, medals, icons, words."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final

from markupsafe import Markup

from maestra.core.tokens import TokenId
from maestra.web.board_drawing import ACCENT, Point, element, text

_SHAPES: Final = (
    "M0-8A8 8 0 1 1 0 8A8 8 0 1 1 0-8z",
    "M0-9L9 8L-9 8z",
    "M-8-8H8V8H-8z",
    "M0-10L10 0L0 10L-10 0z",
    "M0-10L3-3L10-3L5 2L7 10L0 5L-7 10L-5 2L-10-3L-3-3z",
    "M-3-9H3V-3H9V3H3V9H-3V3H-9V-3H-3z",
)
"""Marks of sets, around 0 0: circle, triangle, square, diamond, star, cross."""
CORNERS: Final = ((1, -1), (-1, -1), (1, 1), (-1, 1))


@dataclass
class Marks:
    """Which mark each set of tokens has, in the order in which they are spoken of."""

    sets: list[frozenset[TokenId]] = field(default_factory=list[frozenset[TokenId]])
    texts: dict[TokenId, str] = field(default_factory=dict[TokenId, str])
    """What is written on tokens instead: their turn."""

    def of(self, tokens: Iterable[TokenId]) -> int:
        """The number of a set's mark."""
        found = frozenset(tokens)
        if found not in self.sets:
            self.sets.append(found)
        return self.sets.index(found)

    def on(self, token: TokenId) -> list[int]:
        """The marks of the sets that a token is in."""
        return [number for number, one in enumerate(self.sets) if token in one]


def mark(number: int, at: Point) -> Markup:
    """A set's mark; letters once there are no more shapes."""
    style = {"fill": ACCENT, "stroke": "#fff", "stroke_width": 2.5, "paint_order": "stroke"}
    if number < len(_SHAPES):
        place = f"translate({at.x:.1f} {at.y:.1f})"
        return element("path", d=_SHAPES[number], transform=place, **style)
    letter = chr(ord("A") + (number - len(_SHAPES)) % 26)
    return element("circle", cx=at.x, cy=at.y, r=11, **style) + text(letter, at, 15, "#fff")


def medal(words: str, at: Point) -> Markup:
    """A short text in a circle."""
    size = 17.0 if len(words) < 3 else 13.0  # noqa: PLR2004 - what fits
    circle = element(
        "circle", cx=at.x, cy=at.y, r=13, fill="#fff", stroke=ACCENT, stroke_width=2.5
    )
    return circle + text(words, at, size)
