"""The grammar of English, as far as the sentences need it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from maestra.core.tokens import Value
from maestra.language.phrases import Joint
from maestra.language.templates import Spoken
from maestra.language.tongue import AttributeWords, plain_number

_NTH: Final = [
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "sixth",
    "seventh",
    "eighth",
    "ninth",
    "tenth",
    "eleventh",
    "twelfth",
    "thirteenth",
    "fourteenth",
    "fifteenth",
    "sixteenth",
    "seventeenth",
    "eighteenth",
    "nineteenth",
    "twentieth",
]
_COUNTS: Final = [
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
]
_TEENS: Final = range(11, 14)
_ENDINGS: Final = {1: "st", 2: "nd", 3: "rd"}
_WORDS_OF: Final = {
    Joint.AND: " and ",
    Joint.OR: " or ",
    Joint.COMMA: ", ",
    Joint.PLUS: " plus ",
    Joint.TIMES: " times ",
}


class English:
    """No gender, no article before a number or letter."""

    token: Spoken = Spoken("token", {"plural": "tokens"})

    def join(self, items: Sequence[str], joint: Joint) -> str:
        """``19, 23 or 32``."""
        word = _WORDS_OF[joint]
        if joint not in {Joint.AND, Joint.OR}:
            return word.join(items)
        *others, last = items
        return word.join([", ".join(others), last] if others else [last])

    def derive(self, spoken: Spoken, form: str) -> str:
        """The forms are `capital`, `bare` and those the phrase brings."""
        if form == "capital":
            return spoken.text[:1].upper() + spoken.text[1:]
        if form in spoken.forms:
            return spoken.forms[form]
        if form not in {"", "bare"}:
            raise KeyError(form)
        return spoken.text

    def nth(self, number: int) -> Spoken:
        """``first`` to ``twentieth``, then in digits."""
        if number <= len(_NTH):
            return Spoken(_NTH[number - 1])
        ending = "th" if number % 100 in _TEENS else _ENDINGS.get(number % 10, "th")
        return Spoken(f"{number}{ending}")

    def count(self, number: int) -> Spoken:
        """``one`` to ``twelve``, then in digits."""
        word = _COUNTS[number - 1] if 1 <= number <= len(_COUNTS) else str(number)
        return Spoken(word, many=number != 1)

    def numeral(self, number: Value) -> str:
        """With a decimal point."""
        return plain_number(number)

    def place(self, row: int, column: int) -> Spoken:
        """``row 2, column 3``."""
        return Spoken(f"row {row}, column {column}")

    def row(self, row: int, rows: int) -> Spoken:
        """``the top row``, ``the bottom row``, ``row 3``."""
        if row == 1:
            return Spoken("the top row")
        return Spoken("the bottom row" if row == rows else f"row {row}")

    def plain(self, text: str, number: Value, words: AttributeWords) -> Spoken:  # noqa: ARG002 - only other languages need them
        """``34``."""
        return Spoken(text)

    def word(self, text: str) -> Spoken:
        """``cup``."""
        return Spoken(text)

    def quality(self, word: str) -> Spoken:
        """``the red token``."""
        return Spoken(f"the {word} token")

    def measure(self, words: AttributeWords, text: str) -> Spoken:
        """``size 3``."""
        return Spoken(f"{words.noun} {text}")

    def qualify(self, head: Spoken, others: Sequence[str]) -> Spoken:
        """``34 (red)``."""
        return Spoken(f"{head.text} ({', '.join(others)})")
