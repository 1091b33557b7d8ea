"""What is asked of one place or two, and the words of a lexicon."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from maestra.learning.fewshot.families.base import Proposal, each
from maestra.learning.fewshot.prior import ALONG_TIME_BITS, Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.base import FIRST, LAST, MIDDLE, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.relations import TwoPlaces
from maestra.rules.forms.words import Word
from maestra.rules.pairs import Compare, Named, Relation, different, same
from maestra.rules.setting import Line
from maestra.rules.token_tests import Comparison


def places(shown: Shown) -> Iterator[Proposal]:
    """What is asked of one place or two, and conditions on the ends."""
    yield from _one_place(shown)
    ends = (
        IfThen(At(FIRST, one), At(LAST, last))
        for one, two in shown.contrasts
        for last in (one, two)
    )
    yield from each(Kind.IF_THEN, ends)
    yield from _two_places(shown)


def _one_place(shown: Shown) -> Iterator[Proposal]:
    """At an end or the middle; anywhere else; first or last in time."""
    tests = shown.kinds_and_features
    length = shown.setting.length
    ends = [FIRST, LAST, *([MIDDLE] if length % 2 else [])]
    between = [Position(k) for k in range(2, length) if length + 1 != 2 * k]
    yield from each(Kind.AT_END, (At(place, test) for place in ends for test in tests))
    yield from each(Kind.AT_PLACE, (At(place, test) for place in between for test in tests))
    if shown.timed:
        cost = ALONG_TIME_BITS + one_of(2 * len(tests))
        timed = (At(place, test, Line.TIME) for place in (FIRST, LAST) for test in tests)
        yield from each(Kind.AT_END, timed, cost)


def _two_places(shown: Shown) -> Iterator[Proposal]:
    """The first and the last, seldom other two places, are alike, different, related, in order."""
    relations: list[Relation] = [r(a) for a in shown.named_attributes for r in (same, different)]
    relations += [Named(name) for name in shown.setting.deck.relations]
    relations += [
        Compare(a, order) for a in shown.ordinal for order in (Comparison.LESS, Comparison.MORE)
    ]
    spots = [*map(Position, range(1, shown.setting.length)), LAST]
    for one, two in combinations(spots, 2):
        kind = Kind.TWO_PLACES if (one, two) == (FIRST, LAST) else Kind.TWO_PLACES_FAR
        yield from each(kind, (TwoPlaces(one, two, relation) for relation in relations))


def words(shown: Shown) -> Iterator[Proposal]:
    """Any word of the lexicon, or any that a relation pairs with a value: any bird."""
    deck = shown.setting.deck
    if not deck.lexicon:
        return
    yield Proposal(Kind.WORD, (Word(),), 0.0)
    paired = (
        Word(relation=name, value=value)
        for name, related in deck.relations.items()
        for value in sorted({value for _, value in related})
    )
    yield from each(Kind.WORD_OF, paired)
