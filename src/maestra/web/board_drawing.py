"""A board and its tokens as SVG: what rules are drawn on, and thumbnails.

Nothing here is an element that anybody presses; that is `parts/board.html`. Drawings are readable
from 240 px on, need no style, and have no colour as the only cue.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from markupsafe import Markup, escape

from maestra.core.board import Board, Cell
from maestra.web.token_view import TokenView

CELL: Final = 56.0
GAP: Final = 6.0
MARGIN: Final = 12.0
PITCH: Final = CELL + GAP
MOST_COLUMNS: Final = 12
MOST_ROWS: Final = 8
"""Of a drawing: more would be too small to be read, and a board may have a hundred."""
TEXT: Final = 20.0
"""Of signs and words beside the board."""
LETTER: Final = 0.7
"""Width of a letter at most, in sizes of its text; of a bold one that is wide."""

INK: Final = "#1b2733"
ACCENT: Final = "#0a4f5c"
TINT: Final = "#e8f1f2"
LINE: Final = "#6f7d88"
PLAIN: Final = "#fff6dd"
"""A token without a colour of its own, as in the style."""
FILLS: Final[Mapping[str, tuple[str, str]]] = {
    "red": ("#a31621", "#fff"),
    "orange": ("#ffa04d", "#1b1206"),
    "yellow": ("#ffdc4a", "#1b1206"),
    "green": ("#17602c", "#fff"),
    "turquoise": ("#66d6c9", "#06201d"),
    "blue": ("#124a9c", "#fff"),
    "purple": ("#5b2a86", "#fff"),
    "pink": ("#ffa9c6", "#2a0614"),
    "brown": ("#5f3a1c", "#fff"),
    "black": ("#16191c", "#fff"),
    "white": ("#ffffff", "#16191c"),
    "grey": ("#bcc3c9", "#16191c"),
}
"""A token's colour and that of the text on it: the same as in the style."""
_POLYGONS: Final[Mapping[str, str]] = {
    "triangle": "50,2 100,96 0,96",
    "diamond": "50,0 100,50 50,100 0,50",
    "hexagon": "25,6 75,6 100,50 75,94 25,94 0,50",
    "cross": "30,0 70,0 70,30 100,30 100,70 70,70 70,100 30,100 30,70 0,70 0,30 30,30",
    "star": "50,0 63,35 100,36 71,59 81,95 50,74 19,95 29,59 0,36 37,35",
}
_LONGEST: Final = 5
"""Characters of a label that fit a cell; longer ones are cut."""


@dataclass(frozen=True, slots=True)
class Point:
    """A place in the drawing."""

    x: float
    y: float


@dataclass(frozen=True, slots=True)
class Plan:
    """Where the board's cells are in a drawing."""

    board: Board
    above: float = 0.0
    """Free space over the goal row, for what is drawn between its cells."""

    @property
    def columns(self) -> int:
        """Drawn ones."""
        return min(self.board.columns, MOST_COLUMNS)

    @property
    def rows(self) -> range:
        """Drawn ones, with the goal row among them."""
        last = max(min(self.board.rows, MOST_ROWS), self.board.goal_row)
        return range(max(1, last - MOST_ROWS + 1), last + 1)

    @property
    def width(self) -> float:
        """Of the board."""
        return self.columns * PITCH - GAP

    @property
    def bottom(self) -> float:
        """The lower edge of the last row."""
        return MARGIN + self.above + len(self.rows) * PITCH - GAP

    def has(self, cell: Cell) -> bool:
        """Whether the cell is drawn."""
        return cell.column <= self.columns and cell.row in self.rows

    def corner(self, cell: Cell) -> Point:
        """The upper left corner of a cell."""
        above = self.above if cell.row >= self.board.goal_row else 0.0
        x = MARGIN + (cell.column - 1) * PITCH
        return Point(x, MARGIN + above + (cell.row - self.rows[0]) * PITCH)

    def middle(self, cell: Cell) -> Point:
        """The middle of a cell."""
        corner = self.corner(cell)
        return Point(corner.x + CELL / 2, corner.y + CELL / 2)

    def draw(
        self, tokens: Mapping[Cell, TokenView], between: Iterable[Markup] = ()
    ) -> Iterable[Markup]:
        """The cells, the tokens that lie on them, and `between` them what tokens may hide."""
        drawn = [cell for cell in self.board.cells if self.has(cell)]
        for cell in drawn:
            corner, is_goal = self.corner(cell), cell.row == self.board.goal_row
            yield element(
                "rect",
                x=corner.x,
                y=corner.y,
                width=CELL,
                height=CELL,
                rx=8,
                fill=TINT if is_goal else "#fff",
                stroke=ACCENT if is_goal else LINE,
                stroke_width=4 if is_goal else 1.5,
            )
        yield from between
        for cell in drawn:
            if cell in tokens:
                yield draw_token(tokens[cell], self.middle(cell))
        if self.columns < self.board.columns:
            yield text("…", Point(MARGIN + self.width + 2, self.bottom - CELL / 2), start=True)


