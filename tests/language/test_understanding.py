"""Sentences are read as the rules that they say, whatever may be left out or said otherwise."""

import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.core.board import Board, Row
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language, Lexicon
from maestra.language.keys import Key, Predicate
from maestra.language.of_places import Spot
from maestra.language.of_rules import RULES as RULE_WORDINGS
from maestra.language.of_tokens import Tokens
from maestra.language.tongue import AttributeWords, OwnWords
from maestra.language.understanding import (
    MAX_SENTENCE,
    Listener,
    Several,
    Understood,
    Unknown,
    listener_for,
    rules_like,
)
from maestra.rules.canonical import canonical
from maestra.rules.fields import Position
from maestra.rules.forms.base import FIRST, LAST, Direction
from maestra.rules.forms.conditions import At
from maestra.rules.forms.counting import Count, Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered, Zigzag
from maestra.rules.forms.patterns import Blocks, given_row
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.pairs import Named, different, same
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.rules.token_tests import Both, Comparison, Either, Not, has
from tests.rules.rule_strategies import FORMS, RULES, decks

NUMBERS = Deck(
    tuple(
        Token(TokenId(f"v{value}"), (("value", value),))
        for value in (19, 23, 32, 34, 36, 46, 51, 57, 63, 68)
    )
)
COLOURS = Deck(
    tuple(
        Token(
            TokenId(f"t{number}"),
            (("value", number + 1), ("colour", ("red", "blue", "green")[number % 3])),
        )
        for number in range(9)
    )
)
LETTERS = Deck(tuple(Token(TokenId(f"l{k}"), (("letter", c),)) for k, c in enumerate("CURIEABZ")))
DECKS = {"numbers": NUMBERS, "colours": COLOURS, "letters": LETTERS}

EVEN, ODD, RED, BLUE = (
    has("even", "value"),
    has("odd", "value"),
    has("is-red", "colour"),
    has("is-blue", "colour"),
)
RISING, FALLING = Ordered("value"), Ordered("value", Direction.FALLING)
ALPHABET = Ordered("letter")
CURIE = given_row("letter", tuple("CURIE"))


def listener(deck: Deck = NUMBERS, language: Language = Language.EN) -> Listener:
    return listener_for(language, Board(), deck)


uncounted = pytest.mark.no_cover
"""Lark parses long here, three times as long where lines are counted; others reach each line."""


