"""What else people say for the words that a language's tables use."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from maestra.language.keys import Key, Predicate


@dataclass(frozen=True)
class Synonyms:
    """Other words of one language, understood and never said. Small letters, no accents needed."""

    articles: frozenset[str]
    """Words that may be there or not."""
    contractions: Mapping[str, str]
    """``del``: the words that were drawn together."""
    elisions: Mapping[str, str] = field(default_factory=dict[str, str])
    """``d'``: the whole word, with a space after it; empty if it is an article."""
    numbers: Mapping[str, int] = field(default_factory=dict[str, int])
    """Numbers in words beyond those that the language itself says."""
    phrases: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    """What sentences say, and what else people say for it wherever it stands."""
    sentences: Mapping[Key, tuple[str, ...]] = field(default_factory=dict[Key, tuple[str, ...]])
    """Other templates for a sentence or a part of one; gaps may be missing."""
    predicates: Mapping[Predicate, tuple[tuple[str, str], ...]] = field(
        default_factory=dict[Predicate, tuple[tuple[str, str], ...]]
    )
    """Other verbs and templates of what follows them."""
    kinds: Mapping[Predicate, tuple[str, ...]] = field(
        default_factory=dict[Predicate, tuple[str, ...]]
    )
    """Other short names for tokens of a kind."""
    more: tuple[str, ...] = ()
    """Comparatives that serve any numbers: bigger, larger, greater."""
    less: tuple[str, ...] = ()
    most: tuple[str, ...] = ()
    least: tuple[str, ...] = ()
