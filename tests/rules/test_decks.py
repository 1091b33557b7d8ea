import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.faults import InvalidError
from maestra.core.tokens import Attributes, Deck, Token, TokenId, Value
from maestra.rules.decks import merge_decks

DAYS = ("Mon", "Tue")


def token(name: str, value: Value, attribute: str = "value") -> Token:
    return Token(TokenId(name), ((attribute, value),))


def shown(deck: Deck) -> set[Attributes]:
    return {one.attributes for one in deck.tokens}


def test_one_deck_is_itself() -> None:
    deck = Deck((token("a", 1),))
    assert merge_decks([deck]) is deck
    assert merge_decks([deck, Deck((token("a", 1),)), deck]) is deck


def test_tokens_that_show_something_new_are_added() -> None:
    merged = merge_decks(
        [
            Deck((token("a", 1), token("b", 1))),
            Deck((token("c", 1), token("d", 2), token("e", 2))),
            Deck((token("f", 2), token("g", 3))),
        ]
    )
    assert [one.id for one in merged.tokens] == ["a", "b", "d", "e", "g"]


def test_what_any_deck_declares_counts() -> None:
    one = Deck((token("a", 1),), orders={"day": DAYS}, lexicon=("CURIE",))
    two = Deck((token("b", 2),), cycles={"week": DAYS}, relations={"r": frozenset({("x", "y")})})
    merged = merge_decks([one, two, Deck((token("c", 3),))])
    assert merged.orders == {"day": DAYS}
    assert merged.cycles == {"week": DAYS}
    assert merged.relations == {"r": frozenset({("x", "y")})}
    assert merged.lexicon == ("CURIE",)


@pytest.mark.parametrize(
    ("second", "where"),
    [
        (Deck((token("a", 2),)), "tokens.a"),
        (Deck((token("b", 1),), orders={"day": ("Tue", "Mon")}), "orders.day"),
        (Deck((token("b", 1),), cycles={"week": ("Tue", "Mon")}), "cycles.week"),
        (Deck((token("b", 1),), relations={"r": frozenset({("y", "x")})}), "relations.r"),
        (Deck((token("b", 1),), lexicon=("PIERRE",)), "lexicon.words"),
    ],
)
def test_a_deck_that_says_something_else_is_refused(second: Deck, where: str) -> None:
    first = Deck(
        (token("a", 1),),
        {"day": DAYS},
        {"week": DAYS},
        {"r": frozenset({("x", "y")})},
        ("CURIE",),
    )
    for decks in ([first, first, second], [first, first, second, second]):
        with pytest.raises(InvalidError) as caught:
            merge_decks(decks)
        [fault] = caught.value.faults
        assert fault.where == f"demonstration 3: {where}"
        assert (fault.found, fault.expected) == (
            "something else than before",
            "the same everywhere",
        )


def test_what_one_deck_declares_must_fit_the_tokens_of_the_others() -> None:
    ordered = Deck((token("a", "Mon", "day"),), orders={"day": DAYS})
    with pytest.raises(InvalidError, match=r"a value of orders\.day"):
        merge_decks([ordered, Deck((token("b", "Sun", "day"),))])


@given(st.data())
def test_the_order_of_decks_changes_neither_what_is_shown_nor_whether_they_fit(
    data: st.DataObject,
) -> None:
    tokens = st.builds(token, st.sampled_from("abc"), st.integers(1, 3))
    decks = data.draw(
        st.lists(
            st.lists(tokens, min_size=1, max_size=3, unique_by=lambda one: one.id).map(
                lambda some: Deck(tuple(some))
            ),
            min_size=1,
            max_size=4,
        )
    )
    found: list[set[Attributes] | None] = []
    for order in (decks, data.draw(st.permutations(decks))):
        try:
            found.append(shown(merge_decks(order)))
        except InvalidError:
            found.append(None)
    assert found[0] == found[1]
    fits = len({(one.id, one.attributes) for deck in decks for one in deck.tokens}) == len(
        {one.id for deck in decks for one in deck.tokens}
    )
    assert (found[0] is not None) == fits
