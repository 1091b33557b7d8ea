"""Observable features of tokens, of pairs of tokens, and of the cells of a move.

A feature has a name, the scales of attribute it applies to, and a test. A parameter is part of
the name: ``multiple-of-5``, ``digits-2``, ``is-red``. Where several attributes qualify, a
feature is taken over each of them; ``less-than:size`` means that of one attribute only. What
each tests is in `registry`, their words in each language in `maestra.language`.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.faults import Fault, InvalidError, shorten
from maestra.core.tokens import NAME, Attributes, Deck, Value
from maestra.rules.registry import (
    CELL_FEATURES,
    CONVERSES,
    IS,
    PAIR_FEATURES,
    PARAMETER_FEATURES,
    SYMMETRIC,
    TOKEN_FEATURES,
    CellValue,
)


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
        return self.name in SYMMETRIC


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


def pair_feature_table(
    feature: PairFeature, deck: Deck, shown: Sequence[Attributes]
) -> tuple[int, ...]:
    """For each of `shown` as the first, the bit set of the seconds for which `feature` is true.

    The same as `pair_feature_holds` for every pair, in a fraction of the time.
    """
    attribute = feature.attribute
    values = [_value(attributes, attribute) for attributes in shown]
    places = [(1 << place, value) for place, value in enumerate(values) if value is not None]
    if feature.name in PAIR_FEATURES:
        test = PAIR_FEATURES[feature.name].test
        return tuple(
            0
            if first is None
            else sum(bit for bit, second in places if test(deck, attribute, first, second))
            for first in values
        )
    pairs = deck.relations[feature.name]
    return tuple(
        sum(
            bit
            for bit, second in places
            if first is not None and (str(first), str(second)) in pairs
        )
        for first in values
    )


def select_features(deck: Deck, names: Sequence[str] | None) -> tuple[Feature, ...]:
    """The features that count for `deck`: `FRAME`, then those of `names` in their order.

    Args:
        deck: its attributes decide which features apply. A relation named like a feature of the
            registry cannot be selected.
        names: what the caregiver selected; None takes the defaults. If no cell feature is among
            them, those count that do by default; ``cells`` alone leaves nothing else.

    Raises:
        UnknownFeatureError: a name that is none (with the nearest known one), or that applies to
            no attribute of the deck; all of them at once.
    """
    if names is None:
        applicable = _applicable(deck)
        chosen = [applicable[name] for name in (*DEFAULT_TOKENS, *DEFAULT_PAIRS)]
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


def labelled_feature(deck: Deck, label: str) -> Feature:
    """The one feature whose `label` this is.

    Raises:
        UnknownFeatureError: there is none for this deck.
    """
    found = next((one for one in _features_named(deck, label) if one.label == label), None)
    if found is None:
        expected = "one feature with its attribute, such as odd:value"
        raise UnknownFeatureError([Fault("", shorten(label), expected)])
    return found


def feature_names(deck: Deck) -> tuple[str, ...]:
    """Every name of a feature, with the relations of `deck`; parameters are written as ``K``."""
    families = (f"{name}-K" for name in PARAMETER_FEATURES)
    relations = (name for name in deck.relations if _is_relation(name))
    names = (*TOKEN_FEATURES, *families, *PAIR_FEATURES, *CONVERSES, *relations)
    return (CELLS, *CELL_FEATURES, *names)


def _features_named(deck: Deck, name: str) -> tuple[Feature, ...]:
    """The features that one selected name stands for: at least one."""
    if name == CELLS:
        return DEFAULT_CELLS
    if name in CELL_FEATURES:
        return (CellFeature(name),)
    fault: Fault | None = None
    for bare, attribute in _readings(deck, name):
        features = _over_each_attribute(deck, CONVERSES.get(bare, bare))
        if features is None:
            continue
        if attribute is not None:
            features = tuple(feature for feature in features if feature.attribute == attribute)
        if features:
            return features
        fault = fault or _not_applicable(deck, name, bare)
    raise UnknownFeatureError([fault or Fault(name, "unknown feature", _nearest(deck, name))])


def _readings(deck: Deck, name: str) -> Iterator[tuple[str, str | None]]:
    """What ``less-than:size`` can mean, as feature and attribute, the likeliest first.

    Names of attributes and the values of ``is`` may have colons themselves.
    """
    pieces = name.split(":")
    splits = [
        (":".join(pieces[:count]), ":".join(pieces[count:])) for count in range(1, len(pieces))
    ]
    yield from (split for split in splits if split[1] in deck.scales)
    yield name, None
    yield from (split for split in splits if split[1] not in deck.scales)


def _over_each_attribute(deck: Deck, name: str) -> tuple[TokenFeature | PairFeature, ...] | None:
    """A feature over every attribute it applies to; None if there is no such feature."""
    features = _applicable(deck).get(name)
    return _family_features(deck, name) if features is None else features


def _applicable(deck: Deck) -> dict[str, tuple[TokenFeature | PairFeature, ...]]:
    """Each feature without a parameter, over every attribute it applies to."""
    scales = deck.scales.items()
    tokens = {
        name: tuple(TokenFeature(name, a) for a, scale in scales if scale in definition.scales)
        for name, definition in TOKEN_FEATURES.items()
    }
    pairs = {
        name: tuple(PairFeature(name, a) for a, scale in scales if scale in definition.scales)
        for name, definition in PAIR_FEATURES.items()
    }
    over_names = [NAME] if NAME in deck.scales else []
    relations = {
        name: tuple(PairFeature(name, attribute) for attribute in over_names)
        for name in deck.relations
        if _is_relation(name)
    }
    return {**tokens, **pairs, **relations}


def _is_relation(name: str) -> bool:
    """Whether a relation of this name can be told from the registry's features."""
    family, _ = _split_parameter(name)
    registries = (TOKEN_FEATURES, PARAMETER_FEATURES, PAIR_FEATURES, CONVERSES, CELL_FEATURES)
    return name != CELLS and not any(family in registry for registry in registries)


