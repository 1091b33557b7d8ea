"""What the few-shot learner believes before it sees anything: all of its numbers in one place.

A hypothesis is a conjunction of rules. Its prior is 2^-bits: for each rule what it takes to say
it (`maestra.rules.description`) and `RULE_BITS` more, for people use few rules. The likelihood
of a demonstration is the habit-weighted share it has of all plays that the hypothesis allows.

The numbers marked "tuned" were set on the seeds 0 to 999 of `maestra.experiments.fewshot`.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import log2
from types import MappingProxyType
from typing import Final

from maestra.rules.description import description_length
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.timing import Filling
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.token_tests import Has

SCALE: Final = 0.5
"""Of a rule's description: much of what could be said no caregiver would; tuned."""
RULE_BITS: Final = 2.0
"""For each rule of a conjunction; tuned."""
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


def rule_bits(rule: Rule, setting: Setting) -> float:
    """Bits that `rule` costs as part of a hypothesis."""
    if is_given_row(rule, setting):
        cells = setting.given.count(None)
        tokens = setting.movable.bit_count()
        return GIVEN_ROW_BITS + sum(log2(max(1, tokens - k)) for k in range(cells))
    return RULE_BITS + SCALE * description_length(rule, setting)


def is_given_row(rule: Rule, setting: Setting) -> bool:
    """Whether `rule` names what each goal cell shows."""
    match rule:
        case Pattern(tests, False):
            return len(tests) == setting.length and all(
                isinstance(test, Has) and test.feature.name.startswith("is-") for test in tests
            )
        case EveryToken():
            return False
        case _:
            return False
