"""Drawings of rules: well-formed, named, and with every stroke in them."""

from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.rules.forms.base import FIRST, LAST
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow, Reading
from maestra.rules.forms.counting import CompareCounts, Count, Kinds, Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import CyclicOrdered, Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import AllOfThem, EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme
from maestra.rules.forms.timing import Before, Filling, FillOrder
from maestra.rules.pairs import AddUp, Compare, Named, Step
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Setting
from maestra.rules.token_tests import Comparison, Extreme, has
from maestra.web.board_drawing import MOST_COLUMNS, MOST_ROWS, Plan, picture_of
from maestra.web.rule_drawing import draw_exercise, draw_rule
from maestra.web.token_view import TokenView
from tests.rules.rule_strategies import RULES, decks, settings_with
from tests.rules.therapy_boards import TEN, THINGS, TOYS

SVG = "{http://www.w3.org/2000/svg}"


def parsed(drawing: str) -> ET.Element:
    return ET.fromstring(drawing)  # noqa: S314 - our own drawing


def texts(drawing: str) -> list[str]:
    return [one.text or "" for one in parsed(drawing).iter(f"{SVG}text")]


def signs(rule: Rule, setting: Setting) -> list[str]:
    """What stands on the drawing besides what stands on the board alone."""
    board = texts(draw_exercise((), setting))
    drawn = texts(draw_rule(rule, setting))
    for one in board:
        drawn.remove(one)
    return drawn


@st.composite
def rules_somewhere(draw: st.DrawFn) -> tuple[Rule, Setting]:
    setting = draw(settings_with(draw(decks())))
    build = RULES[draw(st.sampled_from(sorted(RULES, key=lambda form: form.__name__)))]
    rule: Rule = draw(build(setting.deck, setting.start.board))
    return rule, setting


@given(rules_somewhere(), st.sampled_from(Language))
def test_each_rule_has_a_drawing_with_title_and_description(
    chosen: tuple[Rule, Setting], language: Language
) -> None:
    rule, setting = chosen
    drawing = draw_rule(rule, setting, "<What> & “who”", description="d", language=language)
    root = parsed(drawing)
    assert (root.tag, root.get("role")) == (f"{SVG}svg", "img")
    first, second = root[0], root[1]
    assert (first.tag, first.text) == (f"{SVG}title", "<What> & “who”")
    assert (second.tag, second.text) == (f"{SVG}desc", "d")
    assert "style=" not in drawing
    assert "id=" not in drawing


@given(rules_somewhere())
def test_everything_drawn_is_inside_the_drawing(chosen: tuple[Rule, Setting]) -> None:
    root = parsed(draw_rule(*chosen))
    _, _, width, height = (float(one) for one in (root.get("viewBox") or "").split())
    for one in root.iter(f"{SVG}rect"):
        right = float(one.get("x", "0")) + float(one.get("width", "0"))
        assert 0 <= right <= width
    for one in root.iter(f"{SVG}text"):
        assert 0 <= float(one.get("x", "0")) <= width
        assert -40 <= float(one.get("y", "0")) <= height


def test_a_drawing_without_a_sentence_is_decoration() -> None:
    root = parsed(draw_rule(FullRow(), TEN))
    assert root.get("aria-hidden") == "true"
    assert root.get("role") is None


def test_an_order_is_signs_between_neighbours() -> None:
    assert signs(Ordered("value"), TEN) == ["<"] * 4
    assert signs(Ordered("value", strict=False), TEN) == ["≤"] * 4


def test_an_order_in_time_stands_on_the_line_of_time() -> None:
    assert signs(Ordered("value", line=Line.TIME), TEN) == ["1", "2", "3", "4", "5", *"<<<<"]


