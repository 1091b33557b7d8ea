"""Each language says everything, with the same parts, and short where patients hear it."""

import pytest

from maestra.language import Language
from maestra.language.keys import Key, Predicate
from maestra.language.languages import words_of
from maestra.language.of_verdicts import MAX_WORDS
from maestra.language.templates import Slot, parse, slots

LANGUAGES = list(Language)
FOR_PATIENTS = [
    Key.WRONG_PLACE,
    Key.NEXT_PLACE,
    Key.WRONG_COLUMN,
    Key.WRONG_ORIGIN,
    Key.WRONG_ORIGIN_ROW,
    Key.WRONG_ORIGIN_COLUMN,
    Key.OTHER_COLUMN,
    Key.NOT_FROM_STORAGE,
    Key.NOT_TO_GOAL_ROW,
    Key.NOTHING_THERE,
    Key.BELONGS_THERE,
    Key.NOT_SHOWN,
    Key.NOT_NOW,
    Key.DEAD_END,
    Key.AFTER_THE_END,
]
BLAME = ("wrong", "mistake", "error", "mal", "equivoc", "incorrect", "malament")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("key", Key)
def test_each_key_is_there_with_the_parts_it_has_in_english(key: Key, language: Language) -> None:
    ours, english = words_of(language).sentences[key], words_of(Language.EN).sentences[key]
    # What a language leaves out, such as a pronoun, it may; it may not ask for more.
    assert slots(ours) <= slots(english) | {"subject"}
    gaps = {piece.name for piece in parse(english) if isinstance(piece, Slot)}
    assert gaps <= slots(ours)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("predicate", Predicate)
def test_each_predicate_has_a_verb_and_the_parts_it_has_in_english(
    predicate: Predicate, language: Language
) -> None:
    words = words_of(language)
    verb, rest = words.predicates[predicate]
    _, english = words_of(Language.EN).predicates[predicate]
    assert verb in words.verbs
    assert slots(rest) <= slots(english) | {"subject", "attribute"}
    assert slots(english) <= slots(rest)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_same_things_have_short_names_in_each_language(language: Language) -> None:
    assert words_of(language).kinds.keys() == words_of(Language.EN).kinds.keys()
    assert words_of(language).attributes.keys() == words_of(Language.EN).attributes.keys()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("key", FOR_PATIENTS)
def test_what_patients_hear_is_short_and_without_blame(key: Key, language: Language) -> None:
    template = words_of(language).sentences[key]
    # A cell takes four words, a token two.
    words = template.replace("{place", "a b c d {place").split()
    assert len(words) <= MAX_WORDS + 1
    assert not any(blame in template.casefold() for blame in BLAME)
