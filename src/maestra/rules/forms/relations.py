"""How tokens in pairs of places relate: neighbours, two by two, mirrored, all, given places."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum
from itertools import combinations
from typing import Literal, assert_never

from maestra.rules.fields import Place
from maestra.rules.forms.base import Link, Pairwise, demand, place_of
from maestra.rules.pairs import Relation, converse, related
from maestra.rules.setting import Index, Line, Setting


class Pairs(Enum):
    """Which pairs of places of a line, the earlier one first."""

    NEIGHBOURS = "neighbours"
    TWO_BY_TWO = "two-by-two"
    """The first with the second, the third with the fourth, and so on."""
    MIRRORED = "mirrored"
    """The first with the last, the second with the last but one; of the row only."""
    FIRST_WITH_REST = "first-with-rest"
    ALL = "all"

    def of(self, length: int) -> Iterator[tuple[Index, Index]]:
        """The pairs on a line of `length` places."""
        match self:
            case Pairs.NEIGHBOURS:
                return ((k, k + 1) for k in range(length - 1))
            case Pairs.TWO_BY_TWO:
                return ((k, k + 1) for k in range(0, length - 1, 2))
            case Pairs.MIRRORED:
                return ((k, length - 1 - k) for k in range(length // 2))
            case Pairs.FIRST_WITH_REST:
                return ((0, k) for k in range(1, length))
            case Pairs.ALL:
                return combinations(range(length), 2)
            case _:
                assert_never(self)


@dataclass(frozen=True, slots=True)
class EachPair(Pairwise):
    """The tokens in each of these pairs of places stand in `relation`; empty places do not matter.

    Neighbours of different colours; each the successor of the one before; partners side by
    side; mirrored colours; all different; all of the first one's category.
    """

    pairs: Pairs
    relation: Relation
    line: Line = Line.ROW
    form: Literal["each-pair"] = field(default="each-pair", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse a mirror in time: where it stands is not known before the end."""
        mirror_in_time = self.pairs is Pairs.MIRRORED and self.line is Line.TIME
        demand(not mirror_in_time, "pairs", "mirrored in time", "mirrored along the row")

    def along(self) -> Line:
        """The line of the rule."""
        return self.line

    def links(self, setting: Setting) -> Iterator[Link]:
        """The pairs of places."""
        masks = related(setting, self.relation)
        return ((i, j, masks) for i, j in self.pairs.of(setting.length))


@dataclass(frozen=True, slots=True)
class TwoPlaces(Pairwise):
    """The tokens at `first` and `second` of the row stand in `relation`, if both are there.

    A place that the row does not have, as the middle of four, asks nothing.
    """

    first: Place
    second: Place
    relation: Relation
    form: Literal["two-places"] = field(default="two-places", kw_only=True, repr=False)

    def links(self, setting: Setting) -> Iterator[Link]:
        """The one pair."""
        i, j = (place_of(place, setting.length) for place in (self.first, self.second))
        masks = related(setting, self.relation)
        if i is not None and j is not None and i != j:
            yield (i, j, masks) if i < j else (j, i, converse(setting, masks))