def test_a_circle_has_an_arrow_back() -> None:
    days = ("Mon", "Tue", "Wed")
    deck = Deck(tuple(Token(TokenId(day), (("day", day),)) for day in days), cycles={"day": days})
    board = Board(2, 3)
    setting = Setting(deck, State(board, dict(zip(deck.by_id, board.storage_cells, strict=True))))
    assert len(signs(CyclicOrdered("day"), setting)) == 3


def test_a_selection_ticks_the_tokens_that_belong_in_the_row() -> None:
    assert signs(EveryToken(has("odd", "value")), TEN) == ["✓"] * 6


def test_taking_the_smallest_numbers_the_tokens_as_they_are_taken() -> None:
    drawn = signs(TakeExtreme("value", Extreme.LOWEST), TEN)
    assert drawn[:10] == [str(turn) for turn in range(1, 11)]
    assert drawn[10:] == ["1", "→ 10"]


def test_first_and_then_numbers_two_sets() -> None:
    drawn = signs(Before(has("is-red", "colour"), has("is-blue", "colour"), Line.ROW), TOYS)
    assert sorted(drawn[:8]) == ["1"] * 4 + ["2"] * 4
    assert drawn[8:] == ["1", "→ 2"]


def test_a_sum_stands_below_the_board_and_numbers_are_as_the_language_writes_them() -> None:
    assert signs(Total("value", Comparison.EQUAL, 100), TEN) == ["Σ", "number", "=", "100"]
    drawn = draw_rule(Total("value", Comparison.MORE, 1000), TEN, language=Language.ES)
    assert "número" in texts(drawn)


def test_kinds_are_counted_by_their_attribute() -> None:
    assert signs(Kinds("category", Comparison.AT_LEAST, 2), THINGS) == ["#", "category", "≥", "2"]


def test_a_count_has_a_mark_on_each_token_that_counts() -> None:
    def paths(rule: Rule) -> int:
        return len(list(parsed(draw_rule(rule, THINGS)).iter(f"{SVG}path")))

    animals = has("is-animal", "category")
    assert signs(Count(animals, Comparison.EQUAL, 2), THINGS) == ["=", "2"]
    # Three animals, and the mark before the number.
    assert paths(Count(animals, Comparison.EQUAL, 2)) == 4
    more = CompareCounts(animals, Comparison.MORE, has("is-plant", "category"))
    assert signs(more, THINGS) == [">"]
    assert paths(more) == 8


def test_what_no_token_is_has_the_sign_of_the_empty_set() -> None:
    nothing = has("above-900", "value")
    assert "∅" in signs(Count(nothing, Comparison.EQUAL, 2), TEN)
    assert "∅" in signs(At(FIRST, nothing), TEN)


def test_a_token_that_alone_may_be_at_a_place_is_drawn_there_as_a_ghost() -> None:
    drawing = draw_rule(At(FIRST, has("is-19", "value")), TEN)
    ghosts = [one for one in parsed(drawing).iter() if one.get("stroke-dasharray")]
    assert len(ghosts) == 1
    assert texts(drawing).count("19") == 2


def test_a_pattern_in_time_has_its_marks_below_the_circles() -> None:
    rule = Pattern((has("odd", "value"), has("even", "value")), repeat=True, line=Line.TIME)
    root = parsed(draw_rule(rule, TEN))
    # Ten tokens have one each, and five circles.
    assert len(list(root.iter(f"{SVG}path"))) == 15


def test_the_last_in_time_is_a_circle_with_two_rings() -> None:
    root = parsed(draw_rule(At(LAST, has("odd", "value"), Line.TIME), TEN))
    rings = [one for one in root.iter(f"{SVG}circle") if one.get("r") in {"19", "14"}]
    # Five turns, the last one twice, and the place of the mark.
    assert len(rings) == 5 + 2 + 1


def test_what_follows_from_what_has_a_board_each() -> None:
    rule = IfThen(At(FIRST, has("odd", "value")), At(LAST, has("even", "value")))
    root = parsed(draw_rule(rule, TEN))
    assert next(one.get("transform") for one in root.findall(f"{SVG}g")) == "translate(0 0.0)"
    assert len(root.findall(f"{SVG}g")) == 2


