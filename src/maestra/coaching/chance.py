"""Chance without a source of randomness: numbers that follow from a seed, SplitMix64.

Every draw is a pure function of the state before it, so that a recorded session replays. The
generator adds a constant to its state and mixes the sum, as `core.mixing` says; the tests check
the first numbers of the reference named there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

from maestra.core.mixing import GOLDEN, MASK, mixed

_T = TypeVar("_T")


@dataclass(frozen=True, slots=True)
class Chance:
    """A place in the stream of numbers that a seed gives."""

    state: int
    """0 to 2^64 - 1; the seed at first."""

    def word(self) -> tuple[int, Chance]:
        """A number from 0 to 2^64 - 1, and the place after it."""
        state = (self.state + GOLDEN) & MASK
        return mixed(state), Chance(state)

    def below(self, count: int) -> tuple[int, Chance]:
        """A number from 0 to `count` - 1, each as likely (to one part in 2^64 / count)."""
        word, after = self.word()
        return word * count >> 64, after

    def share(self) -> tuple[float, Chance]:
        """A number from 0 up to, but not, 1."""
        word, after = self.word()
        return (word >> 11) / 2**53, after

    def pick(self, things: Sequence[_T]) -> tuple[_T, Chance]:
        """One of `things`, of which there is at least one."""
        index, after = self.below(len(things))
        return things[index], after

    def shuffled(self, things: Sequence[_T]) -> tuple[tuple[_T, ...], Chance]:
        """`things` in any order, each as likely (Fisher and Yates)."""
        order, chance = list(things), self
        for last in range(len(order) - 1, 0, -1):
            other, chance = chance.below(last + 1)
            order[last], order[other] = order[other], order[last]
        return tuple(order), chance

    def split(self, number: int) -> Chance:
        """A stream of its own for each `number`, none of which the draws from here touch."""
        word, _ = Chance((self.state ^ (number * 0xD1342543DE82EF95 + 1)) & MASK).word()
        return Chance(word)


def shares(chance: Chance) -> Iterator[float]:
    """Shares for ever; for whoever keeps no place, such as an experiment."""
    while True:
        share, chance = chance.share()
        yield share
