"""What the coach says to patients and caregivers: each phrase in several ways, in each language.

Patients' sentences have at most twelve words and one clause, and blame nobody; tests hold the
catalogues to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from maestra.language.ca.coach import ASKED as ASKED_CA
from maestra.language.ca.coach import PHRASES as PHRASES_CA
from maestra.language.coach_keys import AskKey, CoachKey
from maestra.language.en.coach import ASKED as ASKED_EN
from maestra.language.en.coach import PHRASES as PHRASES_EN
from maestra.language.es.coach import ASKED as ASKED_ES
from maestra.language.es.coach import PHRASES as PHRASES_ES
from maestra.language.languages import Language
from maestra.language.phrases import Foreign, Phrase
from maestra.language.speaker import Speaker
from maestra.language.templates import fill

FEWEST_WAYS: Final = 4
"""In which each phrase can be said, so that none comes back within three others."""

_PHRASES: Final[Mapping[Language, Mapping[str, tuple[str, ...]]]] = MappingProxyType(
    {Language.EN: PHRASES_EN, Language.ES: PHRASES_ES, Language.CA: PHRASES_CA}
)
_ASKED: Final[Mapping[Language, Mapping[str, str]]] = MappingProxyType(
    {Language.EN: ASKED_EN, Language.ES: ASKED_ES, Language.CA: ASKED_CA}
)


def ways_to_say(key: CoachKey, language: Language) -> tuple[str, ...]:
    """The templates of a phrase."""
    return _PHRASES[language][key.value]


def coach_phrase(template: str, speaker: Speaker, parts: Mapping[str, Phrase | str]) -> str:
    """One way to say a phrase, its gaps filled, beginning with a capital.

    Args:
        template: one of `ways_to_say`.
        speaker: of the same language, for the board and deck.
        parts: for each gap a phrase, or a sentence that is said as it is.

    Raises:
        KeyError: a gap without a part.
    """
    spoken = {
        name: speaker.spoken(Foreign(part) if isinstance(part, str) else part)
        for name, part in parts.items()
    }
    text = fill(template, spoken, speaker.grammar.derive)
    return text[:1].upper() + text[1:]


def question_to_caregiver(
    key: AskKey, language: Language, speaker: Speaker, parts: Mapping[str, Phrase | str]
) -> str:
    """What a caregiver is asked for."""
    return coach_phrase(_ASKED[language][key.value], speaker, parts)
