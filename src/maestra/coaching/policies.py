"""How much to help next: fixed, a ladder, or learned from this patient.

A policy is asked before each attempt at a move, in a situation as the earlier framework has it:
the part of the exercise (4), the attempt (1 to 4), the last outcome (right, wrong, silence); it
answers with an assistance level, 0 to 5.

*Adaptive.* Beta-Bernoulli posterior sampling [1, Algorithm 16.4 and the text before it] with one
arm for each level. What is learned for each situation and level is how likely the next attempt
is right, as a Beta distribution. To choose, one probability is drawn for each level; the level
taken is the *least* one whose draw reaches a target, or comes close to the best draw if none
does. So uncertain levels are tried now and then, no exploration rate is needed, and help falls
away as the patient succeeds. The target is 50, 55 or 60 % at a first attempt, by the robot's
initial behaviour; it rises with each failed attempt, and with the strain of a session that goes
badly, so that a patient is let try while all is well and is helped at once when it is not.

Departures from [1]: the aim is not the arm with the greatest reward, which would always be the
most help, but the least sufficient help; the parts of an exercise share what is learned, for a
patient gives some ten outcomes a session and 288 cells would stay empty; one silence may be a
pause for thought and teaches nothing, a second one counts as a failure. The first beliefs come
from the profile (`_FIRST_RIGHT`), each worth `PRIOR_WORTH` outcomes, so that a few sessions
outweigh them; counts are halved when they exceed `MEMORY` outcomes, so that a patient who changes
is followed.

A draw from Beta(a, b) with whole a and b is the a-th smallest of a + b - 1 uniform draws.

Cost: one choice takes six draws of at most `MEMORY` + `PRIOR_WORTH` uniform numbers.

[1] Zhang, Mathematical Analysis of Machine Learning Algorithms, chapter 16 (Thompson sampling).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Final, Literal, TypeAlias, assert_never, cast

from pydantic import Field, StrictInt, TypeAdapter

from maestra.coaching.chance import Chance
from maestra.coaching.fields import MAX_LEVEL, STRICT, Level, decode
from maestra.coaching.settings import Behaviour, Mental, PolicyName, Settings

PARTS: Final = 4
ATTEMPTS: Final = 4
PRIOR_WORTH: Final = 4
"""Outcomes that a first belief is worth."""
MEMORY: Final = 24
"""Outcomes of a situation and level before they are halved."""

_TARGETS: Final = MappingProxyType(
    {Behaviour.CHALLENGING: 0.5, Behaviour.NEUTRAL: 0.55, Behaviour.HELPING: 0.6}
)
"""How likely a first attempt should be right."""
_RISE: Final = 0.2
"""By how much that rises with each attempt that failed."""
_RISE_BY_STRAIN: Final = 0.15
_HIGHEST_TARGET: Final = 0.9
_NO_BETTER: Final = 0.15
"""A level that promises this much less than the best one is as good: it helps less."""
_FIRST_RIGHT: Final[Mapping[Mental, tuple[int, ...]]] = MappingProxyType(
    {
        Mental.NONE: (3, 3, 3, 4, 4, 4),
        Mental.VERY_MILD: (2, 3, 3, 3, 4, 4),
        Mental.MILD: (2, 2, 3, 3, 4, 4),
        Mental.MODERATE: (1, 1, 2, 3, 4, 4),
        Mental.SEVERE: (0, 1, 1, 2, 3, 4),
    }
)
"""How many of `PRIOR_WORTH` attempts we expect to be right at each level: our assumption."""


class Outcome(Enum):
    """What became of an attempt."""

    RIGHT = "right"
    WRONG = "wrong"
    SILENCE = "silence"


_STRAIN: Final = MappingProxyType({Outcome.RIGHT: -2, Outcome.WRONG: 2, Outcome.SILENCE: 1})
"""What each outcome adds, in halves of an error."""


@dataclass(frozen=True, slots=True)
class Situation:
    """Before an attempt."""

    __pydantic_config__ = STRICT
    part: int
    """1 to 4: how much of the exercise is done."""
    attempt: int
    """1 to 4; 4 stands for all later ones too."""
    last: Outcome
    """Before the first attempt of all: right."""

    @classmethod
    def at(cls, made: int, length: int, attempt: int, last: Outcome) -> Situation:
        """After `made` of about `length` moves."""
        part = 1 + PARTS * min(made, length - 1) // length
        return cls(part, min(attempt, ATTEMPTS), last)


@dataclass(frozen=True, slots=True)
class Limits:
    """What the caregiver allows."""

    least: int = 0
    most: int = MAX_LEVEL

    def clamp(self, level: int) -> int:
        """The allowed level nearest to `level`."""
        return min(max(level, self.least), self.most)


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


_Counts = tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Adaptive:
    """What has been learned of one patient; to be kept from session to session."""

    __pydantic_config__ = STRICT
    first: tuple[int, ...]
    """By level: of `PRIOR_WORTH` attempts how many were expected to be right."""
    target: float
    """How likely the next attempt should be right."""
    strain: Annotated[StrictInt, Field(ge=0)] = 0
    """How badly this session has gone lately, in halves of an error."""
    seen: dict[str, _Counts] = field(default_factory=dict[str, _Counts])
    """For each situation that occurred, by level: right and other outcomes."""
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
            first = _FIRST_RIGHT[settings.profile.mental]
            return Adaptive(first, _TARGETS[settings.behaviour])
        case _:
            assert_never(settings.policy)


def choose(
    policy: Policy, situation: Situation, limits: Limits, chance: Chance
) -> tuple[int, Chance]:
    """The level to help with before the next attempt, within `limits`."""
    match policy:
        case Fixed(level) | Ladder(level):
            return limits.clamp(level), chance
        case Adaptive():
            return _least_sufficient(policy, situation, limits, chance)
        case _:
            assert_never(policy)


def learn(policy: Policy, situation: Situation, level: int, outcome: Outcome) -> Policy:
    """The policy once an attempt in `situation`, helped with `level`, had this outcome."""
    match policy:
        case Fixed():
            return policy
        case Ladder(at, row):
            if outcome is not Outcome.RIGHT:
                return Ladder(min(at + 1, MAX_LEVEL))
            return Ladder(max(at - 1, 0)) if row else replace(policy, row=1)
        case Adaptive():
            strain = max(0, policy.strain + _STRAIN[outcome])
            policy = replace(policy, strain=strain)
            if outcome is Outcome.SILENCE and situation.last is not Outcome.SILENCE:
                return policy
            right = outcome is Outcome.RIGHT
            counts = _counted(_counts(policy, situation), level, right=right)
            return replace(policy, seen={**policy.seen, _name(situation): counts})
        case _:
            assert_never(policy)


def rested(policy: Policy) -> Policy:
    """The policy when the next session begins: what it learned stays, the strain is gone."""
    return replace(policy, strain=0) if isinstance(policy, Adaptive) else policy


def likelihood(policy: Adaptive, situation: Situation, level: int) -> float:
    """How likely the next attempt is right, by what has been learned: the Beta's mean."""
    right, other = _beta(policy, situation, level)
    return right / (right + other)


