import pickle
from collections.abc import Mapping, MutableMapping, Sequence
from dataclasses import FrozenInstanceError
from decimal import Decimal
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.faults import Fault, InvalidError
from maestra.core.text import MAX_TEXT
from maestra.core.tokens import (
    MAX_LISTED,
    MAX_NAMES,
    MAX_NUMBER,
    MAX_TOKENS,
    MAX_WORDS,
    Deck,
    Scale,
    Token,
    TokenId,
    Value,
    alphabet_rank,
    expected_value,
)
from tests.strategies import decks, values


def token(name: str, **attributes: Value) -> Token:
    return Token(TokenId(name), tuple(attributes.items()))


def faults_of_token(name: str, *attributes: tuple[str, Value]) -> tuple[Fault, ...]:
    with pytest.raises(InvalidError) as caught:
        Token(TokenId(name), attributes)
    return caught.value.faults


# ---------------------------------------------------------------- tokens


def test_tokens_are_equal_however_their_attributes_were_written() -> None:
    one = Token(TokenId("T1"), (("value", 19), ("colour", "red")))
    other = Token(TokenId("T1"), (("colour", "red"), ("value", Decimal("19.0"))))
    assert one == other
    assert hash(one) == hash(other)


@pytest.mark.parametrize(
    ("written", "kept"),
    [("2.0", "2"), ("1.50", "1.5"), ("-0.0", "0"), ("1E+3", "1000"), ("0.10", "0.1")],
)
def test_equal_numbers_are_kept_alike(written: str, kept: str) -> None:
    assert str(token("T1", a=Decimal(written)).value("a")) == kept


def test_a_token_without_an_attribute_has_no_value_there() -> None:
    assert token("T1", value=19).value("value") == 19
    assert token("T1", value=19).value("colour") is None


def test_a_token_cannot_be_changed() -> None:
    with pytest.raises(FrozenInstanceError):
        token("T1").id = TokenId("T2")  # type: ignore[misc]  # must also fail at run time


def test_every_fault_of_a_token_is_named_at_once() -> None:
    assert faults_of_token("T\n", ("", 1), ("a", 1), ("a", 2), ("b", Decimal("NaN"))) == (
        Fault("tokens.T\n", '"T\\n"', "text without control characters"),
        Fault("tokens.T\n", '"a" 2 times', "each once"),
        Fault("tokens.T\n.", "an empty name", "at least one character"),
        Fault("tokens.T\n.b", "NaN", "a number"),
    )


def test_an_empty_or_endless_id_is_refused() -> None:
    assert faults_of_token("") == (Fault("tokens.", "an empty name", "at least one character"),)
    (fault,) = faults_of_token("x" * (MAX_TEXT + 1))
    assert (fault.found, fault.expected) == ("1001 characters", "at most 1000")
    Token(TokenId("x" * MAX_TEXT), ())


def test_more_attributes_than_anybody_can_know_are_refused() -> None:
    many: list[tuple[str, Value]] = [(f"a{index}", 1) for index in range(MAX_NAMES + 1)]
    assert faults_of_token("T1", *many) == (Fault("tokens.T1", "101 attributes", "at most 100"),)
    Token(TokenId("T1"), tuple(many[:-1]))


@given(values())
def test_a_generated_value_can_be_shown(value: Value) -> None:
    assert expected_value(value) is None


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (True, "a number or a string"),
        (None, "a number or a string"),
        (1.5, "a number or a string"),
        ([1], "a number or a string"),
        (Decimal("NaN"), "a number"),
        (Decimal("sNaN"), "a number"),
        (Decimal("Infinity"), "a number from -10^15 to 10^15"),
        (MAX_NUMBER + 1, "a number from -10^15 to 10^15"),
        (-MAX_NUMBER - 1, "a number from -10^15 to 10^15"),
        (Decimal(MAX_NUMBER) + Decimal("0.5"), "a number from -10^15 to 10^15"),
        (Decimal("0.1234567890123456789"), "a number of at most 15 digits"),
        (Decimal("1E-400"), "a number of at most 15 digits"),
        ("a\tb", "text of at most 1000 characters without control characters"),
        ("\x9b31m", "text of at most 1000 characters without control characters"),
        ("\ud800", "text of at most 1000 characters without control characters"),
        ("x" * (MAX_TEXT + 1), "text of at most 1000 characters without control characters"),
    ],
)
def test_what_no_token_can_show_is_refused(value: object, expected: str) -> None:
    assert expected_value(value) == expected


