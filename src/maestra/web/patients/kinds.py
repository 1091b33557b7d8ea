"""What each setting is: its kind, its group on the page, and its values in words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Final, TypeAlias, assert_never, cast

from maestra.coaching.difficulty import MOST_DIGITS, MOST_SIMILAR
from maestra.coaching.settings import (
    FASTEST_WPM,
    LONGEST_PATIENCE_S,
    MOST_ATTEMPTS,
    MOST_ROUNDS,
    SHORTEST_PATIENCE_S,
    SLOWEST_WPM,
    Behaviour,
    Hand,
    Helper,
    Mental,
    Modality,
    Persona,
    Physical,
    PolicyName,
    Reach,
)
from maestra.language import Language
from maestra.language.coach_settings import value_words
from maestra.web.pages import Pages

YES: Final = "yes"
"""What a ticked box sends."""


@dataclass(frozen=True, slots=True)
class OneOf:
    """One of a few values, named by language/."""

    values: type[Enum]


@dataclass(frozen=True, slots=True)
class SomeOf:
    """Any of a few values, at least one."""

    values: type[Enum]


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole number within limits."""

    low: int
    high: int


@dataclass(frozen=True, slots=True)
class YesNo:
    """A box to tick."""


@dataclass(frozen=True, slots=True)
class HelpLevel:
    """An assistance level, 0 to 5."""


@dataclass(frozen=True, slots=True)
class Hardness:
    """How many digits, and how close together: two values."""


Kind: TypeAlias = OneOf | SomeOf | Whole | YesNo | HelpLevel | Hardness

PROFILE: Final[Mapping[str, Kind]] = MappingProxyType(
    {
        "mental": OneOf(Mental),
        "physical": OneOf(Physical),
        "hand": OneOf(Hand),
        "reach": OneOf(Reach),
    }
)
GROUPS: Final[Mapping[str, Mapping[str, Kind]]] = MappingProxyType(
    {
        "Speaking": {
            "language": OneOf(Language),
            "modalities": SomeOf(Modality),
            "speech_wpm": Whole(SLOWEST_WPM, FASTEST_WPM),
            "volume": Whole(0, 100),
        },
        "Manner and pace": {
            "persona": OneOf(Persona),
            "behaviour": OneOf(Behaviour),
            "patience_s": Whole(SHORTEST_PATIENCE_S, LONGEST_PATIENCE_S),
            "rounds": Whole(1, MOST_ROUNDS),
        },
        "Helping": {
            "policy": OneOf(PolicyName),
            "level": HelpLevel(),
            "least_level": HelpLevel(),
            "most_level": HelpLevel(),
            "attempts": Whole(1, MOST_ATTEMPTS),
            "errorless": YesNo(),
        },
        "The patient's screen": {"one_switch": YesNo(), "show_score": YesNo()},
        "Wrong tokens": {"put_back": OneOf(Helper), "robot_moves": YesNo()},
        "Tokens with numbers": {
            "difficulty": Hardness(),
            "easiest": Hardness(),
            "hardest": Hardness(),
        },
    }
)
"""Every setting but the profile, as the page shows them; the heads are texts of the pages."""
KINDS: Final[Mapping[str, Kind]] = MappingProxyType(
    {name: kind for group in GROUPS.values() for name, kind in group.items()}
)
HARDNESS: Final[Mapping[str, int]] = MappingProxyType(
    {"digits": MOST_DIGITS, "similarity": MOST_SIMILAR}
)
"""The two values of a difficulty, each from 1."""
PARTS: Final[tuple[str, ...]] = tuple(
    part
    for name, kind in KINDS.items()
    for part in ([f"{name}.{one}" for one in HARDNESS] if isinstance(kind, Hardness) else [name])
)
"""What the form sends, by name."""
LEVEL_WORDS: Final = (
    "0: it only says whose turn it is",
    "1: it encourages or says the rule again",
    "2: it says in which row to look",
    "3: it names a few tokens, one of which is right",
    "4: it shows the token and its place",
    "5: it offers to place the token together, or places it",
)
_HARDNESS_WORDS: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "digits": ("one digit", "two digits", "three digits"),
        "similarity": (
            "far apart",
            "rather far apart",
            "neither far nor close",
            "rather close",
            "close",
        ),
    }
)


def words_of(name: str, value: object, pages: Pages) -> str:
    """A setting's value, as JSON has it, in words."""
    kind = KINDS.get(name) or PROFILE[name]
    match kind:
        case OneOf():
            return value_words(name, str(value), pages.language)
        case SomeOf():
            listed = cast("list[str]", value)
            return ", ".join(value_words(name, each, pages.language) for each in listed)
        case Whole():
            return str(value)
        case YesNo():
            return pages.say("yes") if value else pages.say("no")
        case HelpLevel():
            return level_words(int(str(value)), pages)
        case Hardness():
            parts = cast("dict[str, int]", value)
            return ", ".join(hardness_words(one, parts[one], pages) for one in HARDNESS)
        case _:
            assert_never(kind)


def level_words(level: int, pages: Pages) -> str:
    """What the robot does at an assistance level."""
    return pages.say(LEVEL_WORDS[level])


def hardness_words(part: str, value: int, pages: Pages) -> str:
    """What a value of a part of a difficulty is called."""
    return pages.say(_HARDNESS_WORDS[part][value - 1])