def _least_sufficient(
    policy: Adaptive, situation: Situation, limits: Limits, chance: Chance
) -> tuple[int, Chance]:
    rise = _RISE * (situation.attempt - 1) + _RISE_BY_STRAIN * policy.strain
    target = min(policy.target + rise, _HIGHEST_TARGET)
    drawn: dict[int, float] = {}
    for level in range(limits.least, limits.most + 1):
        drawn[level], chance = _draw(*_beta(policy, situation, level), chance)
    enough = min(target, max(drawn.values()) - _NO_BETTER)
    return next(level for level, share in drawn.items() if share >= enough), chance


def _draw(right: int, other: int, chance: Chance) -> tuple[float, Chance]:
    """A draw from Beta(right, other)."""
    drawn: list[float] = []
    for _ in range(right + other - 1):
        share, chance = chance.share()
        drawn.append(share)
    return sorted(drawn)[right - 1], chance


def _beta(policy: Adaptive, situation: Situation, level: int) -> tuple[int, int]:
    """The belief's two parameters, each at least 1."""
    right, other = _counts(policy, situation)[level]
    expected = policy.first[level]
    return 1 + expected + right, 1 + PRIOR_WORTH - expected + other


def _counts(policy: Adaptive, situation: Situation) -> _Counts:
    nothing: _Counts = ((0, 0),) * (MAX_LEVEL + 1)
    return policy.seen.get(_name(situation), nothing)


def _counted(counts: _Counts, level: int, *, right: bool) -> _Counts:
    """One more outcome at `level`; the oldest weigh less and less."""
    good, bad = counts[level]
    good, bad = good + right, bad + (not right)
    if good + bad > MEMORY:
        good, bad = good // 2, bad // 2
    return (*counts[:level], (good, bad), *counts[level + 1 :])


def _name(situation: Situation) -> str:
    """What the parts of an exercise share: ``2-wrong``."""
    return f"{situation.attempt}-{situation.last.value}"


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
