"""What the coach says: in each language, short, kind, and in several ways."""

from __future__ import annotations

import re
from dataclasses import fields
from enum import Enum
from typing import get_args, get_type_hints

import pytest

from maestra.coaching.settings import Profile, Settings
from maestra.core.board import Board, Cell, Column, Row
from maestra.language import Language
from maestra.language.coach import (
    FEWEST_WAYS,
    coach_phrase,
    question_to_caregiver,
    ways_to_say,
)
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.coach_settings import setting_explanation, setting_name, value_words
from maestra.language.languages import speaker_for
from maestra.language.phrases import InRow, Joint, Listing, Named, Phrase, Place
from maestra.language.templates import slots
from maestra.rules.paper import NUMBER_DECK

MAX_WORDS = 12
BLAME = ("wrong", "mistake", "error", "fail", "equivoc", "incorrect", "malament", "fall")
TOKENS = [Named(token.attributes) for token in NUMBER_DECK.tokens[:3]]
PARTS: dict[str, Phrase | str] = {
    "token": TOKENS[0],
    "tokens": Listing(tuple(TOKENS), Joint.OR),
    "place": Place(Cell(Row(1), Column(2))),
    "row": InRow(3),
    "reason": "R.",
    "rule": "R.",
    "rules": "R.",
}
each_language = pytest.mark.parametrize("language", Language)


@each_language
@pytest.mark.parametrize("key", CoachKey)
def test_each_phrase_has_several_ways_that_say_the_same_things(
    key: CoachKey, language: Language
) -> None:
    ways = ways_to_say(key, language)
    assert len(set(ways)) == len(ways) >= FEWEST_WAYS
    assert {frozenset(slots(way)) for way in ways} <= {
        frozenset(slots(way)) for way in ways_to_say(key, Language.EN)
    }


@each_language
def test_no_two_phrases_share_a_way(language: Language) -> None:
    every = [way for key in CoachKey for way in ways_to_say(key, language)]
    assert len(set(every)) == len(every)


@each_language
@pytest.mark.parametrize("key", CoachKey)
def test_each_sentence_is_short_and_blames_nobody(key: CoachKey, language: Language) -> None:
    speaker = speaker_for(language, Board(), NUMBER_DECK)
    for way in ways_to_say(key, language):
        text = coach_phrase(way, speaker, PARTS)
        assert not text[0].islower()
        for sentence in re.split(r"(?<=[.!?:]) ", text):
            assert len(sentence.split()) <= MAX_WORDS, sentence
        assert not any(blame in text.casefold() for blame in BLAME)


@each_language
@pytest.mark.parametrize("key", AskKey)
def test_each_question_to_a_caregiver_is_a_sentence(key: AskKey, language: Language) -> None:
    speaker = speaker_for(language, Board(), NUMBER_DECK)
    asked = question_to_caregiver(key, language, speaker, PARTS)
    assert asked[-1] in ".?"
    assert "{" not in asked


def enums_of_settings() -> list[tuple[str, type[Enum]]]:
    found: list[tuple[str, type[Enum]]] = []
    for kind in (Profile, Settings):
        for name, hint in get_type_hints(kind).items():
            parts = (hint, *get_args(hint))
            kinds = (part for part in parts if isinstance(part, type))
            found += [(name, part) for part in kinds if issubclass(part, Enum)]
    return found


@each_language
def test_each_setting_is_explained_and_each_value_named(language: Language) -> None:
    names = {field.name for kind in (Profile, Settings) for field in fields(kind)} - {"profile"}
    for name in names:
        assert setting_name(name, language)
        assert setting_explanation(name, language).endswith(".")
    values = enums_of_settings()
    assert {name for name, _ in values} >= {"mental", "hand", "modalities", "language"}
    for name, kind in values:
        for value in kind:
            assert value_words(name, value.value, language)
