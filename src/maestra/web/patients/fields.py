"""The settings as a form: in groups, each with its name, its explanation and its values in words.

A form holds texts alone. `typed_of` writes settings so, `settings_of` reads them again and says
at which field what is wrong.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, assert_never, cast

from maestra.coaching.fields import MAX_LEVEL
from maestra.coaching.settings import (
    Hand,
    Mental,
    Physical,
    Profile,
    Reach,
    Settings,
    decode_settings,
    encode_settings,
)
from maestra.core.faults import InvalidError
from maestra.language.coach_settings import setting_explanation, setting_name, value_words
from maestra.web.pages import Pages
from maestra.web.patients.kinds import (
    HARDNESS,
    KINDS,
    PARTS,
    PROFILE,
    YES,
    Hardness,
    HelpLevel,
    Kind,
    OneOf,
    SomeOf,
    Whole,
    YesNo,
    hardness_words,
    level_words,
)
from maestra.web.patients.plan import Typed

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
        Choice(str(one), hardness_words(part, one, pages), str(one) in chosen)
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
