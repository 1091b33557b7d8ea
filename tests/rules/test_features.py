from collections.abc import Mapping, Sequence
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.tokens import NAME, Attributes, Deck, Token, TokenId, Value
from maestra.rules.features import (
    CELLS,
    DEFAULT_CELLS,
    FRAME,
    CellFeature,
    Feature,
    PairFeature,
    TokenFeature,
    UnknownFeatureError,
    feature_names,
    labelled_feature,
    pair_feature_holds,
    pair_feature_table,
    select_features,
    token_feature_holds,
)
from maestra.rules.registry import (
    CELL_FEATURES,
    CONVERSES,
    PAIR_FEATURES,
    PARAMETER_FEATURES,
    TOKEN_FEATURES,
)
from tests.strategies import decks

Declared = Mapping[str, tuple[str, ...]]
NOTHING: Declared = {}
Pair = tuple[Value, Value]
DAYS = ("Mon", "Tue", "Wed")


def deck(
    *shown: dict[str, Value],
    orders: Declared = NOTHING,
    cycles: Declared = NOTHING,
    relations: Mapping[str, frozenset[tuple[str, str]]] | None = None,
) -> Deck:
    tokens = tuple(Token(TokenId(f"t{n}"), tuple(one.items())) for n, one in enumerate(shown))
    return Deck(tokens, orders, cycles, relations or {})


NUMBERS = deck({"value": 1, "size": 3}, {"value": 2, "size": 4})
MIXED = deck(
    {"value": 1, "letter": "a", "colour": "red", "day": "Mon", "name": "cup"},
    {"value": 2, "letter": "b", "colour": "blue", "day": "Tue", "name": "saucer"},
    orders={"day": DAYS},
    relations={"partner": frozenset({("cup", "saucer")})},
)

TOKEN_EXAMPLES: Sequence[tuple[str, Sequence[Value], Sequence[Value]]] = [
    ("odd", [1, 19, -3], [0, 2, Decimal("1.5")]),
    ("even", [0, 2, -4], [1, 19, Decimal("2.5")]),
    ("prime", [2, 3, 5, 7, 97], [0, 1, 4, 9, -3, Decimal("2.5"), 25, 49]),
    ("vowel", ["a", "E", "í", "Ü", "o"], ["b", "ñ", "Y", "ç"]),
    ("consonant", ["b", "ñ", "Ñ", "Y", "ç"], ["a", "É", "u"]),
    ("multiple-of-5", [0, 5, -10, 100], [1, 4, Decimal("2.5")]),
    ("digits-2", [10, 99, -42], [9, 100, Decimal("1.5")]),
    ("digits-1", [0, 9], [10]),
    ("above-30", [31, Decimal("30.5")], [30, 29, -31]),
    ("above--2.5", [0, -2], [-3, Decimal("-2.5")]),
    ("below-30", [29, Decimal("29.5"), -31], [30, 31]),
    ("is-red", ["red"], ["blue", "dark red"]),
    ("is-19", [19, "19"], [1, 190]),
    ("is-2.50", [Decimal("2.5")], [2, 25]),
    ("is-red", ["red"], [19]),
]

PAIR_EXAMPLES: Sequence[tuple[str, Sequence[Pair], Sequence[Pair]]] = [
    ("less-than", [(1, 2), (Decimal("1.5"), 2), (-2, 1)], [(2, 2), (2, 1)]),
    ("successor", [(1, 2), (-1, 0), (Decimal("1.5"), Decimal("2.5"))], [(1, 3), (2, 1), (1, 1)]),
    ("twice", [(2, 4), (Decimal("1.5"), 3), (0, 0)], [(4, 2), (2, 5)]),
    ("same", [(1, 1), ("red", "red")], [(1, 2), ("red", "blue")]),
    ("different", [(1, 2), ("red", "blue")], [(1, 1), ("red", "red")]),
]


def holds_for(name: str, value: Value) -> bool:
    return token_feature_holds(TokenFeature(name, "x"), (("x", value),))


@pytest.mark.parametrize(("name", "having", "lacking"), TOKEN_EXAMPLES)
def test_a_feature_of_one_token_by_example(
    name: str, having: Sequence[Value], lacking: Sequence[Value]
) -> None:
    assert [value for value in having if not holds_for(name, value)] == []
    assert [value for value in lacking if holds_for(name, value)] == []


def test_every_feature_of_one_token_has_an_example() -> None:
    shown = {name for name, _, _ in TOKEN_EXAMPLES}
    assert shown >= set(TOKEN_FEATURES)
    assert {name.rpartition("-")[0] for name in shown} >= {*PARAMETER_FEATURES} - {"above"}


