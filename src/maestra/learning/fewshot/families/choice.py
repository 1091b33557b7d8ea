"""Which tokens are in the row: only these, all of these, so many of them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Final

from maestra.learning.fewshot.families.base import Proposal, each
from maestra.learning.fewshot.prior import Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.learning.fewshot.token_tests import extremes, thresholds
from maestra.rules.forms.counting import CompareCounts, Count, Kinds
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.token_tests import (
    Anything,
    Comparison,
    Either,
    Not,
    TokenTest,
    has,
    passing,
)

MAX_EITHER: Final = 40
"""Simple tests that are paired by `or`; of more, as on a deck of names, none is."""


def selections(shown: Shown) -> Iterator[Proposal]:
    """Only these tokens; all of these."""
    tests = shown.kinds_and_features
    beyond = list(thresholds(shown.setting))
    yield from each(Kind.ONLY, map(EveryToken, tests))
    yield from each(Kind.ONLY_NOT, (EveryToken(Not(test)) for test in tests))
    if len(tests) <= MAX_EITHER:
        twos = (Either(one, two) for one, two in combinations(tests, 2))
        chosen = (EveryToken(test) for test in twos if _selects(shown, test))
        yield from each(Kind.ONLY_EITHER, chosen)
    yield from each(Kind.ONLY_BEYOND, map(EveryToken, beyond))
    extreme = (EveryToken(test) for test in extremes(shown.setting) if _selects(shown, test))
    yield from each(Kind.ONLY_EXTREME, extreme)
    for test in tests:
        yield Proposal(Kind.ALL_OF_THEM, (EveryToken(test), AllOfThem(test)))
        yield Proposal(Kind.AT_LEAST_ALL, (AllOfThem(test),))
    for limit in beyond:
        yield Proposal(Kind.ALL_BEYOND, (EveryToken(limit), AllOfThem(limit)))


def _selects(shown: Shown, test: TokenTest) -> bool:
    """Whether some token in storage does not pass."""
    return any(play.setting.movable & ~passing(play.setting, test) for play in shown.plays)


def counts(shown: Shown) -> Iterator[Proposal]:
    """So many of a kind, so many kinds, more of one than of another."""
    for test in shown.kinds_and_features:
        yield from _counts_of(shown, test)
    yield from _contains(shown)
    yield from _so_many_of_each(shown)
    for order in (Comparison.MORE, Comparison.AT_LEAST, Comparison.EQUAL):
        yield from each(Kind.MORE_OF, (CompareCounts(a, order, b) for a, b in shown.contrasts))
    for attribute in shown.named_attributes:
        yield from _kinds_of(shown, attribute)
    placed = {len(play.tokens) for play in shown.plays}
    if len(placed) == 1 and not shown.full:
        so_long = Count(Anything(), Comparison.EQUAL, placed.pop())
        yield Proposal(Kind.SO_LONG, (so_long,), one_of(shown.setting.length))


def _counts_of(shown: Shown, test: TokenTest) -> Iterator[Proposal]:
    """Exactly, at least and at most as many as the play with the fewest or the most has."""
    length = shown.setting.length
    cost = one_of(len(shown.kinds_and_features) * (length - 1))
    found = [play.count(passing(play.setting, test)) for play in shown.plays]
    for number in sorted({min(found), max(found)}):
        if 0 < number < length:
            yield Proposal(Kind.COUNT, (Count(test, Comparison.EQUAL, number),), cost)
        if number > 0:
            at_least = Count(test, Comparison.AT_LEAST, number)
            yield Proposal(Kind.COUNT_BEYOND, (at_least,), cost + 0.5)
        if number < length:
            at_most = Count(test, Comparison.AT_MOST, number)
            yield Proposal(Kind.COUNT_BEYOND, (at_most,), cost + 0.5)


def _contains(shown: Shown) -> Iterator[Proposal]:
    """One of the tokens of the first play, whatever else."""
    for attribute in shown.unique:
        values = shown.setting.values(attribute)
        cost = one_of(len(values) * len(shown.unique))
        for token in shown.plays[0].tokens:
            if values[token] is not None:
                named = has(f"is-{values[token]}", attribute)
                contains = Count(named, Comparison.AT_LEAST, 1)
                yield Proposal(Kind.CONTAINS, (contains,), cost)


def _so_many_of_each(shown: Shown) -> Iterator[Proposal]:
    """Three of one kind and two of the other, and nothing else."""
    cost = one_of(len(shown.contrasts) * shown.setting.length / 2)
    for one, two in shown.contrasts:
        for play in shown.plays:
            a, b = (play.count(passing(play.setting, test)) for test in (one, two))
            if a + b == len(play.tokens) and 0 < a <= b:
                both = (Count(one, Comparison.EQUAL, a), Count(two, Comparison.EQUAL, b))
                yield Proposal(Kind.SO_MANY_OF_EACH, both, cost)


def _kinds_of(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """So many different values as the play with the fewest or the most shows."""
    cost = one_of(len(shown.named_attributes) * 3)
    found = [Kinds(attribute, Comparison.EQUAL, 0).amount(play) for play in shown.plays]
    for number in sorted({min(found), max(found)} - {0}):
        yield Proposal(Kind.KINDS, (Kinds(attribute, Comparison.EQUAL, number),), cost)
        for order in (Comparison.AT_LEAST, Comparison.AT_MOST):
            yield Proposal(Kind.KINDS, (Kinds(attribute, order, number),), cost + 1.5)
