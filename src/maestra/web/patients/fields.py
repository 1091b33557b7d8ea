"""The settings as a form: in groups, each with its name, its explanation and its values in words.

A form holds texts alone. `typed_of` writes settings so, `settings_of` reads them again and says
at which field what is wrong.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Any, Final, TypeAlias, assert_never, cast

from maestra.coaching.difficulty import MOST_DIGITS, MOST_SIMILAR
from maestra.coaching.fields import MAX_LEVEL
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
    Profile,
    Reach,
    Settings,
    decode_settings,
    encode_settings,
)
from maestra.core.faults import InvalidError
from maestra.language import Language
from maestra.language.coach_settings import setting_explanation, setting_name, value_words
from maestra.web.pages import Pages
from maestra.web.patients.plan import Typed

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
MOST_TYPED: Final = 200
"""Letters of a field that are kept as they were typed: a number has three."""
MOST_FIGURES: Final = 9
"""Of a number that is typed: more than any setting has."""


@dataclass(frozen=True, slots=True)
class Choice:
    """A value to choose."""

    value: str
    words: str
    chosen: bool


@dataclass(frozen=True, slots=True)
class Box:
    """One thing to fill in: a list of choices, or a number."""

    name: str
    label: str
    """Empty where the field's name says it."""
    choices: tuple[Choice, ...] = ()
    typed: str = ""
    low: int = 0
    high: int = 0


@dataclass(frozen=True, slots=True)
class Field:
    """A setting on the page."""

    name: str
    kind: str
    """choice, several, number, yes: how the template draws it."""
    title: str
    explanation: str
    boxes: tuple[Box, ...]
    fault: str
    """What is wrong with it, in the reader's language; empty if nothing."""


def typed_of(settings: Settings) -> Typed:
    """The form that stands for `settings`, without their profile."""
    written = encode_settings(settings)
    return {part: _texts(_part(written, part)) for part in PARTS}


def changes(typed: Typed, settings: Settings) -> Typed:
    """Of the form, what says otherwise than `settings`; not what is unknown or too long."""
    now = typed_of(settings)
    return {
        part: tuple(text for text in typed.get(part, ()) if len(text) <= MOST_TYPED)
        for part in PARTS
        if typed.get(part, ()) != now[part]
    }


def settings_of(typed: Typed, settings: Settings, pages: Pages) -> Settings | Mapping[str, str]:
    """The settings that a whole form means, their profile as it was; or what is wrong, by field.

    Args:
        typed: the form; a part that is missing stands for nothing ticked.
        settings: whose profile stays.
        pages: says what is wrong.
    """
    written: dict[str, Any] = {"profile": encode_settings(settings)["profile"]}
    for name, kind in KINDS.items():
        written[name] = _meant(name, kind, typed)
    try:
        return decode_settings(written)
    except InvalidError as error:
        wrong = dict.fromkeys(
            fault.where.partition(".")[0].partition("[")[0] for fault in error.faults
        )
        return {name: fault_of(name, pages) for name in wrong}


def profile_of(typed: Typed) -> Profile | None:
    """The profile that a form means; None where a value is none of those offered."""
    try:
        return Profile(
            Mental(_only(typed, "mental")),
            Physical(_only(typed, "physical")),
            Hand(_only(typed, "hand")),
            Reach(_only(typed, "reach")),
        )
    except ValueError:
        return None


def fault_of(name: str, pages: Pages) -> str:
    """What is to be mended at a field."""
    kind = KINDS[name]
    match kind:
        case Whole(low, high):
            return pages.say("Please give a number from {low} to {high}.", low=low, high=high)
        case SomeOf():
            return pages.say("Please choose at least one.")
        case HelpLevel():
            return pages.say("Please choose a level from the least help to the most help.")
        case Hardness():
            return pages.say("Please choose from the easiest to the hardest tokens.")
        case OneOf() | YesNo():
            return pages.say("Please choose one of these.")
        case _:
            assert_never(kind)


