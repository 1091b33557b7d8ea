"""Movable pieces, what they show, and sets of them."""

import unicodedata
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum
from functools import cached_property
from types import MappingProxyType
from typing import Final, NewType, TypeAlias, assert_never

from maestra.core.faults import Fault, refuse, shorten
from maestra.core.text import MAX_TEXT, faults_of_name, is_plain

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
MAX_NAMES: Final = 100
"""Attributes of a token, orders, cycles, relations: each is a thing a caregiver must know of."""
MAX_LISTED: Final = 10_000
"""Values of an order, pairs of a relation: as many as tokens."""
MAX_WORDS: Final = 1_000_000
"""Words in a lexicon: larger than any language's dictionary of base forms."""


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
    """A movable piece: its unique id and what it shows.

    Raises:
        InvalidError: an id or name that is empty or no plain text, an attribute twice, more than
            `MAX_NAMES` of them, a value as `expected_value` refuses it.
    """

    id: TokenId
    attributes: Attributes

    def __post_init__(self) -> None:
        """Sort the attributes and reduce numbers: equal tokens look and are written alike."""
        place = f"tokens.{self.id}"
        faults = [
            *faults_of_name(place, self.id),
            *_too_many(place, "attributes", len(self.attributes), MAX_NAMES),
            *_twice(place, [name for name, _ in self.attributes]),
        ]
        for name, value in self.attributes:
            faults += faults_of_name(f"{place}.{name}", name)
            if (expected := expected_value(value)) is not None:
                faults.append(Fault(f"{place}.{name}", shorten(value), expected))
        refuse(faults)
        reduced = [(name, _reduce(value)) for name, value in self.attributes]
        object.__setattr__(self, "attributes", tuple(sorted(reduced, key=lambda pair: pair[0])))

    def value(self, attribute: str) -> Value | None:
        """What the token shows under `attribute`; None when it has no such attribute."""
        return next((value for name, value in self.attributes if name == attribute), None)


