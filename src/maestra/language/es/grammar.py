"""The grammar of Spanish, as far as the sentences need it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from maestra.core.tokens import Value
from maestra.language.phrases import Joint
from maestra.language.templates import Gender, Spoken
from maestra.language.tongue import AttributeWords, inflect, plain_number

_STEMS: Final = [
    "primer",
    "segund",
    "tercer",
    "cuart",
    "quint",
    "sext",
    "séptim",
    "octav",
    "noven",
    "décim",
    "undécim",
    "duodécim",
    "decimotercer",
    "decimocuart",
    "decimoquint",
    "decimosext",
    "decimoséptim",
    "decimoctav",
    "decimonoven",
    "vigésim",
]
_COUNTS: Final = [
    "una",
    "dos",
    "tres",
    "cuatro",
    "cinco",
    "seis",
    "siete",
    "ocho",
    "nueve",
    "diez",
    "once",
    "doce",
]
_SOUNDS_I: Final = re.compile(r"[«“\"']?h?[ií](?![aeou])", re.IGNORECASE)
"""Before this sound "y" becomes "e"; not before a diphthong, as in "hielo"."""
_SOUNDS_O: Final = re.compile(r"[«“\"']?(h?[oó]|8|11(?:\D|$)|11\.?\d{3}(?:\D|$))", re.IGNORECASE)
"""Before this sound "o" becomes "u": ocho, once, ochenta, once mil."""
_BETWEEN: Final = {Joint.COMMA: ", ", Joint.PLUS: " más ", Joint.TIMES: " por "}
_ARTICLES: Final = {
    (Gender.MASCULINE, False): "el",
    (Gender.FEMININE, False): "la",
    (Gender.MASCULINE, True): "los",
    (Gender.FEMININE, True): "las",
}


class Spanish:
    """Two genders; "el" contracts with "de" and "a"; "y" and "o" give way to the next sound."""

    token: Spoken = Spoken("ficha", {"plural": "fichas"}, Gender.FEMININE)

    def join(self, items: Sequence[str], joint: Joint) -> str:
        """``el 19, el 23 o el 32``."""
        if joint is Joint.AND:
            return _listed(items, "e" if _SOUNDS_I.match(items[-1]) else "y")
        if joint is Joint.OR:
            return _listed(items, "u" if _SOUNDS_O.match(items[-1]) else "o")
        return _BETWEEN[joint].join(items)

    def derive(self, spoken: Spoken, form: str) -> str:
        """The forms are `of`, `to`, `the`, `bare` and those the phrase brings."""
        if form in spoken.forms:
            return spoken.forms[form]
        match form:
            case "" | "bare":
                return spoken.text
            case "of":
                return _contracted("de", spoken.text)
            case "to":
                return _contracted("a", spoken.text)
            case "the":
                return f"{_ARTICLES[spoken.gender, spoken.many]} {spoken.text}"
            case _:
                raise KeyError(form)

    def nth(self, number: int) -> Spoken:
        """``primer`` before a noun, ``primera`` of a token; from 21 on in digits."""
        if number > len(_STEMS):
            return Spoken(f"{number}.º", {"feminine": f"{number}.ª"})
        stem = _STEMS[number - 1]
        masculine = stem if stem.endswith("er") else f"{stem}o"
        return Spoken(masculine, {"feminine": f"{stem}a"})

    def count(self, number: int) -> Spoken:
        """``una`` to ``doce``, of tokens and other feminine nouns; then in digits."""
        word = _COUNTS[number - 1] if 1 <= number <= len(_COUNTS) else str(number)
        return Spoken(word, gender=Gender.FEMININE, many=number != 1)

    def numeral(self, number: Value) -> str:
        """With a decimal comma."""
        return plain_number(number).replace(".", ",")

    def place(self, row: int, column: int) -> Spoken:
        """``la fila 2, columna 3``."""
        return Spoken(f"la fila {row}, columna {column}", gender=Gender.FEMININE)

    def row(self, row: int, rows: int) -> Spoken:
        """``la fila de arriba``, ``la fila de abajo``, ``la fila 3``."""
        name = "de arriba" if row == 1 else "de abajo" if row == rows else str(row)
        return Spoken(f"la fila {name}", gender=Gender.FEMININE)

    def plain(self, text: str, number: Value, words: AttributeWords) -> Spoken:  # noqa: ARG002 - only Catalan needs the number
        """``el 34``, ``la C``."""
        article = _ARTICLES[words.gender, False]
        return Spoken(f"{article} {text}", {"bare": text}, words.gender)

    def word(self, text: str) -> Spoken:
        """``la ficha «taza»``."""
        return Spoken(f"la ficha «{text}»", {"bare": text}, Gender.FEMININE)

    def quality(self, word: str) -> Spoken:
        """``la ficha roja``."""
        feminine = inflect(word, Gender.FEMININE)
        return Spoken(f"la ficha {feminine}", {"bare": feminine}, Gender.FEMININE)

    def measure(self, words: AttributeWords, text: str) -> Spoken:
        """``el tamaño 3``."""
        bare = f"{words.noun} {text}"
        return Spoken(f"{_ARTICLES[words.gender, False]} {bare}", {"bare": bare}, words.gender)

    def qualify(self, head: Spoken, others: Sequence[str]) -> Spoken:
        """``el 34 (rojo)``."""
        more = f" ({', '.join(others)})"
        bare = {"bare": head.forms["bare"] + more}
        return Spoken(head.text + more, bare, head.gender)


def _listed(items: Sequence[str], word: str) -> str:
    *others, last = items
    return f"{', '.join(others)} {word} {last}" if others else last


def _contracted(preposition: str, text: str) -> str:
    return f"{preposition}l {text[3:]}" if text.startswith("el ") else f"{preposition} {text}"
