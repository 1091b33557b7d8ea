"""A caregiver's own words for attributes, values and relations."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from maestra.core.board import Board
from maestra.core.json_lines import FormatError
from maestra.core.tokens import Attributes, Deck, Token, TokenId
from maestra.language import NO_LEXICON, Language, Lexicon, read_words
from maestra.language.languages import speaker_for
from maestra.language.of_rules import Rules
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import Named, ValueNamed
from maestra.rules.forms.base import Direction
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.pairs import Named as Related
from maestra.rules.rule import Rule
from maestra.rules.token_tests import has

EN, ES, CA = Language
MINE = {
    "format": "maestra.words/1",
    "attributes": {
        "ripeness": {
            "en": {"noun": "ripeness", "more": "riper", "less": "greener"},
            "es": {
                "noun": "madurez",
                "gender": "f",
                "plural": "madureces",
                "more": "más maduro|más madura",
                "less": "más verde",
            },
        },
        "mood": {"en": {"noun": "mood", "naming": "quality"}},
    },
    "values": {
        "mood": {"sad": {"es": "triste|triste|tristes|tristes", "en": "gloomy"}},
    },
    "relations": {
        "partner": {
            "en": {"verb": "be", "rest": "the mate of {other}", "back": "the first to {other}"},
            "es": {"verb": "ser", "rest": "la pareja {other:of}"},
        },
    },
}
DECK = Deck((Token(TokenId("a"), (("mood", "sad"),)), Token(TokenId("b"), (("mood", "glad"),))))


def lexicon(**changes: object) -> Lexicon:
    return read_words(json.dumps({**MINE, **changes}).encode(), "words.json")


def said(rule: Rule, language: Language, words: Lexicon) -> str:
    board = Board()
    speaker = speaker_for(language, board, DECK, words)
    return speaker.sentence(Rules(Tokens(board, DECK)).says(rule))


def test_own_words_are_said_before_those_there_are() -> None:
    words = lexicon()
    falling = Ordered("ripeness", Direction.FALLING)
    assert said(falling, EN, words) == "Each token must be greener than the one on its left."
    rising = Ordered("ripeness")
    assert said(rising, ES, words) == "Cada ficha debe ser más madura que la de su izquierda."
    # Catalan has no word of the caregiver's and says the attribute's name.
    assert (
        said(rising, CA, words)
        == "Cada fitxa ha de tenir més ripeness que la de la seva esquerra."
    )
    assert said(EveryToken(has("is-sad", "mood")), EN, words) == "Use only gloomy tokens."


def test_relations_have_words_in_both_directions() -> None:
    rule = EachPair(Pairs.NEIGHBOURS, Related("partner"))
    words = lexicon()
    assert said(rule, EN, words) == "Each token must be the mate of the one on its left."
    assert said(rule, ES, words) == "Cada ficha debe ser la pareja de la de su izquierda."
    assert said(rule, EN, NO_LEXICON) == "Each token must be the partner of the one on its left."


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        ({"relations": {"p": {"en": {"verb": "beat", "rest": "{other}"}}}}, "relations.p.en.verb"),
        ({"relations": {"p": {"en": {"verb": "be", "rest": "mate"}}}}, "relations.p.en.rest"),
        (
            {"relations": {"p": {"en": {"verb": "be", "rest": "{other}", "back": "{own}"}}}},
            "relations.p.en.back",
        ),
        ({"attributes": {"size": {"de": {"noun": "Größe"}}}}, "attributes.size.de"),
        ({"attributes": {"size": {"en": {}}}}, "attributes.size.en.noun"),
        ({"attributes": {"size": {"en": {"noun": "{x}"}}}}, "attributes.size.en.noun"),
        ({"colours": {}}, "colours"),
        ({"format": "maestra.words/2"}, "newer Maestra"),
    ],
)
def test_a_file_that_cannot_be_said_is_refused_with_the_place(
    changes: dict[str, object], fault: str
) -> None:
    with pytest.raises(FormatError) as refusal:
        lexicon(**changes)
    assert fault in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("shown", "deck", "names"),
    [
        ((("value", 11),), (), ("11", "el 11", "l'11")),
        ((("letter", "E"),), (), ("E", "la E", "la E")),
        ((("name", "cup"),), (), ("cup", "la ficha «cup»", "la fitxa «cup»")),
        ((("animal", "cat"),), (), ("cat", "la ficha «cat»", "la fitxa «cat»")),
        ((("colour", "red"),), (), ("the red token", "la ficha roja", "la fitxa vermella")),
        ((("size", 3),), (), ("size 3", "el tamaño 3", "la mida 3")),
        ((("height", 3),), (), ("height 3", "la altura 3", "l'alçada 3")),
        (
            (("colour", "red"), ("value", 11)),
            ((("colour", "blue"), ("value", 11)),),
            ("11 (red)", "el 11 (rojo)", "l'11 (vermell)"),
        ),
        (
            (("colour", "red"), ("value", 11)),
            ((("colour", "blue"), ("value", 12)),),
            ("11", "el 11", "l'11"),
        ),
        ((), (), ("token", "ficha", "fitxa")),
    ],
)
def test_a_token_is_named_by_what_tells_it_from_the_others(
    shown: Attributes, deck: tuple[Attributes, ...], names: tuple[str, str, str]
) -> None:
    tokens = tuple(Token(TokenId(str(k)), each) for k, each in enumerate((shown, *deck)))
    for language, name in zip(Language, names, strict=True):
        speaker = speaker_for(language, Board(), Deck(tokens))
        assert speaker.spoken(Named(shown)).text == name
        assert speaker.spoken(Named(shown)).text == name


@pytest.mark.parametrize(
    ("attribute", "value", "texts"),
    [
        ("value", 34, ("34", "el 34", "el 34")),
        ("name", "cup", ("cup", "la ficha «cup»", "la fitxa «cup»")),
        ("colour", "red", ("red", "rojo", "vermell")),
        ("size", 3, ("3", "3", "3")),
    ],
)
def test_a_value_is_named_as_its_attribute_is(
    attribute: str, value: int | str, texts: tuple[str, str, str]
) -> None:
    for language, text in zip(Language, texts, strict=True):
        speaker = speaker_for(language, Board(), DECK)
        assert speaker.spoken(ValueNamed(attribute, value)).text == text


def test_the_documented_file_of_words_is_read() -> None:
    page = Path(__file__).parents[2] / "docs" / "how-to" / "your-own-words.md"
    written = page.read_text(encoding="utf-8").split("```json\n")[1].split("```")[0]
    words = read_words(written.encode(), page.name)
    rule = EachPair(Pairs.NEIGHBOURS, Related("partner"))
    assert said(rule, ES, words) == "Cada ficha debe ser la pareja de la de su izquierda."
