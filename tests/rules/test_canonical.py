"""Rules that mean the same are written in one way, and that way means the same."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.rules.canonical import canonical, canonical_test, letters_of
from maestra.rules.fields import Position
from maestra.rules.forms.base import Direction
from maestra.rules.forms.counting import Equation, Operation
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Template
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.pairs import Compare
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.token_tests import Anything, Both, Comparison, Either, Not, TokenTest, has
from tests.rules.rule_strategies import decks, plays_from, rules_for, settings_with

A, B, C = has("odd", "value"), has("prime", "value"), has("above-3", "value")
ONE, TWO, THREE = Position(1), Position(2), Position(3)


@settings(max_examples=settings().max_examples // 2)
@given(st.data())
def test_the_canonical_rule_means_the_same_and_stays(data: st.DataObject) -> None:
    deck = data.draw(decks())
    setting = data.draw(settings_with(deck))
    rule = data.draw(rules_for(deck, setting.start.board))
    play = data.draw(plays_from(setting))
    found = canonical(rule)
    assert found.holds(play) == rule.holds(play)
    assert found.possible(play) == rule.possible(play)
    assert canonical(found) == found


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        (Not(Not(A)), A),
        (Not(Either(A, B)), Both(Not(A), Not(B))),
        (Not(Both(A, B)), Either(Not(A), Not(B))),
        (Either(Either(A, B), C), Either(A, Either(B, C))),
        (Both(A, Anything()), A),
        (Both(Anything(), Anything()), Anything()),
        (Either(A, Anything()), Anything()),
        (Not(Anything()), Not(Anything())),
        (Both(Either(A, B), C), Both(Either(A, B), C)),
    ],
)
def test_tests_are_written_in_one_way(test: TokenTest, expected: TokenTest) -> None:
    assert canonical_test(test) == expected


@pytest.mark.parametrize(
    ("rule", "expected"),
    [
        (
            EachPair(Pairs.ALL, Compare("value", Comparison.AT_LEAST), Line.TIME),
            Ordered("value", Direction.FALLING, strict=False, line=Line.TIME),
        ),
        (Template("colour", "XYX"), Template("colour", "ABA")),
        (
            Equation("value", (ONE,), (), 5, Operation.PRODUCT),
            Equation("value", (ONE,), (), 5),
        ),
        (
            Equation("value", (ONE,), (TWO,), 1, Operation.PRODUCT),
            Equation("value", (ONE,), (TWO,)),
        ),
        (
            Equation("value", (ONE,), (TWO,), 2, Operation.PRODUCT),
            Equation("value", (ONE,), (TWO,), 2, Operation.PRODUCT),
        ),
        (
            Equation("value", (ONE, TWO), (THREE,), 1, Operation.PRODUCT),
            Equation("value", (ONE, TWO), (THREE,), 1, Operation.PRODUCT),
        ),
        (EveryToken(Both(A, Anything())), EveryToken(A)),
    ],
)
def test_rules_are_written_in_one_way(rule: Rule, expected: Rule) -> None:
    assert canonical(rule) == expected


def test_a_pattern_of_many_letters_keeps_them_apart() -> None:
    letters = "".join(chr(ord("a") + k) for k in range(60))
    assert len(set(letters_of(letters))) == 60
