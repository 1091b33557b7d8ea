"""Each language says the same about the record."""

from string import Formatter

import pytest

from maestra.language import Language
from maestra.language.ca.record import RECORD as CATALAN
from maestra.language.en.record import RECORD as ENGLISH
from maestra.language.es.record import RECORD as SPANISH
from maestra.language.record_keys import RecordKey
from maestra.language.records import record_sentence
from maestra.storage.chain import Finding

TABLES = {Language.EN: ENGLISH, Language.ES: SPANISH, Language.CA: CATALAN}


def gaps(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


@pytest.mark.parametrize("language", Language)
def test_each_key_is_said_with_the_parts_it_has_in_english(language: Language) -> None:
    assert set(TABLES[language]) == {key.value for key in RecordKey}
    for key in RecordKey:
        assert gaps(TABLES[language][key.value]) == gaps(ENGLISH[key.value])
        parts = dict.fromkeys(gaps(ENGLISH[key.value]), "7")
        assert record_sentence(key, language, **parts)


@pytest.mark.parametrize("finding", Finding)
def test_each_finding_has_its_words(finding: Finding) -> None:
    assert record_sentence(RecordKey[finding.name], Language.EN) == finding.value
