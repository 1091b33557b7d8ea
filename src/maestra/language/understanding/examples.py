"""Rules that make sense of a deck: what a caregiver may have wanted to say."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import Final

from maestra.core.board import Board
from maestra.core.tokens import Deck, Scale, Value
from maestra.rules.features import TokenFeature
from maestra.rules.fields import Position
from maestra.rules.fitting import misfits
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Direction
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Equation, Kinds, Total
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme, from_row
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Named, Relation, Step, different, same
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import Among, Comparison, Extreme, Has, Not, TokenTest

MAX_VALUES: Final = 8
"""Of one attribute: more examples of the same kind say nothing new."""
MAX_TESTS: Final = 24
_SECOND: Final = Position(2)


def rules_like(deck: Deck, board: Board) -> tuple[Rule, ...]:
    """Rules of every form that fit the deck, the simplest of each form."""
    found = dict.fromkeys(rule for rule in _rules(deck, board) if not misfits([rule], deck))
    return tuple(found)


def _rules(deck: Deck, board: Board) -> Iterator[Rule]:
    tests = tuple(_tests(deck))[:MAX_TESTS]
    yield from (FillOrder(filling) for filling in Filling)
    yield from (FullRow(), StraightUp(), StraightUp(mirrored=True), Word())
    for test in tests:
        yield from _about(test)
    for one, other in combinations(tests, 2):
        if _attribute(one) == _attribute(other):
            yield from _about_two(one, other)
    for attribute, scale in deck.scales.items():
        yield from _about_attribute(attribute, scale, deck)
    for row in range(1, board.rows):
        yield from_row(row)
        yield EveryToken(Not(from_row(row).test))
    for attribute in (ORIGIN_COLUMN, ORIGIN_ROW):
        yield from (TakeExtreme(attribute, extreme) for extreme in Extreme)
    for name in sorted(deck.relations):
        yield EachPair(Pairs.NEIGHBOURS, Named(name))
        yield EachPair(Pairs.TWO_BY_TWO, Named(name))


def _tests(deck: Deck) -> Iterator[Has]:
    for attribute, scale in deck.scales.items():
        for name in _FEATURES.get(scale, ()):
            yield Has(TokenFeature(name, attribute))
        values = _values(deck, attribute)
        if scale is Scale.NUMBER:
            middle = values[len(values) // 2]
            yield Has(TokenFeature(f"above-{middle}", attribute))
            yield Has(TokenFeature(f"below-{middle}", attribute))
        for value in values[:MAX_VALUES]:
            yield Has(TokenFeature(f"is-{value}", attribute))


_FEATURES: Final = {
    Scale.NUMBER: ("odd", "even", "multiple-of-5"),
    Scale.LETTER: ("vowel", "consonant"),
}


def _values(deck: Deck, attribute: str) -> list[Value]:
    shown = {value for token in deck.tokens if (value := token.value(attribute)) is not None}
    return sorted(shown, key=lambda value: (isinstance(value, str), value))


def _attribute(test: Has) -> str:
    return test.feature.attribute


def _about(test: TokenTest) -> Iterator[Rule]:
    yield EveryToken(test)
    yield EveryToken(Not(test))
    yield AllOfThem(test)
    yield Count(test, Comparison.EQUAL, 2)
    yield Count(test, Comparison.AT_LEAST, 1)
    yield At(FIRST, test)
    yield At(LAST, test)
    yield At(FIRST, test, Line.TIME)


def _about_two(one: TokenTest, other: TokenTest) -> Iterator[Rule]:
    yield Before(one, other)
    yield Before(one, other, Line.ROW)
    yield CompareCounts(one, Comparison.MORE, other)
    yield Follows(one, other)
    yield Pattern((one, other), repeat=True)
    yield IfThen(At(FIRST, one), At(LAST, other))


def _about_attribute(attribute: str, scale: Scale, deck: Deck) -> Iterator[Rule]:
    yield from _alike(attribute)
    if scale is Scale.NOMINAL:
        return
    for direction in Direction:
        yield Ordered(attribute, direction)
        yield Ordered(attribute, direction, strict=False)
        yield Ordered(attribute, direction, line=Line.TIME)
        yield RiseAndFall(attribute, direction)
    if scale is Scale.CYCLE:
        yield from (CyclicOrdered(attribute, direction) for direction in Direction)
    yield Zigzag(attribute)
    yield EqualSteps(attribute)
    yield EachPair(Pairs.NEIGHBOURS, Step(attribute, 1))
    for extreme in Extreme:
        yield from (ExtremeAt(attribute, extreme, place) for place in (FIRST, MIDDLE, LAST))
        yield TakeExtreme(attribute, extreme)
        yield EveryToken(Among(attribute, extreme, 5))
    if scale is Scale.NUMBER:
        yield from _sums(attribute, deck)


def _alike(attribute: str) -> Iterator[Rule]:
    relations: tuple[Relation, ...] = (same(attribute), different(attribute))
    for relation in relations:
        yield EachPair(Pairs.NEIGHBOURS, relation)
        yield EachPair(Pairs.ALL, relation)
        yield TwoPlaces(FIRST, LAST, relation)
    yield EachPair(Pairs.MIRRORED, same(attribute))
    yield EachPair(Pairs.FIRST_WITH_REST, same(attribute))
    yield Template(attribute, "AB", repeat=True)
    yield Blocks(attribute)
    yield Kinds(attribute, Comparison.EQUAL, 2)
    yield from (ModelRow(1, reading, same(attribute)) for reading in Reading)
    yield Cue(1, 1, same(attribute))


def _sums(attribute: str, deck: Deck) -> Iterator[Rule]:
    numbers = [value for value in _values(deck, attribute) if not isinstance(value, str)]
    some = numbers[-1] + numbers[0]
    yield Total(attribute, Comparison.EQUAL, some)
    yield Total(attribute, Comparison.AT_MOST, some)
    yield UntilTotal(attribute, some)
    yield Equation(attribute, (FIRST, _SECOND), (LAST,))
    yield EachPair(Pairs.TWO_BY_TWO, AddUp(attribute, some))
    yield EachPair(Pairs.NEIGHBOURS, Step(attribute, 2))
