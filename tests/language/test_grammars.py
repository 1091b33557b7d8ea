"""What tables cannot say: lists, ordinals, articles, contractions."""

import pytest

from maestra.language.ca import GRAMMAR as CATALAN
from maestra.language.en import GRAMMAR as ENGLISH
from maestra.language.es import GRAMMAR as SPANISH
from maestra.language.phrases import Joint
from maestra.language.templates import Gender, Spoken
from maestra.language.tongue import AttributeWords, Grammar, inflect

NUMBER = AttributeWords("number")
LETTER = AttributeWords("letter", Gender.FEMININE)


@pytest.mark.parametrize(
    ("grammar", "items", "joint", "text"),
    [
        (ENGLISH, ["19"], Joint.OR, "19"),
        (ENGLISH, ["19", "23", "32"], Joint.OR, "19, 23 or 32"),
        (ENGLISH, ["a", "b"], Joint.AND, "a and b"),
        (ENGLISH, ["C", "U"], Joint.COMMA, "C, U"),
        (ENGLISH, ["one", "two"], Joint.PLUS, "one plus two"),
        (ENGLISH, ["one", "two"], Joint.TIMES, "one times two"),
        (SPANISH, ["el 19", "el 23", "el 32"], Joint.OR, "el 19, el 23 o el 32"),
        (SPANISH, ["rojo", "ocre"], Joint.OR, "rojo u ocre"),
        (SPANISH, ["7", "8"], Joint.OR, "7 u 8"),
        (SPANISH, ["7", "80"], Joint.OR, "7 u 80"),
        (SPANISH, ["7", "11"], Joint.OR, "7 u 11"),
        (SPANISH, ["7", "110"], Joint.OR, "7 o 110"),
        (SPANISH, ["7", "11000"], Joint.OR, "7 u 11000"),
        (SPANISH, ["taza", "hoja"], Joint.OR, "taza u hoja"),
        (SPANISH, ["aguja", "hilo"], Joint.AND, "aguja e hilo"),
        (SPANISH, ["A", "I"], Joint.AND, "A e I"),
        (SPANISH, ["nieve", "hielo"], Joint.AND, "nieve y hielo"),
        (SPANISH, ["una"], Joint.AND, "una"),
        (SPANISH, ["C", "U"], Joint.COMMA, "C, U"),
        (SPANISH, ["uno", "dos"], Joint.PLUS, "uno más dos"),
        (SPANISH, ["uno", "dos"], Joint.TIMES, "uno por dos"),
        (CATALAN, ["el 19", "el 23", "l'11"], Joint.OR, "el 19, el 23 o l'11"),
        (CATALAN, ["agulla", "fil"], Joint.AND, "agulla i fil"),
        (CATALAN, ["C", "U"], Joint.COMMA, "C, U"),
        (CATALAN, ["u", "dos"], Joint.PLUS, "u més dos"),
        (CATALAN, ["una"], Joint.OR, "una"),
    ],
)
def test_lists_are_joined_as_the_language_does(
    grammar: Grammar, items: list[str], joint: Joint, text: str
) -> None:
    assert grammar.join(items, joint) == text


@pytest.mark.parametrize(
    ("grammar", "number", "text"),
    [
        (ENGLISH, 1, "first"),
        (ENGLISH, 20, "twentieth"),
        (ENGLISH, 21, "21st"),
        (ENGLISH, 22, "22nd"),
        (ENGLISH, 33, "33rd"),
        (ENGLISH, 40, "40th"),
        (ENGLISH, 100, "100th"),
        (ENGLISH, 111, "111th"),
        (SPANISH, 1, "primer"),
        (SPANISH, 3, "tercer"),
        (SPANISH, 5, "quinto"),
        (SPANISH, 13, "decimotercer"),
        (SPANISH, 20, "vigésimo"),
        (SPANISH, 21, "21.º"),
        (CATALAN, 2, "segon"),
        (CATALAN, 5, "cinquè"),
        (CATALAN, 20, "vintè"),
        (CATALAN, 21, "21è"),
    ],
)
def test_ordinals_are_words_up_to_twenty(grammar: Grammar, number: int, text: str) -> None:
    assert grammar.nth(number).text == text


@pytest.mark.parametrize(
    ("grammar", "number", "text"),
    [
        (SPANISH, 1, "primera"),
        (SPANISH, 13, "decimotercera"),
        (SPANISH, 21, "21.ª"),
        (CATALAN, 5, "cinquena"),
        (CATALAN, 8, "vuitena"),
        (CATALAN, 21, "21a"),
    ],
)
def test_ordinals_of_tokens_are_feminine(grammar: Grammar, number: int, text: str) -> None:
    assert grammar.derive(grammar.nth(number), "feminine") == text


