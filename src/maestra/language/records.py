"""What the commands on the record say."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from maestra.language.ca.record import RECORD as RECORD_CA
from maestra.language.en.record import RECORD as RECORD_EN
from maestra.language.es.record import RECORD as RECORD_ES
from maestra.language.languages import Language
from maestra.language.record_keys import RecordKey

_RECORD: Final[Mapping[Language, Mapping[str, str]]] = MappingProxyType(
    {Language.EN: RECORD_EN, Language.ES: RECORD_ES, Language.CA: RECORD_CA}
)


def record_sentence(key: RecordKey, language: Language, **parts: object) -> str:
    """What is said for `key`, with its parts filled in."""
    return _RECORD[language][key.value].format(**parts)
