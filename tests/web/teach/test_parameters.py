"""Which features with a parameter are offered for which tokens."""

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.language import Language
from maestra.rules.features import TokenFeature, labelled_feature, token_feature_holds
from maestra.rules.paper import LETTER_DECK, NUMBER_DECK
from maestra.rules.registry import PARAMETER_FEATURES
from maestra.web.teach.decks import Ready, numbers_deck, ready_deck, shapes_deck, words_deck
from maestra.web.teach.parameters import (
    DIVISORS,
    MOST_LIMITS,
    MOST_VALUES,
    PARAMETERS,
    offered,
    roundest,
)
from maestra.web.translations import translate


def names(deck: Deck) -> dict[str, list[str]]:
    return {kind: [one.name for one in found] for kind, found in offered(deck, ()).items()}


def deck_of(*values: Value) -> Deck:
    return Deck(tuple(Token(TokenId(f"t{k}"), (("value", v),)) for k, v in enumerate(values)))


def test_each_kind_of_the_registry_can_be_offered() -> None:
    assert set(PARAMETERS) == set(PARAMETER_FEATURES)
    assert set(names(numbers_deck(1, 12, 1))) == set(PARAMETER_FEATURES)


def test_numbers_are_told_apart_by_what_divides_the_deck() -> None:
    assert names(numbers_deck(1, 12, 1)) == {
        "multiple-of": ["multiple-of-3", "multiple-of-5", "multiple-of-10"],
        "digits": ["digits-1", "digits-2"],
        "above": ["above-4", "above-7", "above-10"],
        "below": ["below-4", "below-7", "below-10"],
        "is": [f"is-{k}" for k in range(1, 13)],
    }


def test_limits_are_round_where_the_deck_has_room_for_it() -> None:
    assert names(NUMBER_DECK)["above"] == ["above-30", "above-40", "above-50"]
    assert names(numbers_deck(1, 70, 1))["below"] == ["below-20", "below-40", "below-50"]
    assert names(deck_of(-7, Decimal("0.5"), 1, Decimal("1.25")))["above"] == [
        "above-0",
        "above-1",
    ]


def test_what_all_tokens_have_or_none_is_not_offered() -> None:
    assert names(deck_of(5, 10, 15)) == {
        "multiple-of": ["multiple-of-3", "multiple-of-10"],
        "digits": ["digits-1", "digits-2"],
        "above": ["above-10"],
        "below": ["below-10"],
        "is": ["is-5", "is-10", "is-15"],
    }
    assert names(deck_of(7, 7)) == {}


def test_words_are_told_apart_by_their_values() -> None:
    assert names(shapes_deck(("red", "blue"), ("circle", "star"))) == {
        "is": ["is-blue", "is-red", "is-circle", "is-star"]
    }
    assert sorted(names(words_deck("tea, drink\npie, food"))["is"]) == [
        *("is-drink", "is-food"),
        *("is-pie", "is-tea"),
    ]
    assert len(names(LETTER_DECK)["is"]) == len(LETTER_DECK.tokens)


def test_of_many_values_none_is_offered() -> None:
    assert "is" in names(numbers_deck(1, MOST_VALUES, 1))
    assert "is" not in names(numbers_deck(1, MOST_VALUES + 1, 1))


def test_what_was_chosen_is_offered_at_any_value_and_once() -> None:
    chosen = [TokenFeature("above-33", "value"), TokenFeature("above-30", "value")]
    found = offered(NUMBER_DECK, [*chosen, TokenFeature("odd", "value")])
    assert [one.name for one in found["above"]] == ["above-30", "above-40", "above-50", "above-33"]
    assert "odd" not in {one.name for some in found.values() for one in some}


_numbers = st.integers(-(10**15), 10**15) | st.decimals(-1000, 1000, places=3)


@given(st.lists(_numbers, min_size=1, max_size=70))
def test_all_that_is_offered_can_be_chosen_and_divides_the_tokens(values: list[Value]) -> None:
    deck = deck_of(*values)
    found = offered(deck, ())
    for feature in (one for some in found.values() for one in some):
        assert labelled_feature(deck, feature.label) == feature
        has = {token_feature_holds(feature, token.attributes) for token in deck.tokens}
        assert has == {True, False}
    most = {"multiple-of": len(DIVISORS), "above": MOST_LIMITS, "below": MOST_LIMITS}
    for kind, limit in {**most, "is": MOST_VALUES}.items():
        assert len(found.get(kind, ())) <= limit


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize("which", Ready)
def test_each_ready_deck_has_a_kind_to_offer(which: Ready, language: Language) -> None:
    assert offered(ready_deck(which, lambda word: translate(language, word)), ())


@pytest.mark.parametrize(
    ("low", "high", "number"),
    [
        ("19", "34", "30"),
        ("51", "57", "54"),
        ("3", "4", "4"),
        ("-5", "3", "0"),
        ("0.25", "0.26", "0.26"),
        ("7", "7", "7"),
    ],
)
def test_the_roundest_number_lies_between(low: str, high: str, number: str) -> None:
    assert roundest(Decimal(low), Decimal(high)) == Decimal(number)