@dataclass(frozen=True)
class Deck:
    """A set of tokens, and what their attributes mean: orders, cycles, relations, words.

    Raises:
        InvalidError: no token, an id twice, an attribute with numbers and strings mixed, a value
            missing from its declared order, an order that is empty, has a value twice or is also
            a cycle, more of anything than its limit, a name or word that is no plain text.
    """

    tokens: tuple[Token, ...]
    orders: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    """Attribute to its values from first to last."""
    cycles: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    """Attribute to its values once round."""
    relations: Mapping[str, frozenset[tuple[str, str]]] = field(
        default_factory=dict[str, frozenset[tuple[str, str]]]
    )
    """Relation to its pairs of values of the attribute `name`."""
    lexicon: tuple[str, ...] = ()
    """The words that count as words."""

    def __post_init__(self) -> None:
        """Freeze the mappings and refuse what makes no deck, naming every fault."""
        ordered = tuple(sorted(self.tokens, key=lambda token: token.id))
        object.__setattr__(self, "tokens", ordered)
        for name in ("orders", "cycles", "relations"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))
        refuse(
            [
                *self._faults_of_tokens(),
                *self._faults_of_orders(),
                *self._faults_of_relations(),
                *_faults_of_list("lexicon", self.lexicon, MAX_WORDS),
            ]
        )

    def __hash__(self) -> int:
        """By the tokens alone: enough to tell decks apart quickly."""
        return hash(self.tokens)

    def __reduce__(self) -> tuple[type["Deck"], tuple[object, ...]]:
        """Pickled by its parts, for a frozen mapping cannot be."""
        mappings = (dict(self.orders), dict(self.cycles), dict(self.relations))
        return Deck, (self.tokens, *mappings, self.lexicon)

    def _faults_of_tokens(self) -> list[Fault]:
        faults = [
            *_too_many("tokens", "tokens", len(self.tokens), MAX_TOKENS),
            *_twice("tokens", [token.id for token in self.tokens]),
        ]
        if not self.tokens:
            faults.append(Fault("tokens", "no token", "at least one"))
        kinds: dict[str, str] = {}
        for token in self.tokens:
            for name, value in token.attributes:
                kind = "a string" if isinstance(value, str) else "a number"
                if (first := kinds.setdefault(name, kind)) != kind:
                    expected = f"{first} as on the other tokens"
                    faults.append(Fault(f"tokens.{token.id}.{name}", shorten(value), expected))
        return faults

    def _faults_of_orders(self) -> list[Fault]:
        faults = [
            Fault(f"cycles.{name}", "also in orders", "one or the other")
            for name in sorted(self.orders.keys() & self.cycles.keys())
        ]
        for kind, declared in (("orders", self.orders), ("cycles", self.cycles)):
            faults += _too_many(kind, "names", len(declared), MAX_NAMES)
            for name, values in declared.items():
                place = f"{kind}.{name}"
                faults += faults_of_name(place, name)
                faults += _faults_of_list(place, values, MAX_LISTED)
                faults += _twice(place, values)
                if not values:
                    faults.append(Fault(place, "no value", "the values in their order"))
                faults += self._faults_of_unlisted(place, name, frozenset[object](values))
        return faults

    def _faults_of_unlisted(
        self, place: str, attribute: str, listed: frozenset[object]
    ) -> list[Fault]:
        return [
            Fault(f"tokens.{token.id}.{attribute}", shorten(value), f"a value of {place}")
            for token in self.tokens
            if (value := token.value(attribute)) is not None and value not in listed
        ]

    def _faults_of_relations(self) -> list[Fault]:
        faults = _too_many("relations", "names", len(self.relations), MAX_NAMES)
        for name, pairs in self.relations.items():
            place = f"relations.{name}"
            faults += faults_of_name(place, name)
            faults += _too_many(place, "pairs", len(pairs), MAX_LISTED)
            names = {one for pair in pairs for one in pair}
            faults += [fault for one in sorted(names) for fault in faults_of_name(place, one)]
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
        scale = self.scales.get(attribute, Scale.NOMINAL)
        match scale:
            case Scale.ORDER:
                return self.orders[attribute].index(value)
            case Scale.CYCLE:
                return self.cycles[attribute].index(value)
            case Scale.LETTER:
                return alphabet_rank(value)
            case Scale.NUMBER | Scale.NOMINAL:
                raise ValueError(f"{attribute} has no order")
            case _:
                assert_never(scale)


def expected_value(value: object) -> str | None:
    """What should stand where `value` stands; None when it can be a token's value.

    A number must be one that 64 bits hold: what is written must be what is read.
    """
    if isinstance(value, str):
        plain = len(value) <= MAX_TEXT and is_plain(value)
        return (
            None if plain else f"text of at most {MAX_TEXT} characters without control characters"
        )
    if isinstance(value, bool) or not isinstance(value, int | Decimal):
        return "a number or a string"
    if isinstance(value, Decimal) and value.is_nan():
        return "a number"
    if not -MAX_NUMBER <= value <= MAX_NUMBER:
        return "a number from -10^15 to 10^15"
    return None if _fits_64_bits(value) else "a number of at most 15 digits"


def _reduce(value: Value) -> Value:
    """2.0 is 2, 1.50 is 1.5."""
    if not isinstance(value, Decimal):
        return value
    return int(value) if value == value.to_integral_value() else value.normalize()


def _fits_64_bits(value: int | Decimal) -> bool:
    return isinstance(value, int) or Decimal(repr(float(value))) == value


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


def _too_many(place: str, what: str, count: int, most: int) -> list[Fault]:
    return [Fault(place, f"{count} {what}", f"at most {most}")] if count > most else []


def _twice(place: str, names: Sequence[str]) -> list[Fault]:
    if len(set(names)) == len(names):
        return []
    return [
        Fault(place, f"{shorten(name)} {times} times", "each once")
        for name, times in Counter(names).items()
        if times > 1
    ]


def _faults_of_list(place: str, words: tuple[str, ...], most: int) -> list[Fault]:
    faults = _too_many(place, "words", len(words), most)
    for index, word in enumerate(words):
        faults += faults_of_name(f"{place}[{index}]", word)
    return faults
