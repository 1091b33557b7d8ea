"""Patterns along the row or in time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from maestra.core.tokens import Value
from maestra.rules.fields import MAX_LISTED, Flag, Letters, Name
from maestra.rules.forms.base import EachSlot, Form, Link, Pairwise, demand
from maestra.rules.forms.ranks import PAIR
from maestra.rules.forms.values import all_valued, value_numbers
from maestra.rules.pairs import different, related, same
from maestra.rules.plays import NOBODY, Plays, Truth, close_ranks
from maestra.rules.setting import Index, Line, Mask, Play, Setting, bits
from maestra.rules.token_tests import Anything, TokenTest, has, passing


@dataclass(frozen=True, slots=True)
class Pattern(EachSlot):
    """The k-th token of the line passes the k-th test; with `repeat` from the start again.

    Without it, what comes after the last test is free. The given row every time ("spell
    CURIE"); red, blue, red, blue; rows in turn.
    """

    tests: Annotated[tuple[TokenTest, ...], Field(max_length=MAX_LISTED)]
    repeat: Flag = False
    line: Line = Line.ROW
    form: Literal["pattern"] = field(default="pattern", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse a pattern of nothing."""
        demand(bool(self.tests), "tests", "none", "at least one")

    def along(self) -> Line:
        """The line of the rule."""
        return self.line

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


@dataclass(frozen=True, slots=True)
class Template(Pairwise):
    """Places with the same letter show the same, places with different letters do not.

    Which values they are is free. AABBA; with `repeat` AB alternates along any row. Without it,
    what comes after the last letter is free.
    """

    attribute: Name
    letters: Letters
    repeat: Flag = False
    line: Line = Line.ROW
    form: Literal["template"] = field(default="template", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse a template of nothing."""
        demand(bool(self.letters), "letters", "none", "at least one")

    def along(self) -> Line:
        """The line of the rule."""
        return self.line

    def links(self, setting: Setting) -> Iterator[Link]:
        """Every pair of places that have a letter."""
        letters = self.letters
        reach = setting.length if self.repeat else min(setting.length, len(letters))
        alike = related(setting, same(self.attribute))
        unlike = related(setting, different(self.attribute))
        for i, j in combinations(range(reach), 2):
            match = letters[i % len(letters)] == letters[j % len(letters)]
            yield i, j, alike if match else unlike


@dataclass(frozen=True, slots=True)
class Blocks(Form):
    """Tokens that show the same lie together, with no other token between; gaps do not matter.

    Every token has the attribute.
    """

    attribute: Name
    line: Line = Line.ROW
    form: Literal["blocks"] = field(default="blocks", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """No token lies between two that are alike and differ from it."""
        known = play.setting.values(self.attribute)
        values = [known[token] for token in play.slots(self.line) if token is not None]
        return None not in values and not any(
            one == three != two for one, two, three in combinations(values, 3)
        )

    def possible(self, play: Play) -> bool:
        """A part of such a line is such a line."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no token that is left can come between two alike, or be like one further on."""
        if not self.holds(play):
            return False
        known = play.setting.values(self.attribute)
        left = Counter(known[token] for token in bits(play.left))
        if not play.room:
            return True
        if None in left:
            return False
        slots = [None if token is None else known[token] for token in play.slots(self.line)]
        return not any(
            _can_split(slots, i, k, left, play.room)
            for i, k in combinations(range(len(slots)), 2)
            if k > i + 1
        )

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: there are as many blocks as values."""
        tokens = plays.line(self.line)
        if self.line is Line.ROW:
            tokens = close_ranks(tokens)
        numbers = value_numbers(plays.setting, self.attribute)
        values = np.where(tokens == NOBODY, NOBODY, numbers[tokens])
        changes = (np.diff(values, axis=1) != 0) & (tokens[:, 1:] != NOBODY)
        kinds = sum((values == k).any(axis=1) for k in range(numbers.max(initial=-1) + 1))
        has_value = all_valued(plays, self.line, self.attribute)
        some = tokens[:, 0] != NOBODY
        right: Truth = (changes.sum(axis=1) + some == kinds) & has_value
        return right


def _can_split(
    slots: list[Value | None], i: Index, k: Index, left: Counter[Value | None], room: int
) -> bool:
    """Whether slots i and k can come to be alike and one between them different."""
    fixed = {value for value in (slots[i], slots[k]) if value is not None}
    new = (slots[i], slots[k]).count(None)
    candidates = fixed or left.keys()
    between = slots[i + 1 : k]
    for value in candidates if len(fixed) < PAIR else ():
        if left[value] < new or new > room:
            continue
        other = any(v is not None and v != value for v in between)
        others_left = left.total() > left[value]
        if other or (None in between and others_left and new < room):
            return True
    return False