def fields(
    kinds: Mapping[str, Kind], typed: Typed, faults: Mapping[str, str], pages: Pages
) -> tuple[Field, ...]:
    """The settings of a group as the page shows them."""
    return tuple(
        Field(
            name,
            _drawn(kind),
            setting_name(name, pages.language),
            setting_explanation(name, pages.language),
            _boxes(name, kind, typed, pages),
            faults.get(name, ""),
        )
        for name, kind in kinds.items()
    )


def profile_typed(profile: Profile) -> Typed:
    """The form that stands for a profile."""
    return {name: (getattr(profile, name).value,) for name in PROFILE}


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
            return ", ".join(_hardness_words(one, parts[one], pages) for one in HARDNESS)
        case _:
            assert_never(kind)


def level_words(level: int, pages: Pages) -> str:
    """What the robot does at an assistance level."""
    return pages.say(LEVEL_WORDS[level])


def _hardness_words(part: str, value: int, pages: Pages) -> str:
    return pages.say(_HARDNESS_WORDS[part][value - 1])


def _drawn(kind: Kind) -> str:
    match kind:
        case OneOf() | HelpLevel() | Hardness():
            return "choice"
        case SomeOf():
            return "several"
        case Whole():
            return "number"
        case YesNo():
            return "yes"
        case _:
            assert_never(kind)


def _boxes(name: str, kind: Kind, typed: Typed, pages: Pages) -> tuple[Box, ...]:
    chosen = typed.get(name, ())
    match kind:
        case OneOf(values) | SomeOf(values):
            choices = tuple(
                Choice(
                    one.value, value_words(name, one.value, pages.language), one.value in chosen
                )
                for one in values
            )
            return (Box(name, "", choices),)
        case Whole(low, high):
            return (Box(name, "", typed=chosen[0] if chosen else "", low=low, high=high),)
        case YesNo():
            return (Box(name, "", (Choice(YES, pages.say("yes"), YES in chosen),)),)
        case HelpLevel():
            levels = tuple(
                Choice(str(one), level_words(one, pages), str(one) in chosen)
                for one in range(MAX_LEVEL + 1)
            )
            return (Box(name, "", levels),)
        case Hardness():
            return tuple(_hardness_box(name, part, typed, pages) for part in HARDNESS)
        case _:
            assert_never(kind)


def _hardness_box(name: str, part: str, typed: Typed, pages: Pages) -> Box:
    chosen = typed.get(f"{name}.{part}", ())
    label = pages.say("Digits") if part == "digits" else pages.say("Distance")
    choices = tuple(
        Choice(str(one), _hardness_words(part, one, pages), str(one) in chosen)
        for one in range(1, HARDNESS[part] + 1)
    )
    return Box(f"{name}.{part}", label, choices)


def _meant(name: str, kind: Kind, typed: Typed) -> object:
    """What a field means, as JSON has it; what is no number stays a text, to be refused."""
    match kind:
        case OneOf():
            return _only(typed, name)
        case SomeOf():
            return list(typed.get(name, ()))
        case Whole() | HelpLevel():
            return _number(_only(typed, name))
        case YesNo():
            return YES in typed.get(name, ())
        case Hardness():
            return {part: _number(_only(typed, f"{name}.{part}")) for part in HARDNESS}
        case _:
            assert_never(kind)


def _only(typed: Typed, name: str) -> str:
    return next(iter(typed.get(name, ())), "")


def _number(text: str) -> int | str:
    plain = text.strip()
    # Only what people write: int() would also take "1_0" and digits of other scripts.
    return (
        int(plain) if plain.isascii() and plain.isdigit() and len(plain) <= MOST_FIGURES else text
    )


def _part(written: Mapping[str, Any], part: str) -> object:
    name, _, inner = part.partition(".")
    return written[name][inner] if inner else written[name]


def _texts(value: object) -> tuple[str, ...]:
    match value:
        case bool():
            return (YES,) if value else ()
        case list():
            return tuple(map(str, cast("list[object]", value)))
        case _:
            return (str(value),)
