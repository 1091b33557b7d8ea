"""What a rule can ask of two tokens, the first and the second of a pair."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Annotated, Literal, TypeAlias, assert_never

from pydantic import Field

from maestra.core.tokens import NAME, Value
from maestra.rules.fields import Flag, Name, Number, Strict
from maestra.rules.setting import Index, Mask, Rank, Setting
from maestra.rules.token_tests import Comparison


@dataclass(frozen=True, slots=True)
class Compare(Strict):
    """What the first shows compares so to what the second shows.

    Equal and different are of values and need no order. `other` is the second's attribute when
    it is not the same one: the first names the category of the second.
    """

    attribute: Name
    comparison: Comparison
    other: Name | None = None
    relation: Literal["compare"] = field(default="compare", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Step(Strict):
    """The second is `amount` further than the first; round the cycle, if it is one."""

    attribute: Name
    amount: Number
    relation: Literal["step"] = field(default="step", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Apart(Strict):
    """The two are `amount` apart, whichever is the larger; round the cycle, if it is one."""

    attribute: Name
    amount: Number
    relation: Literal["apart"] = field(default="apart", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Times(Strict):
    """The second is `amount` times the first."""

    attribute: Name
    amount: Number
    relation: Literal["times"] = field(default="times", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class AddUp(Strict):
    """The two add up to `amount`."""

    attribute: Name
    amount: Number
    relation: Literal["add-up"] = field(default="add-up", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Named(Strict):
    """The deck's relation `name` holds: either way round, or from first to second only."""

    name: Name
    directed: Flag = False
    relation: Literal["named"] = field(default="named", kw_only=True, repr=False)


Relation: TypeAlias = Annotated[
    Compare | Step | Apart | Times | AddUp | Named, Field(discriminator="relation")
]

Related: TypeAlias = tuple[Mask, ...]
"""For each token as the first, the tokens that stand in the relation as the second."""


def same(attribute: str) -> Compare:
    """Both show the same."""
    return Compare(attribute, Comparison.EQUAL)


def different(attribute: str) -> Compare:
    """The two show different things."""
    return Compare(attribute, Comparison.DIFFERENT)


def related(setting: Setting, relation: Relation) -> Related:
    """Which tokens stand in `relation`; none that lacks the attribute does."""
    return setting.remember(relation, lambda: _related(setting, relation))


def converse(setting: Setting, masks: Related) -> Related:
    """The same pairs, looked up from the second token."""

    def work_out() -> Related:
        count = range(len(masks))
        return tuple(sum(1 << a for a in count if masks[a] >> b & 1) for b in count)

    return setting.remember(("converse", masks), work_out)


def _related(setting: Setting, relation: Relation) -> Related:
    return setting.masks(lambda a, b: _holds(setting, relation, a, b))


def _holds(setting: Setting, relation: Relation, first: Index, second: Index) -> bool:
    match relation:
        case Compare(attribute, comparison, other):
            one = setting.values(attribute)[first]
            two = setting.values(other or attribute)[second]
            return _compares(setting, relation, comparison, one, two)
        case Named(name, directed):
            pairs = setting.deck.relations.get(name, frozenset())
            names = setting.values(NAME)
            pair = (str(names[first]), str(names[second]))
            return pair in pairs or (not directed and pair[::-1] in pairs)
        case Step(attribute) | Apart(attribute) | Times(attribute) | AddUp(attribute):
            ranks = setting.ranks(attribute)
            a, b = ranks[first], ranks[second]
            cycle = len(setting.deck.cycles.get(attribute, ()))
            return a is not None and b is not None and _computes(relation, a, b, cycle)
        case _:
            assert_never(relation)


def _compares(
    setting: Setting,
    relation: Compare,
    comparison: Comparison,
    one: Value | None,
    two: Value | None,
) -> bool:
    if one is None or two is None:
        return False
    if comparison is Comparison.EQUAL:
        return one == two
    if comparison is Comparison.DIFFERENT:
        return one != two
    a = setting.rank(relation.attribute, one)
    b = setting.rank(relation.other or relation.attribute, two)
    return a is not None and b is not None and comparison.holds(a, b)


def _computes(relation: Step | Apart | Times | AddUp, a: Rank, b: Rank, cycle: int) -> bool:
    amount = Fraction(relation.amount)
    match relation:
        case Step():
            return (b - a - amount) % cycle == 0 if cycle else b - a == amount
        case Apart():
            ways = (b - a - amount, a - b - amount)
            return any(way % cycle == 0 if cycle else way == 0 for way in ways)
        case Times():
            return b == amount * a
        case AddUp():
            return a + b == amount
        case _:
            assert_never(relation)
