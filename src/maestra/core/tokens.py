"""Movable pieces, what they show, and sets of them."""

from __future__ import annotations

import unicodedata
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum
from functools import cached_property
from types import MappingProxyType
from typing import Final, NewType, TypeAlias

from maestra.core.faults import Fault, refuse

TokenId = NewType("TokenId", str)
"""A token's unique mark; on a real board the UID of its tag."""

Value: TypeAlias = int | Decimal | str
"""What an attribute can hold: a number is ordinal, a string nominal unless declared otherwise."""

Attributes: TypeAlias = tuple[tuple[str, Value], ...]
"""A token's named attributes, sorted by name: hashable, so that equal tokens can be found."""

LETTER: Final = "letter"
"""The attribute whose one-letter strings are in alphabetical order, as vowels and consonants."""
NAME: Final = "name"
"""The attribute over which a deck's named relations are declared."""

MAX_TOKENS: Final = 10_000
"""As many as the largest board has cells."""
MAX_NUMBER: Final = 10**15
"""Beyond it numbers would lose digits in the vectorised rules, which count in 64 bits."""


class Scale(Enum):
    """How the values of an attribute compare."""

    NUMBER = "number"
    """Ordered, with arithmetic."""
    LETTER = "letter"
    """One letter each: ordered by the alphabet."""
    ORDER = "order"
    """Ordered as the deck declares it."""
    CYCLE = "cycle"
    """Ordered as the deck declares it, and the first follows the last."""
    NOMINAL = "nominal"
    """Only the same or different."""


@dataclass(frozen=True, slots=True)
class Token:
    """A movable piece: its unique id and what it shows."""

    id: TokenId
    attributes: Attributes

    def __post_init__(self) -> None:
        """Sort the attributes, so that equal tokens are equal however they were written."""
        object.__setattr__(
            self, "attributes", tuple(sorted(self.attributes, key=lambda pair: pair[0]))
        )

    def value(self, attribute: str) -> Value | None:
        """What the token shows under `attribute`; None when it has no such attribute."""
        return next((value for name, value in self.attributes if name == attribute), None)


@dataclass(frozen=True)
class Deck:
    """A set of tokens, and what their attributes mean: orders, cycles, relations, words.

    Raises:
        InvalidError: an id twice, an attribute with numbers and strings mixed, a value missing
            from its declared order, an order with a value twice or declared both ways, a number
            outside ±10^15.
    """

    tokens: tuple[Token, ...]
    orders: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Attribute to its values from first to last."""
    cycles: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Attribute to its values once round."""
    relations: Mapping[str, frozenset[tuple[str, str]]] = field(default_factory=dict)
    """Relation to its pairs of values of the attribute `name`."""
    lexicon: tuple[str, ...] = ()
    """The words that count as words."""

    def __post_init__(self) -> None:
        """Freeze the mappings and refuse what makes no deck, naming every fault."""
        object.__setattr__(self, "tokens", tuple(sorted(self.tokens, key=lambda token: token.id)))
        for name in ("orders", "cycles", "relations"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))
        refuse([*self._faults_of_tokens(), *self._faults_of_orders()])

    def __hash__(self) -> int:
        """By the tokens alone: enough to tell decks apart quickly."""
        return hash(self.tokens)

    def _faults_of_tokens(self) -> list[Fault]:
        counts = Counter(token.id for token in self.tokens)
        faults = [
            Fault(f"tokens.{token}", f"the id {times} times", "each id once")
            for token, times in counts.items()
            if times > 1
        ]
        if len(self.tokens) > MAX_TOKENS:
            faults.append(Fault("tokens", f"{len(self.tokens)}", f"at most {MAX_TOKENS}"))
        kinds: dict[str, str] = {}
        for token in self.tokens:
            for name, value in token.attributes:
                kind = "a string" if isinstance(value, str) else "a number"
                where = f"tokens.{token.id}.{name}"
                if kinds.setdefault(name, kind) != kind:
                    faults.append(Fault(where, kind, f"{kinds[name]} as on the other tokens"))
                if not isinstance(value, str) and not -MAX_NUMBER <= value <= MAX_NUMBER:
                    faults.append(Fault(where, "too large a number", f"at most {MAX_NUMBER:.0e}"))
        return faults

    def _faults_of_orders(self) -> list[Fault]:
        faults = [
            Fault(f"cycles.{name}", "also in orders", "one or the other")
            for name in self.orders.keys() & self.cycles.keys()
        ]
        for kind, declared in (("orders", self.orders), ("cycles", self.cycles)):
            for name, values in declared.items():
                faults.extend(
                    Fault(f"{kind}.{name}", f"{value!r} twice", "each value once")
                    for value, times in Counter(values).items()
                    if times > 1
                )
                faults.extend(
                    Fault(
                        f"tokens.{token.id}.{name}",
                        repr(value),
                        f"a value of {kind}.{name}",
                    )
                    for token in self.tokens
                    if (value := token.value(name)) is not None and value not in values
                )
        return faults

    @cached_property
    def by_id(self) -> Mapping[TokenId, Token]:
        """The tokens by their ids."""
        return MappingProxyType({token.id: token for token in self.tokens})

    @cached_property
    def scales(self) -> Mapping[str, Scale]:
        """How the values of each attribute compare, sorted by the attribute's name."""
        names = sorted({name for token in self.tokens for name, _ in token.attributes})
        return MappingProxyType({name: self._scale(name) for name in names})

    def _scale(self, attribute: str) -> Scale:
        if attribute in self.orders:
            return Scale.ORDER
        if attribute in self.cycles:
            return Scale.CYCLE
        values = [value for token in self.tokens if (value := token.value(attribute)) is not None]
        if not any(isinstance(value, str) for value in values):
            return Scale.NUMBER
        letters = attribute == LETTER and all(
            isinstance(value, str) and len(value) == 1 and value.isalpha() for value in values
        )
        return Scale.LETTER if letters else Scale.NOMINAL

    def rank(self, attribute: str, value: Value) -> int | Decimal:
        """Where `value` stands in the order of `attribute`; only differences have a meaning.

        Raises:
            ValueError: the attribute is nominal.
        """
        if not isinstance(value, str):
            return value
        match self.scales.get(attribute, Scale.NOMINAL):
            case Scale.ORDER:
                return self.orders[attribute].index(value)
            case Scale.CYCLE:
                return self.cycles[attribute].index(value)
            case Scale.LETTER:
                return alphabet_rank(value)
            case Scale.NUMBER | Scale.NOMINAL:
                message = f"{attribute} has no order"
                raise ValueError(message)


_ALPHABET: Final = "abcdefghijklmnñopqrstuvwxyz"


def alphabet_rank(letter: str) -> int:
    """The place of `letter` in the alphabet; accents and case do not count, ñ follows n.

    Letters of other scripts come after z in the order of Unicode.
    """
    small = letter.casefold()
    if small == "ñ":
        return _ALPHABET.index("ñ")
    base = unicodedata.normalize("NFD", small)[0]
    place = _ALPHABET.find(base)
    return place if place >= 0 else len(_ALPHABET) + ord(base)
