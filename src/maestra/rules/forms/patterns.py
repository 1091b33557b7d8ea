"""Patterns along the row or in time."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from maestra.rules.forms.base import EachSlot, demand
from maestra.rules.setting import Line, Mask, Setting
from maestra.rules.token_tests import Anything, TokenTest, has, passing


@dataclass(frozen=True, slots=True)
class Pattern(EachSlot):
    """The k-th token of the line passes the k-th test; with `repeat` from the start again.

    Without it, what comes after the last test is free. The given row every time ("spell
    CURIE"); red, blue, red, blue; rows in turn.
    """

    tests: tuple[TokenTest, ...]
    repeat: bool = False
    line: Line = Line.ROW
    form: Literal["pattern"] = field(default="pattern", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse a pattern of nothing."""
        demand(bool(self.tests), "tests", "none", "at least one")

    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """The tokens that pass each slot's test."""
        masks = [passing(setting, test) for test in self.tests]
        free = passing(setting, Anything())
        return tuple(
            masks[k % len(masks)] if self.repeat or k < len(masks) else free
            for k in range(setting.length)
        )


def given_row(attribute: str, values: tuple[object, ...]) -> Pattern:
    """Each goal cell holds its value: ``given_row("letter", tuple("CURIE"))``."""
    return Pattern(tuple(has(f"is-{value}", attribute) for value in values))