def test_straight_up_has_an_arrow_for_each_column_and_no_sign() -> None:
    assert signs(StraightUp(), TEN) == []
    assert len(list(parsed(draw_rule(StraightUp(), TEN)).iter(f"{SVG}path"))) == 10


def test_relations_to_a_model_stand_beside_the_arrows() -> None:
    same = Compare("colour", Comparison.EQUAL)
    assert signs(ModelRow(1, Reading.COPIED, same), TOYS) == [*["="] * 5, "colour"]
    assert signs(Cue(1, 1, same), TOYS) == [*["="] * 5, "colour"]


@pytest.mark.parametrize(
    ("relation", "sign"),
    [
        (Step("value", 3), "+3"),
        (Step("value", -3), "−3"),
        (AddUp("value", 10), "Σ=10"),
        (Named("partner"), "~"),
    ],
)
def test_steps_and_sums_of_neighbours_stand_on_the_arrows(relation: object, sign: str) -> None:
    rule = EachPair(Pairs.NEIGHBOURS, relation)  # type: ignore[arg-type]  # parametrised
    drawn = signs(rule, TEN)
    assert drawn[:4] == [sign] * 4


def test_the_order_of_filling_stands_in_the_goal_cells() -> None:
    assert signs(FillOrder(Filling.RIGHT_TO_LEFT), TEN) == ["5", "4", "3", "2", "1"]


def test_a_thumbnail_shows_the_rule_that_says_most() -> None:
    rules = (FullRow(), FillOrder(Filling.LEFT_TO_RIGHT), Ordered("value"))
    assert draw_exercise(rules, TEN) == draw_rule(Ordered("value"), TEN)
    assert draw_exercise((FullRow(),), TEN) == draw_rule(FullRow(), TEN)


def test_all_of_them_marks_and_counts_them() -> None:
    assert signs(AllOfThem(has("odd", "value")), TEN) == ["=", "6"]


def test_of_a_very_large_board_a_part_is_drawn_with_the_goal_row() -> None:
    board = Board(100, 100, Row(100))
    deck = Deck((Token(TokenId("a"), (("value", 1),)), Token(TokenId("b"), (("value", 2),))))
    far = {TokenId("a"): Cell(Row(1), Column(1)), TokenId("b"): Cell(Row(99), Column(99))}
    drawing = draw_rule(Ordered("value"), Setting(deck, State(board, far)))
    root = parsed(drawing)
    assert len(list(root.iter(f"{SVG}rect"))) == MOST_COLUMNS * MOST_ROWS
    assert "…" in texts(drawing)
    # Marks are for tokens that are seen.
    assert "✓" not in signs(EveryToken(has("odd", "value")), Setting(deck, State(board, far)))


def test_a_board_is_drawn_with_its_pictures_and_shapes() -> None:
    deck = [
        TokenView(TokenId("cup"), "", "cup", picture="/pictures/1"),
        TokenView(TokenId("r"), "3", "3, red, round", colour="red", shape="round"),
        TokenView(TokenId("s"), "4", "4, red, star", colour="red", shape="star"),
        TokenView(TokenId("t"), "umbrella", "umbrella", shape="triangle"),
        TokenView(TokenId("q"), "5", "5, square", shape="square"),
    ]
    board = Board(2, 5)
    cells = {one.id: cell for one, cell in zip(deck, board.storage_cells, strict=True)}
    plan = Plan(board)
    lying = {cells[one.id]: one for one in deck}
    drawing = picture_of(plan.draw(lying), plan.width, plan.bottom, "a board", "with things")
    root = parsed(drawing)
    assert next(root.iter(f"{SVG}image")).get("href") == "/pictures/1"
    assert texts(drawing) == ["3", "4", "umbr…", "5"]
    assert len(list(root.iter(f"{SVG}polygon"))) == 2
