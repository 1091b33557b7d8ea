"""Every form of the rule language, every test, relation and feature, in every language."""

from __future__ import annotations

from decimal import Decimal

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.language.keys import Key
from maestra.language.languages import speaker_for
from maestra.language.of_pairs import Two
from maestra.language.of_rules import Rules
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import Named, opposite, say
from maestra.rules.features import PairFeature, TokenFeature
from maestra.rules.fields import Position
from maestra.rules.forms.base import LAST, MIDDLE, Direction
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import (
    CompareCounts,
    Count,
    Equation,
    Kinds,
    Operation,
    Total,
)
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Blocks, Pattern, Template, given_row
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme, from_row
from maestra.rules.forms.timing import Before, Filling, FillOrder, Follows
from maestra.rules.forms.words import Word
from maestra.rules.pairs import AddUp, Apart, Compare, Step, Times, different, same
from maestra.rules.pairs import Named as Related
from maestra.rules.registry import CONVERSES, PAIR_FEATURES, PARAMETER_FEATURES, TOKEN_FEATURES
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Extreme,
    Not,
    has,
)
from tests.rules.rule_strategies import FORMS, decks, rules_for

DECK = Deck(
    (
        Token(TokenId("t1"), (("value", 3), ("colour", "red"), ("day", "Mon"), ("letter", "c"))),
        Token(TokenId("t2"), (("value", 4), ("colour", "blue"), ("day", "Tue"), ("letter", "u"))),
    ),
    {"day": ("Mon", "Tue")},
    relations={"partner": frozenset({("cup", "saucer")})},
)
PLAIN = Deck((Token(TokenId("t1"), (("value", 3),)), Token(TokenId("t2"), (("value", 4),))))
RED, ODD = has("is-red", "colour"), has("odd", "value")


def sentence(rule: Rule, language: Language = Language.EN, deck: Deck = DECK) -> str:
    board = Board()
    return speaker_for(language, board, deck).sentence(Rules(Tokens(board, deck)).says(rule))


