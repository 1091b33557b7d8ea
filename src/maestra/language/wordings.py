"""Tables from what is meant to how it is put, read in both directions.

A `Wording` says which form of a rule (of a test, a relation, a place...) a key or predicate
stands for: which fields are what they are there, and which are said in the gaps of its template.
Reading it one way gives the phrase for a rule; reading it the other way, the rule for a phrase.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields
from types import MappingProxyType
from typing import Any, Final, Protocol, cast

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Scale
from maestra.language.keys import Key, Predicate
from maestra.language.phrases import AttributeNamed, Count, Numeral, Phrase
from maestra.rules.features import TokenFeature
from maestra.rules.registry import PARAMETER_FEATURES
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW
from maestra.rules.token_tests import Has

ORIGINS: Final = (ORIGIN_ROW, ORIGIN_COLUMN)
"""What every token has besides what it shows."""


class About(Protocol):
    """What is spoken of."""

    @property
    def board(self) -> Board:
        """The board."""
        ...

    @property
    def deck(self) -> Deck:
        """The tokens."""
        ...


@dataclass(frozen=True, slots=True)
class Part:
    """How a value is said in a gap, and what is meant by what was said there."""

    symbol: str
    """What the grammar calls phrases of this kind."""
    phrase: Callable[[Any, About], Phrase | None]
    """The phrase for a value; None if it cannot be said so."""
    meaning: Callable[[Any, About], Any] = lambda value, _: value
    """The value for what was read; None if it cannot stand here."""
    unsaid: object = None
    """The value where nothing was said; None if something must be."""


@dataclass(frozen=True, slots=True)
class Gap:
    """One gap of a template: how it is filled, and with which fields."""

    part: Part
    names: tuple[str, ...]

    def value(self, values: Mapping[str, object]) -> object:
        """What is said in the gap: the field, or all of them; None if it says none."""
        chosen = tuple(values[name] for name in self.names)
        if len(chosen) > 1:
            return chosen
        return chosen[0] if chosen else None

    def fields(self, value: object) -> dict[str, object]:
        """The fields that say `value`."""
        if len(self.names) < 2:  # noqa: PLR2004 - a value for each of several
            return dict.fromkeys(self.names, value)
        return dict(zip(self.names, cast("tuple[object, ...]", value), strict=True))


@dataclass(frozen=True, slots=True, eq=False)
class Wording:
    """One way to put things of one form."""

    says: Key | Predicate
    of: Callable[..., Any]
    """The form."""
    fixed: Mapping[str, object]
    """Fields that have one value where it is put so."""
    gaps: Mapping[str, Gap]
    scales: frozenset[Scale] | None = None
    """How the values of `attribute` must compare; None: in any way, or there is none."""
    negated: bool = False
    """Put so that it is not so."""

    def phrases(self, thing: object, about: About) -> dict[str, Phrase] | None:
        """What fills the gaps; None if `thing` is not put so."""
        if type(thing) is not self.of:
            return None
        values = fields_of(thing)
        if any(values[name] != value for name, value in self.fixed.items()):
            return None
        if not self._fits(cast("str", values.get("attribute", "")), about):
            return None
        said: dict[str, Phrase] = {}
        for name, gap in self.gaps.items():
            phrase = gap.part.phrase(gap.value(values), about)
            if phrase is None:
                return None
            said[name] = phrase
        return said

    def things(self, read: Mapping[str, object], about: About) -> Iterator[object]:
        """What may be meant where `read` was said in the gaps; gaps may be missing.

        Where no attribute is said, it is one whose values compare as is said of them.
        """
        values = dict(self.fixed)
        for name, said in read.items():
            gap = self.gaps.get(name)
            value = None if gap is None else gap.part.meaning(said, about)
            if gap is None or value is None:
                return
            for field, one in gap.fields(value).items():
                if values.setdefault(field, one) != one:
                    return
        for gap in self.gaps.values():
            if gap.part.unsaid is not None:
                values = {**gap.fields(gap.part.unsaid), **values}
        if "attribute" in values or not self._has_attribute:
            yield from self._made(values)
            return
        scales = about.deck.scales
        for attribute in [name for name in scales if self._fits(name, about)] or scales:
            yield from self._made({**values, "attribute": attribute})

    @property
    def _has_attribute(self) -> bool:
        return any("attribute" in gap.names for gap in self.gaps.values())

    def _made(self, values: Mapping[str, object]) -> Iterator[object]:
        needed = {name for gap in self.gaps.values() for name in gap.names}
        if not needed <= values.keys():
            return
        try:
            yield built(self.of, values)
        except InvalidError:
            return

    def _fits(self, attribute: str, about: About) -> bool:
        if self.scales is None:
            return True
        return scale_of(attribute, about.deck) in self.scales


def scale_of(attribute: str, deck: Deck) -> Scale:
    """How values of `attribute` compare; as numbers, if the deck does not have it."""
    return deck.scales.get(attribute, Scale.NUMBER)


def fields_of(thing: object) -> dict[str, object]:
    """The fields of a rule or of a part of one; a feature's name is taken apart."""
    if isinstance(thing, Has):
        family, parameter = _split(thing.feature.name)
        attribute = thing.feature.attribute
        return {"family": family, "parameter": parameter, "attribute": attribute}
    return {each.name: getattr(thing, each.name) for each in fields(cast("Any", thing))}


def built(form: Callable[..., Any], values: Mapping[str, object]) -> object:
    """The thing with these fields.

    Raises:
        InvalidError: they do not go together.
    """
    if form is Has:
        family, parameter = values["family"], values.get("parameter", "")
        name = f"{family}-{parameter}" if parameter else str(family)
        return Has(TokenFeature(name, str(values["attribute"])))
    return form(**values)


def _split(name: str) -> tuple[str, str]:
    for family in PARAMETER_FEATURES:
        if name.startswith(f"{family}-"):
            return family, name.removeprefix(f"{family}-")
    return name, ""


def put(
    says: Key | Predicate,
    of: Callable[..., Any],
    fixed: Mapping[str, object] | None = None,
    *,
    scales: Iterable[Scale] | None = None,
    negated: bool = False,
    **gaps: Part | tuple[Any, ...],
) -> Wording:
    """A line of a table; a gap is a part, or a part and the fields it says if named otherwise."""
    filled = {
        name: Gap(gap, (name,)) if isinstance(gap, Part) else Gap(gap[0], gap[1:])
        for name, gap in gaps.items()
    }
    only = None if scales is None else frozenset(scales)
    return Wording(says, of, fixed or {}, MappingProxyType(filled), only, negated)


def _attribute(value: str | None, _: About) -> Phrase | None:
    return None if value is None else AttributeNamed(value)


def _count(number: object, _: About) -> Phrase | None:
    return Count(number) if isinstance(number, int) else Numeral(cast("Any", number))


ATTRIBUTE: Final = Part("attribute", _attribute)
NUMBER: Final = Part("number", lambda number, _: Numeral(number))
COUNT: Final = Part("number", _count)
