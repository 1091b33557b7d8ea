"""Shares of samples, with the interval that holds the true share with 95 % confidence."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import sqrt
from typing import Final

Z_95: Final = 1.959964
"""Standard deviations on either side that hold 95 % of a normal distribution."""
DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class Share:
    """How many of how many, with the 95 % interval of Wilson's score for the true share."""

    count: int
    of: int
    low: float
    high: float

    @classmethod
    def of_all(cls, hits: Iterable[bool]) -> Share:
        """The share of those that are true; without any, from 0 to 1."""
        seen = list(hits)
        count, of = sum(seen), len(seen)
        if not of:
            return cls(0, 0, 0.0, 1.0)
        share = count / of
        spread = Z_95 * sqrt(share * (1 - share) / of + Z_95**2 / (4 * of**2))
        middle, scale = share + Z_95**2 / (2 * of), 1 + Z_95**2 / of
        low, high = (max(0.0, middle - spread) / scale, min(1.0, (middle + spread) / scale))
        return cls(count, of, round(low, DIGITS), round(high, DIGITS))
