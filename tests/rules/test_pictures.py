"""What is drawn for single rules: each stroke names what a person should see."""

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.forms.sources import TakeExtreme
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.pictures import Badge, Succession, picture
from maestra.rules.setting import Line, Setting
from maestra.rules.token_tests import Extreme

BOARD = Board(2, 3)
DECK = Deck(
    (
        Token(TokenId("two"), (("value", 2),)),
        Token(TokenId("one"), (("value", 1),)),
        Token(TokenId("cup"), (("name", "cup"),)),
    )
)
SETTING = Setting(
    DECK,
    State(
        BOARD,
        {token.id: cell for token, cell in zip(DECK.tokens, BOARD.storage_cells, strict=True)},
    ),
)


def test_taking_the_smallest_draws_the_tokens_that_have_a_size_from_the_smallest() -> None:
    (stroke,) = picture(TakeExtreme("value", Extreme.LOWEST), SETTING)
    assert stroke == Succession(((TokenId("one"),), (TokenId("two"),)), Line.TIME)


def test_taking_the_largest_draws_them_from_the_largest() -> None:
    (stroke,) = picture(TakeExtreme("value", Extreme.HIGHEST), SETTING)
    assert stroke == Succession(((TokenId("two"),), (TokenId("one"),)), Line.TIME)


def test_filling_from_the_ends_numbers_both_ends_alike() -> None:
    strokes = picture(FillOrder(Filling.ENDS_FIRST), SETTING)
    assert strokes == tuple(
        Badge(cell, turn) for cell, turn in zip(BOARD.goal_cells, ("1", "2", "1"), strict=True)
    )
