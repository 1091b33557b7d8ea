"""Sentences with gaps, and how they are filled: the form in which languages keep their words.

``{moved}`` is filled with a phrase, ``{moved:of}`` with one of its other forms, such as "of it".
``[moved@rojo|roja]`` agrees with its gender, ``[moved#is|are]`` with its number.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import Enum
from functools import cache
from typing import Final, TypeAlias

_PART: Final = re.compile(r"\{(\w+)(?::(\w+))?\}|\[(\w+)([@#])([^|\]]*)\|([^|\]]*)\]")


class Gender(Enum):
    """Of a noun, where the language has any."""

    MASCULINE = "m"
    FEMININE = "f"


@dataclass(frozen=True, slots=True)
class Spoken:
    """A phrase in words, with what others agree with."""

    text: str
    forms: Mapping[str, str] = field(default_factory=dict[str, str])
    """Its other forms by name; a form that is missing is derived or is the text itself."""
    gender: Gender = Gender.MASCULINE
    many: bool = False


@dataclass(frozen=True, slots=True)
class Slot:
    """A gap for a phrase, in one of its forms."""

    name: str
    form: str


@dataclass(frozen=True, slots=True)
class Agreement:
    """A word with two forms, chosen by a phrase's gender or number."""

    name: str
    by_gender: bool
    forms: tuple[str, str]


Piece: TypeAlias = str | Slot | Agreement
Derive: TypeAlias = Callable[[Spoken, str], str]
"""A phrase's form by name."""


@cache
def parse(template: str) -> tuple[Piece, ...]:
    """The pieces of a template, in order."""
    pieces: list[Piece] = []
    end = 0
    for match in _PART.finditer(template):
        pieces.append(template[end : match.start()])
        slot, form, word, kind, first, second = match.groups()
        if slot is not None:
            pieces.append(Slot(slot, form or ""))
        else:
            pieces.append(Agreement(word, kind == "@", (first, second)))
        end = match.end()
    pieces.append(template[end:])
    return tuple(piece for piece in pieces if piece != "")


def slots(template: str) -> frozenset[str]:
    """The names that a template needs phrases for."""
    return frozenset(piece.name for piece in parse(template) if not isinstance(piece, str))


def fill(template: str, phrases: Mapping[str, Spoken], derive: Derive) -> str:
    """The template with its gaps filled.

    Raises:
        KeyError: a gap without a phrase.
    """
    return "".join(_fill_piece(piece, phrases, derive) for piece in parse(template))


def _fill_piece(piece: Piece, phrases: Mapping[str, Spoken], derive: Derive) -> str:
    match piece:
        case Slot(name, form):
            return derive(phrases[name], form)
        case Agreement(name, by_gender, forms):
            spoken = phrases[name]
            second = spoken.gender is Gender.FEMININE if by_gender else spoken.many
            return forms[second]
        case _:
            return piece
