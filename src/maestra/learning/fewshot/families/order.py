"""Order and shape: rising and falling, zigzag, the largest in the middle."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from maestra.core.tokens import Scale
from maestra.learning.fewshot.families.base import Proposal, later
from maestra.learning.fewshot.prior import Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction, Position
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.setting import Line
from maestra.rules.token_tests import Extreme


def orders(shown: Shown) -> Iterator[Proposal]:
    """Order and shape."""
    yield from _ordered(shown)
    for line in shown.lines:
        for attribute in shown.ordinal:
            yield from _shapes(shown, attribute, line)
    yield from _extremes(shown)


def _ordered(shown: Shown) -> Iterator[Proposal]:
    """Rising and falling; strictly as a rule where no two tokens show the same."""
    cost = one_of(2 * len(shown.ordinal))
    for attribute, direction in product(shown.ordinal, Direction):
        ties = shown.has_ties(attribute)
        for strict in (True, False):
            usual = strict is not ties
            kind = Kind.ORDER if usual else Kind.ORDER_LOOSE
            yield Proposal(kind, (Ordered(attribute, direction, strict),), cost)
            if shown.timed:
                in_time = Ordered(attribute, direction, strict, Line.TIME)
                yield Proposal(Kind.ORDER_IN_TIME, (in_time,), cost + (not usual))


def _shapes(shown: Shown, attribute: str, line: Line) -> Iterator[Proposal]:
    """Zigzag, hill and valley, equal steps and ratios, round a cycle."""
    cost = later(line) + one_of(len(shown.ordinal))
    yield Proposal(Kind.SHAPE, (Zigzag(attribute, line),), cost)
    for direction in Direction:
        yield Proposal(Kind.SHAPE, (RiseAndFall(attribute, direction, line),), cost + 1)
    yield Proposal(Kind.EQUAL_STEPS, (EqualSteps(attribute, line=line),), cost)
    if attribute in shown.numeric:
        ratio = EqualSteps(attribute, ratio=True, line=line)
        yield Proposal(Kind.EQUAL_RATIO, (ratio,), cost)
    if shown.scales[attribute] is Scale.CYCLE:
        for direction in Direction:
            cyclic = CyclicOrdered(attribute, direction, line)
            yield Proposal(Kind.CYCLIC, (cyclic,), later(line) + 1)


def _extremes(shown: Shown) -> Iterator[Proposal]:
    """The largest or smallest on one goal cell, as a rule the middle or an end."""
    length = shown.setting.length
    # The middle of an odd row is said once.
    cells = [k for k in range(1, length + 1) if k in (1, length) or 2 * k != length + 1]
    places = (MIDDLE, *(LAST if k == length else Position(k) for k in cells))
    cost = one_of(6 * len(shown.ordinal))
    for attribute, extreme, place in product(shown.ordinal, Extreme, places):
        seldom = 0.0 if place in (FIRST, MIDDLE, LAST) else 3.0
        yield Proposal(Kind.EXTREME_AT, (ExtremeAt(attribute, extreme, place),), cost + seldom)
