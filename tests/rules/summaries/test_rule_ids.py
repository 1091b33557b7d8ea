"""Rules have stable names."""

import pytest

from maestra.rules.forms.base import Direction
from maestra.rules.forms.counting import Count
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern, given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.summaries.rule_ids import rule_ids
from maestra.rules.token_tests import Comparison, Either, Not, has

RED, ODD = has("is-red", "colour"), has("odd", "value")


@pytest.mark.parametrize(
    ("rule", "name"),
    [
        (FillOrder(Filling.LEFT_TO_RIGHT), "left-to-right"),
        (Ordered("value"), "increasing-value"),
        (Ordered("value", Direction.FALLING), "decreasing-value"),
        (Ordered("value", strict=False), "not-decreasing-value"),
        (Ordered("value", Direction.FALLING, strict=False), "not-increasing-value"),
        (Ordered("value", line=Line.TIME), "increasing-value-in-time"),
        (EveryToken(ODD), "only-odd-value"),
        (EveryToken(Not(RED)), "no-is-red-colour"),
        (EveryToken(Either(RED, ODD)), "every-token-is-red-colour-has-odd-value-has-either"),
        (from_row(2), "from-storage-row-2"),
        (StraightUp(), "same-column"),
        (StraightUp(mirrored=True), "mirrored-column"),
        (given_row("letter", tuple("CURIE")), "given-row"),
        (Pattern((RED, ODD), repeat=True), "pattern-is-red-colour-has-odd-value-has-true-row"),
        (Count(RED, Comparison.EQUAL, 2), "count-is-red-colour-has-equal-2"),
    ],
)
def test_each_rule_has_a_name(rule: Rule, name: str) -> None:
    assert rule_ids([rule]) == (name,)


def test_equal_names_are_numbered() -> None:
    rules: list[Rule] = [given_row("letter", ("C",)), given_row("letter", ("U",)), StraightUp()]
    assert rule_ids(rules) == ("given-row", "given-row-2", "same-column")
