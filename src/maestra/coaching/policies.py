"""How much to help next: fixed, a ladder, or learned from this patient.

A policy is asked before each attempt at a move and answers with an assistance level, 0 to 5.

*Adaptive.* The earlier framework learns, from simulated persons and before anybody is met, the
best level for each part of the game, attempt and last outcome: 288 numbers. A patient gives some
ten outcomes a session, so here less is learned and more is worked out: how likely an attempt is
right at each level, and how likely there is none; what is best in which situation follows by a
plan (`planning`), in which help has a price. The beliefs are Beta distributions with their means
taken for certain (certainty equivalence [1]): trying levels out for the sake of knowing them
would be at the patient's expense, and what a session brings anyway is enough to learn from.

The first beliefs come from the profile (`_FIRST_RIGHT`), each worth `PRIOR_WORTH` outcomes, so
that a few sessions outweigh them; that an attempt does not come counts over all levels together,
for it depends on the patient more than on the hint; counts are halved when they exceed `MEMORY`
outcomes, so that a patient who changes is followed. The price follows from the profile and the
robot's initial behaviour (`_PRICES`, `_BOLDNESS`).

[1] Patterns, Predictions, and Actions, chapter on reinforcement learning, mlstory.org/rl.html.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Final, Literal, TypeAlias, assert_never, cast

from pydantic import Field, StrictInt, TypeAdapter

from maestra.coaching.fields import MAX_LEVEL, STRICT, Level, decode
from maestra.coaching.planning import Odds, best_help
from maestra.coaching.settings import Behaviour, Mental, PolicyName, Settings
from maestra.coaching.situation import STRAIN, Limits, Outcome, Situation

PRIOR_WORTH: Final = 4
"""Outcomes that a first belief is worth."""
MEMORY: Final = 48
"""Outcomes at a level before they are halved."""

_PRICES: Final = MappingProxyType(
    {
        Mental.NONE: 0.012,
        Mental.VERY_MILD: 0.012,
        Mental.MILD: 0.012,
        Mental.MODERATE: 0.012,
        Mental.SEVERE: 0.022,
    }
)
"""What a level of help costs a helping robot, in completed sessions. Chosen on simulated patients
so that about as many sessions are completed as with the most help: severely impaired ones complete
more than that at the lower price, and are helped more than they need."""
_BOLDNESS: Final = MappingProxyType(
    {Behaviour.CHALLENGING: 1.5, Behaviour.NEUTRAL: 1.25, Behaviour.HELPING: 1.0}
)
"""How many times as much it costs others."""
_FIRST_RIGHT: Final[Mapping[Mental, tuple[int, ...]]] = MappingProxyType(
    {
        Mental.NONE: (3, 3, 3, 4, 4, 4),
        Mental.VERY_MILD: (2, 3, 3, 3, 4, 4),
        Mental.MILD: (2, 2, 3, 3, 4, 4),
        Mental.MODERATE: (1, 1, 2, 3, 4, 4),
        Mental.SEVERE: (0, 1, 1, 2, 4, 4),
    }
)
"""How many of `PRIOR_WORTH` attempts we expect to be right at each level: our assumption."""
_FIRST_SILENT: Final = (1, 4)
"""How many attempts we expect not to come, of how many."""


@dataclass(frozen=True, slots=True)
class Fixed:
    """The same level always."""

    __pydantic_config__ = STRICT
    level: Level
    policy: Literal["fixed"] = field(default="fixed", kw_only=True, repr=False)


@dataclass(frozen=True, slots=True)
class Ladder:
    """One level up after an error or silence, one down after two right attempts in a row."""

    __pydantic_config__ = STRICT
    level: Level
    row: Annotated[StrictInt, Field(ge=0)] = 0
    """Right attempts in a row."""
    policy: Literal["ladder"] = field(default="ladder", kw_only=True, repr=False)


_Count: TypeAlias = tuple[int, int, int]
"""Attempts that were right, that were wrong, that did not come."""
_NOTHING: Final[tuple[_Count, ...]] = ((0, 0, 0),) * (MAX_LEVEL + 1)
_PLACES: Final = MappingProxyType({Outcome.RIGHT: 0, Outcome.WRONG: 1, Outcome.SILENCE: 2})


@dataclass(frozen=True, slots=True)
class Adaptive:
    """What has been learned of one patient; to be kept from session to session."""

    __pydantic_config__ = STRICT
    first: tuple[int, ...]
    """By level: of `PRIOR_WORTH` attempts how many were expected to be right."""
    price: Annotated[float, Field(ge=0)]
    """Of a level of help, in completed sessions."""
    strain: Annotated[StrictInt, Field(ge=0)] = 0
    """How badly this session has gone lately, in halves of an error."""
    seen: tuple[_Count, ...] = _NOTHING
    """What attempts came to, by the level of the help that stood."""
    policy: Literal["adaptive"] = field(default="adaptive", kw_only=True, repr=False)


Policy: TypeAlias = Fixed | Ladder | Adaptive


def policy_for(settings: Settings) -> Policy:
    """The policy that the settings name, knowing no more than they say."""
    match settings.policy:
        case PolicyName.FIXED:
            return Fixed(settings.level)
        case PolicyName.LADDER:
            return Ladder(settings.level)
        case PolicyName.ADAPTIVE:
            mental = settings.profile.mental
            price = _PRICES[mental] * _BOLDNESS[settings.behaviour]
            return Adaptive(_FIRST_RIGHT[mental], price)
        case _:
            assert_never(settings.policy)


def choose(policy: Policy, situation: Situation, limits: Limits) -> int:
    """The level to help with before the next attempt, within `limits`."""
    match policy:
        case Fixed(level) | Ladder(level):
            return limits.clamp(level)
        case Adaptive():
            return best_help(odds(policy), situation, policy.strain, limits, policy.price)
        case _:
            assert_never(policy)


def learn(policy: Policy, level: int, outcome: Outcome) -> Policy:
    """The policy once an attempt had this outcome while the help of `level` stood."""
    match policy:
        case Fixed():
            return policy
        case Ladder(at, row):
            if outcome is not Outcome.RIGHT:
                return Ladder(min(at + 1, MAX_LEVEL))
            return Ladder(max(at - 1, 0)) if row else replace(policy, row=1)
        case Adaptive(seen=seen):
            strain = max(0, policy.strain + STRAIN[outcome])
            counted = _counted(seen[level], outcome)
            seen = (*seen[:level], counted, *seen[level + 1 :])
            return replace(policy, strain=strain, seen=seen)
        case _:
            assert_never(policy)


def rested(policy: Policy) -> Policy:
    """The policy when the next session begins: what it learned stays, the strain is gone."""
    return replace(policy, strain=0) if isinstance(policy, Adaptive) else policy


def odds(policy: Adaptive) -> Odds:
    """What is believed of the next attempt: the means of the Beta distributions."""
    right = tuple(
        (1 + expected + good) / (2 + PRIOR_WORTH + good + bad)
        for expected, (good, bad, _) in zip(policy.first, policy.seen, strict=True)
    )
    silent, all_first = _FIRST_SILENT
    silences = sum(none for _, _, none in policy.seen)
    return Odds(right, (silent + silences) / (all_first + sum(map(sum, policy.seen))))


def _counted(count: _Count, outcome: Outcome) -> _Count:
    """One more; the oldest weigh less and less."""
    good, bad, none = (number + (place == _PLACES[outcome]) for place, number in enumerate(count))
    if good + bad + none > MEMORY:
        return good // 2, bad // 2, none // 2
    return good, bad, none


@cache
def _adapter() -> TypeAdapter[Policy]:
    return TypeAdapter(Annotated[Policy, Field(discriminator="policy")])


def encode_policy(policy: Policy) -> dict[str, Any]:
    """The policy and what it has learned as JSON; `decode_policy` gives the same again."""
    return cast("dict[str, Any]", _adapter().dump_python(policy, mode="json"))


def decode_policy(written: object) -> Policy:
    """The policy that the parsed JSON describes.

    Raises:
        InvalidError: it describes none; with every fault and its place.
    """
    return decode(_adapter(), written)
