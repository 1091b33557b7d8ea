"""What the start of this very play fixes: a model row, a cue."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Literal, assert_never

from maestra.rules.fields import Side
from maestra.rules.forms.base import EachSlot
from maestra.rules.pairs import Relation, related
from maestra.rules.setting import ORIGIN_ROW, Index, Mask, Setting, bits
from maestra.rules.token_tests import Anything, has, passing


class Reading(Enum):
    """How a model row is read."""

    COPIED = "copied"
    """Each goal cell goes by the model's cell in its column."""
    MIRRORED = "mirrored"
    """Each goal cell goes by the model's cell in the column as far from the other side."""
    REVERSED = "reversed"
    """The model's tokens from right to left, gaps left out, from the first goal cell on."""


@dataclass(frozen=True, slots=True)
class ModelRow(EachSlot):
    """The tokens of storage row `row` stay, and each token stands in `relation` to its model.

    Storage rows are counted from 1, the goal row passed over. `same("colour")` copies colours;
    other relations make a row of partners or successors. The model's token is the first of the
    pair. Where the model has no token, any may come.
    """

    row: Side
    reading: Reading
    relation: Relation
    form: Literal["model-row"] = field(default="model-row", kw_only=True, repr=False)

    def models(self, setting: Setting) -> tuple[Index | None, ...]:
        """The model's token for each goal cell."""
        stays = passing(setting, has(f"is-{self.row}", ORIGIN_ROW)) & setting.movable
        cells = [setting.start.cells[token.id] for token in setting.deck.tokens]
        by_column = {cells[token].column - 1: token for token in bits(stays)}
        length = setting.length
        match self.reading:
            case Reading.COPIED:
                return tuple(by_column.get(k) for k in range(length))
            case Reading.MIRRORED:
                return tuple(by_column.get(length - 1 - k) for k in range(length))
            case Reading.REVERSED:
                tokens = [by_column[k] for k in sorted(by_column, reverse=True)]
                return (*tokens, *((None,) * (length - len(tokens))))
            case _:
                assert_never(self.reading)

    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """The tokens that go with each model."""
        return setting.remember(self, lambda: self._allowed(setting))

    def _allowed(self, setting: Setting) -> tuple[Mask, ...]:
        models = self.models(setting)
        masks = related(setting, self.relation)
        others = passing(setting, Anything())
        for token in models:
            others &= ~(0 if token is None else 1 << token)
        return tuple(others if token is None else others & masks[token] for token in models)


@dataclass(frozen=True, slots=True)
class Cue(EachSlot):
    """One token stays in storage, and every token of the row stands in `relation` to it.

    It is the one that lies on storage row `row` and `column` at the start; if none lies there,
    the rule asks nothing. The cue is the first of the pair: a cue "fruit" and
    ``Compare("name", EQUAL, other="category")``.
    """

    row: Side
    column: Side
    relation: Relation
    form: Literal["cue"] = field(default="cue", kw_only=True, repr=False)

    def cue(self, setting: Setting) -> Index | None:
        """The token that stays."""
        row = passing(setting, has(f"is-{self.row}", ORIGIN_ROW)) & setting.movable
        cells = [setting.start.cells[token.id] for token in setting.deck.tokens]
        return next((token for token in bits(row) if cells[token].column == self.column), None)

    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """The tokens that go with the cue."""
        cue = self.cue(setting)
        right = passing(setting, Anything())
        if cue is not None:
            right = related(setting, self.relation)[cue] & ~(1 << cue)
        return (right,) * setting.length
