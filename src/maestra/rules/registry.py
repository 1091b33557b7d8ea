"""The registry of features: what each applies to and what it tests.

A new feature is one line in a table here, and its words in each language.
"""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from types import MappingProxyType
from typing import Final, TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.tokens import Deck, Scale, Value

CellValue: TypeAlias = Cell | int | bool
"""What a feature of a move's cells can be."""

_NUMBERS: Final = frozenset({Scale.NUMBER})
_LETTERS: Final = frozenset({Scale.LETTER})
_DECLARED: Final = frozenset({Scale.LETTER, Scale.ORDER})
_STEPPED: Final = frozenset({Scale.NUMBER, Scale.LETTER, Scale.ORDER, Scale.CYCLE})
_ANY: Final = frozenset(Scale)

MAX_COUNT: Final = 10**9
"""The largest parameter that counts something; any machine holds it."""
MAX_DIGITS: Final = 15
"""Digits of a parameter that is compared with values: as many as a value has."""
PRIME_LIMIT: Final = 10**8
"""Above it no number counts as prime: no token shows such, and trial division takes its time."""


@dataclass(frozen=True, slots=True)
class TokenDefinition:
    """A feature of one token: for which scales of attribute, and whether a value has it."""

    scales: frozenset[Scale]
    test: Callable[[Value], bool]


@dataclass(frozen=True, slots=True)
class ParameterDefinition:
    """A family of features of one token, one for each parameter that `accepts` takes."""

    scales: frozenset[Scale]
    test: Callable[[Value, str], bool]
    accepts: Callable[[str], bool]


@dataclass(frozen=True, slots=True)
class PairDefinition:
    """A feature of two tokens: deck, attribute, and what the first and the second show."""

    scales: frozenset[Scale]
    test: Callable[[Deck, str, Value, Value], bool]


@dataclass(frozen=True, slots=True)
class CellDefinition:
    """A feature of a move's cells."""

    of: Callable[[Board, Cell, Cell], CellValue]
    values: Callable[[Board], Sequence[CellValue]]
    """What a literal can demand of it; of a yes or no only the yes."""


def _is_odd(value: Value) -> bool:
    return isinstance(value, int) and value % 2 == 1


def _is_even(value: Value) -> bool:
    return isinstance(value, int) and value % 2 == 0


def _is_prime(value: Value) -> bool:
    if not isinstance(value, int) or not 1 < value <= PRIME_LIMIT:
        return False
    return all(value % divisor for divisor in range(2, math.isqrt(value) + 1))


def _is_vowel(value: Value) -> bool:
    """Whether the letter is one of a, e, i, o, u, with or without an accent."""
    return unicodedata.normalize("NFD", str(value).casefold())[0] in "aeiou"


def _is_consonant(value: Value) -> bool:
    return not _is_vowel(value)


def _rows(board: Board) -> Sequence[CellValue]:
    return range(1, board.rows + 1)


def _columns(board: Board) -> Sequence[CellValue]:
    return range(1, board.columns + 1)


def _yes(_board: Board) -> Sequence[CellValue]:
    return (True,)


def _is_count(text: str) -> bool:
    return _is_digits(text) and len(text) <= len(str(MAX_COUNT)) and 0 < int(text) <= MAX_COUNT


def _is_number(text: str) -> bool:
    digits = text.removeprefix("-").replace(".", "", 1)
    return _is_digits(digits) and len(digits) <= MAX_DIGITS


def _is_digits(text: str) -> bool:
    return text.isascii() and text.isdecimal()


def _is_multiple(value: Value, of: str) -> bool:
    return Fraction(value) % int(of) == 0


def _has_digits(value: Value, count: str) -> bool:
    return isinstance(value, int) and len(str(abs(value))) == int(count)


def _is_above(value: Value, limit: str) -> bool:
    return Decimal(value) > Decimal(limit)


def _is_below(value: Value, limit: str) -> bool:
    return Decimal(value) < Decimal(limit)


