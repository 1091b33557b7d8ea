from string import Formatter

import pytest

from maestra.language import Language
from maestra.language.ca import terminal as ca
from maestra.language.en import terminal as en
from maestra.language.es import terminal as es
from maestra.language.terminal import TerminalKey, feature_words, terminal_sentence
from maestra.rules.features import CELLS
from maestra.rules.registry import (
    CELL_FEATURES,
    CONVERSES,
    PAIR_FEATURES,
    PARAMETER_FEATURES,
    TOKEN_FEATURES,
)

TABLES = {Language.EN: en, Language.ES: es, Language.CA: ca}
NAMES = (
    *(CELLS, *CELL_FEATURES, *TOKEN_FEATURES, *PAIR_FEATURES, *CONVERSES),
    *(f"{name}-K" for name in PARAMETER_FEATURES),
)
every_language = pytest.mark.parametrize("language", Language)


def parts(sentence: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(sentence) if name is not None}


@every_language
def test_each_key_has_a_sentence_in_each_language_and_no_other_is_there(
    language: Language,
) -> None:
    assert set(TABLES[language].SENTENCES) == {key.value for key in TerminalKey}


@every_language
@pytest.mark.parametrize("key", TerminalKey)
def test_a_sentence_is_about_the_same_in_each_language(
    key: TerminalKey, language: Language
) -> None:
    assert parts(TABLES[language].SENTENCES[key.value]) == parts(en.SENTENCES[key.value])


@every_language
def test_each_feature_of_the_registry_has_words_in_each_language(language: Language) -> None:
    assert set(TABLES[language].FEATURES) == set(NAMES)
    assert len({feature_words(name, language) for name in NAMES}) == len(NAMES)


def test_a_relation_that_a_deck_declares_is_named() -> None:
    said = feature_words("partner", Language.EN)
    assert said == "the first is partner of the second, as the demonstrations declare it"


@every_language
def test_what_is_typed_for_commands_can_be_told_apart(language: Language) -> None:
    typed = [key for key in TerminalKey if key.name.startswith("TYPE_")]
    first = [terminal_sentence(key, language).split()[0] for key in typed]
    assert len(set(first)) == len(typed)


@every_language
@pytest.mark.parametrize("key", [TerminalKey.PUT_BACK, TerminalKey.HINT, TerminalKey.COMPLETE])
def test_what_a_patient_reads_has_at_most_twelve_words(
    key: TerminalKey, language: Language
) -> None:
    said = terminal_sentence(key, language, token="34", column=3)
    assert len(said.split()) <= 12
