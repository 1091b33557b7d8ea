"""When the row is long enough."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from maestra.rules.forms.base import Form
from maestra.rules.plays import NOBODY, Plays, Truth
from maestra.rules.setting import Play


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
