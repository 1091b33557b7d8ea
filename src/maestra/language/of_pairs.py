"""What is said of two tokens: relations and features, as phrases about one of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from types import MappingProxyType
from typing import Final

from maestra.core.tokens import Scale
from maestra.language.keys import Key, Predicate
from maestra.language.of_tokens import Tokens, adjective, said_of
from maestra.language.phrases import Degree, Does, Foreign, Phrase, say
from maestra.language.wordings import ATTRIBUTE, COUNT, NUMBER, Part, Wording, put
from maestra.rules.features import PairFeature
from maestra.rules.pairs import AddUp, Apart, Compare, Named, Relation, Step, Times
from maestra.rules.token_tests import Comparison

_NUMBERS: Final = frozenset({Scale.NUMBER, Scale.NOMINAL})
_LISTED: Final = frozenset({Scale.ORDER, Scale.CYCLE})
_LETTERS: Final = frozenset({Scale.LETTER})
_PLACED: Final = _LISTED | _LETTERS
_HALF: Final = Decimal("0.5")


def _forward(part: Part) -> tuple[Part, str]:
    """By how much, if it is more."""
    return (
        Part("number", lambda n, about: part.phrase(n, about) if n >= 0 else None),
        "amount",
    )


def _back(part: Part) -> tuple[Part, str]:
    """By how much, if it is less."""
    return (
        Part(
            "number",
            lambda n, about: part.phrase(-n, about) if n < 0 else None,
            lambda n, _: -n,
        ),
        "amount",
    )


_RELATION: Final = (Part("relation_name", lambda name, _: Foreign(name)), "name")
_ACROSS: Final = (ATTRIBUTE, "other")
_ORDERED: Final = MappingProxyType(
    {
        Comparison.LESS: (Degree.MORE, False),
        Comparison.MORE: (Degree.LESS, False),
        Comparison.AT_MOST: (Degree.LESS, True),
        Comparison.AT_LEAST: (Degree.MORE, True),
    }
)
"""What the second of two is, if the first compares so to it; "at most" is "not less"."""


def _compared(comparison: Comparison) -> tuple[Wording, ...]:
    degree, negated = _ORDERED[comparison]
    own: dict[str, object] = {"comparison": comparison, "other": None}

    def line(more: Predicate, less: Predicate, scales: frozenset[Scale]) -> Wording:
        says = more if degree is Degree.MORE else less
        return put(says, Compare, own, scales=scales, negated=negated, attribute=ATTRIBUTE)

    return (
        put(
            Predicate.MORE if degree is Degree.MORE else Predicate.LESS,
            Compare,
            own,
            scales=_NUMBERS,
            negated=negated,
            adjective=(adjective(degree), "attribute"),
            attribute=ATTRIBUTE,
        ),
        line(Predicate.AFTER, Predicate.BEFORE, _LISTED),
        line(Predicate.AFTER_IN_ALPHABET, Predicate.BEFORE_IN_ALPHABET, _LETTERS),
        put(
            Predicate.MORE_ACROSS if degree is Degree.MORE else Predicate.LESS_ACROSS,
            Compare,
            {"comparison": comparison},
            negated=negated,
            attribute=_ACROSS,
            theirs=(ATTRIBUTE, "attribute"),
        ),
    )


def _across(comparison: Comparison, *, negated: bool) -> Wording:
    return put(
        Predicate.SAME_ACROSS,
        Compare,
        {"comparison": comparison},
        negated=negated,
        attribute=_ACROSS,
        theirs=(ATTRIBUTE, "attribute"),
    )


def _steps(
    forward: tuple[Predicate, Predicate], back: tuple[Predicate, Predicate], scale: Scale
) -> tuple[Wording, ...]:
    """Places further on in an order: one, or so many."""
    return (
        put(forward[0], Step, {"amount": 1}, attribute=ATTRIBUTE, scales={scale}),
        put(back[0], Step, {"amount": -1}, attribute=ATTRIBUTE, scales={scale}),
        put(forward[1], Step, k=_forward(COUNT), attribute=ATTRIBUTE, scales={scale}),
        put(back[1], Step, k=_back(COUNT), attribute=ATTRIBUTE, scales={scale}),
    )


RELATIONS: Final[tuple[Wording, ...]] = (
    put(
        Predicate.SAME,
        Compare,
        {"comparison": Comparison.EQUAL, "other": None},
        attribute=ATTRIBUTE,
    ),
    put(
        Predicate.DIFFERENT,
        Compare,
        {"comparison": Comparison.DIFFERENT, "other": None},
        attribute=ATTRIBUTE,
    ),
    _across(Comparison.EQUAL, negated=False),
    _across(Comparison.DIFFERENT, negated=True),
    *(wording for comparison in _ORDERED for wording in _compared(comparison)),
    *_steps(
        (Predicate.NEXT_IN_ALPHABET, Predicate.AFTER_BY_IN_ALPHABET),
        (Predicate.PREVIOUS_IN_ALPHABET, Predicate.BEFORE_BY_IN_ALPHABET),
        Scale.LETTER,
    ),
    *(
        wording
        for scale in (Scale.ORDER, Scale.CYCLE)
        for wording in _steps(
            (Predicate.NEXT, Predicate.AFTER_BY), (Predicate.PREVIOUS, Predicate.BEFORE_BY), scale
        )
    ),
    put(Predicate.MORE_BY, Step, k=_forward(NUMBER), attribute=ATTRIBUTE, scales=_NUMBERS),
    put(Predicate.LESS_BY, Step, k=_back(NUMBER), attribute=ATTRIBUTE, scales=_NUMBERS),
    put(Predicate.APART_BY, Apart, k=(NUMBER, "amount"), attribute=ATTRIBUTE),
    put(Predicate.TWICE, Times, {"amount": 2}, attribute=ATTRIBUTE),
    put(Predicate.HALF, Times, {"amount": _HALF}, attribute=ATTRIBUTE),
    put(Predicate.TIMES, Times, k=(NUMBER, "amount"), attribute=ATTRIBUTE),
    put(Predicate.TOGETHER, AddUp, k=(NUMBER, "amount"), attribute=ATTRIBUTE),
    put(Predicate.RELATED, Named, {"directed": False}, relation=_RELATION),
    put(
        Predicate.RELATED,
        Named,
        {"directed": True},
        relation=_RELATION,
        way=(Part("way", lambda _, __: say(Key.IN_THAT_ORDER), lambda _, __: True), "directed"),
    ),
)
"""How the other token, the first of the pair, stands to the subject, the second."""


@dataclass(frozen=True, slots=True)
class Two:
    """Says how a token, the subject, stands to another."""

    tokens: Tokens
    subject: Phrase | None
    other: Phrase

    def stands(self, relation: Relation) -> Does:
        """That the other is the first of the pair and the subject the second."""
        return said_of(RELATIONS, relation, self.tokens, self.subject, other=self.other)

    def has(self, feature: PairFeature, *, converse: bool) -> Does:
        """That the feature holds of the other and the subject; `converse`: the other way round."""
        attribute = feature.attribute
        match feature.name:
            case "less-than" | "before":
                less = Comparison.MORE if converse else Comparison.LESS
                return self.stands(Compare(attribute, less))
            case "same":
                return self.stands(Compare(attribute, Comparison.EQUAL))
            case "different":
                return self.stands(Compare(attribute, Comparison.DIFFERENT))
            case "successor":
                return self.stands(Step(attribute, -1 if converse else 1))
            case "twice":
                return self.stands(Times(attribute, _HALF if converse else 2))
            case name if converse:
                return said_back(self, name)
            case name:
                return self.stands(Named(name))


def said_back(two: Two, name: str) -> Does:
    """That the deck's relation holds of the subject and the other, in this order."""
    parts: Mapping[str, Phrase] = {"relation": Foreign(name), "other": two.other}
    return Does(Predicate.RELATED_BACK, MappingProxyType(parts), two.subject)
