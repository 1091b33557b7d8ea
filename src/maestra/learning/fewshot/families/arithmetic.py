"""Steps, ratios, distances, sums and equations, with the amounts that were shown."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product
from math import ceil, comb, floor
from typing import Final

from maestra.core.tokens import Scale
from maestra.learning.fewshot.families.base import Proposal
from maestra.learning.fewshot.prior import Kind, amount_bits, one_of, round_bits
from maestra.learning.fewshot.shown import Shown, as_number, distance, quotient, total
from maestra.rules.forms.base import Position
from maestra.rules.forms.counting import Equation, Operation, Total
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.pairs import AddUp, Apart, Step, Times
from maestra.rules.token_tests import Comparison

UNITS: Final = (10, 50, 100)
"""People bound sums by round numbers."""


def arithmetic(shown: Shown) -> Iterator[Proposal]:
    """Steps and distances of what has an order; ratios, sums and equations of numbers."""
    for attribute in shown.ordinal:
        yield from _steps(shown, attribute)
    for attribute in shown.numeric:
        yield from _ratios(shown, attribute)
        yield from _pair_sums(shown, attribute)
        yield from _row_sums(shown, attribute)
        yield from _equations(shown, attribute)


def _steps(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """From each token to the next; a step of one is the successor, as Tuesday is of Monday."""
    cost = one_of(len(shown.ordinal))
    for amount in shown.steps(attribute):
        rule = EachPair(Pairs.NEIGHBOURS, Step(attribute, amount))
        if shown.scales[attribute] in (Scale.CYCLE, Scale.ORDER) and abs(amount) == 1:
            yield Proposal(Kind.SUCCESSORS, (rule,), cost + 0.5)
        else:
            yield Proposal(Kind.STEP, (rule,), cost + amount_bits(amount))
    for amount in shown.amounts(attribute, distance):
        rule = EachPair(Pairs.NEIGHBOURS, Apart(attribute, amount))
        yield Proposal(Kind.APART, (rule,), cost + amount_bits(amount))


def _ratios(shown: Shown, attribute: str) -> Iterator[Proposal]:
    cost = one_of(len(shown.numeric))
    for factor in shown.amounts(attribute, quotient):
        rule = EachPair(Pairs.NEIGHBOURS, Times(attribute, factor))
        yield Proposal(Kind.RATIO, (rule,), cost + amount_bits(factor))


def _pair_sums(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """Two tokens add up to a number; seldom those as far from the middle."""
    cost = one_of(len(shown.numeric))
    for number in shown.amounts(attribute, total):
        amount = round_bits(number, 2 * shown.span(attribute))
        for which in (Pairs.NEIGHBOURS, Pairs.TWO_BY_TWO, Pairs.MIRRORED):
            seldom = 2.0 if which is Pairs.MIRRORED else 0.0
            rule = EachPair(which, AddUp(attribute, number))
            yield Proposal(Kind.ADD_UP, (rule,), cost + (seldom + amount))


def _row_sums(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """What the row adds up to, and round bounds of it."""
    cost = one_of(len(shown.numeric))
    span = shown.span(attribute) * shown.setting.length
    found = {shown.sum_of(play, attribute) for play in shown.plays} - {None}
    sums = sorted(one for one in found if one is not None)
    for number in [n for one in sums if (n := as_number(one)) is not None]:
        rule = Total(attribute, Comparison.EQUAL, number)
        yield Proposal(Kind.TOTAL, (rule,), cost + round_bits(number, span / 3))
    for unit in UNITS if sums else ():
        bound = one_of(span / unit)
        least, most = unit * floor(sums[0] / unit), unit * ceil(sums[-1] / unit)
        for low in (least, least - unit):
            if low > 0:
                at_least = Total(attribute, Comparison.AT_LEAST, low)
                yield Proposal(Kind.TOTAL_BEYOND, (at_least,), cost + bound + 1)
                yield Proposal(Kind.UNTIL_TOTAL, (UntilTotal(attribute, low),), cost + bound)
        for high in (most, most + unit):
            at_most = Total(attribute, Comparison.AT_MOST, high)
            yield Proposal(Kind.TOTAL_BEYOND, (at_most,), cost + bound + 1)


def _equations(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """Two places make a third: as a rule the first two make the third or the last."""
    cost = one_of(len(shown.numeric))
    length = shown.setting.length
    places = [Position(k) for k in range(1, length + 1)]
    for result, operation in product(places, Operation):
        others = [place for place in places if place != result]
        constant = 0 if operation is Operation.SUM else 1
        for one, two in combinations(others, 2):
            rule = Equation(attribute, (one, two), (result,), constant, operation)
            if (one, two) == (1, 2) and result in (3, length):
                yield Proposal(Kind.EQUATION, (rule,), cost + 1.5)
            else:
                anywhere = one_of(6 * comb(length, 3))
                yield Proposal(Kind.EQUATION_ANYWHERE, (rule,), cost + anywhere)
