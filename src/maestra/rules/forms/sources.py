"""Where the tokens come from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from maestra.rules.fields import Flag, Name
from maestra.rules.forms.base import EachSlot, Form
from maestra.rules.forms.selection import EveryToken
from maestra.rules.pairs import Compare, Related, related
from maestra.rules.plays import Plays, Truth, as_table
from maestra.rules.setting import ORIGIN_ROW, Mask, Play, Setting, bits
from maestra.rules.token_tests import Anything, Comparison, Extreme, TokenTest, has, passing


def from_row(row: int) -> EveryToken:
    """All tokens come from storage row `row`, counted from 1."""
    return EveryToken(has(f"is-{row}", ORIGIN_ROW))


@dataclass(frozen=True, slots=True)
class StraightUp(EachSlot):
    """Each token stays in its column, or goes to the mirrored one; given tokens are right."""

    mirrored: Flag = False
    form: Literal["straight-up"] = field(default="straight-up", kw_only=True, repr=False)

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

    attribute: Name
    extreme: Extreme
    among: TokenTest = field(default_factory=Anything)
    form: Literal["take-extreme"] = field(default="take-extreme", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        sooner, unranked = self._sooner(play.setting)
        left = play.setting.movable
        for token, _ in play.placed:
            left &= ~(1 << token)
            if left & sooner[token] or unranked >> token & 1:
                return False
        return True

    def possible(self, play: Play) -> bool:
        """What was taken too early stays so."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether every one left may be next: they are all alike."""
        return self.holds(play) and (not play.room or self.next_tokens(play) == play.left)

    def next_tokens(self, play: Play) -> Mask:
        """The tokens that may be taken next."""
        sooner, unranked = self._sooner(play.setting)
        return sum(1 << k for k in bits(play.left & ~unranked) if not play.left & sooner[k])

    def _sooner(self, setting: Setting) -> tuple[Related, Mask]:
        """For each token those to be taken before it, and the tokens that may not be taken."""
        return setting.remember(self, lambda: self._work_out(setting))

    def _work_out(self, setting: Setting) -> tuple[Related, Mask]:
        pool = passing(setting, self.among)
        order = Comparison.MORE if self.extreme is Extreme.LOWEST else Comparison.LESS
        beyond = related(setting, Compare(self.attribute, order))
        ranks = setting.ranks(self.attribute)
        masks = (mask & pool if pool >> k & 1 else 0 for k, mask in enumerate(beyond))
        return tuple(masks), pool & setting.mask(lambda k: ranks[k] is None)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: all that go sooner than a token were placed before it."""
        setting = plays.setting
        sooner, unranked = self._sooner(setting)
        stored = [mask & setting.movable for mask in sooner]
        table = np.vstack([as_table(setting, mask, nobody=False) for mask in (*stored, 0)])
        wanted = table.sum(axis=1)
        right = ~as_table(setting, unranked, nobody=False)[plays.time].any(axis=1)
        for t in range(setting.length):
            now = plays.time[:, t]
            before = table[now[:, None], plays.time[:, :t]].sum(axis=1)
            right &= before == wanted[now]
        return np.asarray(right)