@pytest.mark.parametrize("language", Language)
@settings(max_examples=settings().max_examples // 10)  # a grammar takes long to make
@given(st.data())
def test_what_is_said_of_a_rule_is_read_as_that_rule(
    language: Language, data: st.DataObject
) -> None:
    deck = data.draw(decks())
    board = data.draw(st.sampled_from([Board(), Board(3, 4, Row(2))]))
    heard = listener_for(language, board, deck)
    for build in RULES.values():
        rule = canonical(data.draw(build(deck, board)))
        if heard.fits(rule):
            said = heard.says(rule)
            assert (said, heard.understand(said)) == (said, Understood((rule,)))


@uncounted
@pytest.mark.parametrize("language", Language)
def test_every_example_is_understood(language: Language) -> None:
    heard = listener(COLOURS, language)
    for rule in rules_like(COLOURS, Board())[::3]:
        said = heard.says(rule)
        assert (said, heard.understand(said)) == (said, Understood((canonical(rule),)))


_IN_ENGLISH: list[tuple[Language, str, str, tuple[Rule, ...]]] = [
    (Language.EN, "numbers", sentence, rules)
    for rules, sentences in (
        (
            (EveryToken(EVEN), FALLING),
            (
                "Only even numbers, from large to small",
                "only even numbers in descending order",
                "EVEN NUMBERS ONLY; biggest first!",
                "Just even numbers and largest to smallest",
            ),
        ),
        (
            (RISING,),
            (
                "rising",
                "Ascending.",
                "from small to large",
                "smallest first",
                "in order",
                "numbers in ascending order",
                "put the numbers from small to large",
                "numbers go up",
                "each number must be bigger than the one on its left",
                "Every token should be greater than the one on its left",
            ),
        ),
        (
            (EveryToken(EVEN),),
            ("nothing but even numbers", "even numbers", "all tokens must be even"),
        ),
        (
            (EveryToken(Not(ODD)),),
            (
                "no odd numbers",
                "never odd numbers",
                "Don't use odd numbers",
                "without odd numbers",
            ),
        ),
        ((EveryToken(has("above-30", "value")),), ("numbers greater than thirty",)),
        (
            (EveryToken(Both(has("above-30", "value"), has("below-60", "value"))),),
            ("only numbers above 30 and below 60",),
        ),
        (
            (At(FIRST, ODD), At(LAST, EVEN)),
            (
                "the first must be odd and the last must be even",
                "the first number must be odd, the last number must be even",
            ),
        ),
        ((FullRow(),), ("fill the row", "the row must be full")),
        ((StraightUp(),), ("straight up",)),
        (
            (FillOrder(Filling.LEFT_TO_RIGHT),),
            ("left to right", "fill the row from left to right"),
        ),
        ((from_row(1),), ("only from row 2",)),
        ((Zigzag("value"),), ("up and down by turns",)),
        ((Total("value", Comparison.EQUAL, 100),), ("the numbers add up to 100",)),
    )
    for sentence in sentences
]
_IN_OTHER_WORDS: list[tuple[Language, str, str, tuple[Rule, ...]]] = [
    (language, deck, sentence, rules)
    for language, deck, rules, sentences in (
        (
            Language.EN,
            "colours",
            (EveryToken(Either(RED, BLUE)),),
            ("only red or blue tokens", "red and blue cards", "red tokens or blue tokens"),
        ),
        (Language.EN, "colours", (AllOfThem(RED),), ("all red cards",)),
        (
            Language.EN,
            "colours",
            (EveryToken(Not(RED)), EveryToken(EVEN)),
            ("No red tokens, only even ones",),
        ),
        (
            Language.EN,
            "colours",
            (EachPair(Pairs.NEIGHBOURS, different("colour")),),
            (
                "neighbours have different colours",
                "no two neighbours of the same colour",
                "Each card must have another color than the one before it",
            ),
        ),
        (
            Language.EN,
            "colours",
            (EachPair(Pairs.ALL, same("colour")),),
            ("all tokens have the same colour",),
        ),
        (
            Language.EN,
            "colours",
            (EachPair(Pairs.ALL, different("colour")),),
            ("all colours are different", "no colour twice"),
        ),
        (Language.EN, "colours", (Blocks("colour"),), ("group by colour",)),
        (
            Language.EN,
            "colours",
            (Count(RED, Comparison.AT_LEAST, 2),),
            ("the row must have at least two red tokens",),
        ),
        (
            Language.EN,
            "letters",
            (ALPHABET,),
            ("alphabetical order", "from a to z", "put the letters in alphabetical order"),
        ),
        (Language.EN, "letters", (EveryToken(has("vowel", "letter")),), ("only vowels",)),
        (Language.EN, "letters", (CURIE,), ("spell CURIE", "write the word curie")),
        (
            Language.ES,
            "numbers",
            (EveryToken(EVEN), FALLING),
            ("Solo números pares, de mayor a menor", "solamente numeros pares y descendente"),
        ),
        (
            Language.ES,
            "numbers",
            (RISING,),
            (
                "en orden ascendente",
                "de menor a mayor",
                "ponga los números de pequeño a grande",
                "Cada numero debe ser mayor que el de su izquierda",
            ),
        ),
        (Language.ES, "numbers", (EveryToken(Not(ODD)),), ("nunca números impares",)),
        (
            Language.ES,
            "numbers",
            (EveryToken(has("above-30", "value")),),
            ("números mayores que treinta",),
        ),
        (
            Language.ES,
            "numbers",
            (FillOrder(Filling.LEFT_TO_RIGHT),),
            ("Llena la fila de izquierda a derecha",),
        ),
        (Language.ES, "colours", (EveryToken(RED),), ("solo fichas rojas", "únicamente rojas")),
        (Language.ES, "colours", (EveryToken(Not(RED)),), ("ninguna ficha roja",)),
        (
            Language.ES,
            "colours",
            (EachPair(Pairs.NEIGHBOURS, different("colour")),),
            ("vecinas de distinto color",),
        ),
        (Language.ES, "letters", (ALPHABET,), ("en orden alfabético", "alfabeticamente")),
        (Language.ES, "letters", (CURIE,), ("la palabra CURIE",)),
        (
            Language.CA,
            "numbers",
            (EveryToken(EVEN), FALLING),
            ("Només nombres parells, de gran a petit", "nomes nombres parells i descendent"),
        ),
        (
            Language.CA,
            "numbers",
            (RISING,),
            (
                "en ordre ascendent",
                "de petit a gran",
                "Cada nombre ha de ser més gran que el de la seva esquerra",
            ),
        ),
        (Language.CA, "numbers", (EveryToken(Not(ODD)),), ("mai nombres senars",)),
        (
            Language.CA,
            "numbers",
            (FillOrder(Filling.LEFT_TO_RIGHT),),
            ("Omple la fila d'esquerra a dreta", "omple la fila d’esquerra a dreta"),
        ),
        (Language.CA, "colours", (EveryToken(RED),), ("només fitxes vermelles",)),
        (Language.CA, "colours", (EveryToken(Not(RED)),), ("cap fitxa vermella",)),
        (Language.CA, "letters", (ALPHABET,), ("en ordre alfabètic",)),
        (Language.CA, "letters", (CURIE,), ("la paraula CURIE",)),
    )
    for sentence in sentences
]


@pytest.mark.parametrize(
    ("language", "deck", "sentence", "rules"), [*_IN_ENGLISH, *_IN_OTHER_WORDS]
)
def test_other_words_say_the_same(
    language: Language, deck: str, sentence: str, rules: tuple[Rule, ...]
) -> None:
    assert listener(DECKS[deck], language).understand(sentence) == Understood(rules)


def test_what_may_mean_several_things_is_said_so_that_each_is_clear() -> None:
    deck = Deck((Token(TokenId("t"), (("value", 3), ("weight", 4))),))
    heard = listener(deck)
    found = heard.understand("only even tokens")
    assert found == Several(("Use only even tokens by number.", "Use only even tokens by weight."))
    assert heard.understand("only even numbers") == Understood((EveryToken(EVEN),))
    assert isinstance(found, Several)
    for sentence in found.sentences:
        assert isinstance(heard.understand(sentence), Understood)


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize(
    ("sentence", "quoted"),
    [
        ("xyzzy", ("xyzzy",)),
        ("abracadabra, plugh", ("abracadabra", "plugh")),
        ("", ("",)),
        ("!?", ("!?",)),
    ],
)
def test_what_is_not_understood_is_quoted(
    sentence: str, quoted: tuple[str, ...], language: Language
) -> None:
    heard = listener(language=language)
    found = heard.understand(sentence)
    assert isinstance(found, Unknown)
    assert tuple(quote.text for quote in found.quotes) == quoted


def test_only_what_is_not_understood_is_quoted() -> None:
    found = listener().understand("Only even numbers, and then dance; from small to large.")
    assert isinstance(found, Unknown)
    assert [quote.text for quote in found.quotes] == ["then dance"]
    found = listener().understand("Only purple numbers and sing. Rising, odd dances.")
    assert isinstance(found, Unknown)
    assert [quote.text for quote in found.quotes] == ["Only purple numbers", "sing", "odd dances"]


def test_what_is_understood_piece_by_piece_is_understood() -> None:
    found = listener().understand("From left to right; even numbers: rising!")
    assert found == Understood((FillOrder(Filling.LEFT_TO_RIGHT), EveryToken(EVEN), RISING))


@pytest.mark.parametrize(
    ("language", "sentence", "nearest"),
    [
        (Language.EN, "use only evven numbers", "Use only even numbers."),
        (Language.EN, "fil the row", "Fill the whole of the top row."),
        (Language.ES, "use solo numeros parez", "Use solo números pares."),
        (Language.CA, "feu servir nombres parels", "Feu servir només nombres parells."),
    ],
)
def test_the_nearest_sentences_come_first_and_are_understood(
    language: Language, sentence: str, nearest: str
) -> None:
    heard = listener(language=language)
    found = heard.understand(sentence)
    assert isinstance(found, Unknown)
    (quote,) = found.quotes
    assert nearest in quote.nearest
    assert len(quote.nearest) == 3
    for suggested in quote.nearest:
        assert isinstance(heard.understand(suggested), Understood)


TWO_NUMBERS = Deck((Token(TokenId("t"), (("value", 3), ("weight", 4))),))
LONG = "each token must have a higher number than the one on its left"
"""Twelve words that count: eleven times that is more than a sentence that is read as a whole."""


def test_a_long_text_is_read_clause_by_clause() -> None:
    text = ". ".join([LONG] * 11)
    assert listener().understand(text) == Understood((RISING,) * 11)


def test_in_a_long_text_what_may_mean_several_things_is_found() -> None:
    weight = "each token must have a higher weight than the one on its left"
    found = listener(TWO_NUMBERS).understand(". ".join([weight] * 11 + ["only even tokens"]))
    assert isinstance(found, Several)
    assert found.sentences[0].endswith("Use only even tokens by number.")


def test_of_many_clauses_the_whole_is_quoted() -> None:
    text = "sing. " * 13
    found = listener().understand(text)
    assert isinstance(found, Unknown)
    assert [quote.text for quote in found.quotes] == [text.strip(" .")]


@pytest.mark.parametrize(
    "sentence",
    [
        "use exactly 20000 tokens",
        "the first token must come after the one on its left in the alphabet",
        "spell XYZQ",
        "at least 1.5 tokens",
    ],
)
def test_what_no_rule_can_say_is_not_understood(sentence: str) -> None:
    assert isinstance(listener(LETTERS).understand(sentence), Unknown)


def test_numbers_in_a_row_are_a_pattern() -> None:
    assert listener().understand("Make this row: 19, 23, 32.") == Understood(
        (given_row("value", (19, 23, 32)),)
    )


def test_attributes_that_are_called_the_same_are_told_apart_by_their_names() -> None:
    heard = listener(Deck((Token(TokenId("t"), (("value", 3), ("number", 4))),)))
    said = heard.says(Ordered("number"))
    assert said == "Each token must be larger than the one on its left by number."
    assert heard.understand(said) == Understood((Ordered("number"),))


def test_a_wording_means_nothing_where_something_is_missing() -> None:
    tokens = Tokens(Board(), NUMBERS)
    total = next(wording for wording in RULE_WORDINGS if wording.says is Key.TOTAL)
    assert list(total.things({}, tokens)) == []
    at = next(wording for wording in RULE_WORDINGS if wording.of is At)
    nowhere = {"subject": Spot(Position(-2), Line.TIME), "does": EVEN}
    assert list(at.things(nowhere, tokens)) == []


def test_a_caregivers_own_words_are_understood() -> None:
    grade = AttributeWords("grade", more="harder", less="easier", most="hardest", least="easiest")
    words = Lexicon({"en": OwnWords({"level": grade})})
    deck = Deck(tuple(Token(TokenId(f"t{k}"), (("level", k),)) for k in range(4)))
    heard = listener_for(Language.EN, Board(), deck, words)
    said = "each token must be harder than the one on its left"
    assert heard.understand(said) == Understood((Ordered("level"),))


def test_a_relation_in_the_caregivers_own_words_is_understood() -> None:
    own = OwnWords(relations={("partner", Predicate.RELATED): ("be", "the mate of {other}")})
    deck = Deck(
        (Token(TokenId("t"), (("name", "cup"),)),),
        relations={"partner": frozenset({("cup", "saucer")})},
    )
    heard = listener_for(Language.EN, Board(), deck, Lexicon({"en": own}))
    said = "Two by two: each second token must be the mate of the one on its left."
    assert heard.understand(said) == Understood((EachPair(Pairs.TWO_BY_TWO, Named("partner")),))


def test_a_page_is_too_long() -> None:
    with pytest.raises(InvalidError, match=f"{MAX_SENTENCE + 1} characters"):
        listener().understand("a" * (MAX_SENTENCE + 1))


HEARD = [
    "only",
    "even",
    "numbers",
    "tokens",
    ",",
    "1",
    "the",
    "first",
    "must",
    "be",
    "not",
    "from",
    "to",
    "A",
    "left",
    "right",
    "row",
    "than",
    "larger",
    "one",
    "its",
    "on",
    "each",
    "and",
    "or",
]
LONGEST_SECONDS = 60.0
"""On a machine that does other things too."""


@uncounted
@pytest.mark.parametrize("piece", ["red or blue and ", "1 ", "a, b, ", "( [ {0} % \\ / "])
def test_the_longest_sentences_are_answered_in_time(piece: str) -> None:
    began = time.perf_counter()
    text = (piece * MAX_SENTENCE)[:MAX_SENTENCE]
    assert isinstance(listener(COLOURS).understand(text), Understood | Several | Unknown)
    assert time.perf_counter() - began < LONGEST_SECONDS


@settings(max_examples=settings().max_examples // 4)
@given(st.text(max_size=60) | st.lists(st.sampled_from(HEARD)).map(" ".join))
def test_any_text_gets_an_answer(text: str) -> None:
    found = listener(COLOURS).understand(text)
    if isinstance(found, Understood):
        assert all(listener(COLOURS).fits(rule) for rule in found.rules)


def test_examples_have_every_form_that_a_deck_can_show() -> None:
    deck = Deck(
        (
            *COLOURS.tokens,
            Token(TokenId("l1"), (("letter", "A"), ("day", "Mon"))),
            Token(TokenId("l2"), (("letter", "B"), ("day", "Tue"))),
        ),
        cycles={"day": ("Mon", "Tue")},
        relations={"partner": frozenset({("cup", "saucer")})},
        lexicon=("ab",),
    )
    assert {type(rule) for rule in rules_like(deck, Board())} == set(FORMS)