def _is(value: Value, shown: str) -> bool:
    if isinstance(value, str):
        return value == shown
    return _is_number(shown) and Decimal(value) == Decimal(shown)


IS: Final = "is"
"""The family of features that name a value: ``is-red``."""

TOKEN_FEATURES: Final[Mapping[str, TokenDefinition]] = MappingProxyType(
    {
        "odd": TokenDefinition(_NUMBERS, _is_odd),
        "even": TokenDefinition(_NUMBERS, _is_even),
        "prime": TokenDefinition(_NUMBERS, _is_prime),
        "vowel": TokenDefinition(_LETTERS, _is_vowel),
        "consonant": TokenDefinition(_LETTERS, _is_consonant),
    }
)
"""Features of one token that have no parameter."""

PARAMETER_FEATURES: Final[Mapping[str, ParameterDefinition]] = MappingProxyType(
    {
        "multiple-of": ParameterDefinition(_NUMBERS, _is_multiple, _is_count),
        "digits": ParameterDefinition(_NUMBERS, _has_digits, _is_count),
        "above": ParameterDefinition(_NUMBERS, _is_above, _is_number),
        "below": ParameterDefinition(_NUMBERS, _is_below, _is_number),
        IS: ParameterDefinition(_ANY, _is, bool),
    }
)
"""Families of features of one token: the parameter follows the name and a hyphen."""


def _less(deck: Deck, attribute: str, first: Value, second: Value) -> bool:
    return deck.rank(attribute, first) < deck.rank(attribute, second)


def _successor(deck: Deck, attribute: str, first: Value, second: Value) -> bool:
    # Fractions, for a sum of decimals is rounded.
    following = Fraction(deck.rank(attribute, first)) + 1
    if attribute in deck.cycles:
        following %= len(deck.cycles[attribute])
    return following == deck.rank(attribute, second)


def _twice(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return Fraction(first) * 2 == Fraction(second)


def _same(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return first == second


def _different(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return first != second


PAIR_FEATURES: Final[Mapping[str, PairDefinition]] = MappingProxyType(
    {
        "less-than": PairDefinition(_NUMBERS, _less),
        "before": PairDefinition(_DECLARED, _less),
        "successor": PairDefinition(_STEPPED, _successor),
        "twice": PairDefinition(_NUMBERS, _twice),
        "same": PairDefinition(_ANY, _same),
        "different": PairDefinition(_ANY, _different),
    }
)
"""Features of two tokens, read from the first to the second: ``less-than`` is first < second,
``successor`` that the second is the successor of the first, ``twice`` that it is twice as much."""

CONVERSES: Final[Mapping[str, str]] = MappingProxyType(
    {"greater-than": "less-than", "after": "before", "predecessor": "successor", "half": "twice"}
)
"""Names for a feature read from its other end; whoever selects one gets the feature itself."""

SYMMETRIC: Final = frozenset({"same", "different"})
"""Features of two tokens that always hold both ways or neither."""

CELL_FEATURES: Final[Mapping[str, CellDefinition]] = MappingProxyType(
    {
        "origin": CellDefinition(lambda _, origin, __: origin, lambda board: board.cells),
        "destination": CellDefinition(lambda _, __, to: to, lambda board: board.cells),
        "origin-row": CellDefinition(lambda _, origin, __: int(origin.row), _rows),
        "origin-column": CellDefinition(lambda _, origin, __: int(origin.column), _columns),
        "destination-column": CellDefinition(lambda _, __, to: int(to.column), _columns),
        "same-column": CellDefinition(lambda _, origin, to: origin.column == to.column, _yes),
        "from-storage": CellDefinition(
            lambda board, origin, _: origin.row != board.goal_row, _yes
        ),
        "to-goal-row": CellDefinition(lambda board, _, to: to.row == board.goal_row, _yes),
    }
)
"""Features of a move's two cells."""
