"""Words of the deck's lexicon. A given row every time is a `Pattern`."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Final, Literal

import numpy as np

from maestra.core.tokens import LETTER
from maestra.rules.fields import Name
from maestra.rules.forms.base import Form
from maestra.rules.plays import Plays, Truth, close_ranks
from maestra.rules.setting import Play, Setting, bits

_NO_LETTER: Final = "\uffff"
"""Stands for a token without a letter: no word has it."""


@dataclass(frozen=True, slots=True)
class Word(Form):
    """The letters of the row, read from left to right over any gaps, make a word of the lexicon.

    Case does not count, accents do. With `relation` and `value` only words that the deck's
    relation pairs with that value count: ``Word(relation="category", value="bird")``.
    """

    attribute: Name = LETTER
    relation: Name | None = None
    value: Name | None = None
    form: Literal["word"] = field(default="word", kw_only=True, repr=False)

    def words(self, setting: Setting) -> frozenset[str]:
        """The words that the deck's tokens and the goal cells suffice for."""
        return setting.remember((self, "words"), lambda: self._words(setting))

    def _words(self, setting: Setting) -> frozenset[str]:
        deck = setting.deck
        words = {word.lower() for word in deck.lexicon}
        if self.relation is not None:
            pairs = deck.relations.get(self.relation, frozenset())
            words &= {word.lower() for word, value in pairs if value == self.value}
        stock = Counter(self.letters(setting))
        return frozenset(
            word for word in words if 0 < len(word) <= setting.length and Counter(word) <= stock
        )

    def letters(self, setting: Setting) -> tuple[str, ...]:
        """Each token's letter in lower case."""
        values = (str(value or "").lower() for value in setting.values(self.attribute))
        return tuple(value if len(value) == 1 else _NO_LETTER for value in values)

    def holds(self, play: Play) -> bool:
        """As the class says."""
        letters = self.letters(play.setting)
        return "".join(letters[token] for token in play.tokens) in self.words(play.setting)

    def possible(self, play: Play) -> bool:
        """Whether letters that are left can complete some word around those that lie there."""
        letters = self.letters(play.setting)
        here = Counter(letters[token] for token in play.tokens)
        stock = Counter(letters[token] for token in bits(play.left))
        return any(
            here <= (whole := Counter(word))
            and whole - here <= stock
            and _fits(word, play, letters)
            for word in self.words(play.setting)
        )

    def certain(self, play: Play) -> bool:
        """Whether all that can still come of it are words; ends, because words do."""
        return self.holds(play) and all(self.certain(longer) for longer in play.extensions())

    def mask(self, plays: Plays) -> Truth:
        """As `holds`."""
        table = np.array([*self.letters(plays.setting), ""], "<U1")
        rows = np.ascontiguousarray(table[close_ranks(plays.row)])
        words = sorted(self.words(plays.setting))
        joined = rows.view(f"<U{plays.setting.length}")[:, 0]
        return np.isin(joined, np.array(words, f"<U{plays.setting.length}"))


def _fits(word: str, play: Play, letters: tuple[str, ...]) -> bool:
    """Whether `word` can be read once free cells are filled or passed over."""
    read = {0}
    for token in play.row:
        if token is None:
            read |= {k + 1 for k in read if k < len(word)}
        else:
            read = {k + 1 for k in read if k < len(word) and word[k] == letters[token]}
    return len(word) in read
