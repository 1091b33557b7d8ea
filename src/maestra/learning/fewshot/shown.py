"""What was shown, as the generators of proposals look at it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cached_property
from itertools import permutations
from typing import Final

from maestra.core.tokens import Scale, Value
from maestra.learning.fewshot.token_tests import naming, scales_of, simple
from maestra.rules.fields import Number
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Play, Rank, Setting
from maestra.rules.token_tests import TokenTest, has, passing

MAX_KINDS: Final = 6
"""Values an attribute may have for its pairs of values to be looked at."""
ORIGINS: Final = (ORIGIN_ROW, ORIGIN_COLUMN)


@dataclass(frozen=True)
class Shown:
    """What was shown, as the generators look at it."""

    plays: tuple[Play, ...]
    timed: bool
    """Whether rules about the order in time are worth a thought."""

    @property
    def setting(self) -> Setting:
        """That of the first play; the others' decks show the same attributes."""
        return self.plays[0].setting

    @property
    def full(self) -> bool:
        """Whether every goal cell was filled each time."""
        return all(not play.free for play in self.plays)

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The lines to look along."""
        return (Line.ROW, Line.TIME) if self.timed else (Line.ROW,)

    @cached_property
    def scales(self) -> dict[str, Scale]:
        """Every attribute with its scale."""
        return scales_of(self.setting)

    @cached_property
    def ordinal(self) -> tuple[str, ...]:
        """The attributes of the tokens that have an order and differ."""
        scales = self.setting.deck.scales
        return tuple(
            name
            for name, scale in scales.items()
            if scale is not Scale.NOMINAL and len(set(self.setting.values(name))) > 1
        )

    @cached_property
    def numeric(self) -> tuple[str, ...]:
        """The attributes of the tokens that are numbers."""
        return tuple(name for name in self.ordinal if self.scales[name] is Scale.NUMBER)

    def has_ties(self, attribute: str) -> bool:
        """Whether two tokens in storage show the same."""
        values = self.setting.values(attribute)
        stored = [
            v for k, v in enumerate(values) if v is not None and self.setting.movable >> k & 1
        ]
        return len(set(stored)) < len(stored)

    @cached_property
    def kinds_and_features(self) -> list[TokenTest]:
        """Simple tests of what tokens show that some token in storage passes and another not."""
        setting = self.setting
        everything = setting.movable
        seen: set[int] = set()
        kept: list[TokenTest] = []
        for test in simple(setting):
            mask = passing(setting, test) & everything
            if mask not in (0, everything) and mask not in seen:
                seen.add(mask)
                kept.append(test)
        return kept

    @cached_property
    def kinds(self) -> dict[str, list[TokenTest]]:
        """For each attribute with few shared values, the tests that name them."""
        named = {name: naming(self.setting, name) for name in self.setting.deck.scales}
        return {name: tests for name, tests in named.items() if 1 < len(tests) <= MAX_KINDS}

    @cached_property
    def named_attributes(self) -> tuple[str, ...]:
        """The attributes with few shared values: colour, category."""
        return tuple(self.kinds)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The attributes without an order that no two tokens share: names."""
        return tuple(
            name
            for name, scale in self.setting.deck.scales.items()
            if scale is Scale.NOMINAL and not self.has_ties(name)
        )

    @cached_property
    def unique(self) -> tuple[str, ...]:
        """The attributes that no two tokens share."""
        scales = self.setting.deck.scales
        return tuple(name for name in scales if not self.has_ties(name))

    @cached_property
    def origins(self) -> dict[str, list[TokenTest]]:
        """The storage rows and columns that tokens lie in, as tests."""
        return {name: naming(self.setting, name) for name in ORIGINS}

    @cached_property
    def contrasts(self) -> list[tuple[TokenTest, TokenTest]]:
        """Two tests of one attribute that no token passes both: red and blue, odd and even."""
        found: list[tuple[TokenTest, TokenTest]] = []
        for tests in self.kinds.values():
            found += permutations(tests, 2)
        for scale, one, two in (
            (Scale.NUMBER, "odd", "even"),
            (Scale.LETTER, "vowel", "consonant"),
        ):
            for attribute, its in self.setting.deck.scales.items():
                if its is scale:
                    found.append((has(one, attribute), has(two, attribute)))
                    found.append((has(two, attribute), has(one, attribute)))
        return found

    def amounts(self, attribute: str, of: Callable[[Rank, Rank], Rank | None]) -> list[Number]:
        """What `of` gives for the first pairs of neighbours of the plays; without repetition."""
        found: dict[Number, None] = {}
        for play in self.plays:
            ranks = play.setting.ranks(attribute)
            ranked = [rank for t in play.tokens[:2] if (rank := ranks[t]) is not None]
            amount = of(ranked[0], ranked[1]) if len(ranked) > 1 else None
            if amount is not None and (number := as_number(amount)) is not None:
                found[number] = None
        return list(found)

    def steps(self, attribute: str) -> list[Number]:
        """The first steps of the plays; round a cycle the shorter way."""
        steps = self.amounts(attribute, difference)
        if self.scales[attribute] is not Scale.CYCLE:
            return steps
        around = len(self.setting.deck.cycles[attribute])
        return list(dict.fromkeys((int(n) + around // 2) % around - around // 2 for n in steps))

    def span(self, attribute: str) -> float:
        """How far apart the least and the greatest are."""
        ranks = [rank for rank in self.setting.ranks(attribute) if rank is not None]
        return float(max(ranks) - min(ranks)) + 1

    def sum_of(self, play: Play, attribute: str) -> Fraction | None:
        """What the row adds up to; None if a token has no number."""
        ranks = [play.setting.ranks(attribute)[token] for token in play.tokens]
        if None in ranks:
            return None
        return sum((Fraction(rank) for rank in ranks if rank is not None), Fraction(0))

    def rows_of(self, attribute: str) -> list[tuple[Value, ...]]:
        """What the full rows of the plays show; without repetition."""
        found: dict[tuple[Value, ...], None] = {}
        for play in self.plays:
            values = play.setting.values(attribute)
            row = [values[token] for token in play.row if token is not None]
            whole = tuple(value for value in row if value is not None)
            if len(whole) == play.setting.length:
                found[whole] = None
        return list(found)

    def templates_of(self, attribute: str, line: Line) -> list[str]:
        """The patterns of equal and different values of the plays that leave no gap."""
        found: dict[str, None] = {}
        for play in self.plays:
            values = play.setting.values(attribute)
            shown = [None if t is None else values[t] for t in play.slots(line)]
            letters: dict[Value | None, str] = {}
            for value in shown:
                letters.setdefault(value, chr(ord("A") + len(letters)))
            if 1 < len(letters) < len(shown) and None not in letters:
                found["".join(letters[value] for value in shown)] = None
        return list(found)


def as_number(rank: Rank) -> Number | None:
    """A number that can be written; None for a third."""
    fraction = Fraction(rank)
    if fraction.denominator == 1:
        return int(fraction)
    written = Decimal(fraction.numerator) / Decimal(fraction.denominator)
    return written if Fraction(written) == fraction else None


def quotient(one: Rank, two: Rank) -> Rank | None:
    """How many times the first the second is."""
    return Fraction(two) / one if one else None


def difference(one: Rank, two: Rank) -> Rank:
    """How much more the second is."""
    return Fraction(two) - one


def distance(one: Rank, two: Rank) -> Rank:
    """How far apart they are."""
    return abs(Fraction(two) - one)


def total(one: Rank, two: Rank) -> Rank:
    """What they add up to."""
    return Fraction(one) + two
