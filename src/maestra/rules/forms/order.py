"""The order of the tokens along the row or in time, and the shape of what they show."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import Literal

from maestra.rules.forms.base import Direction, Link, Pairwise
from maestra.rules.pairs import Compare, related
from maestra.rules.setting import Line, Setting
from maestra.rules.token_tests import Comparison

_ORDERS = {
    (Direction.RISING, True): Comparison.LESS,
    (Direction.RISING, False): Comparison.AT_MOST,
    (Direction.FALLING, True): Comparison.MORE,
    (Direction.FALLING, False): Comparison.AT_LEAST,
}


@dataclass(frozen=True, slots=True)
class Ordered(Pairwise):
    """Of two tokens the one further on the line shows more (rising) or less (falling).

    Not strict: or as much. Gaps do not matter. A token without a rank is never in order with
    another.
    """

    attribute: str
    direction: Direction = Direction.RISING
    strict: bool = True
    line: Line = Line.ROW
    form: Literal["ordered"] = field(default="ordered", kw_only=True, repr=False)

    def links(self, setting: Setting) -> Iterator[Link]:
        """Every pair."""
        comparison = _ORDERS[self.direction, self.strict]
        masks = related(setting, Compare(self.attribute, comparison))
        for i, j in combinations(range(setting.length), 2):
            yield i, j, masks