def _family_features(deck: Deck, name: str) -> tuple[TokenFeature, ...] | None:
    """A feature with its parameter over every attribute it applies to; None if it is none."""
    family, parameter = _split_parameter(name)
    definition = PARAMETER_FEATURES.get(family)
    if definition is None or not definition.accepts(parameter):
        return None
    over = [a for a, scale in deck.scales.items() if scale in definition.scales]
    features = tuple(TokenFeature(name, attribute) for attribute in over)
    if family != IS:
        return features
    # A value that no token shows is a slip of the pen.
    shown = [token.attributes for token in deck.tokens]
    return tuple(one for one in features if any(token_feature_holds(one, own) for own in shown))


def _split_parameter(name: str) -> tuple[str, str]:
    """The family and the parameter of a name: ``multiple-of-5`` is ``multiple-of`` and ``5``."""
    for family in PARAMETER_FEATURES:
        if name.startswith(f"{family}-"):
            return family, name.removeprefix(f"{family}-")
    return name, ""


def _not_applicable(deck: Deck, name: str, bare: str) -> Fault:
    """The fault of a feature that exists, but not for this deck."""
    family, value = _split_parameter(bare)
    if family == IS:
        return Fault(name, "no token shows it", f"a value that some token shows, not {value}")
    have = ", ".join(f"{one} ({scale.value})" for one, scale in deck.scales.items())
    return Fault(name, "no attribute it applies to", f"a feature of {have or 'bare tokens'}")


def _nearest(deck: Deck, name: str) -> str:
    known = feature_names(deck)
    near = difflib.get_close_matches(name.partition(":")[0], known, n=1, cutoff=0.0)
    return f"a known one, the nearest is {near[0]}"


def _value(attributes: Attributes, attribute: str) -> Value | None:
    for name, value in attributes:
        if name == attribute:
            return value
    return None
