"""The sentences nearest to one that is not understood."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cached_property

from maestra.language.understanding.plain import Plainly

_SHARED = 0.6
"""What words in common count for; the rest is for letters in the same order, for misspelt ones."""


@dataclass(frozen=True)
class Nearest:
    """Ranks sentences by what they have in common with another."""

    plainly: Plainly
    sentences: tuple[str, ...]
    """What can be said."""

    @cached_property
    def _plain(self) -> tuple[str, ...]:
        return tuple(map(self.plainly.text, self.sentences))

    def to(self, text: str, number: int) -> tuple[str, ...]:
        """The nearest, first of all the nearest one."""
        plain = self.plainly.text(text)
        ranked = sorted(
            zip(self._plain, self.sentences, strict=True),
            key=lambda pair: -_likeness(plain, pair[0]),
        )
        return tuple(sentence for _, sentence in ranked[:number])


def _likeness(one: str, two: str) -> float:
    """From 0, nothing in common, to 1."""
    words, others = Counter(one.split()), Counter(two.split())
    total = words.total() + others.total()
    shared = 2 * (words & others).total() / total if total else 0.0
    return _SHARED * shared + (1 - _SHARED) * SequenceMatcher(None, one, two).ratio()
