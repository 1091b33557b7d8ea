"""Sentences made plain: what must not matter is taken away before they are compared or read.

Case, accents, punctuation, articles; contractions are taken apart, numbers written in digits,
and what people say for a word is replaced by the word that sentences use.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cached_property
from typing import Final

from maestra.core.text import without_accents
from maestra.language.synonyms import Synonyms
from maestra.language.tongue import Grammar

_QUOTES: Final = re.compile(r"[\"\u00ab\u00bb\u201c-\u201e\u2039\u203a]")
_APOSTROPHES: Final = re.compile(r"[`\u00b4\u2018\u2019]")
_DECIMAL_COMMA: Final = re.compile(r"(?<![\d,])(\d+),(\d+)(?!,?\d)")
_MARKS: Final = re.compile(r"[,;:!?¡¿()\[\]…]|\.(?!\d)|(?<!\d)\.(?=\d)")
_HALF: Final = Decimal("0.5")
_COUNTED: Final = 12
"""Languages write numbers up to this in words."""


@dataclass(frozen=True)
class Plainly:
    """Makes the sentences of one language plain."""

    grammar: Grammar
    synonyms: Synonyms

    def text(self, sentence: str) -> str:
        """The sentence's words with one space before each; empty if it has none."""
        return "".join(f" {word}" for word in self.words(sentence))

    def words(self, sentence: str) -> list[str]:
        """The sentence's words."""
        words: list[str] = []
        for written in self._spelled(sentence).split():
            words += self._taken_apart(written)
        return self._replaced([word for word in words if word not in self.synonyms.articles])

    def _spelled(self, sentence: str) -> str:
        text = _APOSTROPHES.sub("'", _QUOTES.sub(" ", sentence))
        if self.grammar.numeral(_HALF) != str(_HALF):
            text = _DECIMAL_COMMA.sub(r"\1.\2", text)
        return _MARKS.sub(" ", without_accents(text.casefold()))

    def _taken_apart(self, word: str) -> list[str]:
        for elided, whole in self.synonyms.elisions.items():
            if word.startswith(elided):
                return [*whole.split(), *self._taken_apart(word.removeprefix(elided))]
        whole = self.synonyms.contractions.get(word, word)
        if whole in self._numbers:
            return [self._numbers[whole]]
        return [part for part in whole.strip("'").split() if part]

    @cached_property
    def _numbers(self) -> Mapping[str, str]:
        """Numbers in words to digits."""
        counts = {self.grammar.count(k).text: k for k in range(1, _COUNTED + 1)}
        return {
            without_accents(word): str(number)
            for word, number in {**counts, **self.synonyms.numbers}.items()
        }

    @cached_property
    def _phrases(self) -> Mapping[tuple[str, ...], tuple[str, ...]]:
        """What is replaced, and by what."""
        simple = Plainly(self.grammar, replace(self.synonyms, phrases={}))
        return {
            tuple(simple.words(said)): tuple(simple.words(phrase))
            for phrase, others in self.synonyms.phrases.items()
            # A phrase stays what it is, though another one may be a part of it.
            for said in (*others, phrase)
        }

    @cached_property
    def _longest(self) -> int:
        return max(map(len, self._phrases), default=0)

    def _replaced(self, words: list[str]) -> list[str]:
        """The longest phrase first, from left to right."""
        found: list[str] = []
        start = 0
        while start < len(words):
            for length in range(min(self._longest, len(words) - start), 0, -1):
                other = self._phrases.get(tuple(words[start : start + length]))
                if other is not None:
                    found += other
                    start += length
                    break
            else:
                found.append(words[start])
                start += 1
        return found


def escaped(text: str) -> str:
    """A pattern for plain text, as lark takes it."""
    return re.escape(text).replace("\\ ", " ").replace("/", r"\/")
