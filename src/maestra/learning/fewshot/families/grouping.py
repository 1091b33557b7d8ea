"""Kinds together and apart, partners, and patterns that repeat."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations
from math import perm
from typing import Final

from maestra.learning.fewshot.families.base import (
    Proposal,
    along_lines,
    crossing,
    each,
    later,
    pairs,
)
from maestra.learning.fewshot.prior import Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.patterns import Blocks, Pattern, Template, given_row
from maestra.rules.forms.relations import Pairs
from maestra.rules.pairs import Named, Relation, different, same
from maestra.rules.setting import Line

REPEATED: Final = ("ABC", "AAB", "ABB", "AABB")
"""Templates that repeat, besides the alternating one."""
OF_THREE: Final = 3
"""Named kinds that take turns, where they are more than two."""


def groupings(shown: Shown) -> Iterator[Proposal]:
    """Kinds together and apart, and partners."""
    names = shown.named_attributes
    alike: list[Relation] = [same(name) for name in names]
    other: list[Relation] = [different(name) for name in names]
    named: list[Relation] = [Named(name) for name in shown.setting.deck.relations]
    yield from along_lines(shown, Kind.BLOCKS, lambda line: (Blocks(n, line) for n in names))
    yield from along_lines(shown, Kind.NEIGHBOURS_DIFFER, pairs(Pairs.NEIGHBOURS, other))
    for kind, which, relations in (
        (Kind.ALL_ALIKE, Pairs.ALL, alike),
        (Kind.ALL_DIFFERENT, Pairs.ALL, other),
        (Kind.MIRRORED, Pairs.MIRRORED, alike),
        (Kind.PAIRED_ALIKE, Pairs.TWO_BY_TWO, alike),
        (Kind.PARTNERS, Pairs.TWO_BY_TWO, named),
        (Kind.NEIGHBOURS_RELATED, Pairs.NEIGHBOURS, named),
        (Kind.NEIGHBOURS_RELATED, Pairs.MIRRORED, named),
        (Kind.NEIGHBOURS_RELATED, Pairs.FIRST_WITH_REST, named),
        (Kind.NEIGHBOURS_RELATED, Pairs.ALL, named),
        (Kind.NEIGHBOURS_RELATED, Pairs.NEIGHBOURS, crossing(shown)),
        (Kind.NEIGHBOURS_RELATED, Pairs.FIRST_WITH_REST, crossing(shown)),
    ):
        yield from each(kind, pairs(which, relations)(Line.ROW))


def patterns(shown: Shown) -> Iterator[Proposal]:
    """Rows and templates that repeat, and the same row every time."""
    yield from along_lines(
        shown,
        Kind.ALTERNATING,
        lambda line: (
            *(Pattern(two, repeat=True, line=line) for two in shown.contrasts),
            *(Template(name, "AB", repeat=True, line=line) for name in shown.named_attributes),
        ),
    )
    for line in shown.lines:
        for name in shown.named_attributes:
            yield from _repeating(shown, name, line)
            yield from _templates(shown, name, line)
    for attribute in shown.setting.deck.scales:
        yield from _given_rows(shown, attribute)


def _repeating(shown: Shown, attribute: str, line: Line) -> Iterator[Proposal]:
    """Three named kinds in turn; other templates that repeat."""
    cost = later(line) + one_of(len(shown.named_attributes))
    tests = shown.kinds[attribute]
    for three in permutations(tests, OF_THREE):
        rule = Pattern(three, repeat=True, line=line)
        yield Proposal(Kind.REPEATED, (rule,), cost + one_of(perm(len(tests), OF_THREE)))
    for letters in REPEATED:
        template = Template(attribute, letters, repeat=True, line=line)
        yield Proposal(Kind.REPEATED, (template,), cost + 2)


def _templates(shown: Shown, attribute: str, line: Line) -> Iterator[Proposal]:
    """The templates that were shown; the odd one out at an end is a usual one."""
    cost = later(line) + one_of(len(shown.named_attributes))
    length = shown.setting.length
    one_out = ("A" * (length - 1) + "B", "A" + "B" * (length - 1))
    for letters in shown.templates_of(attribute, line):
        usual = letters in one_out
        amount = 0.5 if usual else length - 1 + (len(set(letters)) - 2) * 3.0
        yield Proposal(Kind.TEMPLATE, (Template(attribute, letters, line=line),), cost + amount)


def _given_rows(shown: Shown, attribute: str) -> Iterator[Proposal]:
    """The very rows that were shown: of kinds, or of named tokens."""
    length = shown.setting.length
    for row in shown.rows_of(attribute):
        rule = given_row(attribute, row)
        if attribute in shown.kinds:
            values = len(set(shown.setting.values(attribute)))
            cost = length * one_of(values) + one_of(len(shown.named_attributes))
            yield Proposal(Kind.TEMPLATE_NAMED, (rule,), cost)
        else:
            cost = one_of(perm(shown.setting.movable.bit_count(), length))
            yield Proposal(Kind.GIVEN_ROW, (rule,), cost)