def related(
    name: str,
    attribute: str,
    one: Value,
    other: Value,
    *,
    orders: Declared = NOTHING,
    cycles: Declared = NOTHING,
) -> bool:
    both = deck({attribute: one}, {attribute: other}, orders=orders, cycles=cycles)
    first, second = (token.attributes for token in both.tokens)
    return pair_feature_holds(PairFeature(name, attribute), both, first, second)


@pytest.mark.parametrize(("name", "having", "lacking"), PAIR_EXAMPLES)
def test_a_feature_of_two_tokens_by_example(
    name: str, having: Sequence[Pair], lacking: Sequence[Pair]
) -> None:
    assert [pair for pair in having if not related(name, "x", *pair)] == []
    assert [pair for pair in lacking if related(name, "x", *pair)] == []


@pytest.mark.parametrize(
    ("one", "other", "before", "next_to"),
    [
        ("a", "b", True, True),
        ("a", "C", True, False),
        ("b", "a", False, False),
        ("É", "f", True, True),
        ("n", "ñ", True, True),
        ("ñ", "o", True, True),
        ("n", "o", True, False),
        ("a", "á", False, False),
        ("z", "ж", True, False),
    ],
)
def test_letters_are_ordered_by_the_alphabet_whatever_their_case_and_accent(
    *, one: str, other: str, before: bool, next_to: bool
) -> None:
    assert related("before", "letter", one, other) is before
    assert related("successor", "letter", one, other) is next_to


def test_declared_values_are_in_their_order() -> None:
    assert related("before", "day", "Mon", "Wed", orders={"day": DAYS})
    assert not related("before", "day", "Tue", "Mon", orders={"day": DAYS})
    assert related("successor", "day", "Mon", "Tue", orders={"day": DAYS})
    assert not related("successor", "day", "Wed", "Mon", orders={"day": DAYS})


def test_in_a_cycle_the_first_follows_the_last() -> None:
    assert related("successor", "day", "Mon", "Tue", cycles={"day": DAYS})
    assert related("successor", "day", "Wed", "Mon", cycles={"day": DAYS})
    assert not related("successor", "day", "Mon", "Wed", cycles={"day": DAYS})


def test_a_successor_is_exact_however_small_the_difference() -> None:
    assert not related("successor", "x", Decimal("1e-300"), 1)


def test_a_relation_of_the_deck_holds_for_the_pairs_it_lists() -> None:
    cup, saucer = (token.attributes for token in MIXED.tokens)
    partner = PairFeature("partner", "name")
    assert pair_feature_holds(partner, MIXED, cup, saucer)
    assert not pair_feature_holds(partner, MIXED, saucer, cup)


def test_nothing_holds_for_a_token_that_lacks_the_attribute() -> None:
    shown, bare = (("value", 1),), ()
    assert not token_feature_holds(TokenFeature("odd", "value"), bare)
    for name in ("same", "different"):
        assert not pair_feature_holds(PairFeature(name, "value"), NUMBERS, shown, bare)
        assert not pair_feature_holds(PairFeature(name, "value"), NUMBERS, bare, shown)


def test_a_huge_number_does_not_count_as_prime() -> None:
    assert not holds_for("prime", 100_000_007)


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


@pytest.mark.parametrize(
    ("name", "value", "values"),
    [
        ("origin", cell(3, 1), Board(3, 2, Row(2)).cells),
        ("destination", cell(2, 2), Board(3, 2, Row(2)).cells),
        ("origin-row", 3, range(1, 4)),
        ("origin-column", 1, range(1, 3)),
        ("destination-column", 2, range(1, 3)),
        ("same-column", False, (True,)),
        ("from-storage", True, (True,)),
        ("to-goal-row", True, (True,)),
    ],
)
def test_a_feature_of_a_moves_cells_by_example(
    name: str, value: object, values: Sequence[object]
) -> None:
    board = Board(3, 2, Row(2))
    feature = CellFeature(name)
    assert feature.of(board, cell(3, 1), cell(2, 2)) == value
    assert list(feature.values(board)) == list(values)
    assert feature.label == name


def test_a_yes_or_no_of_a_moves_cells_is_both() -> None:
    board = Board(3, 2, Row(2))
    one, other = (cell(3, 1), cell(2, 1)), (cell(2, 1), cell(1, 2))
    assert [CellFeature("same-column").of(board, *move) for move in (one, other)] == [True, False]
    assert [CellFeature("from-storage").of(board, *move) for move in (one, other)] == [True, False]
    assert [CellFeature("to-goal-row").of(board, *move) for move in (one, other)] == [True, False]


def test_every_feature_of_a_moves_cells_has_an_example() -> None:
    assert len(CELL_FEATURES) == 8


# ------------------------------------------------------------------ selecting


