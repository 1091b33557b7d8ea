"""Decks from what a caregiver writes."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Scale
from maestra.web.teach import decks

NONE: frozenset[str] = frozenset()


def values(deck: Deck, name: str) -> list[str]:
    return sorted(str(token.value(name)) for token in deck.tokens)


@pytest.mark.parametrize("which", decks.Ready)
def test_each_ready_deck_fits_the_papers_board(which: decks.Ready) -> None:
    deck = decks.ready_deck(which, str)
    assert decks.board_for(deck) == Board()
    assert len(deck.tokens) >= 9


def test_numbers_go_from_one_to_another_in_either_direction() -> None:
    assert values(decks.numbers_deck(9, 1, 4), "value") == ["1", "5", "9"]
    assert len(decks.numbers_deck(1, 3, 0).tokens) == 3


def test_numbers_are_listed_with_fractions_and_twice() -> None:
    deck = decks.listed_deck("3; 0.5 3,  -2")
    assert values(deck, "value") == ["-2", "0.5", "3", "3"]
    assert len({token.id for token in deck.tokens}) == 4


def test_letters_and_words_are_what_was_written() -> None:
    assert values(decks.letters_deck("c u-r1"), "letter") == ["C", "R", "U"]
    deck = decks.words_deck("apple, fruit\n\n dog \n, animal\n,")
    assert values(deck, "word") == ["None", "apple", "dog"]
    assert values(deck, "category") == ["None", "animal", "fruit"]


def test_colours_and_shapes_are_combined_or_stand_alone() -> None:
    assert len(decks.shapes_deck(["red", "blue"], ["circle", "star", "cross"]).tokens) == 6
    assert len(decks.shapes_deck(["red", "blue"], []).tokens) == 2
    assert len(decks.shapes_deck([], ["circle"]).tokens) == 1


def test_pictures_are_added_to_those_that_are_there() -> None:
    one = decks.pictures_deck(["cup"])
    assert values(decks.pictures_deck(["dog"], one.tokens), "picture") == ["cup", "dog"]


@pytest.mark.parametrize("which", decks.Ready)
def test_a_deck_as_a_table_is_the_same_deck(which: decks.Ready) -> None:
    deck = decks.ready_deck(which, str)
    again = decks.deck_of(decks.table_of(deck))
    shown = [sorted(map(str, (t.attributes for t in one.tokens))) for one in (again, deck)]
    assert shown[0] == shown[1]


def test_words_in_the_order_of_the_table_are_ordered() -> None:
    days = ("Monday", "Tuesday", "Wednesday")
    rows = tuple(("", (day, "")) for day in days)
    table = decks.Table(("day", " "), frozenset({"day"}), rows, ("CAT",))
    deck = decks.deck_of(table)
    assert deck.scales == {"day": Scale.ORDER}
    assert deck.orders["day"] == days
    assert deck.lexicon == ("CAT",)
    assert [shown for _, (shown,) in decks.table_of(deck).rows] == list(days)


def test_a_column_of_numbers_is_of_numbers_and_any_other_of_words() -> None:
    table = decks.Table(("a", "b"), frozenset(), (("", ("1", "2")), ("", ("x", ""))))
    deck = decks.deck_of(table)
    assert deck.scales == {"a": Scale.NOMINAL, "b": Scale.NUMBER}


WRONG: dict[str, Callable[[], object]] = {
    "too many numbers": lambda: decks.numbers_deck(1, 1000, 1),
    "a word among numbers": lambda: decks.listed_deck("1 two"),
    "a number too large": lambda: decks.listed_deck("1e999999"),
    "not a number": lambda: decks.listed_deck("nan"),
    "no number": lambda: decks.listed_deck(""),
    "no letter": lambda: decks.letters_deck("123"),
    "a word too long": lambda: decks.words_deck("x" * 41),
    "too many words": lambda: decks.words_deck("\n".join(map(str, range(80)))),
    "too many properties": lambda: decks.deck_of(decks.Table(tuple("abcdefg"), NONE, ())),
    "twice": lambda: decks.deck_of(decks.Table(("a", "a"), NONE, (("", ("1", "2")),))),
    "no room": lambda: decks.board_for(decks.numbers_deck(1, 70, 1)),
    "too few rows": lambda: decks.sized(1, 5, goal_at_the_end=False),
    "too wide": lambda: decks.sized(4, 11, goal_at_the_end=True),
    "too high": lambda: decks.fit(Board(9, 5)),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_makes_no_deck_or_board_is_refused(wrong: str) -> None:
    with pytest.raises(InvalidError):
        WRONG[wrong]()


@given(st.text(max_size=60))
def test_whatever_is_written_makes_a_deck_or_is_refused(text: str) -> None:
    for make in (decks.listed_deck, decks.letters_deck, decks.words_deck):
        try:
            deck = make(text)
        except InvalidError:
            continue
        assert deck.tokens


def test_a_board_grows_with_its_tokens_and_keeps_its_goal_row() -> None:
    deck = decks.numbers_deck(1, 30, 1)
    board = decks.board_for(deck)
    assert (board.rows, board.columns, board.goal_row) == (7, 5, 1)
    bottom = decks.sized(4, 5, goal_at_the_end=True)
    assert bottom.goal_row == 4
    assert decks.board_for(decks.numbers_deck(1, 5, 1), bottom) == bottom