@pytest.mark.parametrize(
    ("grammar", "texts"),
    [
        (ENGLISH, ["0", "one", "twelve", "13"]),
        (SPANISH, ["0", "una", "doce", "13"]),
        (CATALAN, ["0", "una", "dotze", "13"]),
    ],
)
def test_counts_are_words_up_to_twelve(grammar: Grammar, texts: list[str]) -> None:
    counts = [grammar.count(number) for number in (0, 1, 12, 13)]
    assert [count.text for count in counts] == texts
    assert [count.many for count in counts] == [True, False, True, True]


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (1, "l'1"),
        (8, "el 8"),
        (11, "l'11"),
        (12, "el 12"),
        (100, "el 100"),
        (110, "el 110"),
        (1000, "el 1000"),
        (11000, "l'11000"),
        (1000000, "l'1000000"),
    ],
)
def test_catalan_elides_before_numbers_that_begin_with_a_vowel(number: int, text: str) -> None:
    assert CATALAN.plain(str(number), number, NUMBER).text == text


def test_names_of_letters_do_not_elide() -> None:
    assert CATALAN.plain("A", "A", LETTER).text == "la A"
    assert CATALAN.plain("A", "A", NUMBER).text == "el A"
    assert SPANISH.plain("A", "A", LETTER).text == "la A"


@pytest.mark.parametrize(
    ("grammar", "text", "form", "said"),
    [
        (SPANISH, "el 34", "of", "del 34"),
        (SPANISH, "el 34", "to", "al 34"),
        (SPANISH, "la C", "of", "de la C"),
        (SPANISH, "la fila 1", "to", "a la fila 1"),
        (CATALAN, "el 34", "of", "del 34"),
        (CATALAN, "els 34", "of", "dels 34"),
        (CATALAN, "el 34", "to", "al 34"),
        (CATALAN, "l'11", "of", "de l'11"),
        (CATALAN, "aquesta", "of", "d'aquesta"),
        (CATALAN, "la C", "to", "a la C"),
    ],
)
def test_prepositions_contract(grammar: Grammar, text: str, form: str, said: str) -> None:
    assert grammar.derive(Spoken(text), form) == said


@pytest.mark.parametrize(
    ("noun", "gender", "said"),
    [
        ("mida", Gender.FEMININE, "la mida"),
        ("alçada", Gender.FEMININE, "l'alçada"),
        ("imatge", Gender.FEMININE, "la imatge"),
        ("pes", Gender.MASCULINE, "el pes"),
        ("ordre", Gender.MASCULINE, "l'ordre"),
    ],
)
def test_catalan_articles_elide(noun: str, gender: Gender, said: str) -> None:
    assert CATALAN.derive(Spoken(noun, gender=gender), "the") == said


def test_spanish_articles_agree() -> None:
    assert SPANISH.derive(Spoken("mida", gender=Gender.FEMININE), "the") == "la mida"
    assert SPANISH.derive(Spoken("pesos", many=True), "the") == "los pesos"


@pytest.mark.parametrize("grammar", [ENGLISH, SPANISH, CATALAN])
def test_a_form_that_no_language_has_is_a_mistake_in_a_template(grammar: Grammar) -> None:
    assert grammar.derive(Spoken("x"), "bare") == "x"
    with pytest.raises(KeyError):
        grammar.derive(Spoken("x"), "ablative")


@pytest.mark.parametrize(
    ("grammar", "rows"),
    [
        (ENGLISH, ["the top row", "row 2", "the bottom row"]),
        (SPANISH, ["la fila de arriba", "la fila 2", "la fila de abajo"]),
        (CATALAN, ["la fila de dalt", "la fila 2", "la fila de baix"]),
    ],
)
def test_rows_at_the_edges_have_names(grammar: Grammar, rows: list[str]) -> None:
    assert [grammar.row(row, 3).text for row in (1, 2, 3)] == rows


def test_words_inflect_by_as_many_forms_as_they_have() -> None:
    assert inflect("azul", Gender.FEMININE, many=True) == "azul"
    assert inflect("rojo|roja", Gender.FEMININE) == "roja"
    assert inflect("rojo|roja|rojos|rojas", Gender.MASCULINE, many=True) == "rojos"
    assert inflect("rojo|roja|rojos|rojas", Gender.FEMININE, many=True) == "rojas"


def test_decimals_have_the_mark_of_the_language() -> None:
    numbers = [grammar.numeral(2) for grammar in (ENGLISH, SPANISH, CATALAN)]
    assert numbers == ["2", "2", "2"]