def selected(of: Deck, *names: str) -> list[str]:
    features = select_features(of, names)
    assert features[:2] == FRAME
    return [feature.label for feature in features[2:]]


def test_by_default_the_cells_the_papers_order_and_the_tests_that_apply_count() -> None:
    assert [one.label for one in select_features(MIXED, None)] == [
        *("from-storage", "to-goal-row", "destination", "origin"),
        *("odd:value", "even:value", "vowel:letter", "consonant:letter"),
        *("less-than:value", "before:day", "before:letter"),
    ]


def test_cells_alone_leave_nothing_else() -> None:
    assert selected(MIXED, "cells") == ["destination", "origin"]
    assert selected(MIXED) == ["destination", "origin"]


def test_cells_count_unless_other_features_of_the_move_are_named() -> None:
    assert selected(MIXED, "odd") == ["destination", "origin", "odd:value"]
    assert selected(MIXED, "odd", "origin-row") == ["odd:value", "origin-row"]
    assert selected(MIXED, "odd", "cells") == ["odd:value", "destination", "origin"]
    assert selected(MIXED, "from-storage") == []


def test_a_feature_is_taken_over_every_attribute_it_applies_to() -> None:
    both = ["destination", "origin", "less-than:size", "less-than:value"]
    assert selected(NUMBERS, "less-than") == both
    assert selected(NUMBERS, "less-than:size") == [*both[:2], "less-than:size"]


@pytest.mark.parametrize(("name", "known"), CONVERSES.items())
def test_the_converse_of_a_feature_is_the_feature_itself(name: str, known: str) -> None:
    assert selected(MIXED, name) == selected(MIXED, known)
    assert selected(MIXED, f"{name}:day" if name == "after" else name) != ["destination", "origin"]


def test_a_feature_counts_once_however_often_it_is_named() -> None:
    names = ("less-than", "greater-than", "less-than:value", "destination", "destination")
    assert selected(MIXED, *names) == ["less-than:value", "destination"]


@pytest.mark.parametrize("name", ["multiple-of-5", "digits-2", "above-30", "below--2.5"])
def test_a_feature_with_a_number_applies_to_numbers(name: str) -> None:
    assert selected(NUMBERS, name) == ["destination", "origin", f"{name}:size", f"{name}:value"]


def test_a_value_is_named_over_the_attributes_that_show_it() -> None:
    assert selected(MIXED, "is-red")[2:] == ["is-red:colour"]
    assert selected(MIXED, "is-2")[2:] == ["is-2:value"]
    assert selected(MIXED, "is-red:colour")[2:] == ["is-red:colour"]


def test_a_relation_of_the_deck_is_selected_by_its_name() -> None:
    assert selected(MIXED, "partner")[2:] == ["partner:name"]
    assert selected(MIXED, "partner:name")[2:] == ["partner:name"]


@pytest.mark.parametrize("name", ["same", "odd", "after", "cells", "origin", "is-a", "digits"])
def test_a_relation_named_like_a_feature_is_not_in_its_way(name: str) -> None:
    disguised = deck({"name": "a", "value": 1}, relations={name: frozenset({("a", "a")})})
    plain = deck({"name": "a", "value": 1})
    if name not in {"digits", "after"}:
        assert select_features(disguised, [name]) == select_features(plain, [name])
    assert feature_names(disguised) == feature_names(plain)


def test_names_and_values_may_have_colons() -> None:
    odd = deck({"at:t": 1, "t": 2, "kind": "a:b"}, relations={"x:y": frozenset({("a", "b")})})
    assert selected(odd, "odd:at:t")[2:] == ["odd:at:t"]
    assert selected(odd, "is-a:b")[2:] == ["is-a:b:kind"]
    assert selected(odd, "is-a:b:kind")[2:] == ["is-a:b:kind"]
    named = deck({"name": "a"}, relations={"x:y": frozenset({("a", "b")})})
    assert selected(named, "x:y")[2:] == ["x:y:name"]


def refusal(of: Deck, *names: str) -> list[str]:
    with pytest.raises(UnknownFeatureError) as caught:
        select_features(of, names)
    return [str(fault) for fault in caught.value.faults]


@pytest.mark.parametrize(
    ("name", "nearest"),
    [
        ("od", "odd"),
        ("less-then", "less-than"),
        ("lessthan:value", "less-than"),
        ("multiple-of-x", "multiple-of-K"),
        ("multiple-of-0", "multiple-of-K"),
        ("multiple-of-", "multiple-of-K"),
        ("digits-10000000000", "digits-K"),
        ("multiple-of-1000000001", "multiple-of-K"),
        ("above-1234567890123456", "above-K"),
        ("above-1.2.3", "above-K"),
        ("above-³", "above-K"),
        ("is-", "is-K"),
        ("partne", "partner"),
        ("", "cells"),
    ],
)
def test_an_unknown_feature_is_refused_with_the_nearest_known_one(name: str, nearest: str) -> None:
    [told] = refusal(MIXED, name)
    assert "unknown feature" in told
    if name:
        assert told.endswith(f"the nearest is {nearest}")