@pytest.mark.parametrize(
    "value",
    [MAX_NUMBER, -MAX_NUMBER, 0, Decimal("0.1"), Decimal("5E-324"), "", "x" * MAX_TEXT, "👩‍🦰"],
)
def test_the_last_value_that_a_token_can_show_is_accepted(value: Value) -> None:
    assert token("T1", a=value).value("a") == value


# ---------------------------------------------------------------- decks


def faults_of_deck(
    *tokens: Token,
    orders: Mapping[str, tuple[str, ...]] | None = None,
    cycles: Mapping[str, tuple[str, ...]] | None = None,
    relations: Mapping[str, frozenset[tuple[str, str]]] | None = None,
    lexicon: tuple[str, ...] = (),
) -> tuple[Fault, ...]:
    with pytest.raises(InvalidError) as caught:
        Deck(tokens, orders or {}, cycles or {}, relations or {}, lexicon)
    return caught.value.faults


def test_a_deck_without_tokens_is_refused() -> None:
    assert faults_of_deck() == (Fault("tokens", "no token", "at least one"),)


def test_an_id_on_two_tokens_is_refused() -> None:
    assert faults_of_deck(token("T1", value=1), token("T2"), token("T1")) == (
        Fault("tokens", '"T1" 2 times', "each once"),
    )


def test_an_attribute_of_numbers_and_strings_is_refused() -> None:
    assert faults_of_deck(token("T1", value=19), token("T2", value="C")) == (
        Fault("tokens.T2.value", '"C"', "a number as on the other tokens"),
    )
    assert faults_of_deck(token("T1", value="C"), token("T2", value=Decimal("1.5"))) == (
        Fault("tokens.T2.value", "1.5", "a string as on the other tokens"),
    )


@pytest.mark.parametrize("kind", ["orders", "cycles"])
def test_every_fault_of_an_order_is_named_at_once(kind: str) -> None:
    declared = {"day": ("Monday", "Tuesday", "Monday"), "": ("a",), "size": (), "hour": ("",)}
    tokens = (token("T1", day="Friday"), token("T2", day="Monday"), token("T3"))
    orders, cycles = (declared, {}) if kind == "orders" else ({}, declared)
    assert faults_of_deck(*tokens, orders=orders, cycles=cycles) == (
        Fault(f"{kind}.day", '"Monday" 2 times', "each once"),
        Fault("tokens.T1.day", '"Friday"', f"a value of {kind}.day"),
        Fault(f"{kind}.", "an empty name", "at least one character"),
        Fault(f"{kind}.size", "no value", "the values in their order"),
        Fault(f"{kind}.hour[0]", "an empty name", "at least one character"),
    )


def test_a_number_has_no_place_in_a_declared_order() -> None:
    assert faults_of_deck(token("T1", size=1), orders={"size": ("small",)}) == (
        Fault("tokens.T1.size", "1", "a value of orders.size"),
    )


def test_an_order_that_is_also_a_cycle_is_refused() -> None:
    both = {"day": ("Monday",), "age": ("young",)}
    assert faults_of_deck(token("T1"), orders=both, cycles=both) == (
        Fault("cycles.age", "also in orders", "one or the other"),
        Fault("cycles.day", "also in orders", "one or the other"),
    )


def test_names_in_relations_and_words_are_plain_text() -> None:
    pairs = frozenset({("cup", "sau\ncer"), ("", "a")})
    found = faults_of_deck(token("T1"), relations={"": pairs}, lexicon=("CURIE", "", "\x7f"))
    empty = Fault("relations.", "an empty name", "at least one character")
    assert found == (
        empty,
        empty,
        Fault("relations.", '"sau\\ncer"', "text without control characters"),
        Fault("lexicon[1]", "an empty name", "at least one character"),
        Fault("lexicon[2]", '"\x7f"', "text without control characters"),
    )


