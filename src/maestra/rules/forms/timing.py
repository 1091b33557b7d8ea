"""When tokens are placed."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Literal, assert_never

import numpy as np

from maestra.rules.forms.base import Form
from maestra.rules.plays import NOBODY, Plays, Truth
from maestra.rules.setting import Index, Play


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
        keys = np.array([*self.keys(plays.setting.length), 0])
        filled = plays.cells != NOBODY
        # After the last placement every free cell's key must be at least the last one's.
        in_time = np.where(filled, keys[plays.cells], np.iinfo(np.int64).max)
        rising = (np.diff(in_time, axis=1) >= 0).all(axis=1)
        last = np.where(filled, keys[plays.cells], np.iinfo(np.int64).min).max(axis=1)
        spare = np.where(plays.row == NOBODY, keys[:-1], np.iinfo(np.int64).max).min(axis=1)
        right: Truth = rising & (spare >= last)
        return right
