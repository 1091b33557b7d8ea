"""What a rule can ask of one token.

A feature, a comparison, its place among the others, and `not`, `and`, `or` of these. The answer
depends on the start of the play alone.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Annotated, Literal, TypeAlias, assert_never

from pydantic import Field

from maestra.core.tokens import Value
from maestra.rules.features import TokenFeature, token_feature_holds
from maestra.rules.fields import Amount, Feature, Name, Shown, Strict
from maestra.rules.setting import Mask, Rank, Setting, bits


class Comparison(Enum):
    """How two numbers or two places in an order compare, the first to the second."""

    LESS = "less"
    AT_MOST = "at-most"
    EQUAL = "equal"
    DIFFERENT = "different"
    AT_LEAST = "at-least"
    MORE = "more"

    @property
    def opposite(self) -> Comparison:
        """True exactly where this one is not."""
        return _OPPOSITES[self]

    def holds(self, first: Rank, second: Rank) -> bool:
        """Whether `first` compares so to `second`."""
        match self:
            case Comparison.LESS:
                return first < second
            case Comparison.AT_MOST:
                return first <= second
            case Comparison.EQUAL:
                return first == second
            case Comparison.DIFFERENT:
                return first != second
            case Comparison.AT_LEAST:
                return first >= second
            case Comparison.MORE:
                return first > second
            case _:
                assert_never(self)


_OPPOSITES = {
    Comparison.LESS: Comparison.AT_LEAST,
    Comparison.AT_MOST: Comparison.MORE,
    Comparison.EQUAL: Comparison.DIFFERENT,
    Comparison.DIFFERENT: Comparison.EQUAL,
    Comparison.AT_LEAST: Comparison.LESS,
    Comparison.MORE: Comparison.AT_MOST,
}


class Extreme(Enum):
    """Which end of an order."""

    LOWEST = "lowest"
    HIGHEST = "highest"


@dataclass(frozen=True, slots=True)
class Anything(Strict):
    """Every token passes."""

    test: Literal["anything"] = field(default="anything", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Has(Strict):
    """The token has the feature, for example ``odd:value`` or ``is-red:colour``."""

    feature: Feature
    test: Literal["has"] = field(default="has", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Compared(Strict):
    """What the token shows compares so to `value`, in the order of `attribute`."""

    attribute: Name
    comparison: Comparison
    value: Shown
    test: Literal["compared"] = field(default="compared", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Among(Strict):
    """The token is one of the `number` lowest or highest in storage at the start.

    None stands for as many as there are goal cells. Of equal tokens at the border each counts:
    a token passes when fewer than `number` are beyond it.
    """

    attribute: Name
    extreme: Extreme
    number: Amount | None = None
    test: Literal["among"] = field(default="among", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Not(Strict):
    """The token does not pass `of`."""

    of: TokenTest
    test: Literal["not"] = field(default="not", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Either(Strict):
    """The token passes `first` or `second` or both."""

    first: TokenTest
    second: TokenTest
    test: Literal["either"] = field(default="either", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Both(Strict):
    """The token passes `first` and `second`."""

    first: TokenTest
    second: TokenTest
    test: Literal["both"] = field(default="both", kw_only=True, repr=False)


TokenTest: TypeAlias = Annotated[
    Anything | Has | Compared | Among | Not | Either | Both, Field(discriminator="test")
]


def has(name: str, attribute: str) -> Has:
    """The test for a feature: ``has("is-red", "colour")``."""
    return Has(TokenFeature(name, attribute))


def passing(setting: Setting, test: TokenTest) -> Mask:
    """The tokens of the deck that pass `test`; a token that lacks the attribute does not."""
    return setting.remember(test, lambda: _passing(setting, test))


def _passing(setting: Setting, test: TokenTest) -> Mask:
    match test:
        case Anything():
            return (1 << len(setting.deck.tokens)) - 1
        case Has(feature):
            return setting.mask(lambda k: token_feature_holds(feature, setting.shown[k]))
        case Compared(attribute, comparison, value):
            return _compared(setting, attribute, comparison, value)
        case Among(attribute, extreme, number):
            return _among(setting, attribute, extreme, number)
        case Not(of):
            return passing(setting, Anything()) & ~passing(setting, of)
        case Either(first, second):
            return passing(setting, first) | passing(setting, second)
        case Both(first, second):
            return passing(setting, first) & passing(setting, second)
        case _:
            assert_never(test)


def _compared(setting: Setting, attribute: str, comparison: Comparison, value: Value) -> Mask:
    try:
        border = setting.rank(attribute, value)
    except ValueError:
        # The deck's order does not name this value; no token compares to it.
        border = None
    if border is None:
        return 0
    ranks = setting.ranks(attribute)
    return setting.mask(
        lambda k: (rank := ranks[k]) is not None and comparison.holds(rank, border)
    )


def _among(setting: Setting, attribute: str, extreme: Extreme, number: int | None) -> Mask:
    sign = 1 if extreme is Extreme.LOWEST else -1
    ranks = setting.ranks(attribute)
    stored = [sign * rank for k in bits(setting.movable) if (rank := ranks[k]) is not None]
    wanted = setting.length if number is None else number

    def passes(k: int) -> bool:
        rank = ranks[k]
        return rank is not None and sum(other < sign * rank for other in stored) < wanted

    return setting.mask(passes)