def test_more_of_anything_than_its_limit_is_refused() -> None:
    tokens = tuple(token(f"T{index}") for index in range(MAX_TOKENS + 1))
    numbered = [str(index) for index in range(MAX_LISTED + 1)]
    names = numbered[: MAX_NAMES + 1]
    found = faults_of_deck(
        *tokens,
        orders={"long": tuple(numbered)},
        cycles=dict.fromkeys(names, ("a",)),
        relations={name: frozenset[tuple[str, str]]() for name in names}
        | {"0": frozenset((one, "a") for one in numbered)},
        lexicon=("word",) * (MAX_WORDS + 1),
    )
    assert found == (
        Fault("tokens", "10001 tokens", "at most 10000"),
        Fault("orders.long", "10001 words", "at most 10000"),
        Fault("cycles", "101 names", "at most 100"),
        Fault("relations", "101 names", "at most 100"),
        Fault("relations.0", "10001 pairs", "at most 10000"),
        Fault("lexicon", "1000001 words", "at most 1000000"),
    )


def test_a_deck_cannot_be_changed() -> None:
    deck = Deck((token("T1", day="Monday"),), orders={"day": ("Monday",)})
    with pytest.raises(FrozenInstanceError):
        deck.tokens = ()  # type: ignore[misc]  # must also fail at run time
    for frozen in (deck.orders, deck.cycles, deck.relations, deck.by_id, deck.scales):
        with pytest.raises(TypeError):
            cast("MutableMapping[str, object]", frozen)["day"] = ()


@given(decks(), st.data())
def test_the_order_of_tokens_does_not_matter(deck: Deck, data: st.DataObject) -> None:
    tokens = data.draw(st.permutations(deck.tokens))
    twin = Deck(tuple(tokens), deck.orders, deck.cycles, deck.relations, deck.lexicon)
    assert twin == deck
    assert hash(twin) == hash(deck)


@given(decks())
def test_a_deck_survives_pickling(deck: Deck) -> None:
    assert pickle.loads(pickle.dumps(deck)) == deck  # noqa: S301 - pickled in this line


@given(decks())
def test_every_attribute_of_a_deck_has_a_scale_that_ranks_its_values(deck: Deck) -> None:
    assert list(deck.scales) == sorted({name for one in deck.tokens for name, _ in one.attributes})
    for one in deck.tokens:
        for name, value in one.attributes:
            if deck.scales[name] is Scale.NOMINAL:
                with pytest.raises(ValueError, match="has no order"):
                    deck.rank(name, value)
            else:
                deck.rank(name, value)


@pytest.mark.parametrize(
    ("attribute", "shown", "scale"),
    [
        ("value", [19, Decimal("1.5")], Scale.NUMBER),
        ("letter", ["C", "ñ"], Scale.LETTER),
        ("letter", ["C", "ch"], Scale.NOMINAL),
        ("letter", ["C", "?"], Scale.NOMINAL),
        ("initial", ["C", "U"], Scale.NOMINAL),
        ("day", ["Monday", "Friday"], Scale.ORDER),
        ("month", ["May", "June"], Scale.CYCLE),
    ],
)
def test_the_scale_follows_from_values_and_declarations(
    attribute: str, shown: Sequence[Value], scale: Scale
) -> None:
    tokens = tuple(token(f"T{index}", **{attribute: one}) for index, one in enumerate(shown))
    orders = {"day": ("Monday", "Tuesday", "Friday")}
    deck = Deck(tokens, orders, {"month": ("April", "May", "June")})
    assert deck.scales == {attribute: scale}


def test_ranks_stand_in_the_declared_the_numeric_and_the_alphabetical_order() -> None:
    tokens = (token("T1", day="Friday", month="May", letter="b", value=Decimal("1.5")),)
    deck = Deck(tokens, {"day": ("Monday", "Friday")}, {"month": ("April", "May")})
    assert deck.rank("day", "Friday") == 1
    assert deck.rank("month", "April") == 0
    assert deck.rank("letter", "b") == 1
    assert deck.rank("value", Decimal("1.5")) == Decimal("1.5")
    with pytest.raises(ValueError, match="colour has no order"):
        deck.rank("colour", "red")


def test_the_alphabet_ignores_case_and_accents_and_has_enye_after_n() -> None:
    in_order = ["a", "B", "ç", "É", "n", "Ñ", "o", "z", "δ", "λ", "я"]
    ranks = [alphabet_rank(letter) for letter in in_order]
    assert ranks == sorted(set(ranks))
    assert alphabet_rank("É") == alphabet_rank("e") == 4