@pytest.mark.parametrize("name", ["multiple-of-1000000000", "above-123456789012345"])
def test_the_largest_parameter_is_known(name: str) -> None:
    assert selected(NUMBERS, name)


def test_a_feature_that_applies_to_no_attribute_is_refused() -> None:
    letters = deck({"letter": "a"})
    has = "expected a feature of letter (letter)"
    assert refusal(letters, "odd") == [f"odd: no attribute it applies to, {has}"]
    assert refusal(letters, "above-3") == [f"above-3: no attribute it applies to, {has}"]
    assert refusal(letters, "before:day") == [f"before:day: no attribute it applies to, {has}"]
    related = deck({"letter": "a"}, relations={"partner": frozenset({("a", "b")})})
    assert refusal(related, "partner") == [f"partner: no attribute it applies to, {has}"]
    bare = "odd: no attribute it applies to, expected a feature of bare tokens"
    assert refusal(deck({}), "odd") == [bare]


def test_a_value_that_no_token_shows_is_refused() -> None:
    expected = "is-purple: no token shows it, expected a value that some token shows, not purple"
    assert refusal(MIXED, "is-purple") == [expected]


def test_all_wrong_names_are_told_at_once() -> None:
    assert len(refusal(MIXED, "od", "odd", "vowl", "is-purple")) == 3


# ------------------------------------------------------------------ labels


def test_the_names_are_those_of_the_registry_and_of_the_decks_relations() -> None:
    names = feature_names(MIXED)
    assert len(names) == len(set(names))
    families = {f"{name}-K" for name in PARAMETER_FEATURES}
    assert set(names) == {
        *(CELLS, "partner"),
        *CELL_FEATURES,
        *TOKEN_FEATURES,
        *families,
        *PAIR_FEATURES,
        *CONVERSES,
    }


@given(decks(), st.sampled_from([(), ("same", "different"), ("cells", "same")]))
def test_a_label_selects_just_its_feature(of: Deck, names: Sequence[str]) -> None:
    names = names if of.scales else ()
    for feature in select_features(of, names or None):
        assert labelled_feature(of, feature.label) == feature


@pytest.mark.parametrize("label", ["less-than", "greater-than:value", "cells", "odd"])
def test_a_name_that_is_no_label_is_refused_as_one(label: str) -> None:
    with pytest.raises(UnknownFeatureError, match="one feature with its attribute"):
        labelled_feature(MIXED, label)


def test_labels_say_name_and_attribute() -> None:
    features: Sequence[Feature] = (TokenFeature("odd", "value"), PairFeature("same", "value"))
    assert [feature.label for feature in features] == ["odd:value", "same:value"]
    assert CellFeature("origin") in DEFAULT_CELLS


def test_only_what_holds_both_ways_is_symmetric() -> None:
    assert [name for name in PAIR_FEATURES if PairFeature(name, "x").symmetric] == [
        "same",
        "different",
    ]


@given(decks())
def test_the_table_of_a_feature_says_of_every_pair_what_the_feature_says(deck: Deck) -> None:
    shown = [token.attributes for token in deck.tokens]
    features = [
        PairFeature(name, attribute)
        for name, definition in PAIR_FEATURES.items()
        for attribute, scale in deck.scales.items()
        if scale in definition.scales
    ]
    features += [PairFeature(name, NAME) for name in deck.relations if name not in PAIR_FEATURES]
    for feature in features:
        table = pair_feature_table(feature, deck, shown)
        for first, row in zip(shown, table, strict=True):
            said = [bool(row >> place & 1) for place in range(len(shown))]
            assert said == [pair_feature_holds(feature, deck, first, second) for second in shown]


def test_the_table_of_a_relation_leaves_out_tokens_without_a_name() -> None:
    shown: list[Attributes] = [(("name", "cup"),), (("name", "saucer"),), (("value", 1),)]
    tokens = tuple(Token(TokenId(f"{k}"), attributes) for k, attributes in enumerate(shown))
    with_partners = Deck(tokens, relations={"partner": frozenset({("cup", "saucer")})})
    partner = PairFeature("partner", "name")
    assert pair_feature_table(partner, with_partners, shown) == (0b010, 0, 0)
    assert pair_feature_table(PairFeature("same", "name"), with_partners, shown) == (1, 2, 0)
