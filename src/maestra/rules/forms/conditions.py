"""What is asked of one place, and conditions: if this, then that."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Literal, TypeAlias

import numpy as np
from pydantic import Field

from maestra.rules.fields import Place
from maestra.rules.forms.base import LAST, Form, demand, place_of
from maestra.rules.forms.counting import Count
from maestra.rules.plays import NOBODY, Plays, Truth, as_table
from maestra.rules.setting import Index, Line, Mask, Play, Setting, bits
from maestra.rules.token_tests import TokenTest, passing


@dataclass(frozen=True, slots=True)
class At(Form):
    """There is a token at `position` of the line and it passes `test`.

    In time: the first, the second..., or the last one placed.
    """

    position: Place
    test: TokenTest
    line: Line = Line.ROW
    form: Literal["at"] = field(default="at", kw_only=True, repr=False)

    def __post_init__(self) -> None:
        """Refuse a place in time that is counted from an end nobody knows."""
        known = self.line is Line.ROW or self.position > 0 or self.position == LAST
        demand(known, "position", self.position, "1, 2, ... or -1 in time")

    def token(self, play: Play) -> Index | None:
        """The token there if the play ends here."""
        if self.line is Line.ROW:
            place = place_of(self.position, play.setting.length)
            return None if place is None else play.row[place]
        place = place_of(self.position, len(play.placed))
        return None if place is None else play.placed[place][0]

    def holds(self, play: Play) -> bool:
        """As the class says."""
        token = self.token(play)
        return token is not None and bool(self._right(play) >> token & 1)

    def possible(self, play: Play) -> bool:
        """It is so, or a token that passes is left and can come there."""
        if self.holds(play):
            return True
        return self._is_open(play) and bool(play.left & self._right(play))

    def certain(self, play: Play) -> bool:
        """It is so, and nothing else can become the last."""
        return self.holds(play) and (not self._is_open(play) or not play.left & ~self._right(play))

    def _right(self, play: Play) -> Mask:
        return passing(play.setting, self.test)

    def _is_open(self, play: Play) -> bool:
        """Whether another token can still come there."""
        if self.line is Line.ROW:
            place = place_of(self.position, play.setting.length)
            return place is not None and play.row[place] is None and play.room > 0
        if self.position == LAST:
            return play.room > 0
        return len(play.placed) < self.position <= len(play.placed) + play.room

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        setting = plays.setting
        tokens = plays.line(self.line)
        table = as_table(setting, passing(setting, self.test), nobody=False)
        if self.line is Line.TIME and self.position == LAST:
            ends = np.maximum((tokens != NOBODY).sum(axis=1) - 1, 0)
            return np.asarray(table[tokens[np.arange(len(plays)), ends]])
        place = place_of(self.position, setting.length)
        if place is None:
            return np.zeros(len(plays), np.bool_)
        return np.asarray(table[tokens[:, place]])


Condition: TypeAlias = Annotated[At | Count, Field(discriminator="form")]


@dataclass(frozen=True, slots=True)
class IfThen(Form):
    """If `condition` is so in the finished row, `consequence` is so too."""

    condition: Condition
    consequence: Condition
    form: Literal["if-then"] = field(default="if-then", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        return not self.condition.holds(play) or self.consequence.holds(play)

    def possible(self, play: Play) -> bool:
        """Whether the condition can fail or the consequence can hold."""
        return not self.condition.certain(play) or self.consequence.possible(play)

    def certain(self, play: Play) -> bool:
        """Whether the condition cannot come to hold without the consequence.

        A search over plays that differ in what the two look at, at most: what the special
        places hold, how many tokens are left of each of the four kinds, what came last.
        """
        seen: set[object] = set()
        todo = [play]
        while todo:
            now = todo.pop()
            if not self.condition.possible(now) or self.consequence.certain(now):
                continue
            if not self.holds(now):
                return False
            if (key := self._key(now)) not in seen:
                seen.add(key)
                todo.extend(self._continued(now))
        return True

    def _kind(self, setting: Setting, token: Index | None) -> tuple[int, ...]:
        """What the two tests say of a token."""
        tests = (self.condition.test, self.consequence.test)
        if token is None:
            return ()
        return tuple(passing(setting, test) >> token & 1 for test in tests)

    def _special(self, length: int) -> set[Index | None]:
        """The cells of the row that one of the two looks at."""
        both = (self.condition, self.consequence)
        places = [one.position for one in both if isinstance(one, At) and one.line is Line.ROW]
        return {place_of(place, length) for place in places}

    def _key(self, play: Play) -> object:
        setting = play.setting
        special = [cell for cell in self._special(setting.length) if cell is not None]
        times = [self._kind(setting, token) for token, _ in play.placed]
        timed = any(
            isinstance(one, At) and one.line is Line.TIME
            for one in (self.condition, self.consequence)
        )
        return (
            tuple(self._kind(setting, play.row[cell]) for cell in sorted(special)),
            tuple(sorted(self._kind(setting, token) for token in bits(play.left))),
            tuple(times) if timed else len(times),
        )

    def _continued(self, play: Play) -> list[Play]:
        """Longer plays by one token of each kind, onto each special cell and one other."""
        special = self._special(play.setting.length)
        cells = [cell for cell in play.free if cell in special]
        cells += [cell for cell in play.free if cell not in special][:1]
        kinds = {self._kind(play.setting, token): token for token in bits(play.left)}
        return [play.after(token, cell) for token in kinds.values() for cell in cells]

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        return ~self.condition.mask(plays) | self.consequence.mask(plays)
