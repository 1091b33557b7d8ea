"""What the few-shot learner believes before it sees anything: all of its numbers in one place.

A hypothesis is a conjunction of rules. Its prior is 2^-bits: for each rule `RULE_BITS`, for people
use few rules; the weight of its form (`maestra.rules.description.FORMS`), shared equally by all
rules of its kind that the deck and the board suggest; and what `surcharge` says. The likelihood
of a demonstration is the habit-weighted share it has of all plays that the hypothesis allows.

The numbers marked "tuned" were set on the seeds 0 to 999 of `maestra.experiments.fewshot`.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import log2
from types import MappingProxyType
from typing import Final

from maestra.learning.fewshot.space import looks_at_start
from maestra.rules.description import FORMS
from maestra.rules.forms.conditions import At
from maestra.rules.forms.context import ModelRow
from maestra.rules.forms.counting import Count, Kinds, Total
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.order import CyclicOrdered, EqualSteps, Ordered, RiseAndFall, Zigzag
from maestra.rules.forms.patterns import Blocks, Pattern, Template
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, Follows
from maestra.rules.pairs import AddUp, Apart, Step, Times
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Setting
from maestra.rules.token_tests import Compared, Either, Has, Not

RULE_BITS: Final = 2.0
"""For each rule of a conjunction; tuned."""
AMOUNT_BITS: Final = 5.0
"""For a step, a distance or a sum, which is read off the plays."""
UNUSUAL_BITS: Final = 2.0
"""For what people seldom mean."""
GIVEN_ROW_BITS: Final = 5.0
"""For "this row every time", beside naming the one row among all; tuned."""
OUTSIDE_BITS: Final = 3.0
"""A hypothesis must save so much against listing the demonstrations, or nothing is learned."""
SLIP: Final = 0.03
"""How often a demonstration holds a mistake."""
TRUST: Final = 0.97
"""How often a caregiver's answer is meant; between the 95 and 98 % that others report."""
LEARNED_AT: Final = 0.95
"""Confidence from which a lesson counts as learned."""
LAZY: Final = 0.1
"""How many caregivers show the same row again and again."""
REPEATS: Final = 0.7
"""How often those do."""

NEAREST: Final[Mapping[float, float]] = MappingProxyType({0.0: 0.8, 1.0: 0.2})
"""How strongly people take what is near, to how many do: each cell of distance makes a token
less likely by the factor e^-strength."""

FILLING: Final[Mapping[Filling | None, float]] = MappingProxyType(
    {
        None: 0.91,
        Filling.LEFT_TO_RIGHT: 0.01,
        Filling.RIGHT_TO_LEFT: 0.04,
        Filling.ENDS_FIRST: 0.02,
        Filling.MIDDLE_FIRST: 0.02,
    }
)
"""How often an exercise asks for an order of placement; nobody has to be told the usual one."""

HABITS: Final[Mapping[Filling | None, float]] = MappingProxyType(
    {
        None: 0.3,
        Filling.LEFT_TO_RIGHT: 0.6,
        Filling.RIGHT_TO_LEFT: 0.096,
        Filling.ENDS_FIRST: 0.002,
        Filling.MIDDLE_FIRST: 0.002,
    }
)
"""How people fill a row when they may fill it anyhow; None: now so, now so."""


def kind_of(rule: Rule) -> tuple[object, ...]:
    """What rules share a weight: the form, and what kind of test or relation it is about."""
    match rule:
        case EveryToken(test) | AllOfThem(test):
            return type(rule), type(test)
        case EachPair(pairs, relation, line):
            return type(rule), type(relation), pairs, line
        case Count(_, comparison) | Kinds(_, comparison) | Total(_, comparison):
            return type(rule), comparison
        case Ordered() | Blocks() | Zigzag() | EqualSteps() | RiseAndFall() | CyclicOrdered():
            return type(rule), rule.line
        case Pattern() | Template() | Before() | Follows() | At():
            return type(rule), rule.line
        case _:
            return (type(rule),)


def surcharge(rule: Rule, setting: Setting) -> float:  # noqa: C901 - one for each kind
    """Bits for a parameter that was read off the plays, and for what is seldom said."""
    length = max(2, setting.length)
    match rule:
        case EveryToken(Either()):
            return 1.0
        case EveryToken(Compared() | Not()):
            return 0.5
        case AllOfThem(Compared()):
            return 3.0
        case Total() | UntilTotal():
            return 5.0
        case EachPair(pairs, Step() | Apart() | AddUp() | Times()):
            return AMOUNT_BITS + (0.0 if pairs is Pairs.NEIGHBOURS else UNUSUAL_BITS)
        case EachPair(Pairs.TWO_BY_TWO | Pairs.FIRST_WITH_REST):
            return UNUSUAL_BITS
        case Count() | Kinds():
            return log2(length)
        case Template(_, _, False):
            return float(length - 1)
        case Pattern(_, False):
            return float(length)
        case Ordered() | EachPair() | Blocks() | Zigzag() if rule.line is Line.TIME:
            return 2.0
        case _:
            return 0.0


def rule_bits(rule: Rule, setting: Setting, among: int = 1) -> float:
    """Bits that `rule` costs as part of a hypothesis.

    Args:
        rule: one rule.
        setting: a start it was seen from.
        among: how many rules of its kind were thought of.
    """
    if is_given_row(rule, setting):
        cells = setting.given.count(None)
        tokens = setting.movable.bit_count()
        return GIVEN_ROW_BITS + sum(log2(max(1, tokens - k)) for k in range(cells))
    bits = RULE_BITS + FORMS[type(rule)] + log2(among) + surcharge(rule, setting)
    # Relations of the cells that tokens came from: possible, but seldom meant.
    indirect = looks_at_start(rule) and not isinstance(
        rule, EveryToken | StraightUp | TakeExtreme | ModelRow | Ordered
    )
    return bits + (UNUSUAL_BITS if indirect else 0.0)


def is_given_row(rule: Rule, setting: Setting) -> bool:
    """Whether `rule` names what each goal cell shows."""
    match rule:
        case Pattern(tests, False):
            return len(tests) == setting.length and all(
                isinstance(test, Has) and test.feature.name.startswith("is-") for test in tests
            )
        case _:
            return False
