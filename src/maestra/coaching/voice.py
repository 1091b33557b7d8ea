"""Which way to say what: no phrase comes back within a few others."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Protocol

from maestra.coaching.chance import Chance
from maestra.coaching.commands import Say
from maestra.language.coach import FEWEST_WAYS, coach_phrase, ways_to_say
from maestra.language.coach_keys import CoachKey
from maestra.language.languages import Language
from maestra.language.phrases import Phrase
from maestra.language.speaker import Speaker

RECENT: Final = FEWEST_WAYS - 1
"""Phrases within which none is repeated; every phrase can be said in one way more."""


class Tongue(Protocol):
    """Which language, and what is spoken about."""

    @property
    def language(self) -> Language:
        """The language."""
        ...

    @property
    def speaker(self) -> Speaker:
        """Says things about the board and its tokens."""
        ...


@dataclass(frozen=True, slots=True)
class Voice:
    """What was said lately, and the chance that picks what is said next."""

    chance: Chance
    recent: tuple[str, ...] = ()
    """The last templates, the latest last."""

    def say(self, key: CoachKey, tongue: Tongue, **parts: Phrase | str) -> tuple[Say, Voice]:
        """A way to say it that is none of the last."""
        ways = [way for way in ways_to_say(key, tongue.language) if way not in self.recent]
        way, chance = self.chance.pick(ways)
        said = {name: _spoken(part, tongue.speaker) for name, part in parts.items()}
        text = coach_phrase(way, tongue.speaker, parts)
        voice = replace(self, chance=chance, recent=(*self.recent, way)[-RECENT:])
        return Say(key.value, said, text), voice


def _spoken(part: Phrase | str, speaker: Speaker) -> str:
    return part if isinstance(part, str) else speaker.spoken(part).text
