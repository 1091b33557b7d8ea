"""Observable features of tokens, of pairs of tokens, and of the cells of a move.

A feature has a name, the scales of attribute it applies to, and a test. A parameter is part of
the name: ``multiple-of-5``, ``digits-2``, ``is-red``. Where several attributes qualify, a
feature is taken over each of them; ``less-than:size`` means that of one attribute only. Their
words in each language are in `maestra.language`.
"""

from __future__ import annotations

import difflib
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from types import MappingProxyType
from typing import Final, TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import NAME, Attributes, Deck, Scale, Value

_NUMBERS: Final = frozenset({Scale.NUMBER})
_LETTERS: Final = frozenset({Scale.LETTER})
_DECLARED: Final = frozenset({Scale.LETTER, Scale.ORDER})
_STEPPED: Final = frozenset({Scale.NUMBER, Scale.LETTER, Scale.ORDER, Scale.CYCLE})
_ANY: Final = frozenset(Scale)

PRIME_LIMIT: Final = 10**8
"""Above it a number is not tested for being prime by trial division: no token shows such."""


@dataclass(frozen=True, slots=True, order=True)
class TokenFeature:
    """A predicate over what one token shows under `attribute`, such as ``odd``."""

    name: str
    attribute: str

    @property
    def label(self) -> str:
        """The name that selects just this feature: ``odd:value``."""
        return f"{self.name}:{self.attribute}"


@dataclass(frozen=True, slots=True, order=True)
class PairFeature:
    """A predicate over what two tokens show under `attribute`, such as ``less-than``."""

    name: str
    attribute: str

    @property
    def label(self) -> str:
        """The name that selects just this feature: ``less-than:value``."""
        return f"{self.name}:{self.attribute}"

    @property
    def symmetric(self) -> bool:
        """Whether it always holds both ways or neither."""
        return self.name in _SYMMETRIC


@dataclass(frozen=True, slots=True, order=True)
class CellFeature:
    """Something about the origin and destination of a move, such as ``origin``."""

    name: str

    @property
    def label(self) -> str:
        """The name that selects this feature."""
        return self.name

    def of(self, board: Board, origin: Cell, destination: Cell) -> CellValue:
        """What this feature is for a move from `origin` to `destination`."""
        return CELL_FEATURES[self.name].of(board, origin, destination)

    def values(self, board: Board) -> Sequence[CellValue]:
        """What a literal can demand of it on `board`; of a yes or no only the yes."""
        return CELL_FEATURES[self.name].values(board)


Feature: TypeAlias = TokenFeature | PairFeature | CellFeature
CellValue: TypeAlias = Cell | int | bool

_TokenTest: TypeAlias = Callable[[Value], bool]
_PairTest: TypeAlias = Callable[[Deck, str, Value, Value], bool]


def _is_odd(value: Value) -> bool:
    return isinstance(value, int) and value % 2 == 1


def _is_even(value: Value) -> bool:
    return isinstance(value, int) and value % 2 == 0


def _is_prime(value: Value) -> bool:
    if not isinstance(value, int) or not 1 < value <= PRIME_LIMIT:
        return False
    return all(value % divisor for divisor in range(2, int(value**0.5) + 1))


def _is_vowel(value: Value) -> bool:
    """Whether the letter is one of a, e, i, o, u, with or without an accent."""
    return unicodedata.normalize("NFD", str(value).casefold())[0] in "aeiou"


def _is_consonant(value: Value) -> bool:
    return not _is_vowel(value)


@dataclass(frozen=True, slots=True)
class _TokenDefinition:
    scales: frozenset[Scale]
    test: _TokenTest


@dataclass(frozen=True, slots=True)
class _ParameterDefinition:
    """A family of token features, one for each value of a parameter."""

    scales: frozenset[Scale]
    test: Callable[[Value, str], bool]
    accepts: Callable[[str], bool]


