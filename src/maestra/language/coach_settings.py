"""What a caregiver can set, in plain words: each setting, and each value to choose."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from maestra.language.ca.settings import SETTINGS as SETTINGS_CA
from maestra.language.ca.settings import VALUES as VALUES_CA
from maestra.language.en.settings import SETTINGS as SETTINGS_EN
from maestra.language.en.settings import VALUES as VALUES_EN
from maestra.language.es.settings import SETTINGS as SETTINGS_ES
from maestra.language.es.settings import VALUES as VALUES_ES
from maestra.language.languages import Language

_SETTINGS: Final[Mapping[Language, Mapping[str, tuple[str, str]]]] = MappingProxyType(
    {Language.EN: SETTINGS_EN, Language.ES: SETTINGS_ES, Language.CA: SETTINGS_CA}
)
_VALUES: Final[Mapping[Language, Mapping[str, str]]] = MappingProxyType(
    {Language.EN: VALUES_EN, Language.ES: VALUES_ES, Language.CA: VALUES_CA}
)


def setting_name(setting: str, language: Language) -> str:
    """What a setting is called, by its name in the settings' file."""
    return _SETTINGS[language][setting][0]


def setting_explanation(setting: str, language: Language) -> str:
    """What it does."""
    return _SETTINGS[language][setting][1]


def value_words(setting: str, value: str, language: Language) -> str:
    """What a value to choose is called."""
    return _VALUES[language][f"{setting}.{value}"]