IN_ENGLISH: list[tuple[Rule, str]] = [
    (EveryToken(ODD), "Use only odd tokens."),
    (EveryToken(Not(RED)), "Use no red tokens."),
    (EveryToken(Either(RED, ODD)), "Use only tokens that are red or are odd."),
    (EveryToken(Both(RED, Not(ODD))), "Use only tokens that are red and are not odd."),
    (EveryToken(Not(Either(RED, ODD))), "Use only tokens that are not red and are not odd."),
    (EveryToken(Anything()), "Use only tokens that are any token."),
    (EveryToken(Not(Anything())), "Use only tokens that are no token."),
    (EveryToken(Either(RED, Anything())), "Use only tokens that are any token."),
    (EveryToken(Both(RED, Anything())), "Use only red tokens."),
    (EveryToken(Both(Anything(), Anything())), "Use only tokens that are any token."),
    (from_row(1), "Take the tokens only from row 2."),
    (EveryToken(Not(has("is-3", ORIGIN_ROW))), "Take no tokens from the bottom row."),
    (EveryToken(has("is-3", ORIGIN_COLUMN)), "Take the tokens only from column 3."),
    (EveryToken(Not(has("is-3", ORIGIN_COLUMN))), "Take no tokens from column 3."),
    (
        EveryToken(Compared("value", Comparison.AT_LEAST, 30)),
        "Use only tokens that are at least 30.",
    ),
    (
        EveryToken(Compared("size", Comparison.MORE, Decimal("1.5"))),
        "Use only tokens that have a size of more than 1.5.",
    ),
    (
        EveryToken(Compared("day", Comparison.LESS, "Tue")),
        "Use only tokens that come before Tue.",
    ),
    (
        EveryToken(Compared("day", Comparison.MORE, "Mon")),
        "Use only tokens that come after Mon.",
    ),
    (
        EveryToken(Compared("colour", Comparison.DIFFERENT, "red")),
        "Use only tokens that come before or after red.",
    ),
    (
        EveryToken(Among("value", Extreme.LOWEST)),
        "Use only tokens that are among the smallest that fill the row.",
    ),
    (
        EveryToken(Among("grade", Extreme.HIGHEST, 3)),
        "Use only tokens that are among the three with the highest grade.",
    ),
    (AllOfThem(ODD), "Use all odd tokens."),
    (AllOfThem(Anything()), "Use all the tokens."),
    (AllOfThem(Not(ODD)), "Use all tokens that are not odd."),
    (Ordered("value"), "Each token must be larger than the one on its left."),
    (
        Ordered("value", Direction.RISING, strict=False),
        "Each token must not be smaller than the one on its left.",
    ),
    (
        Ordered("value", Direction.FALLING, strict=False, line=Line.TIME),
        "Each token must not be larger than the one placed before it.",
    ),
    (
        Ordered("letter", Direction.FALLING),
        "Each token must come before the one on its left in the alphabet.",
    ),
    (Ordered("grade"), "Each token must have a higher grade than the one on its left."),
    (Ordered("day"), "Each token must come after the one on its left."),
    (
        CyclicOrdered("day"),
        "From left to right, the days go up; after the last comes the first.",
    ),
    (
        CyclicOrdered("day", Direction.FALLING, Line.TIME),
        "In the order you place them, the days go down; after the first comes the last.",
    ),
    (RiseAndFall("value"), "From left to right, the numbers first go up, then down."),
    (
        RiseAndFall("value", Direction.FALLING),
        "From left to right, the numbers first go down, then up.",
    ),
    (Zigzag("value"), "From left to right, the numbers go up and down by turns."),
    (
        EqualSteps("value"),
        "From left to right, the numbers change by the same amount each time.",
    ),
    (
        EqualSteps("value", ratio=True),
        "From left to right, the numbers are multiplied by the same each time.",
    ),
    (
        ExtremeAt("value", Extreme.HIGHEST, MIDDLE),
        "The token in the middle must be the largest of the row.",
    ),
    (
        ExtremeAt("grade", Extreme.LOWEST, LAST, negated=True),
        "The last token of the row must not have the lowest grade of the row.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, different("colour")),
        "Each token must have another colour than the one on its left.",
    ),
    (
        EachPair(Pairs.TWO_BY_TWO, Related("partner")),
        "Two by two: each second token must be the partner of the one on its left.",
    ),
    (
        EachPair(Pairs.MIRRORED, same("colour")),
        "Each token in the right half must have the same colour as the opposite one.",
    ),
    (
        EachPair(Pairs.FIRST_WITH_REST, same("colour"), Line.TIME),
        "Each token must have the same colour as the first token placed.",
    ),
    (
        EachPair(Pairs.ALL, different("colour")),
        "Each token must have another colour than every one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("value", 2)),
        "Each token must be 2 more than the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("value", -2)),
        "Each token must be 2 less than the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("value", 0)),
        "Each token must be 0 more than the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("day", 1)),
        "Each token must come right after the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("letter", -1)),
        "Each token must come right before the one on its left in the alphabet.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Step("day", -2)),
        "Each token must come two places before the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Apart("value", 5)),
        "Each token must be 5 away from the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Times("value", 2)),
        "Each token must be twice the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Times("value", Decimal("0.5"))),
        "Each token must be half of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Times("value", 3)),
        "Each token must be 3 times the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, AddUp("value", 10)),
        "Each token must make 10 together with the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("name", Comparison.EQUAL, "category")),
        "Each token must have as category the name of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("a", Comparison.AT_MOST, "b")),
        "Each token must not have a lower b than the a of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("a", Comparison.DIFFERENT, "b")),
        "Each token must not have as b the a of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("a", Comparison.LESS, "b")),
        "Each token must have a higher b than the a of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("a", Comparison.AT_LEAST, "b")),
        "Each token must not have a higher b than the a of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("a", Comparison.MORE, "b")),
        "Each token must have a lower b than the a of the one on its left.",
    ),
    (
        EachPair(Pairs.NEIGHBOURS, Compare("colour", Comparison.EQUAL)),
        "Each token must have the same colour as the one on its left.",
    ),
    (
        TwoPlaces(Position(1), LAST, same("colour")),
        ("The last token of the row must have the same colour as the first token from the left."),
    ),
    (given_row("letter", tuple("cu")), "Make this row: c, u."),
    (
        Pattern((RED, Anything()), repeat=True),
        "From left to right: the first is red, the second is any, and again from the start.",
    ),
    (
        Pattern((RED, ODD), line=Line.TIME),
        "In the order you place them: the first is red, the second is odd.",
    ),
    (
        Template("colour", "AAB"),
        "From left to right, the colours follow the pattern A, A, B.",
    ),
    (
        Template("colour", "AB", repeat=True),
        "From left to right, the colours follow the pattern A, B again and again.",
    ),
    (Blocks("colour"), "From left to right, tokens with the same colour stay together."),
    (Count(RED, Comparison.EQUAL, 2), "The row must have exactly two tokens that are red."),
    (Count(RED, Comparison.AT_LEAST, 1), "The row must have at least one token that is red."),
    (Count(Anything(), Comparison.AT_MOST, 3), "Place at most three tokens."),
    (
        CompareCounts(RED, Comparison.MORE, ODD),
        "The row must have more tokens that are red than tokens that are odd.",
    ),
    (
        Kinds("colour", Comparison.EQUAL, 2),
        "The number of different colours in the row must be exactly 2.",
    ),
    (
        Total("value", Comparison.EQUAL, 100),
        "The numbers of the row must make exactly 100 together.",
    ),
    (
        Equation("value", (Position(1), Position(2)), (Position(3),)),
        (
            "By number, the first token from the left plus the second token from the left "
            "must make the third token from the left."
        ),
    ),
    (
        Equation("value", (Position(1), Position(-2)), (), 12, Operation.PRODUCT),
        (
            "By number, the first token from the left times the second token from the right "
            "must make 12."
        ),
    ),
    (At(Position(1), RED), "The first token from the left must be red."),
    (At(LAST, RED, Line.TIME), "The last token placed must be red."),
    (
        IfThen(At(Position(1), RED), Count(ODD, Comparison.MORE, 1)),
        (
            "If the first token from the left is red, then the row has more than one token "
            "that is odd."
        ),
    ),
    (
        IfThen(Count(Anything(), Comparison.LESS, 3), At(Position(2), Anything(), Line.TIME)),
        (
            "If the row has less than three tokens that are any token, then the second token "
            "placed is any token."
        ),
    ),
    (Word(), "The letters must make a word of the list."),
    (
        Word(relation="kind", value="bird"),
        "The letters must make a word of the list, with kind “bird”.",
    ),
    (StraightUp(), "Keep each token in its column."),
    (
        StraightUp(mirrored=True),
        "Move each token to the opposite column, as in a mirror.",
    ),
    (
        TakeExtreme(ORIGIN_COLUMN, Extreme.LOWEST),
        "The token you take is always the left-most one still in storage.",
    ),
    (
        TakeExtreme(ORIGIN_ROW, Extreme.HIGHEST),
        "The token you take is always from the lower-most storage row with tokens.",
    ),
    (
        TakeExtreme("value", Extreme.HIGHEST, RED),
        (
            "Of the tokens that are red, the token you take is always the largest one still "
            "in storage."
        ),
    ),
    (
        TakeExtreme("grade", Extreme.LOWEST),
        "The token you take is always the one in storage with the lowest grade.",
    ),
    (
        FillOrder(Filling.ENDS_FIRST),
        "Put the tokens in the top row from the ends inwards.",
    ),
    (Before(RED, ODD), "Place all tokens that are red before any that are odd."),
    (
        Before(RED, ODD, Line.ROW),
        "All tokens that are red must be left of all that are odd.",
    ),
    (Follows(RED, ODD), "After a token that is red, place next one that is odd."),
    (
        Follows(RED, ODD, immediately=False, line=Line.ROW),
        "To the right of a token that is red, put one that is odd.",
    ),
    (
        ModelRow(1, Reading.MIRRORED, same("colour")),
        (
            "Row 2 is the model and stays: each token must have the same colour as its model, "
            "as in a mirror."
        ),
    ),
    (
        Cue(2, 4, same("colour")),
        ("The token in row 3, column 4 stays: each token must have the same colour as this one."),
    ),
    (FullRow(), "Fill the whole of the top row."),
    (UntilTotal("value", 50), "Stop as soon as the numbers make 50 or more together."),
]


