"""What two tokens are to each other: the quick look-up says what the plain definition says."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from itertools import product
from typing import assert_never

import pytest

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.pairs import (
    AddUp,
    Apart,
    Compare,
    Named,
    Relation,
    Step,
    Times,
    converse,
    related,
)
from maestra.rules.setting import Setting
from maestra.rules.token_tests import Comparison

DAYS = ("Mon", "Tue", "Wed", "Thu", "Fri")
SIZES = ("small", "medium", "large")
TOKENS: tuple[tuple[tuple[str, Value], ...], ...] = (
    (("name", "a"), ("value", 1), ("other", 2), ("day", "Mon"), ("size", "small")),
    (("name", "b"), ("value", 2), ("other", 1), ("day", "Fri"), ("size", "large")),
    (("name", "c"), ("value", Decimal("0.5")), ("day", "Wed"), ("size", "medium")),
    (("name", "d"), ("value", 4), ("other", 4), ("day", "Mon")),
    (("name", "e"), ("other", 2), ("size", "small")),
    (("value", 0), ("day", "Tue")),
)
DECK = Deck(
    tuple(Token(TokenId(f"t{k}"), shown) for k, shown in enumerate(TOKENS)),
    {"size": SIZES},
    {"day": DAYS},
    {"partner": frozenset({("a", "b"), ("c", "d"), ("d", "c"), ("e", "e")})},
)
SETTING = Setting(
    DECK,
    State(
        Board(4, 3),
        {t.id: cell for t, cell in zip(DECK.tokens, Board(4, 3).storage_cells, strict=False)},
    ),
)
ATTRIBUTES = ("value", "other", "day", "size", "missing")
AMOUNTS: tuple[int | Decimal, ...] = (0, 1, 2, 3, -1, Decimal("0.5"))
RELATIONS: tuple[Relation, ...] = (
    *(Compare(*one) for one in product(ATTRIBUTES, Comparison, (None, "other", "value"))),
    *(
        relation(attribute, amount)
        for attribute in ATTRIBUTES
        for amount in AMOUNTS
        for relation in (Step, Apart, Times, AddUp)
    ),
    *(Named(*one) for one in product(("partner", "stranger"), (True, False))),
)


def relates(relation: Relation, one: int, two: int) -> bool:
    """The definition, for one pair of tokens."""
    shown = [dict(token.attributes) for token in DECK.tokens]
    match relation:
        case Named(name, directed):
            pairs = DECK.relations.get(name, frozenset())
            pair = (str(shown[one].get("name")), str(shown[two].get("name")))
            return pair in pairs or (not directed and pair[::-1] in pairs)
        case Compare(attribute, Comparison.EQUAL | Comparison.DIFFERENT, other):
            first, second = shown[one].get(attribute), shown[two].get(other or attribute)
            equal = relation.comparison is Comparison.EQUAL
            return first is not None and second is not None and (first == second) is equal
        case Compare(attribute, comparison, other):
            ranks = SETTING.ranks(attribute)[one], SETTING.ranks(other or attribute)[two]
            return None not in ranks and comparison.holds(ranks[0] or 0, ranks[1] or 0)
        case Step() | Apart() | Times() | AddUp():
            a, b = (SETTING.ranks(relation.attribute)[token] for token in (one, two))
            return a is not None and b is not None and amounts_to(relation, a, b)
        case _:
            assert_never(relation)


def amounts_to(
    relation: Step | Apart | Times | AddUp, one: int | Fraction, two: int | Fraction
) -> bool:
    """The arithmetic of it; steps on a cycle go round."""
    amount = Fraction(relation.amount)
    around = len(DECK.cycles.get(relation.attribute, ()))
    match relation:
        case Step():
            return is_the_same(two - one, amount, around)
        case Apart():
            return any(is_the_same(two - one, n, around) for n in (amount, -amount))
        case Times():
            return two == one * amount
        case AddUp():
            return one + two == amount
        case _:
            assert_never(relation)


def is_the_same(one: int | Fraction, two: int | Fraction, around: int) -> bool:
    return (one - two) % around == 0 if around else one == two


@pytest.mark.parametrize("relation", RELATIONS, ids=str)
def test_related_tokens_are_those_of_the_definition(relation: Relation) -> None:
    tokens = range(len(DECK.tokens))
    wanted = tuple(sum(1 << b for b in tokens if relates(relation, a, b)) for a in tokens)
    assert related(SETTING, relation) == wanted


def test_some_pairs_stand_in_each_kind_of_relation() -> None:
    kinds = {type(relation) for relation in RELATIONS if any(related(SETTING, relation))}
    assert kinds == {Compare, Step, Apart, Times, AddUp, Named}


@pytest.mark.parametrize("relation", RELATIONS[::7], ids=str)
def test_the_converse_has_the_same_pairs(relation: Relation) -> None:
    masks = related(SETTING, relation)
    back = converse(SETTING, masks)
    for one, two in product(range(len(masks)), repeat=2):
        assert masks[one] >> two & 1 == back[two] >> one & 1
