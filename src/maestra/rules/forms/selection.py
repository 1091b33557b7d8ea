"""Which tokens belong in the row."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from maestra.rules.forms.base import EachSlot, Form
from maestra.rules.plays import Plays, Truth
from maestra.rules.setting import Mask, Play, Setting, bits
from maestra.rules.token_tests import TokenTest, passing


@dataclass(frozen=True, slots=True)
class EveryToken(EachSlot):
    """Every token of the row passes `test`.

    All odd; anything but animals; red or round; the five smallest; all from storage row 1
    (``has("is-1", ORIGIN_ROW)``).
    """

    test: TokenTest
    form: Literal["every-token"] = field(default="every-token", kw_only=True, repr=False)

    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """The same tokens everywhere."""
        return (passing(setting, self.test),) * setting.length


@dataclass(frozen=True, slots=True)
class AllOfThem(Form):
    """No token that passes `test` is left in storage: as many as there are."""

    test: TokenTest
    form: Literal["all-of-them"] = field(default="all-of-them", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """None of them is left."""
        return not play.left & passing(play.setting, self.test)

    def possible(self, play: Play) -> bool:
        """There is a free cell for each that is left."""
        return (play.left & passing(play.setting, self.test)).bit_count() <= len(play.free)

    def certain(self, play: Play) -> bool:
        """What is placed stays placed."""
        return self.holds(play)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        wanted = list(bits(passing(plays.setting, self.test) & plays.setting.movable))
        right = np.ones(len(plays), np.bool_)
        for token in wanted:
            right &= (plays.row == token).any(axis=1)
        return right
