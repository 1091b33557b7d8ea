"""What all forms have in common, and the two kinds most of them are.

A form says which finished plays are right: `holds`. A play may end at any moment as far as one
form alone can tell, and goes on by placing any token that is left onto any free goal cell. On
that rests what a form says of a play that is not finished: `possible`, some way to go on (ending
at once is one) makes it hold; `certain`, every way does. Both are exact.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator
from enum import Enum
from typing import TypeAlias

import numpy as np

from maestra.core.faults import Fault, InvalidError
from maestra.rules.fields import Position, Strict
from maestra.rules.pairs import Related, converse
from maestra.rules.plays import Plays, Truth, as_matrix, as_table
from maestra.rules.setting import Index, Line, Mask, Play, Setting, bits

__all__ = [
    "FIRST",
    "LAST",
    "MIDDLE",
    "Direction",
    "EachSlot",
    "Form",
    "Link",
    "Pairwise",
    "Position",
    "can_clash",
    "demand",
    "place_of",
]

FIRST, MIDDLE, LAST = Position(1), Position(0), Position(-1)


class Direction(Enum):
    """Which way an order goes."""

    RISING = "rising"
    FALLING = "falling"


def place_of(position: Position, length: int) -> Index | None:
    """The index of `position` on a line of `length`; None if it has none, as the middle of 4."""
    if position == MIDDLE:
        return length // 2 if length % 2 else None
    index = position - 1 if position > 0 else length + position
    return index if 0 <= index < length else None


class Form(Strict):
    """One rule: which finished plays are right, and what can still become of the others.

    No `ABC`, whose `isinstance` makes each `match` over the forms several times slower; mypy
    refuses to build a form that lacks a method all the same.
    """

    __slots__ = ()

    @abstractmethod
    def holds(self, play: Play) -> bool:
        """Whether `play` is right if it ends here."""

    @abstractmethod
    def possible(self, play: Play) -> bool:
        """Whether some way to go on, ending here included, makes it right."""

    def possible_with(self, play: Play, more: int) -> bool:  # noqa: ARG002 - some forms use it
        """Whether `more` moves or more may make it hold; never wrongly no, perhaps wrongly yes."""
        return self.possible(play)

    @abstractmethod
    def certain(self, play: Play) -> bool:
        """Whether every way to go on, ending here included, makes it right."""

    @abstractmethod
    def mask(self, plays: Plays) -> Truth:
        """Which of many finished plays are right; the same as `holds` for each."""


class EachSlot(Form):
    """Says for each slot of a line which tokens may be there, and of empty slots nothing."""

    __slots__ = ()

    def along(self) -> Line:
        """The line it looks at; the row, unless a form says otherwise."""
        return Line.ROW

    @abstractmethod
    def allowed(self, setting: Setting) -> tuple[Mask, ...]:
        """For each slot the tokens that may be there; as many slots as there are goal cells."""

    def holds(self, play: Play) -> bool:
        """As the class says."""
        masks = self.allowed(play.setting)
        slots = play.slots(self.along())
        return all(t is None or mask >> t & 1 for t, mask in zip(slots, masks, strict=False))

    def possible(self, play: Play) -> bool:
        """What lies wrong stays wrong, and ending adds nothing wrong."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no token that is left is wrong in a slot it can come to."""
        if not self.holds(play):
            return False
        slots = zip(play.slots(self.along()), self.allowed(play.setting), strict=False)
        return not play.room or all(t is not None or not play.left & ~mask for t, mask in slots)

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        setting = plays.setting
        table = np.vstack([as_table(setting, m, nobody=True) for m in self.allowed(setting)])
        return np.asarray(table[np.arange(setting.length), plays.line(self.along())].all(axis=1))


Link: TypeAlias = tuple[Index, Index, Related]
"""Two slots of a line, and which tokens may be in the first and the second."""


class Pairwise(Form):
    """Says for pairs of slots which tokens may be there together.

    Of a pair that is not filled it says nothing.
    """

    __slots__ = ()

    def along(self) -> Line:
        """The line it looks at; the row, unless a form says otherwise."""
        return Line.ROW

    @abstractmethod
    def links(self, setting: Setting) -> Iterator[Link]:
        """The pairs, the earlier slot first; as many slots as there are goal cells."""

    def holds(self, play: Play) -> bool:
        """As the class says."""
        slots = play.slots(self.along())
        return all(
            one is None or two is None or masks[one] >> two & 1
            for i, j, masks in self.links(play.setting)
            if j < len(slots)
            for one, two in ((slots[i], slots[j]),)
        )

    def possible(self, play: Play) -> bool:
        """What lies wrong stays wrong, and ending adds nothing wrong."""
        return self.holds(play)

    def certain(self, play: Play) -> bool:
        """Whether no tokens that are left can come to be a wrong pair."""
        if not self.holds(play):
            return False
        slots = play.slots(self.along())
        return not play.room or not any(
            can_clash(play, slots[i], slots[j], masks)
            for i, j, masks in self.links(play.setting)
            if j < len(slots)
        )

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        right = np.ones(len(plays), np.bool_)
        tokens = plays.line(self.along())
        for i, j, masks in self.links(plays.setting):
            right &= as_matrix(plays.setting, masks)[tokens[:, i], tokens[:, j]]
        return right


def can_clash(play: Play, one: Index | None, two: Index | None, masks: Related) -> bool:
    """Whether the slots that hold `one` and `two` can come to hold a wrong pair."""
    if one is not None and two is not None:
        return False
    if one is not None:
        return bool(play.left & ~masks[one])
    if two is not None:
        return bool(play.left & ~converse(play.setting, masks)[two])
    return play.room > 1 and any(play.left & ~masks[a] & ~(1 << a) for a in bits(play.left))


def demand(right: bool, where: str, found: object, expected: str) -> None:  # noqa: FBT001 - reads as an assertion
    """Refuse a rule with a parameter that makes no sense.

    Raises:
        InvalidError: `right` is false.
    """
    if not right:
        raise InvalidError([Fault(where, str(found), expected)])
