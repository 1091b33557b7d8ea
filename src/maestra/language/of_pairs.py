"""What is said of two tokens: relations and features, as phrases about one of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from maestra.core.tokens import Scale
from maestra.language.keys import Predicate
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import (
    Adjective,
    AttributeNamed,
    Count,
    Degree,
    Does,
    Foreign,
    Numeral,
    Phrase,
    does,
)
from maestra.rules.features import PairFeature
from maestra.rules.fields import Number
from maestra.rules.pairs import AddUp, Apart, Compare, Named, Relation, Step, Times
from maestra.rules.token_tests import Comparison


@dataclass(frozen=True, slots=True)
class Two:
    """Says how a token, the subject, stands to another."""

    tokens: Tokens
    subject: Phrase | None
    other: Phrase

    def stands(self, relation: Relation) -> Does:
        """That the other is the first of the pair and the subject the second."""
        match relation:
            case Compare(attribute, comparison, own):
                if own is None:
                    return self._compares(attribute, comparison)
                return self._compares_across(own, attribute, comparison)
            case Step(attribute, amount):
                return self._is_further(attribute, amount)
            case Apart(attribute, amount):
                return self._about(Predicate.APART_BY, attribute, k=Numeral(amount))
            case Times(attribute, amount):
                return self._is_times(attribute, amount)
            case AddUp(attribute, amount):
                return self._about(Predicate.TOGETHER, attribute, k=Numeral(amount))
            case Named(name):
                return self._is_related(name)
            case _:
                assert_never(relation)

    def has(self, feature: PairFeature, *, converse: bool) -> Does:
        """That the feature holds of the other and the subject; `converse`: the other way round."""
        attribute = feature.attribute
        match feature.name:
            case "less-than" | "before":
                return self._compares(attribute, Comparison.MORE if converse else Comparison.LESS)
            case "same":
                return self._compares(attribute, Comparison.EQUAL)
            case "different":
                return self._compares(attribute, Comparison.DIFFERENT)
            case "successor":
                return self._is_further(attribute, -1 if converse else 1)
            case "twice":
                predicate = Predicate.HALF if converse else Predicate.TWICE
                return self._about(predicate, attribute)
            case name:
                return self._is_related(name, back=converse)

    def _about(self, predicate: Predicate, attribute: str, **parts: Phrase) -> Does:
        named = AttributeNamed(attribute)
        return does(predicate, self.subject, other=self.other, attribute=named, **parts)

    def _compares(self, attribute: str, comparison: Comparison) -> Does:
        """That the other compares so to the subject; "at most" is "the subject is not less"."""
        match comparison:
            case Comparison.EQUAL:
                return self._about(Predicate.SAME, attribute)
            case Comparison.DIFFERENT:
                return self._about(Predicate.DIFFERENT, attribute)
            case Comparison.LESS:
                return self._is_greater(attribute)
            case Comparison.MORE:
                return self._is_less(attribute)
            case Comparison.AT_MOST:
                return _not(self._is_less(attribute))
            case Comparison.AT_LEAST:
                return _not(self._is_greater(attribute))
            case _:
                assert_never(comparison)

    def _is_greater(self, attribute: str) -> Does:
        predicate = self.tokens.compares(attribute, greater=True)
        return self._about(predicate, attribute, adjective=Adjective(attribute, Degree.MORE))

    def _is_less(self, attribute: str) -> Does:
        predicate = self.tokens.compares(attribute, greater=False)
        return self._about(predicate, attribute, adjective=Adjective(attribute, Degree.LESS))

    def _compares_across(self, own: str, attribute: str, comparison: Comparison) -> Does:
        """As `_compares`, what the subject shows under `own` with the other's `attribute`."""
        theirs = AttributeNamed(attribute)
        match comparison:
            case Comparison.EQUAL | Comparison.DIFFERENT:
                said = self._about(Predicate.SAME_ACROSS, own, theirs=theirs)
                return said if comparison is Comparison.EQUAL else _not(said)
            case Comparison.LESS | Comparison.AT_LEAST:
                said = self._about(Predicate.MORE_ACROSS, own, theirs=theirs)
                return said if comparison is Comparison.LESS else _not(said)
            case Comparison.MORE | Comparison.AT_MOST:
                said = self._about(Predicate.LESS_ACROSS, own, theirs=theirs)
                return said if comparison is Comparison.MORE else _not(said)
            case _:
                assert_never(comparison)

    def _is_further(self, attribute: str, amount: Number) -> Does:
        if amount == 0:
            return self._about(Predicate.SAME, attribute)
        scale = self.tokens.deck.scales.get(attribute, Scale.NUMBER)
        if scale in {Scale.LETTER, Scale.ORDER, Scale.CYCLE}:
            return self._is_places_further(attribute, int(amount), scale)
        predicate = Predicate.MORE_BY if amount > 0 else Predicate.LESS_BY
        return self._about(predicate, attribute, k=Numeral(amount if amount > 0 else -amount))

    def _is_places_further(self, attribute: str, amount: int, scale: Scale) -> Does:
        after = amount > 0
        if abs(amount) > 1:
            predicate = Predicate.AFTER_BY if after else Predicate.BEFORE_BY
            return self._about(predicate, attribute, k=Count(abs(amount)))
        if scale is Scale.LETTER:
            beside = Predicate.NEXT_IN_ALPHABET if after else Predicate.PREVIOUS_IN_ALPHABET
            return self._about(beside, attribute)
        return self._about(Predicate.NEXT if after else Predicate.PREVIOUS, attribute)

    def _is_times(self, attribute: str, amount: Number) -> Does:
        if amount == 2:  # noqa: PLR2004 - twice
            return self._about(Predicate.TWICE, attribute)
        if amount + amount == 1:
            return self._about(Predicate.HALF, attribute)
        return self._about(Predicate.TIMES, attribute, k=Numeral(amount))

    def _is_related(self, name: str, *, back: bool = False) -> Does:
        predicate = Predicate.RELATED_BACK if back else Predicate.RELATED
        return does(predicate, self.subject, other=self.other, relation=Foreign(name))


def _not(said: Does) -> Does:
    return Does(said.predicate, said.parts, said.subject, not said.negated)
