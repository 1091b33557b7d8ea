"""What a language has to bring: its words in tables, and a little grammar."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum
from typing import Final, Protocol

from maestra.core.tokens import Value
from maestra.language.keys import Key, Predicate
from maestra.language.phrases import Joint
from maestra.language.templates import Gender, Spoken


class Naming(Enum):
    """How a token is named by what it shows under an attribute."""

    PLAIN = "plain"
    """By the value alone: 34, C."""
    WORD = "word"
    """The token of that name: a word, as it is written."""
    QUALITY = "quality"
    """The token that is so: red."""
    MEASURE = "measure"
    """By the attribute and the value: size 3."""


@dataclass(frozen=True, slots=True)
class AttributeWords:
    """The words of one attribute in one language."""

    noun: str
    """``colour``: what the attribute is called."""
    gender: Gender = Gender.MASCULINE
    plural: str | None = None
    """``colours``; None: the noun itself."""
    things: str | None = None
    """``numbers``: what tokens are called that show only this; None: tokens."""
    more: str | None = None
    """``larger``: what the greater of two is; forms by gender divided by a bar. None: has more."""
    less: str | None = None
    most: str | None = None
    """``largest``: what the greatest of all is."""
    least: str | None = None
    naming: Naming | None = None
    """None: numbers as a measure, anything else as a word."""


@dataclass(frozen=True, slots=True)
class VerbForms:
    """A verb as sentences need it: it must be, it is, one that is, those that are; and not."""

    must: str
    must_not: str
    does: str
    does_not: str
    that: str
    that_not: str
    do: str
    do_not: str


@dataclass(frozen=True)
class OwnWords:
    """Words for what decks are made of, that a caregiver can add to."""

    attributes: Mapping[str, AttributeWords] = field(default_factory=dict[str, AttributeWords])
    values: Mapping[tuple[str, str], str] = field(default_factory=dict[tuple[str, str], str])
    """Attribute and value to its word; forms divided by bars: m|f or m|f|m plural|f plural."""
    relations: Mapping[tuple[str, Predicate], tuple[str, str]] = field(
        default_factory=dict[tuple[str, Predicate], tuple[str, str]]
    )
    """A deck's relation to a verb and what follows it: `RELATED` says what the second token is
    to the first, `RELATED_BACK` what the first is to the second."""


NO_OWN_WORDS: Final = OwnWords()


@dataclass(frozen=True)
class Words(OwnWords):
    """The tables of one language."""

    sentences: Mapping[Key, str] = field(default_factory=dict[Key, str])
    predicates: Mapping[Predicate, tuple[str, str]] = field(
        default_factory=dict[Predicate, tuple[str, str]]
    )
    """A verb, and the template of what follows it."""
    kinds: Mapping[Predicate, str] = field(default_factory=dict[Predicate, str])
    """Tokens of a kind in the plural, for those that have a short way to say it: odd numbers."""
    verbs: Mapping[str, VerbForms] = field(default_factory=dict[str, VerbForms])


class Grammar(Protocol):
    """What tables cannot say."""

    token: Spoken
    """The noun for a token whichever; its gender is what counts."""

    def join(self, items: Sequence[str], joint: Joint) -> str:
        """A list, at least one item long."""
        ...

    def derive(self, spoken: Spoken, form: str) -> str:
        """A form of a phrase by its name; an unknown form is a mistake in a template.

        Raises:
            KeyError: no such form.
        """
        ...

    def nth(self, number: int) -> Spoken:
        """An ordinal, from 1."""
        ...

    def count(self, number: int) -> Spoken:
        """How many, before a noun for tokens."""
        ...

    def numeral(self, number: Value) -> str:
        """A number in digits."""
        ...

    def place(self, row: int, column: int) -> Spoken:
        """A cell."""
        ...

    def row(self, row: int, rows: int) -> Spoken:
        """A row of a board with so many."""
        ...

    def plain(self, text: str, number: Value, words: AttributeWords) -> Spoken:
        """A token named by a number or letter alone."""
        ...

    def word(self, text: str) -> Spoken:
        """A token named by a word."""
        ...

    def quality(self, word: str) -> Spoken:
        """A token named by what it is; `word` has its forms."""
        ...

    def measure(self, words: AttributeWords, text: str) -> Spoken:
        """A token named by an attribute and its value."""
        ...

    def qualify(self, head: Spoken, others: Sequence[str]) -> Spoken:
        """A token named by one attribute, with the values that tell it from others."""
        ...


def inflect(word: str, gender: Gender, *, many: bool = False) -> str:
    """The form for a gender and number of ``m|f`` or ``m|f|mm|ff``; one form serves all."""
    forms = word.split("|")
    wanted = (gender is Gender.FEMININE) + 2 * many
    return forms[wanted % len(forms)]


def plain_number(number: Value) -> str:
    """In digits, never with an exponent."""
    return f"{number:f}" if isinstance(number, Decimal) else str(number)
