"""A caregiver's own words for attributes, values and relations, added to a language's."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Final

from maestra.language.tongue import NO_OWN_WORDS, OwnWords, Words


@dataclass(frozen=True, eq=False)
class Lexicon:
    """Words by the code of their language; what is missing is said with the words there are."""

    by_language: Mapping[str, OwnWords] = field(default_factory=dict[str, OwnWords])

    def added_to(self, words: Words, language: str) -> Words:
        """`words`, and before them what is said here in `language`."""
        own = self.by_language.get(language, NO_OWN_WORDS)
        return replace(
            words,
            attributes={**words.attributes, **own.attributes},
            values={**words.values, **own.values},
            relations={**words.relations, **own.relations},
        )


NO_LEXICON: Final = Lexicon()
"""No words but the languages' own."""