@pytest.mark.parametrize(("rule", "text"), IN_ENGLISH)
def test_rules_are_said_in_english(rule: Rule, text: str) -> None:
    assert sentence(rule) == text


def test_the_opposite_of_several_things_is_said_of_each() -> None:
    rules = Rules(Tokens(Board(), DECK))
    neither = opposite(rules.does(Either(RED, ODD)))
    assert (
        speaker_for(Language.EN, Board(), DECK).spoken(neither).text == "is not red and is not odd"
    )
    assert opposite(neither) == rules.does(Either(RED, ODD))


def test_every_form_is_among_those_that_are_said() -> None:
    assert {type(rule) for rule, _ in IN_ENGLISH} == set(FORMS)


@pytest.mark.parametrize(
    ("language", "rule", "text"),
    [
        (Language.ES, EveryToken(ODD), "Use solo números impares."),
        (Language.CA, EveryToken(ODD), "Feu servir només nombres senars."),
        (Language.ES, AllOfThem(has("prime", "value")), "Use todos los números primos."),
        (Language.CA, EveryToken(Not(has("even", "value"))), "No feu servir nombres parells."),
        (Language.ES, Ordered("size"), "Cada ficha debe ser más grande que la de su izquierda."),
        (
            Language.ES,
            Ordered("size", Direction.FALLING),
            "Cada ficha debe ser más pequeña que la de su izquierda.",
        ),
        (
            Language.CA,
            ExtremeAt("height", Extreme.LOWEST, MIDDLE),
            "La fitxa del mig ha de ser la més baixa de la fila.",
        ),
        (
            Language.ES,
            EveryToken(Among("price", Extreme.HIGHEST, 3)),
            "Use solo fichas que estén entre las tres más caras.",
        ),
        (
            Language.ES,
            EachPair(Pairs.NEIGHBOURS, different("category")),
            "Cada ficha debe tener otra categoría que la de su izquierda.",
        ),
        (
            Language.CA,
            EachPair(Pairs.NEIGHBOURS, Times("value", 2)),
            "Cada fitxa ha de ser el doble de la de la seva esquerra.",
        ),
        (
            Language.ES,
            Zigzag("height"),
            "De izquierda a derecha, las alturas suben y bajan por turnos.",
        ),
        (
            Language.CA,
            Total("value", Comparison.EQUAL, Decimal("2.5")),
            "Els nombres de la fila han de sumar exactament 2,5.",
        ),
    ],
)
def test_words_agree_in_spanish_and_catalan(language: Language, rule: Rule, text: str) -> None:
    assert sentence(rule, language, PLAIN) == text


