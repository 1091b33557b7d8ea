"""The languages there are, and the words of each with a caregiver's own added."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from enum import Enum
from functools import cache, lru_cache
from typing import Protocol, cast

from maestra.core.board import Board
from maestra.core.tokens import Deck
from maestra.language.lexicon import NO_LEXICON, Lexicon
from maestra.language.speaker import Speaker
from maestra.language.synonyms import Synonyms
from maestra.language.tongue import Grammar, Words


class Language(Enum):
    """A language, by its code."""

    EN = "en"
    ES = "es"
    CA = "ca"


class _Package(Protocol):
    """What each language's package has."""

    WORDS: Words
    GRAMMAR: Grammar


class _Others(Protocol):
    """What each language's module of synonyms has."""

    SYNONYMS: Synonyms


@dataclass(frozen=True, slots=True)
class _Loaded:
    words: Words
    grammar: Grammar


@cache
def words_of(language: Language) -> Words:
    """The tables of a language."""
    return _load(language).words


@cache
def synonyms_of(language: Language) -> Synonyms:
    """What else people say in a language."""
    module = f"maestra.language.{language.value}.synonyms"
    return cast("_Others", importlib.import_module(module)).SYNONYMS


@cache
def _load(language: Language) -> _Loaded:
    package = cast("_Package", importlib.import_module(f"maestra.language.{language.value}"))
    return _Loaded(package.WORDS, package.GRAMMAR)


@lru_cache(maxsize=32)
def speaker_for(
    language: Language, board: Board, deck: Deck, lexicon: Lexicon = NO_LEXICON
) -> Speaker:
    """Says things about a board and deck in a language, with a caregiver's words first.

    The last ones are kept: a speaker remembers the names of tokens.
    """
    loaded = _load(language)
    words = lexicon.added_to(loaded.words, language.value)
    return Speaker(loaded.grammar, words, board, deck)
