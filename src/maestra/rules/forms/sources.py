"""Where the tokens come from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from maestra.rules.forms.base import EachSlot, Form
from maestra.rules.forms.selection import EveryToken
from maestra.rules.plays import NOBODY, Plays, Truth, as_matrix, as_table
from maestra.rules.setting import ORIGIN_ROW, Index, Line, Mask, Play, Rank, Setting, bits
from maestra.rules.token_tests import Anything, Extreme, TokenTest, has, passing


def from_row(row: int) -> EveryToken:
    """All tokens come from storage row `row`, counted from 1."""
    return EveryToken(has(f"is-{row}", ORIGIN_ROW))


@dataclass(frozen=True, slots=True)
class StraightUp(EachSlot):
    """Each token stays in its column, or goes to the mirrored one; given tokens are right."""

    mirrored: bool = False
    form: Literal["straight-up"] = field(default="straight-up", kw_only=True, repr=False)

    @property
    def line(self) -> Line:
        """It looks at the row."""
        return Line.ROW

    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """The tokens of each column."""
        return setting.remember(self, lambda: self._allowed(setting))

    def _allowed(self, setting: Setting) -> tuple[Mask, ...]:
        cells = [setting.start.cells[token.id] for token in setting.deck.tokens]
        given = setting.mask(lambda k: not setting.movable >> k & 1)
        columns = [given] * setting.length
        for token, cell in enumerate(cells):
            columns[cell.column - 1] |= 1 << token
        return tuple(columns[::-1] if self.mirrored else columns)


@dataclass(frozen=True, slots=True)
class TakeExtreme(Form):
    """Each token taken shows the least or the most of those left in storage, ties allowed.

    The left-most one left: of ``ORIGIN_COLUMN`` the lowest. Only tokens that pass `among` are
    looked at: always the smallest red one left. A token looked at has a rank.
    """

    attribute: str
    extreme: Extreme
    among: TokenTest = field(default_factory=Anything)
    form: Literal["take-extreme"] = field(default="take-extreme", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        ranks, pool = self._ranks(play.setting), passing(play.setting, self.among)
        left = play.setting.movable & pool
        for token, _ in play.placed:
            if pool >> token & 1:
                mine = ranks[token]
                others = [rank for k in bits(left) if (rank := ranks[k]) is not None]
                if mine is None or mine > min(others):
                    return False
                left &= ~(1 << token)
        return True

    def possible(self, play: Play) -> bool:
        """What was taken too early stays so."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether those left are all alike."""
        ranks = self._ranks(play.setting)
        left = {ranks[k] for k in bits(play.left & passing(play.setting, self.among))}
        return self.holds(play) and (not play.room or (None not in left and len(left) <= 1))

    def _ranks(self, setting: Setting) -> tuple[Rank | None, ...]:
        sign = 1 if self.extreme is Extreme.LOWEST else -1
        return tuple(None if r is None else sign * r for r in setting.ranks(self.attribute))

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: all that are beyond a token were placed before it."""
        setting = plays.setting
        ranks, pool = self._ranks(setting), passing(setting, self.among)
        right = np.ones(len(plays), np.bool_)
        beyond = as_matrix(setting, setting.masks(lambda a, b: self._is_beyond(setting, a, b)))
        stored = [*bits(setting.movable), NOBODY]
        all_beyond = beyond[stored[:-1]].sum(axis=0) if stored[:-1] else np.zeros(len(beyond))
        wrong = as_table(setting, pool & setting.mask(lambda k: ranks[k] is None), nobody=False)
        for t in range(setting.length):
            now = plays.time[:, t]
            before = beyond[plays.time[:, :t], now[:, None]].sum(axis=1)
            right &= ((now == NOBODY) | (before == all_beyond[now])) & ~wrong[now]
        return right

    def _is_beyond(self, setting: Setting, one: Index, two: Index) -> bool:
        """Whether `one` would have to be taken before `two`."""
        ranks, pool = self._ranks(setting), passing(setting, self.among)
        a, b = ranks[one], ranks[two]
        looked_at = pool >> one & 1 and pool >> two & 1
        return bool(looked_at) and a is not None and b is not None and a < b
