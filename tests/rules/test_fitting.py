"""Which decks a rule can be asked of."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.fitting import misfits
from maestra.rules.forms.base import FIRST, LAST
from maestra.rules.forms.counting import Count, Total
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import TakeExtreme
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Compare, Named, same
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Extreme,
    Not,
    has,
)
from tests.rules.therapy_boards import TherapyExercise
from tests.rules.therapy_exercises import LISTED
from tests.rules.therapy_variations import MORE

DECK = Deck((Token(TokenId("a"), (("value", 3), ("colour", "red"))),))


@pytest.mark.parametrize("exercise", [*LISTED, *MORE], ids=lambda one: one.words)
def test_every_exercise_fits_its_own_deck(exercise: TherapyExercise) -> None:
    assert misfits(exercise.rules, exercise.setting.deck) == ()


FITTING: tuple[Rule, ...] = (
    Ordered("value"),
    EachPair(Pairs.ALL, same("colour")),
    TakeExtreme(ORIGIN_COLUMN, Extreme.LOWEST),
    Count(Anything(), Comparison.EQUAL, 2),
    EveryToken(Not(has("is-red", "colour"))),
)
MISFITTING: dict[Rule, list[str]] = {
    Ordered("weight"): ["weight"],
    Ordered("colour"): ["colour"],
    Total("colour", Comparison.EQUAL, 3): ["colour"],
    EachPair(Pairs.ALL, Compare("colour", Comparison.LESS)): ["colour"],
    EachPair(Pairs.ALL, AddUp("weight", 3)): ["weight"],
    TwoPlaces(FIRST, LAST, Named("partner")): ["name", "relations.partner"],
    Word(): ["letter", "lexicon"],
    Word(relation="kind", value="bird"): ["letter", "relations.kind", "lexicon"],
    EveryToken(
        Either(Compared("colour", Comparison.LESS, 3), Both(has("odd", "x"), Anything()))
    ): ["colour", "x"],
    EveryToken(Among("y", Extreme.LOWEST)): ["y"],
}


@given(st.sampled_from(FITTING))
def test_a_deck_with_all_that_is_asked_fits(rule: Rule) -> None:
    assert misfits([rule, rule], DECK) == ()


@pytest.mark.parametrize("rule", MISFITTING)
def test_what_a_deck_lacks_is_named_once(rule: Rule) -> None:
    assert [fault.where for fault in misfits([rule, rule], DECK)] == MISFITTING[rule]
