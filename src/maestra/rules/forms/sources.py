"""Where the tokens come from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from maestra.rules.forms.base import EachSlot
from maestra.rules.forms.selection import EveryToken
from maestra.rules.setting import ORIGIN_ROW, Line, Mask, Setting
from maestra.rules.token_tests import has


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
        columns = [
            given | setting.mask(lambda k, c=c: cells[k].column == c + 1)
            for c in range(setting.length)
        ]
        return tuple(columns[::-1] if self.mirrored else columns)
