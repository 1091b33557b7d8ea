"""The rule language: the closed union of all forms, and what can be asked of any rule.

An exercise's rules are a conjunction; `maestra.rules.completability` says what they allow
together.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import Annotated, Final, TypeAlias

import numpy as np
from pydantic import Field

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
from maestra.rules.plays import Plays, Truth
from maestra.rules.setting import Play

Rule: TypeAlias = Annotated[
    EveryToken
    | AllOfThem
    | Ordered
    | CyclicOrdered
    | RiseAndFall
    | Zigzag
    | EqualSteps
    | ExtremeAt
    | EachPair
    | TwoPlaces
    | Pattern
    | Template
    | Blocks
    | Count
    | CompareCounts
    | Kinds
    | Total
    | Equation
    | At
    | IfThen
    | Word
    | StraightUp
    | TakeExtreme
    | FillOrder
    | Before
    | Follows
    | ModelRow
    | Cue
    | FullRow
    | UntilTotal,
    Field(discriminator="form"),
]


MAX_RULES: Final = 100
"""In one exercise: nobody could keep in mind more."""


class Prospect(Enum):
    """What can become of a rule, looked at alone, while a play goes on."""

    BROKEN = "broken"
    """No way to go on, nor ending here, makes it hold."""
    OPEN = "open"
    """Some ways make it hold and others do not."""
    KEPT = "kept"
    """It holds whatever happens."""


def holds(rule: Rule, play: Play) -> bool:
    """Whether a play that ends here is right as far as `rule` says."""
    return rule.holds(play)


def prospect(rule: Rule, play: Play) -> Prospect:
    """What can still become of `rule`; exact for this rule alone."""
    if not rule.possible(play):
        return Prospect.BROKEN
    return Prospect.KEPT if rule.certain(play) else Prospect.OPEN


def holding(rules: Sequence[Rule], plays: Plays) -> Truth:
    """Which of many finished plays are right as far as all of `rules` say."""
    right = np.ones(len(plays), np.bool_)
    for rule in rules:
        right &= rule.mask(plays)
    return right


def broken_rules(rules: Sequence[Rule], play: Play) -> tuple[Rule, ...]:
    """The rules that can no longer hold, each looked at alone."""
    return tuple(rule for rule in rules if not rule.possible(play))