def element(name: str, *inside: Markup, **attributes: object) -> Markup:
    """One element of SVG; underscores in names of attributes stand for hyphens."""
    written = Markup(" ").join(
        Markup('{}="{}"').format(key.replace("_", "-"), _number(value))
        for key, value in attributes.items()
    )
    opening = Markup("<{} {}").format(name, written)
    if not inside:
        return opening + Markup("/>")
    return opening + Markup(">") + Markup("").join(inside) + Markup("</{}>").format(name)


def _number(value: object) -> object:
    return f"{value:.1f}".removesuffix(".0") if isinstance(value, float) else value


def text(  # noqa: PLR0913 - how words look
    words: str,
    at: Point,
    size: float = TEXT,
    fill: str = INK,
    *,
    start: bool = False,
    halo: bool = False,
    within: float = math.inf,
) -> Markup:
    """Words whose middle is at a point, or that start there.

    Args:
        words: are escaped.
        at: the middle, or the left end at half the height.
        size: of the letters.
        fill: their colour.
        start: whether they start at `at`.
        halo: whether they keep lines behind them away.
        within: how wide they may be; what is wider is drawn closer.
    """
    wide = size * LETTER * len(words) > within
    narrow = {"textLength": within, "lengthAdjust": "spacingAndGlyphs"} if wide else {}
    around = {"stroke": "#fff", "stroke_width": 5, "paint_order": "stroke"} if halo else {}
    return element(
        "text",
        escape(words),
        x=at.x,
        y=at.y + size * 0.35,
        font_size=size,
        font_weight=700,
        fill=fill,
        text_anchor="start" if start else "middle",
        **narrow,
        **around,
    )


def draw_token(view: TokenView, at: Point, *, ghost: bool = False) -> Markup:
    """A token with its middle at a point; as a ghost where it may come to lie."""
    fill, on = FILLS.get(view.colour, (PLAIN, INK))
    half = CELL / 2 - 6
    line = {"stroke": INK, "stroke_width": 2, **({"stroke_dasharray": "5 4"} if ghost else {})}
    body = _outline(view.shape, at, half, {"fill": fill, **line})
    if view.picture:
        side = half * 2 - 8
        picture = element(
            "image",
            href=view.picture,
            x=at.x - side / 2,
            y=at.y - side / 2,
            width=side,
            height=side,
        )
        return body + picture
    # A triangle is widest below its middle.
    lower = 7.0 if view.shape == "triangle" else 0.0
    words = view.label or view.name
    label = words if len(words) <= _LONGEST else f"{words[: _LONGEST - 1]}…"
    size = min(26.0, max(16.0, 1.5 * half * 2 / max(len(label), 1)))
    return body + text(label, Point(at.x, at.y + lower), size, on, within=2 * half - 4)


def _outline(shape: str, at: Point, half: float, style: Mapping[str, object]) -> Markup:
    if shape == "round":
        return element("circle", cx=at.x, cy=at.y, r=half, **style)
    if shape in _POLYGONS:
        corners = (pair.split(",") for pair in _POLYGONS[shape].split())
        points = " ".join(
            f"{at.x + (float(x) / 50 - 1) * half:.1f},{at.y + (float(y) / 50 - 1) * half:.1f}"
            for x, y in corners
        )
        return element("polygon", points=points, stroke_linejoin="round", **style)
    rounded = 3 if shape == "square" else 10
    return element(
        "rect",
        x=at.x - half,
        y=at.y - half,
        width=2 * half,
        height=2 * half,
        rx=rounded,
        **style,
    )


def arrow(points: Sequence[Point], *, bent: bool = False) -> Markup:
    """A line with a head: straight, or bent over its middle point of three."""
    *_, before, end = points
    path = f"M{points[0].x:.1f} {points[0].y:.1f}" + (
        f"Q{points[1].x:.1f} {points[1].y:.1f} {end.x:.1f} {end.y:.1f}"
        if bent
        else "".join(f"L{point.x:.1f} {point.y:.1f}" for point in points[1:])
    )
    angle = math.atan2(end.y - before.y, end.x - before.x)
    wings = [
        f"{end.x - 9 * math.cos(angle + turn):.1f} {end.y - 9 * math.sin(angle + turn):.1f}"
        for turn in (0.5, -0.5)
    ]
    head = f"M{wings[0]}L{end.x:.1f} {end.y:.1f}L{wings[1]}"
    under = {"fill": "none", "stroke": "#fff", "stroke_width": 6.5}
    style = {"fill": "none", "stroke": ACCENT, "stroke_width": 3, "stroke_linecap": "round"}
    return element("path", d=path, **under) + element("path", d=path + head, **style)


def picture_of(
    parts: Iterable[Markup], width: float, height: float, title: str, description: str
) -> Markup:
    """The whole drawing; without a title it is decoration, for what it shows is said beside it."""
    named = [element("title", escape(title))] if title else []
    if description:
        named.append(element("desc", escape(description)))
    hidden = {"role": "img"} if title else {"aria_hidden": "true"}
    return element(
        "svg",
        *named,
        *parts,
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {width:.0f} {height:.0f}",
        **{"class": "drawing"},
        font_family="system-ui, sans-serif",
        **hidden,
    )
