"""What boards and tokens look like, and what presses on them mean."""

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.faults import InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.language import Language
from maestra.language.languages import speaker_for
from maestra.web.board_press import Held, Moved, Nothing, Released, cell_of, outcome
from maestra.web.board_view import board_view, tokens_by_id
from maestra.web.token_view import HUES, OUTLINES, TokenView, token_view
from tests.rules.rule_strategies import decks, settings_with

BOARD = Board(2, 3)
A, B = TokenId("a"), TokenId("b")
DECK = Deck((Token(A, (("value", 1),)), Token(B, (("value", 2),))))
ONE, TWO, GOAL = Cell(Row(2), Column(1)), Cell(Row(2), Column(2)), Cell(Row(1), Column(1))
STATE = State(BOARD, {A: ONE, B: TWO})


def looks(shown: dict[str, Value], language: Language = Language.EN) -> TokenView:
    token = Token(A, tuple(shown.items()))
    return token_view(token, speaker_for(language, BOARD, Deck((token,))), {"cup.png": "/p/1"})


@pytest.mark.parametrize(
    ("shown", "label", "notes", "name"),
    [
        ({"value": 19}, "19", (), "19"),
        ({"letter": "C"}, "C", (), "C"),
        ({"name": "cup"}, "cup", (), "cup"),
        ({"value": 3, "colour": "red"}, "3", ("red",), "3, red"),
        ({"colour": "red"}, "red", (), "red"),
        ({"colour": "red", "shape": "round"}, "red", (), "red, round"),
        ({"shape": "star"}, "star", (), "star"),
        ({"shape": "crooked"}, "crooked", (), "crooked"),
        ({"picture": "cup.png"}, "", (), "cup.png"),
        ({"picture": "cup.png", "name": "cup"}, "cup", (), "cup, cup.png"),
        ({"picture": "gone.png"}, "gone.png", (), "gone.png"),
        ({"category": "animal", "weight": Decimal("1.5")}, "animal", ("1.5",), "animal, 1.5"),
        ({}, "a", (), "a"),
    ],
)
def test_a_token_shows_one_thing_in_large_and_the_rest_below(
    shown: dict[str, Value], label: str, notes: tuple[str, ...], name: str
) -> None:
    view = looks(shown)
    assert (view.label, view.notes, view.name) == (label, notes, name)


def test_tokens_are_read_in_the_readers_language() -> None:
    view = looks({"value": Decimal("1.5"), "colour": "red"}, Language.ES)
    assert (view.label, view.notes, view.name) == ("1,5", ("rojo",), "1,5, rojo")
    assert view.colour == "red"


def test_a_colour_or_shape_is_known_in_each_language_and_never_without_a_word() -> None:
    assert {looks({"colour": word}).colour for word in HUES} == set(HUES.values())
    assert {looks({"shape": word}).shape for word in OUTLINES} == set(OUTLINES.values())
    assert looks({"colour": "beige"}).colour == ""
    for word in HUES:
        assert word in looks({"colour": word, "value": 3}).name


@pytest.mark.parametrize(
    ("label", "size"),
    [
        ("19", "short"),
        ("100", "short"),
        ("cup", "medium"),
        ("yellow", "medium"),
        ("umbrella", "long"),
        ("", "short"),
    ],
)
def test_long_labels_are_smaller(label: str, size: str) -> None:
    assert TokenView(A, label, label).size == size


@given(st.data())
def test_the_stream_has_all_that_a_token_shows(data: st.DataObject) -> None:
    setting = data.draw(settings_with(data.draw(decks())))
    views = tokens_by_id(setting.deck, setting.start.board, data.draw(st.sampled_from(Language)))
    assert set(views) == set(setting.deck.by_id)
    for view in views.values():
        assert view.name
        assert view.as_json()["name"] == view.name
        assert list(view.notes) == view.as_json()["notes"]


def test_a_board_is_its_cells_row_by_row_with_what_is_seen_there() -> None:
    view = board_view(BOARD, DECK, STATE.cells, held=A, pointed=[GOAL], wrong=[TWO], allowed=[ONE])
    assert [cell.value for cell in view.cells] == ["1,1", "1,2", "1,3", "2,1", "2,2", "2,3"]
    assert [cell.is_goal for cell in view.cells] == [True] * 3 + [False] * 3
    assert view.columns == 3
    assert view.goal == view.rows[0]
    first, second = view.rows[1][0], view.rows[1][1]
    assert first.token is not None
    assert (first.token.id, first.held, first.allowed, first.wrong) == (A, True, True, False)
    assert (second.held, second.wrong, view.rows[0][0].pointed) == (False, True, True)
    assert view.held == A


def test_a_token_that_is_not_on_the_board_is_not_held() -> None:
    assert board_view(BOARD, DECK, {B: TWO}, held=A).held is None


def test_two_tokens_on_a_cell_are_no_board() -> None:
    with pytest.raises(InvalidError):
        board_view(BOARD, DECK, {A: ONE, B: ONE})


def test_the_first_press_takes_up_and_the_second_puts_down() -> None:
    assert outcome(STATE, None, ONE) == Held(A)
    assert outcome(STATE, A, GOAL) == Moved(Move(A, ONE, GOAL))
    assert outcome(STATE, A, ONE) == Released()
    assert outcome(STATE, A, TWO) == Held(B)
    assert outcome(STATE, None, GOAL) == Nothing()


def test_a_whole_move_is_one_press_whatever_is_held() -> None:
    assert outcome(STATE, B, GOAL, "a") == Moved(Move(A, ONE, GOAL))
    assert outcome(STATE, None, TWO, "a") == Nothing()
    assert outcome(STATE, A, ONE, "a") == Released()


def test_what_no_board_has_is_nothing() -> None:
    far = cell_of("9,9")
    assert far == Cell(Row(9), Column(9))
    assert outcome(STATE, A, far) == Nothing()
    assert outcome(STATE, None, GOAL, "unknown") == Nothing()
    assert outcome(STATE, TokenId("unknown"), ONE) == Held(A)
