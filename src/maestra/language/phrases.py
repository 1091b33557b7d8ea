"""The intermediate explanation: what is to be said, before any language says it.

The paper [1, section 4.2] goes from a learned rule to an intermediate explanation and from that
to a sentence. Here the explanation is a tree of phrases: a `Say` is a sentence or a part of one,
named by its key, with what it is about; the leaves are tokens, cells, numbers and words.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from types import MappingProxyType
from typing import TypeAlias

from maestra.core.board import Cell
from maestra.core.tokens import Attributes, Value
from maestra.language.keys import Key, Predicate


@dataclass(frozen=True, slots=True)
class Say:
    """A sentence, or a part of one: its key and its parts."""

    key: Key
    parts: Mapping[str, Phrase]


@dataclass(frozen=True, slots=True)
class Does:
    """Something said of a subject: what it is, has or does. Its verb agrees with the subject."""

    predicate: Predicate
    parts: Mapping[str, Phrase]
    subject: Phrase | None = None
    """None: a token, whichever."""
    negated: bool = False


@dataclass(frozen=True, slots=True)
class Several:
    """Several things of which one or all are said of a subject."""

    of: tuple[Does | Several, ...]
    joint: Joint


class Joint(Enum):
    """How the items of a list are joined."""

    AND = "and"
    OR = "or"
    COMMA = "comma"
    PLUS = "plus"
    TIMES = "times"


@dataclass(frozen=True, slots=True)
class Listing:
    """Several phrases of one kind, at least one."""

    items: tuple[Phrase, ...]
    joint: Joint


@dataclass(frozen=True, slots=True)
class Named:
    """A token, by what it shows."""

    shown: Attributes


@dataclass(frozen=True, slots=True)
class ValueNamed:
    """What a token can show under an attribute."""

    attribute: str
    value: Value


@dataclass(frozen=True, slots=True)
class AttributeNamed:
    """An attribute."""

    attribute: str


@dataclass(frozen=True, slots=True)
class Things:
    """Tokens by the noun of an attribute, when they show nothing else: numbers, letters."""

    attribute: str


@dataclass(frozen=True, slots=True)
class Kind:
    """Tokens of a kind, for what has a short way to say it: odd numbers."""

    predicate: Predicate
    parts: Mapping[str, Phrase]


class Degree(Enum):
    """Which comparative or superlative."""

    MORE = "more"
    LESS = "less"
    MOST = "most"
    LEAST = "least"


@dataclass(frozen=True, slots=True)
class Adjective:
    """What the greater or the less of tokens is called under an attribute: larger, smallest."""

    attribute: str
    degree: Degree
    many: bool = False
    """Said of several tokens, whatever the subject is."""


@dataclass(frozen=True, slots=True)
class Place:
    """A cell."""

    cell: Cell


@dataclass(frozen=True, slots=True)
class InRow:
    """A row: the top one, the bottom one, or by its number."""

    row: int


@dataclass(frozen=True, slots=True)
class Numeral:
    """A number in digits."""

    number: Value


@dataclass(frozen=True, slots=True)
class Count:
    """How many: in words where that is usual."""

    number: int


@dataclass(frozen=True, slots=True)
class Nth:
    """A place in a sequence, from 1."""

    number: int


@dataclass(frozen=True, slots=True)
class Foreign:
    """A word of the caregiver's that no list of words knows: it is said as it is written."""

    text: str


Phrase: TypeAlias = (
    Say
    | Does
    | Several
    | Listing
    | Named
    | ValueNamed
    | AttributeNamed
    | Things
    | Kind
    | Adjective
    | Place
    | InRow
    | Numeral
    | Count
    | Nth
    | Foreign
)


def say(key: Key, **parts: Phrase) -> Say:
    """The sentence or part of one with this key and these parts."""
    return Say(key, MappingProxyType(parts))


def opposite(phrase: Does | Several) -> Does | Several:
    """What is said when `phrase` is not so."""
    if isinstance(phrase, Does):
        return replace(phrase, negated=not phrase.negated)
    other = Joint.OR if phrase.joint is Joint.AND else Joint.AND
    return Several(tuple(opposite(each) for each in phrase.of), other)
