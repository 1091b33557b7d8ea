"""What a rule can ask of two tokens, the first and the second of a pair."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Annotated, Literal, TypeAlias, TypeVar, assert_never

from pydantic import Field

from maestra.core.tokens import NAME
from maestra.rules.fields import Flag, Name, Number, Strict
from maestra.rules.setting import Mask, Rank, Setting
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


_Key = TypeVar("_Key", bound=Hashable)


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
    match relation:
        case Compare(attribute, Comparison.EQUAL | Comparison.DIFFERENT, other):
            alike = _by_key(setting.values(other or attribute))
            known = sum(alike.values())
            equal = relation.comparison is Comparison.EQUAL
            return tuple(
                0 if one is None else alike.get(one, 0) if equal else known & ~alike.get(one, 0)
                for one in setting.values(attribute)
            )
        case Compare(attribute, comparison, other):
            ones, twos = setting.ranks(attribute), setting.ranks(other or attribute)
            ranked: dict[Rank, Mask] = _by_key(twos)
            return tuple(
                sum(mask for two, mask in ranked.items() if _compares(comparison, one, two))
                for one in ones
            )
        case Named(name, directed):
            pairs = setting.deck.relations.get(name, frozenset())
            both_ways = pairs if directed else pairs | {pair[::-1] for pair in pairs}
            names = [str(shown) for shown in setting.values(NAME)]
            return setting.masks(lambda a, b: (names[a], names[b]) in both_ways)
        case Step(attribute) | Apart(attribute) | Times(attribute) | AddUp(attribute):
            ranks = setting.ranks(attribute)
            cycle = len(setting.deck.cycles.get(attribute, ()))
            around = cycle if isinstance(relation, Step | Apart) else 0
            there = _by_key([None if rank is None else _wound(rank, around) for rank in ranks])
            return tuple(
                sum(
                    there.get(two, 0)
                    for two in {_wound(second, around) for second in _seconds(relation, one)}
                )
                for one in ranks
            )
        case _:
            assert_never(relation)


def _by_key(shown: Sequence[_Key | None]) -> dict[_Key, Mask]:
    """For each value or rank the tokens that have it."""
    found: dict[_Key, Mask] = {}
    for token, key in enumerate(shown):
        if key is not None:
            found[key] = found.get(key, 0) | 1 << token
    return found


def _compares(comparison: Comparison, one: Rank | None, two: Rank) -> bool:
    return one is not None and comparison.holds(one, two)


def _wound(rank: Rank, around: int) -> Rank:
    """A rank on a cycle of so many; on none for 0."""
    return rank % around if around else rank


def _seconds(relation: Step | Apart | Times | AddUp, first: Rank | None) -> tuple[Rank, ...]:
    """What the second token may have if the first has this."""
    if first is None:
        return ()
    amount = Fraction(relation.amount)
    match relation:
        case Step():
            return (first + amount,)
        case Apart():
            return (first + amount, first - amount)
        case Times():
            return (first * amount,)
        case AddUp():
            return (amount - first,)
        case _:
            assert_never(relation)
