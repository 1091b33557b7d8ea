"""What a rule looks at: the row, the order in time, which attributes and tests of the tokens.

The search for a completion rests on it: where nothing looks at time, the order of placing is
free, and tokens that no rule tells apart are tried once.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence
from typing import TypeAlias, assert_never

from maestra.core.tokens import NAME
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow
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
from maestra.rules.forms.relations import EachPair, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import Compare, Named, Relation
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Mask, Setting
from maestra.rules.token_tests import TokenTest, passing

Sight: TypeAlias = str | TokenTest
"""An attribute, or a test of one token."""


def lines_of(rule: Rule) -> frozenset[Line]:
    """The lines whose order matters to `rule`; none if only which tokens are in the row does."""
    match rule:
        case (
            Ordered()
            | CyclicOrdered()
            | RiseAndFall()
            | Zigzag()
            | EqualSteps()
            | EachPair()
            | Pattern()
            | Template()
            | Blocks()
            | At()
            | Before()
            | Follows()
        ):
            return frozenset({rule.line})
        case ExtremeAt() | TwoPlaces() | Equation() | Word() | StraightUp() | ModelRow():
            return frozenset({Line.ROW})
        case TakeExtreme() | UntilTotal():
            return frozenset({Line.TIME})
        case FillOrder():
            return frozenset(Line)
        case IfThen(condition, consequence):
            return lines_of(condition) | lines_of(consequence)
        case (
            EveryToken()
            | AllOfThem()
            | Count()
            | CompareCounts()
            | Kinds()
            | Total()
            | Cue()
            | FullRow()
        ):
            return frozenset()
        case _:
            assert_never(rule)


def sights_of(rule: Rule) -> tuple[Sight, ...]:  # noqa: C901 - one for each family
    """The attributes and tests by which `rule` tells tokens apart."""
    match rule:
        case EveryToken(test) | AllOfThem(test) | Count(test) | At(_, test):
            return (test,)
        case CompareCounts(first, _, second) | Before(first, second) | Follows(first, second):
            return (first, second)
        case Pattern(tests):
            return tests
        case TakeExtreme(attribute, _, among):
            return (attribute, among)
        case (
            Ordered(attribute)
            | CyclicOrdered(attribute)
            | RiseAndFall(attribute)
            | Zigzag(attribute)
            | EqualSteps(attribute)
            | ExtremeAt(attribute)
            | Template(attribute)
            | Blocks(attribute)
            | Kinds(attribute)
            | Total(attribute)
            | Equation(attribute)
            | Word(attribute)
            | UntilTotal(attribute)
        ):
            return (attribute,)
        case EachPair(_, relation) | TwoPlaces(_, _, relation):
            return _attributes(relation)
        case ModelRow(_, _, relation) | Cue(_, _, relation):
            # The model and the cue are told by where they lie.
            return (*_attributes(relation), ORIGIN_ROW, ORIGIN_COLUMN)
        case StraightUp():
            return (ORIGIN_COLUMN,)
        case IfThen(condition, consequence):
            return (*sights_of(condition), *sights_of(consequence))
        case FillOrder() | FullRow():
            return ()
        case _:
            assert_never(rule)


def _attributes(relation: Relation) -> tuple[str, ...]:
    match relation:
        case Named():
            return (NAME,)
        case Compare(attribute, _, other):
            return (attribute, other or attribute)
        case _:
            return (relation.attribute,)


def kinds_of_tokens(rules: Sequence[Rule], setting: Setting) -> tuple[Mask, ...]:
    """For each token the set of those that `rules` cannot tell from it, itself among them."""
    sights = dict.fromkeys(sight for rule in rules for sight in sights_of(rule))
    columns: list[Iterable[Hashable]] = [
        setting.values(sight) if isinstance(sight, str) else _passes(setting, sight)
        for sight in sights
    ]
    count = len(setting.deck.tokens)
    signs = list(zip(*columns, strict=True)) if columns else [()] * count
    kinds: dict[Hashable, Mask] = {}
    for token, sign in enumerate(signs):
        kinds[sign] = kinds.get(sign, 0) | 1 << token
    return tuple(kinds[sign] for sign in signs)


def _passes(setting: Setting, test: TokenTest) -> Iterator[bool]:
    mask = passing(setting, test)
    return (bool(mask >> token & 1) for token in range(len(setting.deck.tokens)))
