"""The grammar of Catalan, as far as the sentences need it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from maestra.core.tokens import Value
from maestra.language.phrases import Joint
from maestra.language.templates import Gender, Spoken
from maestra.language.tongue import AttributeWords, inflect, plain_number

_ORDINALS: Final = (
    ("primer", "primera"),
    ("segon", "segona"),
    ("tercer", "tercera"),
    ("quart", "quarta"),
    *(
        (f"{stem}è", f"{stem}ena")
        for stem in [
            "cinqu",
            "sis",
            "set",
            "vuit",
            "nov",
            "des",
            "onz",
            "dotz",
            "tretz",
            "catorz",
            "quinz",
            "setz",
            "disset",
            "divuit",
            "dinov",
            "vint",
        ]
    ),
)
_COUNTS: Final = [
    "una",
    "dues",
    "tres",
    "quatre",
    "cinc",
    "sis",
    "set",
    "vuit",
    "nou",
    "deu",
    "onze",
    "dotze",
]
_VOWEL: Final = re.compile(r"h?[aeiouàèéíïòóúü]", re.IGNORECASE)
_WEAK: Final = re.compile(r"h?[iu]", re.IGNORECASE)
"""A feminine noun with this beginning, unstressed as it mostly is, keeps "la": la imatge."""
_JOINTS: Final = {
    Joint.AND: " i ",
    Joint.OR: " o ",
    Joint.COMMA: ", ",
    Joint.PLUS: " més ",
    Joint.TIMES: " per ",
}
_CONTRACTIONS: Final = (("el ", "l "), ("els ", "ls "))


class Catalan:
    """Two genders; articles and "de" elide before vowels; "el" contracts with "de" and "a"."""

    token: Spoken = Spoken("fitxa", {"plural": "fitxes"}, Gender.FEMININE)

    def join(self, items: Sequence[str], joint: Joint) -> str:
        """``el 19, el 23 o el 32``."""
        word = _JOINTS[joint]
        if joint not in {Joint.AND, Joint.OR}:
            return word.join(items)
        *others, last = items
        return word.join([", ".join(others), last] if others else [last])

    def derive(self, spoken: Spoken, form: str) -> str:
        """The forms are `of`, `to`, `the`, `bare` and those the phrase brings."""
        if form in spoken.forms:
            return spoken.forms[form]
        match form:
            case "" | "bare":
                return spoken.text
            case "of":
                return _of(spoken.text)
            case "to":
                return _contracted("a", spoken.text)
            case "the":
                return _with_article(spoken.text, spoken.gender)
            case _:
                raise KeyError(form)

    def nth(self, number: int) -> Spoken:
        """``primer`` before a noun, ``primera`` of a token; from 21 on in digits."""
        if number > len(_ORDINALS):
            return Spoken(f"{number}è", {"feminine": f"{number}a"})
        masculine, feminine = _ORDINALS[number - 1]
        return Spoken(masculine, {"feminine": feminine})

    def count(self, number: int) -> Spoken:
        """``una`` to ``dotze``, of tokens and other feminine nouns; then in digits."""
        word = _COUNTS[number - 1] if 1 <= number <= len(_COUNTS) else str(number)
        return Spoken(word, gender=Gender.FEMININE, many=number != 1)

    def numeral(self, number: Value) -> str:
        """With a decimal comma."""
        return plain_number(number).replace(".", ",")

    def place(self, row: int, column: int) -> Spoken:
        """``la fila 2, columna 3``."""
        return Spoken(f"la fila {row}, columna {column}", gender=Gender.FEMININE)

    def row(self, row: int, rows: int) -> Spoken:
        """``la fila de dalt``, ``la fila de baix``, ``la fila 3``."""
        name = "de dalt" if row == 1 else "de baix" if row == rows else str(row)
        return Spoken(f"la fila {name}", gender=Gender.FEMININE)

    def plain(self, text: str, number: Value, words: AttributeWords) -> Spoken:
        """``el 34``, ``l'11``, ``la C``: names of letters do not elide."""
        if words.gender is Gender.FEMININE:
            return Spoken(f"la {text}", {"bare": text}, Gender.FEMININE)
        elided = not isinstance(number, str) and _begins_with_vowel(text)
        article = "l'" if elided else "el "
        return Spoken(f"{article}{text}", {"bare": text})

    def word(self, text: str) -> Spoken:
        """``la fitxa «tassa»``."""
        return Spoken(f"la fitxa «{text}»", {"bare": text}, Gender.FEMININE)

    def quality(self, word: str) -> Spoken:
        """``la fitxa vermella``."""
        feminine = inflect(word, Gender.FEMININE)
        return Spoken(f"la fitxa {feminine}", {"bare": feminine}, Gender.FEMININE)

    def measure(self, words: AttributeWords, text: str) -> Spoken:
        """``la mida 3``, ``l'alçada 3``."""
        bare = f"{words.noun} {text}"
        return Spoken(_with_article(bare, words.gender), {"bare": bare}, words.gender)

    def qualify(self, head: Spoken, others: Sequence[str]) -> Spoken:
        """``el 34 (vermell)``."""
        more = f" ({', '.join(others)})"
        bare = {"bare": head.forms["bare"] + more}
        return Spoken(head.text + more, bare, head.gender)


def _begins_with_vowel(digits: str) -> bool:
    """Whether a number begins with "u" or "onze" when it is read: 1, 11, 11.000, 1.000.000."""
    whole = digits.split(",", maxsplit=1)[0]
    lead = whole[: len(whole) % 3 or 3]
    if lead == "11":
        return True
    # 1.000 is read "mil", but 1.000.000 is read "un milió".
    return lead == "1" and (len(whole) == 1 or len(whole) % 6 == 1)


def _with_article(noun: str, gender: Gender) -> str:
    if gender is Gender.FEMININE:
        elided = _VOWEL.match(noun) and not _WEAK.match(noun)
        return f"l'{noun}" if elided else f"la {noun}"
    return f"l'{noun}" if _VOWEL.match(noun) else f"el {noun}"


def _of(text: str) -> str:
    """``de`` before it: ``del 34``, ``de l'11``, ``d'aquesta``."""
    contracted = any(text.startswith(article) for article, _ in _CONTRACTIONS)
    if _VOWEL.match(text) and not contracted:
        return f"d'{text}"
    return _contracted("de", text)


def _contracted(preposition: str, text: str) -> str:
    for article, end in _CONTRACTIONS:
        if text.startswith(article):
            return f"{preposition}{end}{text.removeprefix(article)}"
    return f"{preposition} {text}"
