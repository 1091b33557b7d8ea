import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.features import PairFeature, TokenFeature, select_features
from maestra.rules.strips.literals import Contains, Placed, Related, Shows
from maestra.rules.strips.vocabulary import Level, Vocabulary, positions
from tests.rules import by_definition
from tests.rules.lessons import Lesson, lessons

DECK = Deck(tuple(Token(TokenId(f"t{n}"), (("value", n),)) for n in (1, 2, 3)))


def cell(row: int, column: int) -> Cell:
    return Cell(Row(row), Column(column))


def vocabulary(level: Level, *names: str) -> Vocabulary:
    return Vocabulary(Board(2, 2), DECK, level, select_features(DECK, names or None))


@given(lessons())
def test_the_literals_are_those_of_the_definition_each_once(lesson: Lesson) -> None:
    literals = lesson.vocabulary.literals
    assert len(literals) == len(set(literals)) == lesson.vocabulary.size
    assert set(literals) == set(by_definition.every_literal(lesson.vocabulary))


@given(lessons())
def test_the_bits_that_hold_are_the_literals_that_hold_by_definition(lesson: Lesson) -> None:
    words, index = lesson.vocabulary, lesson.vocabulary.index_of_token
    for play in lesson.demonstrations:
        for state, move in zip(play.states(), play.moves, strict=False):
            contents = {at: index[token] for token, at in state.cells.items()}
            found = words.holding(contents, index[move.token], move.origin, move.destination)
            expected = {
                one for one in words.literals if by_definition.holds(one, words.deck, state, move)
            }
            assert set(words.select(found)) == expected
            assert found == words.bits(expected)


@given(lessons())
def test_a_literal_is_at_its_place(lesson: Lesson) -> None:
    words = lesson.vocabulary
    assert [words.place_of(one) for one in words.literals] == list(range(words.size))
    assert words.everything == (1 << words.size) - 1
    assert words.bits(words.literals) == words.everything


@given(st.integers(0, 2**200))
def test_the_positions_of_bits_are_where_they_are_set(bits: int) -> None:
    found = list(positions(bits))
    assert found == sorted(found)
    assert sum(1 << place for place in found) == bits


@pytest.mark.parametrize(
    ("level", "kinds", "cells"),
    [
        (Level.A, {Placed, Related}, {cell(1, 1), cell(1, 2)}),
        (Level.B, {Placed, Related, Shows, Contains}, {cell(1, 1), cell(1, 2)}),
        (Level.C, {Placed, Related, Shows, Contains}, set(Board(2, 2).cells)),
    ],
)
def test_a_level_says_what_may_be_mentioned(
    level: Level, kinds: set[type], cells: set[Cell]
) -> None:
    words = vocabulary(level)
    assert {type(literal) for literal in words.literals} == kinds
    spoken_of = {one.cell for one in words.literals if not isinstance(one, Placed)}
    assert spoken_of == set(words.watched) == cells


def test_features_are_told_apart_by_what_they_look_at() -> None:
    words = vocabulary(Level.B, "origin", "odd", "less-than")
    assert [one.name for one in words.cell_features] == ["from-storage", "to-goal-row", "origin"]
    assert words.pair_features == (PairFeature("less-than", "value"),)
    assert words.token_features == (TokenFeature("odd", "value"),)
    assert vocabulary(Level.A, "odd").token_features == ()


def test_a_literal_of_another_vocabulary_has_no_place() -> None:
    words = vocabulary(Level.A, "less-than")
    elsewhere = (
        Related(cell(2, 1), PairFeature("less-than", "value"), converse=False),
        Related(cell(1, 1), PairFeature("same", "value"), converse=False),
        Contains(cell(1, 1), (("value", 1),)),
        Placed(words.cell_features[0], 7),
    )
    for literal in elsewhere:
        with pytest.raises(KeyError):
            words.place_of(literal)
    with pytest.raises(IndexError):
        words.literal_at(words.size)


def test_tokens_that_look_the_same_are_one_thing_shown() -> None:
    deck = Deck(tuple(Token(TokenId(name), (("value", 1),)) for name in "xyz"))
    words = Vocabulary(Board(2, 2), deck, Level.B, select_features(deck, None))
    assert words.shown == ((("value", 1),),)
    assert words.index_of_token == {TokenId("x"): 0, TokenId("y"): 0, TokenId("z"): 0}


def test_another_deck_is_read_by_what_its_tokens_show() -> None:
    other = Deck((Token(TokenId("z"), (("value", 3),)), Token(TokenId("a"), (("value", 1),))))
    words = vocabulary(Level.A)
    assert words.indices(other) == {TokenId("z"): 2, TokenId("a"): 0}
    assert words.indices(DECK) is words.index_of_token


def test_a_deck_that_shows_something_unknown_is_refused_with_every_such_token() -> None:
    other = Deck(tuple(Token(TokenId(f"z{n}"), (("value", n),)) for n in (3, 4, 5)))
    with pytest.raises(InvalidError) as caught:
        vocabulary(Level.A).indices(other)
    assert [fault.where for fault in caught.value.faults] == ["tokens.z4", "tokens.z5"]
