"""The words of a report on a patient's progress."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from maestra.language.ca.reports import REPORT as REPORT_CA
from maestra.language.en.reports import REPORT as REPORT_EN
from maestra.language.es.reports import REPORT as REPORT_ES
from maestra.language.languages import Language
from maestra.language.report_keys import ReportKey

_REPORT: Final[Mapping[Language, Mapping[str, str]]] = MappingProxyType(
    {Language.EN: REPORT_EN, Language.ES: REPORT_ES, Language.CA: REPORT_CA}
)


def report_words(key: ReportKey, language: Language, **parts: str) -> str:
    """What a report says for `key`, with its parts filled in."""
    return _REPORT[language][key.value].format(**parts)


def decimal(number: float, language: Language, places: int = 1) -> str:
    """A number as the language writes it: Spanish and Catalan have a comma."""
    text = f"{number:.{places}f}"
    return text if language is Language.EN else text.replace(".", ",")
