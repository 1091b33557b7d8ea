"""When tokens are placed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum
from itertools import combinations
from typing import Literal, assert_never

import numpy as np

from maestra.rules.fields import Flag
from maestra.rules.forms.base import Form, Link, Pairwise
from maestra.rules.forms.ranks import NO_LIMIT
from maestra.rules.plays import NOBODY, Plays, Truth, as_table
from maestra.rules.setting import Index, Line, Mask, Play, Setting
from maestra.rules.token_tests import Anything, TokenTest, passing


class Filling(Enum):
    """Which free goal cell is next."""

    LEFT_TO_RIGHT = "left-to-right"
    RIGHT_TO_LEFT = "right-to-left"
    ENDS_FIRST = "ends-first"
    MIDDLE_FIRST = "middle-first"


@dataclass(frozen=True, slots=True)
class FillOrder(Form):
    """Each token goes onto the next free goal cell.

    From the left, from the right, from the ends inwards or from the middle outwards. Of two
    cells as far from the middle either is next.
    """

    filling: Filling
    form: Literal["fill-order"] = field(default="fill-order", kw_only=True, repr=False)

    def keys(self, length: int) -> tuple[int, ...]:
        """A number for each goal cell; the free cell with the least is next."""
        match self.filling:
            case Filling.LEFT_TO_RIGHT:
                return tuple(range(length))
            case Filling.RIGHT_TO_LEFT:
                return tuple(range(0, -length, -1))
            case Filling.ENDS_FIRST:
                return tuple(min(k, length - 1 - k) for k in range(length))
            case Filling.MIDDLE_FIRST:
                return tuple(-min(k, length - 1 - k) for k in range(length))
            case _:
                assert_never(self.filling)

    def next_cells(self, play: Play) -> tuple[Index, ...]:
        """The goal cells that may be filled now."""
        keys, free = self.keys(play.setting.length), play.free
        least = min((keys[cell] for cell in free), default=0)
        return tuple(cell for cell in free if keys[cell] == least)

    def holds(self, play: Play) -> bool:
        """No token went onto a cell while a better one was free."""
        keys = self.keys(play.setting.length)
        free = {k for k, token in enumerate(play.setting.given) if token is None}
        for _, cell in play.placed:
            if keys[cell] > min(keys[k] for k in free):
                return False
            free.remove(cell)
        return True

    def possible(self, play: Play) -> bool:
        """What was too early stays so."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no wrong cell is left to be chosen."""
        return self.holds(play) and (not play.room or len(self.next_cells(play)) == len(play.free))

    def mask(self, plays: Plays) -> Truth:
        """As `holds`: the keys of the cells never fall, and none still free at the end is less."""
        length = plays.setting.length
        keys = np.array([*self.keys(length), 0])
        filled = plays.cells != NOBODY
        in_time = np.where(filled, keys[plays.cells], length)
        rising = (np.diff(in_time, axis=1) >= 0).all(axis=1)
        last = np.where(filled, in_time, -length).max(axis=1)
        spare = np.where(plays.row == NOBODY, keys[:-1], length).min(axis=1)
        right: Truth = rising & (spare >= last)
        return right


@dataclass(frozen=True, slots=True)
class Before(Pairwise):
    """No token that passes `second` comes before one that passes `first`.

    All reds before any blue; the kettle before the cup; along the row: all reds left of all blues.
    """

    first: TokenTest
    second: TokenTest
    line: Line = Line.TIME
    form: Literal["before"] = field(default="before", kw_only=True, repr=False)

    def along(self) -> Line:
        """The line of the rule."""
        return self.line

    def links(self, setting: Setting) -> Iterator[Link]:
        """Every pair."""
        first, second = passing(setting, self.first), passing(setting, self.second)
        every = passing(setting, Anything())
        later = every & ~first
        masks = tuple(
            later if second >> token & 1 else every for token in range(len(setting.deck.tokens))
        )
        for i, j in combinations(range(setting.length), 2):
            yield i, j, masks


@dataclass(frozen=True, slots=True)
class Follows(Form):
    """After each token that passes `test` comes one that passes `follower`.

    Immediately: the next one placed, or on the row the next cell's. Otherwise: any later one.
    """

    test: TokenTest
    follower: TokenTest
    immediately: Flag = True
    line: Line = Line.TIME
    form: Literal["follows"] = field(default="follows", kw_only=True, repr=False)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        return not self._waiting(play)

    def _masks(self, setting: Setting) -> tuple[Mask, Mask]:
        return passing(setting, self.test), passing(setting, self.follower)

    def _waiting(self, play: Play) -> list[Index]:
        """The slots with a token that nothing follows yet."""
        test, follower = self._masks(play.setting)
        slots = play.slots(self.line)
        return [
            k
            for k, token in enumerate(slots)
            if token is not None and test >> token & 1 and not self._followed(slots, k, follower)
        ]

    def _followed(self, slots: tuple[Index | None, ...], k: Index, follower: Mask) -> bool:
        later = slots[k + 1 : k + 2] if self.immediately else slots[k + 1 :]
        return any(token is not None and follower >> token & 1 for token in later)

    def possible(self, play: Play) -> bool:
        """Whether what is left can follow all that waits, and wait for nothing itself."""
        waiting = self._waiting(play)
        if not waiting:
            return True
        test, follower = self._masks(play.setting)
        enough = play.left & follower & ~test
        slots = play.slots(self.line)
        if not self.immediately:
            # One that waits for nothing serves all before it; farthest to the right is best.
            return bool(enough) and None in slots[max(waiting) + 1 :]
        if self.line is Line.TIME:
            return waiting == [len(play.placed) - 1] and bool(enough) and play.room > 0
        runs = [self._run(slots, k, follower) for k in waiting]
        if 0 in runs:
            return False
        # A waiting token takes one that waits for nothing, or as many that wait themselves as
        # fill the gap up to a follower that lies there already: save the first for wide gaps.
        spared = sorted(runs, reverse=True)[enough.bit_count() :]
        return sum(spared) <= (play.left & follower & test).bit_count()

    def _run(self, slots: tuple[Index | None, ...], k: Index, follower: Mask) -> int:
        """Free cells from after k up to a follower; as good as endless where none ends them."""
        width = 0
        for token in slots[k + 1 :]:
            if token is not None:
                ends = bool(follower >> token & 1)
                return width if ends or not width else NO_LIMIT
            width += 1
        return NO_LIMIT if width else 0

    def certain(self, play: Play) -> bool:
        """Whether nothing waits, and no token can come that would."""
        test, follower = self._masks(play.setting)
        if self._waiting(play):
            return False
        if not play.room or not play.left & test:
            return True
        slots = play.slots(self.line)
        free = [k for k, token in enumerate(slots) if token is None]
        return all(self._followed(slots, k, follower) for k in free)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        tokens = plays.line(self.line)
        test, follower = (
            as_table(plays.setting, one, nobody=False)[tokens]
            for one in self._masks(plays.setting)
        )
        if self.immediately:
            following = np.roll(follower, -1, axis=1)
        else:
            backwards = np.logical_or.accumulate(follower[:, ::-1], axis=1)
            following = np.roll(backwards[:, ::-1], -1, axis=1)
        following[:, -1] = False
        return np.asarray((~test | following).all(axis=1))