@settings(max_examples=settings().max_examples // 5)  # a rule takes long to draw
@given(st.data())
def test_every_rule_can_be_said_in_every_language(data: st.DataObject) -> None:
    deck = data.draw(decks())
    rule = data.draw(rules_for(deck, Board()))
    for language in Language:
        said = sentence(rule, language, deck)
        assert said.endswith(".")
        assert said == said.strip()
        assert not any(mark in said for mark in ("{", "}", "[", "@", "#", "|", "  ", " ,", "None"))


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize(
    "name", [*TOKEN_FEATURES, *(f"{family}-2" for family in PARAMETER_FEATURES)]
)
def test_every_feature_of_a_token_has_words(name: str, language: Language) -> None:
    tokens = Tokens(Board(), DECK)
    said = tokens.has(TokenFeature(name, "value"), Named(DECK.tokens[0].attributes))
    spoken = speaker_for(language, Board(), DECK).spoken(said)
    assert all(spoken.forms[form] for form in ("must", "does", "that", "do", "clause"))


@pytest.mark.parametrize("language", Language)
@pytest.mark.parametrize("side", ["as it stands", "converse"])
@pytest.mark.parametrize("name", [*PAIR_FEATURES, "partner"])
def test_every_feature_of_two_tokens_has_words(
    name: str,
    side: str,
    language: Language,
) -> None:
    two = Two(Tokens(Board(), DECK), None, say(Key.THE_ONE_ON_ITS_LEFT))
    converse = side == "converse"
    said = two.has(PairFeature(name, "value"), converse=converse)
    speaker = speaker_for(language, Board(), DECK)
    back = two.has(PairFeature(name, "value"), converse=not converse)
    symmetric = name in {"same", "different"}
    assert (speaker.spoken(said).text == speaker.spoken(back).text) == symmetric
    assert {*CONVERSES.values()} <= {*PAIR_FEATURES}
