"""Where tokens come from, and what of the start stays and is followed."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations, product
from typing import Final

from maestra.learning.fewshot.families.base import (
    Proposal,
    along_lines,
    crossing,
    each,
    later,
)
from maestra.learning.fewshot.prior import Kind, one_of
from maestra.learning.fewshot.shown import Shown
from maestra.rules.forms.base import Direction
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.pairs import Named, Relation, Step, different, same
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, bits
from maestra.rules.token_tests import Extreme, Not, has, passing

HOLE_BITS: Final = 2.0
"""For each goal cell that a model row has no token for: one with holes is seldom meant for one."""


def sources(shown: Shown) -> Iterator[Proposal]:
    """Where tokens come from."""
    rows, columns = shown.origins[ORIGIN_ROW], shown.origins[ORIGIN_COLUMN]
    seldom_row, seldom_column = one_of(len(rows)) + 3, one_of(len(columns)) + 3
    yield from each(Kind.FROM_ROW, map(EveryToken, rows))
    yield from each(Kind.FROM_ROW, (EveryToken(Not(row)) for row in rows), seldom_row)
    yield from each(Kind.FROM_ROW, map(AllOfThem, rows), seldom_row)
    yield from each(Kind.FROM_COLUMN, map(EveryToken, columns))
    yield from each(Kind.FROM_COLUMN, (EveryToken(Not(c)) for c in columns), seldom_column)
    yield Proposal(Kind.STRAIGHT_UP, (StraightUp(),), 0.0)
    for row in rows:
        yield Proposal(Kind.ROW_UP, (EveryToken(row), StraightUp()))
    yield Proposal(Kind.STRAIGHT_UP, (StraightUp(mirrored=True),), 1.0)
    yield from along_lines(
        shown,
        Kind.ROWS_IN_TURN,
        lambda line: (Pattern(two, repeat=True, line=line) for two in permutations(rows, 2)),
    )
    takes = (TakeExtreme(ORIGIN_COLUMN, extreme) for extreme in Extreme)
    yield from each(Kind.TAKE_FIRST, takes, 1.0)
    yield from _origins_in_order(shown)
    yield from _origins_in_pairs()


def _origins_in_order(shown: Shown) -> Iterator[Proposal]:
    """The columns or rows that tokens come from rise or fall."""
    for attribute, direction, strict in product(
        (ORIGIN_COLUMN, ORIGIN_ROW), Direction, (False, True)
    ):
        cost = 1.0 + (attribute == ORIGIN_ROW) + 1.5 * strict
        for line in shown.lines:
            rule = Ordered(attribute, direction, strict, line)
            yield Proposal(Kind.ORIGIN_ORDER, (rule,), cost + later(line))


def _origins_in_pairs() -> Iterator[Proposal]:
    """All tokens, or neighbours, come from the same column or row, or from different ones."""
    for attribute, relates, which in product(
        (ORIGIN_COLUMN, ORIGIN_ROW), (different, same), (Pairs.ALL, Pairs.NEIGHBOURS)
    ):
        seldom = 2.0 if which is Pairs.NEIGHBOURS else 0.0
        yield Proposal(Kind.ORIGIN_PAIRS, (EachPair(which, relates(attribute)),), 1.0 + seldom)


def contexts(shown: Shown) -> Iterator[Proposal]:
    """Rows and single tokens of the start that stay and are followed."""
    followed = [
        *map(same, shown.named_attributes),
        *map(Named, shown.setting.deck.relations),
        *crossing(shown),
    ]
    played = sum(1 << token for token in shown.plays[0].tokens)
    for number in range(1, shown.setting.start.board.rows):
        here = passing(shown.setting, has(f"is-{number}", ORIGIN_ROW))
        if here and not here & played:
            holes = shown.setting.length - here.bit_count()
            yield from _model_rows(shown, number, followed, HOLE_BITS * holes)
    columns = shown.setting.values(ORIGIN_COLUMN)
    storage = shown.setting.values(ORIGIN_ROW)
    for token in bits(shown.plays[0].left):
        place = int(str(storage[token])), int(str(columns[token]))
        yield from each(Kind.CUE, (Cue(*place, relation) for relation in followed))


def _model_rows(
    shown: Shown, number: int, followed: list[Relation], seldom: float
) -> Iterator[Proposal]:
    """Storage row `number`, read one way or another, is followed; seldom one step further on."""
    steps = [Step(attribute, n) for attribute in shown.ordinal for n in (1, -1)]
    choices = seldom + one_of(3 * (shown.setting.start.board.rows - 1))
    for reading in Reading:
        for relation in followed:
            cost = choices + one_of(len(followed))
            yield Proposal(Kind.MODEL_ROW, (ModelRow(number, reading, relation),), cost)
        for step in steps:
            cost = choices + one_of(len(steps)) + 3.0
            yield Proposal(Kind.MODEL_ROW, (ModelRow(number, reading, step),), cost)
