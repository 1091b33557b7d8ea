"""The lines below the board of a rule's drawing: what is counted, and in which order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from enum import Enum
from typing import Final, TypeAlias, assert_never

from markupsafe import Markup

from maestra.core.tokens import TokenId
from maestra.language.speaker import Speaker
from maestra.rules.pictures import (
    Arrow,
    Badge,
    Balance,
    Choice,
    Implication,
    Measure,
    Selection,
    Stroke,
    Succession,
    Tally,
)
from maestra.rules.setting import Line, Setting
from maestra.rules.token_tests import Comparison
from maestra.web.board_drawing import ACCENT, GAP, LETTER, TEXT, TINT, Point, element, text
from maestra.web.drawing_marks import Marks, mark

_LONGEST_NAME: Final = 14
_COMPARED: Final = {
    Comparison.LESS: "<",
    Comparison.AT_MOST: "≤",
    Comparison.EQUAL: "=",
    Comparison.DIFFERENT: "≠",
    Comparison.AT_LEAST: "≥",
    Comparison.MORE: ">",
}


class Icon(Enum):
    """What is small enough to stand among words."""

    ROW = "row"
    """All of the goal row."""
    TIME = "time"
    """A clock."""


Chip: TypeAlias = str | int | Icon
"""A part of a line below the board: words, the number of a set's mark, an icon."""


def below(
    strokes: Sequence[Stroke], setting: Setting, speaker: Speaker, marks: Marks
) -> list[list[Chip]]:
    """The lines that `strokes` need; sets of tokens get their marks from `marks`."""
    writer = _Writer(tuple(strokes), setting, speaker, marks)
    return [line for line in map(writer.line, strokes) if line]


def draw_line(line: Sequence[Chip], at: Point) -> Iterator[Markup]:
    """One line, from its left end at half its height."""
    x = at.x
    for part in line:
        match part:
            case int():
                yield mark(part, Point(x + 12, at.y))
            case Icon():
                yield _icon(part, Point(x + 13, at.y))
            case str():
                yield text(part, Point(x, at.y), start=True)
        x += width_of([part])


@dataclass(frozen=True)
class _Writer:
    strokes: tuple[Stroke, ...]
    setting: Setting
    speaker: Speaker
    marks: Marks

    def line(self, stroke: Stroke) -> list[Chip]:
        """A line below the board: words, and the numbers of marks."""
        match stroke:
            case Tally(measure, about, tokens, comparison, number):
                sign, amount = _COMPARED[comparison], self._number(number)
                if measure is Measure.TOKENS:
                    return [*self._set(tokens), sign, amount]
                called = {Measure.SUM: "Σ", Measure.KINDS: "#"}[measure]
                return [called, self._called(about), sign, amount]
            case Balance(first, comparison, second):
                return [*self._set(first), _COMPARED[comparison], *self._set(second)]
            case Succession(sets, line) if sets:
                last = "" if len(sets) == 1 else f"→ {len(sets)}"
                return [Icon.TIME if line is Line.TIME else Icon.ROW, "1", last]
            case Arrow(about=about) if about and self._names(about):
                arrows = (one for one in self.strokes if isinstance(one, Arrow))
                # Once, however many arrows there are.
                is_first = next(one for one in arrows if one.about == about) is stroke
                return [self._called(about)] if is_first else []
            case Arrow() | Choice() | Selection() | Succession() | Badge() | Implication():
                return []
            case _:
                assert_never(stroke)

    def _names(self, about: str) -> bool:
        """Whether it has to be said which attribute is meant."""
        return len(self.setting.deck.scales) > 1 or about not in self.setting.deck.scales

    def _set(self, tokens: tuple[TokenId, ...]) -> list[Chip]:
        if not tokens:
            return ["∅"]
        if len(tokens) == self.setting.movable.bit_count():
            return [Icon.ROW]
        return [self.marks.of(tokens)]

    def _called(self, about: str) -> str:
        """Attributes and names as the reader calls them."""
        names = [self._attribute(one) for one in about.split(", ")]
        called = ", ".join(names)
        return called if len(called) <= _LONGEST_NAME else f"{called[: _LONGEST_NAME - 1]}…"

    def _attribute(self, name: str) -> str:
        return self.speaker.attribute(name).noun or name

    def _number(self, number: int | Decimal) -> str:
        return self.speaker.grammar.numeral(number)


def width_of(line: Sequence[Chip]) -> float:
    """How wide a line below the board is, about."""
    return sum(len(part) * LETTER * TEXT + GAP if isinstance(part, str) else 34.0 for part in line)


def _icon(icon: Icon, at: Point) -> Markup:
    """An icon with its middle at a point."""
    style = {"fill": TINT, "stroke": ACCENT, "stroke_width": 3}
    if icon is Icon.ROW:
        return element("rect", x=at.x - 13, y=at.y - 8, width=26, height=16, rx=3, **style)
    hands = f"M{at.x:.1f} {at.y - 6:.1f}V{at.y:.1f}H{at.x + 5:.1f}"
    return element("circle", cx=at.x, cy=at.y, r=11, **style) + element(
        "path", d=hands, fill="none", stroke=ACCENT, stroke_width=2.5
    )