@dataclass(frozen=True, slots=True)
class _PairDefinition:
    scales: frozenset[Scale]
    test: _PairTest


@dataclass(frozen=True, slots=True)
class _CellDefinition:
    of: Callable[[Board, Cell, Cell], CellValue]
    values: Callable[[Board], Sequence[CellValue]]
    """What a literal can demand of it; of a yes or no only the yes."""


def _rows(board: Board) -> Sequence[CellValue]:
    return range(1, board.rows + 1)


def _columns(board: Board) -> Sequence[CellValue]:
    return range(1, board.columns + 1)


def _yes(_board: Board) -> Sequence[CellValue]:
    return (True,)


def _is_count(text: str) -> bool:
    return text.isascii() and text.isdecimal() and 0 < len(text) <= 9 and int(text) > 0  # noqa: PLR2004 - nine digits fit any machine number


def _is_number(text: str) -> bool:
    digits = text.removeprefix("-").replace(".", "", 1)
    return digits.isascii() and digits.isdecimal() and len(digits) <= 15  # noqa: PLR2004 - as formats


def _shown(value: Value) -> str:
    """A value as a feature's name writes it."""
    return str(value)


def _has_digits(value: Value, count: str) -> bool:
    return isinstance(value, int) and len(str(abs(value))) == int(count)


TOKEN_FEATURES: Final[Mapping[str, _TokenDefinition]] = MappingProxyType(
    {
        "odd": _TokenDefinition(_NUMBERS, _is_odd),
        "even": _TokenDefinition(_NUMBERS, _is_even),
        "prime": _TokenDefinition(_NUMBERS, _is_prime),
        "vowel": _TokenDefinition(_LETTERS, _is_vowel),
        "consonant": _TokenDefinition(_LETTERS, _is_consonant),
    }
)
"""Features of one token that have no parameter."""

PARAMETER_FEATURES: Final[Mapping[str, _ParameterDefinition]] = MappingProxyType(
    {
        "multiple-of": _ParameterDefinition(
            _NUMBERS, lambda value, k: Decimal(value) % int(k) == 0, _is_count
        ),
        "digits": _ParameterDefinition(_NUMBERS, _has_digits, _is_count),
        "above": _ParameterDefinition(
            _NUMBERS, lambda value, k: Decimal(value) > Decimal(k), _is_number
        ),
        "below": _ParameterDefinition(
            _NUMBERS, lambda value, k: Decimal(value) < Decimal(k), _is_number
        ),
        "is": _ParameterDefinition(_ANY, lambda value, shown: _shown(value) == shown, bool),
    }
)
"""Families of features of one token: the parameter follows the name and a hyphen."""


def _ranks(deck: Deck, attribute: str, first: Value, second: Value) -> tuple[Decimal, Decimal]:
    return Decimal(deck.rank(attribute, first)), Decimal(deck.rank(attribute, second))


def _less(deck: Deck, attribute: str, first: Value, second: Value) -> bool:
    before, after = _ranks(deck, attribute, first, second)
    return before < after


def _successor(deck: Deck, attribute: str, first: Value, second: Value) -> bool:
    before, after = _ranks(deck, attribute, first, second)
    if attribute in deck.cycles:
        return (before + 1) % len(deck.cycles[attribute]) == after
    return before + 1 == after


