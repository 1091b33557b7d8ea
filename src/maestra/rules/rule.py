"""The rule language: the closed union of all forms, and what can be asked of any rule.

An exercise's rules are a conjunction; `maestra.rules.completability` says what they allow
together.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from typing import Annotated, TypeAlias

from pydantic import Field

from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import FillOrder
from maestra.rules.plays import Plays, Truth
from maestra.rules.setting import Play

Rule: TypeAlias = Annotated[
    EveryToken | AllOfThem | Ordered | Pattern | StraightUp | FillOrder | FullRow,
    Field(discriminator="form"),
]


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


def holding(rule: Rule, plays: Plays) -> Truth:
    """Which of many finished plays are right as far as `rule` says."""
    return rule.mask(plays)


def broken_rules(rules: Sequence[Rule], play: Play) -> tuple[Rule, ...]:
    """The rules that can no longer hold, each looked at alone."""
    return tuple(rule for rule in rules if not rule.possible(play))
