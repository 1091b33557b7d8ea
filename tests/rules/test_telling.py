"""Exercises of rules that were told."""

import pytest

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.counting import Count
from maestra.rules.forms.length import FullRow, UntilTotal
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.words import Word
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.telling import clash, dealt, told_exercise, with_length
from maestra.rules.token_tests import Anything, Comparison, has

DECK = Deck(tuple(Token(TokenId(f"v{value}"), (("value", value),)) for value in range(1, 11)))
BOARD = Board()
SETTING = Setting(DECK, dealt(DECK, BOARD))
ODD, EVEN = EveryToken(has("odd", "value")), EveryToken(has("even", "value"))


def test_each_rule_is_kept_once_and_certain() -> None:
    exercise = told_exercise([ODD, FullRow(), ODD], BOARD, DECK)
    assert exercise.conjunction == (ODD, FullRow())
    assert exercise.safe == exercise.conjunction
    assert (exercise.status, exercise.confidence) == (LearnStatus.TOLD, 1.0)


def test_a_rule_that_the_deck_cannot_show_is_refused() -> None:
    with pytest.raises(InvalidError, match="colour"):
        told_exercise([Ordered("colour")], BOARD, DECK)


def test_the_row_is_full_unless_a_rule_says_how_long_it_is() -> None:
    assert with_length([ODD]) == (ODD, FullRow())


@pytest.mark.parametrize(
    "rule",
    [
        FullRow(),
        UntilTotal("value", 10),
        AllOfThem(Anything()),
        Word(),
        Count(Anything(), Comparison.EQUAL, 3),
    ],
)
def test_a_rule_about_the_length_is_enough(rule: Rule) -> None:
    assert with_length([ODD, rule]) == (ODD, rule)


def test_rules_that_go_together_do_not_clash() -> None:
    assert clash([ODD, Ordered("value"), FullRow()], SETTING) == ()


def test_only_the_rules_that_clash_are_named() -> None:
    assert clash([Ordered("value"), ODD, EVEN, FullRow()], SETTING) == (ODD, EVEN, FullRow())


def test_more_tokens_than_cells_cannot_be_dealt() -> None:
    with pytest.raises(InvalidError, match="10 tokens for 5 storage cells"):
        dealt(DECK, Board(2, 5))