def _twice(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return Decimal(first) * 2 == Decimal(second)


def _same(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return first == second


def _different(_deck: Deck, _attribute: str, first: Value, second: Value) -> bool:
    return first != second


PAIR_FEATURES: Final[Mapping[str, _PairDefinition]] = MappingProxyType(
    {
        "less-than": _PairDefinition(_NUMBERS, _less),
        "before": _PairDefinition(_DECLARED, _less),
        "successor": _PairDefinition(_STEPPED, _successor),
        "twice": _PairDefinition(_NUMBERS, _twice),
        "same": _PairDefinition(_ANY, _same),
        "different": _PairDefinition(_ANY, _different),
    }
)
"""Features of two tokens, read "first ... second": the second is the successor of the first."""

CONVERSES: Final[Mapping[str, str]] = MappingProxyType(
    {"greater-than": "less-than", "after": "before", "predecessor": "successor", "half": "twice"}
)
"""Names for a feature read from its other end; whoever selects one gets the feature itself."""

_SYMMETRIC: Final = frozenset({"same", "different"})

CELL_FEATURES: Final[Mapping[str, _CellDefinition]] = MappingProxyType(
    {
        "origin": _CellDefinition(lambda _, origin, __: origin, lambda board: board.cells),
        "destination": _CellDefinition(lambda _, __, to: to, lambda board: board.cells),
        "origin-row": _CellDefinition(lambda _, origin, __: int(origin.row), _rows),
        "origin-column": _CellDefinition(lambda _, origin, __: int(origin.column), _columns),
        "destination-column": _CellDefinition(lambda _, __, to: int(to.column), _columns),
        "same-column": _CellDefinition(lambda _, origin, to: origin.column == to.column, _yes),
        "from-storage": _CellDefinition(
            lambda board, origin, _: origin.row != board.goal_row, _yes
        ),
        "to-goal-row": _CellDefinition(lambda board, _, to: to.row == board.goal_row, _yes),
    }
)
"""Features of a move's two cells."""

CELLS: Final = "cells"
"""Selects `origin` and `destination` and nothing else of tokens."""
FRAME: Final = (CellFeature("from-storage"), CellFeature("to-goal-row"))
"""What every exercise of this kind has in common; always in the vocabulary."""
DEFAULT_CELLS: Final = (CellFeature("destination"), CellFeature("origin"))
"""The cell features that count unless the caregiver names others."""
DEFAULT_PAIRS: Final = ("less-than", "before")
"""The features of two tokens that count unless the caregiver names others: the paper's order."""
DEFAULT_TOKENS: Final = ("odd", "even", "vowel", "consonant")
"""The features of one token that count unless the caregiver names others."""


class UnknownFeatureError(InvalidError):
    """A feature that does not exist, or that no attribute of the deck has."""


def token_feature_holds(feature: TokenFeature, attributes: Attributes) -> bool:
    """Whether a token that shows `attributes` has the feature; not, if it lacks the attribute."""
    value = _value(attributes, feature.attribute)
    if value is None:
        return False
    if feature.name in TOKEN_FEATURES:
        return TOKEN_FEATURES[feature.name].test(value)
    family, parameter = _split_parameter(feature.name)
    return PARAMETER_FEATURES[family].test(value, parameter)


def pair_feature_holds(
    feature: PairFeature, deck: Deck, first: Attributes, second: Attributes
) -> bool:
    """Whether `feature`(first, second) is true; not, if either lacks the attribute."""
    one, other = _value(first, feature.attribute), _value(second, feature.attribute)
    if one is None or other is None:
        return False
    if feature.name in PAIR_FEATURES:
        return PAIR_FEATURES[feature.name].test(deck, feature.attribute, one, other)
    return (str(one), str(other)) in deck.relations[feature.name]


def select_features(deck: Deck, names: Sequence[str] | None) -> tuple[Feature, ...]:
    """The features that count for `deck`, in the order of the registry.

    Args:
        deck: its attributes decide which features apply.
        names: what the caregiver selected; None takes the defaults. Cell features that nobody
            names count as by default; ``cells`` alone leaves nothing but those.

    Raises:
        UnknownFeatureError: a name that is none (with the nearest known one), or that applies to
            no attribute of the deck; all of them at once.
    """
    if names is None:
        applicable = _applicable(deck)
        chosen = [applicable.get(name, ()) for name in (*DEFAULT_TOKENS, *DEFAULT_PAIRS)]
        return (*FRAME, *DEFAULT_CELLS, *(feature for some in chosen for feature in some))
    faults: list[Fault] = []
    found: list[Feature] = []
    for name in names:
        try:
            found.extend(_features_named(deck, name))
        except UnknownFeatureError as error:
            faults.extend(error.faults)
    if faults:
        raise UnknownFeatureError(faults)
    if not any(isinstance(feature, CellFeature) for feature in found):
        found[:0] = DEFAULT_CELLS
    return tuple(dict.fromkeys((*FRAME, *found)))


def feature_names(deck: Deck) -> tuple[str, ...]:
    """Every name that `select_features` takes for this deck, parameters written as ``K``."""
    pairs = (*PAIR_FEATURES, *CONVERSES, *deck.relations)
    families = (f"{name}-K" for name in PARAMETER_FEATURES)
    return (CELLS, *CELL_FEATURES, *TOKEN_FEATURES, *families, *pairs)


def _features_named(deck: Deck, name: str) -> tuple[Feature, ...]:
    """The features that one selected name stands for."""
    if name == CELLS:
        return DEFAULT_CELLS
    if name in CELL_FEATURES:
        return (CellFeature(name),)
    bare, attribute = _split_attribute(deck, name)
    known = CONVERSES.get(bare, bare)
    features = _applicable(deck).get(known)
    if features is None:
        features = _family_features(deck, known)
    if features is None:
        raise UnknownFeatureError([Fault(name, "unknown feature", _nearest(deck, name))])
    if attribute:
        features = tuple(feature for feature in features if feature.attribute == attribute)
    if not features:
        have = ", ".join(f"{name} ({scale.value})" for name, scale in deck.scales.items())
        raise UnknownFeatureError(
            [Fault(name, "no attribute it applies to", f"a feature of {have or 'this deck'}")]
        )
    return features


def _split_attribute(deck: Deck, name: str) -> tuple[str, str]:
    """The feature and the attribute of ``less-than:size``; a value too may have a colon."""
    bare, colon, attribute = name.rpartition(":")
    if not colon or (attribute not in deck.scales and bare.startswith("is-")):
        return name, ""
    return bare, attribute


def _applicable(deck: Deck) -> dict[str, tuple[TokenFeature | PairFeature, ...]]:
    """Each registered feature without a parameter, over every attribute it applies to."""
    scales = deck.scales.items()
    tokens = {
        name: tuple(TokenFeature(name, a) for a, scale in scales if scale in definition.scales)
        for name, definition in TOKEN_FEATURES.items()
    }
    pairs = {
        name: tuple(PairFeature(name, a) for a, scale in scales if scale in definition.scales)
        for name, definition in PAIR_FEATURES.items()
    }
    relations = {name: (PairFeature(name, NAME),) for name in deck.relations}
    return {**tokens, **pairs, **relations}


def _family_features(deck: Deck, name: str) -> tuple[TokenFeature, ...] | None:
    """The features of one token that `name` stands for with its parameter; None if none."""
    family, parameter = _split_parameter(name)
    definition = PARAMETER_FEATURES.get(family)
    if definition is None or not definition.accepts(parameter):
        return None
    over = [a for a, scale in deck.scales.items() if scale in definition.scales]
    return tuple(TokenFeature(name, attribute) for attribute in over)


def _split_parameter(name: str) -> tuple[str, str]:
    """The family and the parameter of a name: ``multiple-of-5`` is ``multiple-of`` and ``5``."""
    for family in PARAMETER_FEATURES:
        if name.startswith(f"{family}-"):
            return family, name.removeprefix(f"{family}-")
    return name, ""


def _nearest(deck: Deck, name: str) -> str:
    known = feature_names(deck)
    near = difflib.get_close_matches(name.partition(":")[0], known, n=1, cutoff=0.0)
    return f"a known one, the nearest is {near[0]}"


def _value(attributes: Attributes, attribute: str) -> Value | None:
    return next((value for name, value in attributes if name == attribute), None)
