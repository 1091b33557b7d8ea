"""When the row is long enough."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from itertools import accumulate
from typing import Literal

import numpy as np

from maestra.rules.fields import Name, Number
from maestra.rules.forms.base import Form
from maestra.rules.forms.numbers import largest_gain, scale_of, whole_numbers
from maestra.rules.forms.ranks import all_ranked
from maestra.rules.plays import NOBODY, Plays, Truth
from maestra.rules.setting import Line, Play, Rank, bits


@dataclass(frozen=True, slots=True)
class FullRow(Form):
    """Every goal cell is filled."""

    form: Literal["full-row"] = field(default="full-row", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """No cell is free."""
        return not play.free

    def possible(self, play: Play) -> bool:
        """There are tokens enough."""
        return play.left.bit_count() >= len(play.free)

    def certain(self, play: Play) -> bool:
        """What is full stays full."""
        return self.holds(play)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        right: Truth = (plays.row != NOBODY).all(axis=1)
        return right


@dataclass(frozen=True, slots=True)
class UntilTotal(Form):
    """The play ends as soon as what the tokens show adds up to `number` or more.

    Every token of the row has a rank; what lies there from the start counts.
    """

    attribute: Name
    number: Number
    form: Literal["until-total"] = field(default="until-total", kw_only=True, repr=False)

    def _sums(self, play: Play) -> list[Rank] | None:
        """The sum at the start and after each move; None if a token has no rank."""
        known = play.setting.ranks(self.attribute)
        given = [known[token] for token in play.setting.given if token is not None]
        placed = [known[token] for token, _ in play.placed]
        start = sum(rank for rank in given if rank is not None)
        if None in given or None in placed:
            return None
        return list(accumulate((rank for rank in placed if rank is not None), initial=start))

    def holds(self, play: Play) -> bool:
        """Reached now, and not before."""
        sums, number = self._sums(play), Fraction(self.number)
        return sums is not None and sums[-1] >= number and all(s < number for s in sums[:-1])

    def possible(self, play: Play) -> bool:
        """Not reached before, and reached now or within reach."""
        sums, number = self._sums(play), Fraction(self.number)
        if sums is None or any(total >= number for total in sums[:-1]):
            return False
        known = play.setting.ranks(self.attribute)
        left = [rank for k in bits(play.left) if (rank := known[k]) is not None]
        return sums[-1] >= number or sums[-1] + largest_gain(left, play.room) >= number

    def certain(self, play: Play) -> bool:
        """Reached, and nothing can come any more."""
        return self.holds(play) and not play.room

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        scale = scale_of(plays.setting, self.attribute, self.number)
        numbers = whole_numbers(plays.setting, self.attribute, scale)
        given = [token for token in plays.setting.given if token is not None]
        start = int(numbers[given].sum()) if given else 0
        sums = numbers[plays.time].cumsum(axis=1) + start
        reached = np.asarray(sums >= int(self.number * scale), np.bool_)
        placed = (plays.time != NOBODY).sum(axis=1)
        earlier = np.arange(plays.setting.length) < placed[:, None] - 1
        right = reached[:, -1] & ~(reached & earlier).any(axis=1)
        if start >= self.number * scale:
            right &= placed == 0
        return np.asarray(right & all_ranked(plays, Line.ROW, self.attribute))
