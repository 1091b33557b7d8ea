"""What could be asked of a token: every test that the attributes and values of a deck suggest."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from itertools import pairwise
from typing import Final

from maestra.core.tokens import Scale, Value
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Rank, Setting
from maestra.rules.token_tests import (
    Among,
    Compared,
    Comparison,
    Extreme,
    TokenTest,
    has,
)

NUMBER_FEATURES: Final = ("odd", "even", "prime", "multiple-of-3", "multiple-of-5")
DIGITS: Final = ("digits-1", "digits-2", "digits-3")


def scales_of(setting: Setting) -> dict[str, Scale]:
    """Each attribute that tokens show, and where they came from, with its scale."""
    return {**setting.deck.scales, ORIGIN_ROW: Scale.NUMBER, ORIGIN_COLUMN: Scale.NUMBER}


def values_of(setting: Setting, attribute: str) -> list[Value]:
    """The different values that the tokens in storage show, in order."""
    shown = setting.values(attribute)
    values = {v for k, v in enumerate(shown) if v is not None and setting.movable >> k & 1}
    ranks = {value: setting.rank(attribute, value) for value in values}
    if None in ranks.values():
        return sorted(values, key=str)
    return sorted(values, key=lambda value: ranks[value] or 0)


def naming(setting: Setting, attribute: str) -> list[TokenTest]:
    """One test for each value, where values are shared by tokens; else none."""
    values = values_of(setting, attribute)
    shown = [v for v in setting.values(attribute) if v is not None]
    if len(values) == len(shown) or len(values) == 1:
        return []
    return [has(f"is-{value}", attribute) for value in values]


def simple(setting: Setting) -> list[TokenTest]:
    """Named values and features without an order: what "red", "odd" and "vowel" are."""
    found: list[TokenTest] = []
    for attribute, scale in setting.deck.scales.items():
        found += naming(setting, attribute)
        if scale is Scale.NUMBER:
            found += [has(name, attribute) for name in (*NUMBER_FEATURES, *DIGITS)]
        if scale is Scale.LETTER:
            found += [has(name, attribute) for name in ("vowel", "consonant")]
    return found


def thresholds(setting: Setting) -> Iterator[Compared]:
    """More or less than a value: one test a side for each gap between values that occur."""
    for attribute, scale in setting.deck.scales.items():
        if scale in (Scale.NOMINAL, Scale.CYCLE):
            continue
        for low, high in pairwise(values_of(setting, attribute)):
            if isinstance(low, str) or isinstance(high, str):
                yield Compared(attribute, Comparison.AT_MOST, low)
                yield Compared(attribute, Comparison.AT_LEAST, high)
            else:
                border, inside = round_between(low, high)
                below = Comparison.AT_MOST if inside == low else Comparison.LESS
                above = Comparison.AT_LEAST if inside == high else Comparison.MORE
                yield Compared(attribute, below, border)
                yield Compared(attribute, above, border)


def round_between(low: int | Decimal, high: int | Decimal) -> tuple[int | Decimal, Rank | Decimal]:
    """The roundest number from `low` to `high`, and which end it is, if any: people like those."""
    for unit in (1000, 100, 50, 10, 5, 1):
        border = -(-int(low) // unit) * unit
        if low <= border <= high:
            return border, border
    return high, high


def extremes(setting: Setting) -> Iterator[Among]:
    """As many of the lowest or highest as there are goal cells."""
    for attribute, scale in setting.deck.scales.items():
        if scale is not Scale.NOMINAL:
            yield from (Among(attribute, extreme) for extreme in Extreme)
