"""What comes before what, and which token is always taken next."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import combinations, pairwise
from math import perm
from typing import Final

from maestra.learning.fewshot.families.base import Proposal, along_lines, each
from maestra.learning.fewshot.prior import ALONG_TIME_BITS, Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.fields import Flag
from maestra.rules.forms.sources import TakeExtreme
from maestra.rules.forms.timing import Before, Follows
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.token_tests import Extreme, has

CHAINS: Final = {2: 1.0, 3: 0.0}
"""Named tokens that are asked for one after the other: so many, for so many bits more."""


def timings(shown: Shown) -> Iterator[Proposal]:
    """One kind before another; after one kind another; always the least that is left."""
    kinds = shown.contrasts
    yield from along_lines(shown, Kind.BEFORE, lambda line: [Before(a, b, line) for a, b in kinds])
    for immediately in (True, False):
        follows = partial(_follows, shown, immediately)
        yield from along_lines(shown, Kind.FOLLOWS, follows)
    cost = one_of(2 * len(shown.ordinal)) + (0.0 if shown.timed else ALONG_TIME_BITS)
    takes = (TakeExtreme(a, extreme) for a in shown.ordinal for extreme in Extreme)
    yield from each(Kind.TAKE_EXTREME, takes, cost)
    for attribute in shown.names:
        for line in shown.lines:
            yield from _chains(shown, attribute, line)


def _follows(shown: Shown, immediately: Flag, line: Line) -> list[Rule]:
    return [Follows(a, b, immediately, line) for a, b in shown.contrasts]


def _chains(shown: Shown, attribute: str, line: Line) -> Iterator[Proposal]:
    """Two or three named tokens one before the other, as they are in the first play."""
    values = shown.setting.values(attribute)
    named = set(values) - {None}
    row = [token for token in shown.plays[0].slots(line) if token is not None]
    tests = [has(f"is-{values[token]}", attribute) for token in row]
    for count, more in CHAINS.items():
        for chain in combinations(tests, count):
            rules = tuple(Before(a, b, line) for a, b in pairwise(chain))
            yield Proposal(Kind.CHAIN, rules, one_of(perm(len(named), count)) + more)
