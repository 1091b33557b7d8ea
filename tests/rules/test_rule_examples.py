"""Single facts about rules that random examples meet too seldom, or not at all."""

from __future__ import annotations

from decimal import Decimal

import numpy as np
import pytest

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.completability import (
    Completable,
    Conjunction,
    DeadEnd,
    MoveAllowed,
    MoveRefused,
    MoveUndecided,
    Search,
    Undecided,
)
from maestra.rules.domains import can_match
from maestra.rules.forms.base import FIRST, Position
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.counting import Count, Equation, Operation, Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.numbers import can_add_up
from maestra.rules.forms.order import EqualSteps, Ordered, RiseAndFall, Zigzag
from maestra.rules.forms.patterns import Blocks
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.timing import Filling, FillOrder, Follows
from maestra.rules.pairs import AddUp, Step
from maestra.rules.plays import Plays
from maestra.rules.rule import Rule, holding
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line, Play, Setting, play_of
from maestra.rules.token_tests import Compared, Comparison, Either, Not, has, passing
from tests.rules.rule_strategies import every_way_on

BOARD = Board(4, 5)


def numbers(*values: int, board: Board = BOARD) -> Setting:
    tokens = tuple(Token(TokenId(f"{v:03}"), (("value", v),)) for v in values)
    places = zip(tokens, board.storage_cells, strict=False)
    return Setting(Deck(tokens), State(board, {token.id: cell for token, cell in places}))


def placed(setting: Setting, *values: int) -> Play:
    play = Play.begin(setting)
    for cell, value in enumerate(values):
        play = play.after(setting.number_of[TokenId(f"{value:03}")], cell)
    return play


TEN = numbers(19, 23, 32, 34, 36, 46, 51, 57, 63, 77)
ASCENDING: tuple[Rule, ...] = (
    Ordered("value"),
    FillOrder(Filling.LEFT_TO_RIGHT),
    FullRow(),
)


def test_only_the_six_lowest_of_ten_may_come_first_in_ascending_order() -> None:
    moves = Conjunction(ASCENDING, TEN).allowed_moves(Play.begin(TEN))
    assert moves == tuple((token, 0) for token in range(6))


def test_a_refused_move_names_the_rule_it_breaks_or_the_dead_end() -> None:
    ascending = Conjunction(ASCENDING, TEN)
    assert ascending.judge(placed(TEN, 46), 0, 1) == MoveRefused((Ordered("value"),))
    assert ascending.judge(placed(TEN), 6, 0) == MoveRefused(())
    assert ascending.judge(placed(TEN, 19), 1, 1) == MoveAllowed()


def test_only_the_moves_of_the_paper_complete_its_ascending_exercise() -> None:
    ascending = Conjunction(ASCENDING, TEN)
    seen: set[tuple[int, int]] = set()
    todo = [Play.begin(TEN)]
    while todo:
        play = todo.pop()
        for move in ascending.allowed_moves(play):
            seen.add(move)
            todo.append(play.after(*move))
    assert len(seen) == 30


def test_a_search_that_is_given_up_says_so() -> None:
    deck = Deck(tuple(Token(TokenId(f"{v:03}"), (("value", v),)) for v in range(40)))
    board = Board(5, 10)
    cells = dict(zip(deck.by_id, board.storage_cells, strict=True))
    setting = Setting(deck, State(board, cells))
    rules: tuple[Rule, ...] = (
        EachPair(Pairs.MIRRORED, AddUp("value", 39)),
        Ordered("value", line=Line.TIME),
        EachPair(Pairs.NEIGHBOURS, Step("value", 1), Line.TIME),
        FullRow(),
    )
    conjunction = Conjunction(rules, setting, careful_choices=3)
    assert conjunction.outlook(Play.begin(setting)) == Undecided(3)
    assert conjunction.judge(Play.begin(setting), 5, 0) == MoveUndecided()


def test_a_conjunction_can_be_a_dead_end_though_each_rule_is_possible() -> None:
    rules: tuple[Rule, ...] = (
        Count(has("above-40", "value"), Comparison.AT_LEAST, 4),
        Count(has("below-40", "value"), Comparison.EQUAL, 2),
        FullRow(),
    )
    assert Conjunction(rules, TEN).outlook(Play.begin(TEN)) == DeadEnd()


def test_a_large_board_is_completed() -> None:
    board = Board(20, 20)
    large = numbers(*range(1, 200, 2), board=board)
    rules = (*ASCENDING, Total("value", Comparison.EQUAL, 1000))
    outlook = Conjunction(rules, large).outlook(Play.begin(large))
    assert isinstance(outlook, Completable)
    assert Conjunction(rules, large).may_end(outlook.example)


def test_a_dead_end_among_many_tokens_is_refuted() -> None:
    board = Board(20, 20)
    large = numbers(*range(1, 200, 2), board=board)
    late = Play.begin(large).after(81, 0)
    assert Conjunction(ASCENDING, large).outlook(late) == DeadEnd()
    just = Play.begin(large).after(80, 0)
    assert isinstance(Conjunction(ASCENDING, large).outlook(just), Completable)


def test_moves_are_those_of_the_demonstration() -> None:
    right = placed(TEN, 19, 23)
    shown = Demonstration(TEN.deck, TEN.start, right.moves())
    assert play_of(shown) == right
    assert play_of(shown, TEN).setting is TEN


@pytest.mark.parametrize(
    ("token", "destination"),
    [("019", Cell(Row(4), Column(5))), ("023", Cell(Row(1), Column(3)))],
)
def test_a_move_that_is_not_from_storage_to_goal_is_refused(token: str, destination: Cell) -> None:
    start = State(BOARD, {**TEN.start.cells, TokenId("023"): Cell(Row(1), Column(1))})
    origin = start.cells[TokenId(token)]
    shown = Demonstration(TEN.deck, start, (Move(TokenId(token), origin, destination),))
    with pytest.raises(InvalidError, match=r"moves\[0\]"):
        play_of(shown)


def test_storage_rows_are_counted_without_the_goal_row() -> None:
    board = Board(3, 4, Row(2))
    tokens = tuple(Token(TokenId(name), ((ORIGIN_ROW, 9),)) for name in "abc")
    places = (Cell(Row(1), Column(2)), Cell(Row(2), Column(1)), Cell(Row(3), Column(4)))
    ids = [token.id for token in tokens]
    setting = Setting(Deck(tokens), State(board, dict(zip(ids, places, strict=True))))
    assert setting.values(ORIGIN_ROW) == (1, 0, 2)
    assert setting.values(ORIGIN_COLUMN) == (2, 1, 4)
    assert passing(setting, Not(has("is-2", ORIGIN_ROW))) == 0b011


def test_layouts_are_placed_in_the_order_that_is_asked() -> None:
    setting = numbers(3, 1, 2, board=Board(3, 3))
    rows = np.array([[0, 1, 2], [2, -1, 0]], np.intp)
    rising = Ordered("value", line=Line.TIME)
    left_to_right = Plays.layouts(setting, rows)
    assert left_to_right.time.tolist() == [[0, 1, 2], [2, 0, -1]]
    assert left_to_right.cells.tolist() == [[0, 1, 2], [0, 2, -1]]
    assert holding([rising], left_to_right).tolist() == [True, False]
    right_to_left = Plays.layouts(setting, rows, (2, 1, 0))
    assert right_to_left.cells.tolist() == [[2, 1, 0], [2, 0, -1]]
    assert holding([rising], right_to_left).tolist() == [False, True]
    assert len(right_to_left) == 2


def test_sums_of_very_different_sizes_are_listed() -> None:
    far = [10**9, 3, 10**8 + 1, -7]
    assert can_add_up(far, range(4), 10**9 - 4)
    assert not can_add_up(far, range(2), 10**9 - 4)
    assert not can_add_up(far, range(3, 5), 10**9 + 3)


def test_products_of_fractions_are_exact() -> None:
    tokens = tuple(
        Token(TokenId(name), (("weight", Decimal(name)),)) for name in ("0.5", "1.5", "0.75")
    )
    cells = dict(zip([t.id for t in tokens], BOARD.storage_cells, strict=False))
    setting = Setting(Deck(tokens), State(BOARD, cells))
    rule = Equation(
        "weight",
        (FIRST, Position(2)),
        (Position(3),),
        1,
        Operation.PRODUCT,
    )
    order = [setting.number_of[TokenId(name)] for name in ("0.5", "1.5", "0.75")]
    play = Play.begin(setting)
    for cell, token in enumerate(order):
        play = play.after(token, cell)
    assert rule.holds(play)
    assert holding([rule], Plays.of(setting, [play])).tolist() == [True]


def test_numbers_too_large_for_64_bits_are_still_exact() -> None:
    setting = numbers(10**14, 10**14 + 1, 10**15 - 1)
    order = (10**14, 10**14 + 1, 10**15 - 1)
    tokens = [setting.deck.tokens.index(Token(TokenId(f"{v:03}"), (("value", v),))) for v in order]
    play = Play.begin(setting).after(tokens[0], 0).after(tokens[1], 1)
    product = 10**14 * (10**14 + 1)
    assert product > 2**63
    rule = Equation("value", (FIRST, Position(2)), (), Decimal(10**15), Operation.PRODUCT)
    assert not rule.holds(play)
    assert holding([rule], Plays.of(setting, [play])).tolist() == [False]


def test_a_sum_of_none_is_nothing() -> None:
    assert can_add_up([3], range(2), 0)
    assert not can_add_up([3], range(1, 2), 0)


def test_slots_that_share_too_few_tokens_cannot_be_matched() -> None:
    assert can_match({0: 0b11, 1: 0b01}, (0, 1))
    assert not can_match({0: 0b01, 1: 0b01}, (0, 1))
    assert not can_match({0: 0b01, 1: 0b11, 2: 0b11}, (0, 1, 2))


def test_three_tokens_that_are_too_few_for_four_cells_are_found_out() -> None:
    rules: tuple[Rule, ...] = (EveryToken(has("below-33", "value")), FullRow())
    assert Conjunction(rules, TEN).outlook(Play.begin(TEN)) == DeadEnd()


def test_what_lies_there_from_the_start_takes_no_time() -> None:
    setting = numbers(1, 2, 3, board=Board(2, 3))
    cells = {**setting.start.cells, TokenId("002"): Cell(Row(1), Column(2))}
    given = Setting(setting.deck, State(setting.start.board, cells))
    rules = (Ordered("value", line=Line.TIME), FillOrder(Filling.RIGHT_TO_LEFT), FullRow())
    outlook = Conjunction(rules, given).outlook(Play.begin(given))
    assert isinstance(outlook, Completable)
    assert outlook.example.placed == ((0, 2), (2, 0))


def test_a_value_that_the_order_does_not_name_compares_to_nothing() -> None:
    deck = Deck((Token(TokenId("a"), (("size", "small"),)),), {"size": ("small", "large")})
    setting = Setting(deck, State(BOARD, {TokenId("a"): Cell(Row(2), Column(1))}))
    assert passing(setting, Compared("size", Comparison.AT_MOST, "gigantic")) == 0
    assert passing(setting, Compared("size", Comparison.AT_MOST, "large")) == 1


THREE = numbers(1, 2, 3, 4, board=Board(3, 3))
"""Four tokens, three goal cells."""


def begun(setting: Setting, *moves: tuple[int, int]) -> Play:
    play = Play.begin(setting)
    for token, cell in moves:
        play = play.after(token, cell)
    return play


def coloured(names: str, columns: int = 4) -> Setting:
    """``r1`` is red; ``x`` shows nothing."""
    tokens = tuple(
        Token(TokenId(name), () if name == "x" else (("colour", name[0]),))
        for name in names.split()
    )
    board = Board(4, columns)
    places = zip(tokens, board.storage_cells, strict=False)
    return Setting(Deck(tokens), State(board, {token.id: cell for token, cell in places}))


RED, BLUE = has("is-r", "colour"), has("is-b", "colour")
AT_ONCE = Follows(RED, BLUE, line=Line.ROW)
ONE_RED = Count(RED, Comparison.EQUAL, 1)
CORNERS: list[tuple[Rule, Play]] = [
    (RiseAndFall("value"), begun(coloured("r1 b1"))),
    (EqualSteps("value"), begun(coloured("r1 b1"))),
    (EqualSteps("value"), begun(coloured("r1 b1"), (0, 0), (1, 1))),
    (EqualSteps("value"), begun(THREE)),
    (EqualSteps("value"), begun(THREE, (0, 0), (1, 1))),
    (EqualSteps("value"), begun(THREE, (0, 0), (1, 1), (2, 2))),
    (EqualSteps("value"), begun(THREE, (0, 0), (1, 1), (3, 2))),
    (EqualSteps("value", ratio=True), begun(numbers(0, 1, 2, board=Board(3, 3)))),
    (EqualSteps(ORIGIN_ROW), begun(numbers(1, 2, 3, board=Board(3, 3)))),
    (EqualSteps("value"), begun(numbers(1, 2, board=Board(2, 3)))),
    (IfThen(ONE_RED, ONE_RED), begun(coloured("r1 r2 b1"))),
    (IfThen(At(FIRST, RED), ONE_RED), begun(coloured("r1 r2 b1"))),
    (RiseAndFall("value"), begun(THREE, (0, 0))),
    (RiseAndFall("value"), begun(THREE, (3, 0), (2, 1))),
    (Zigzag("value"), begun(THREE)),
    (Zigzag("value"), begun(THREE, (0, 0), (3, 1))),
    (Zigzag("value"), begun(THREE, (0, 0), (3, 2))),
    (Zigzag("value"), begun(numbers(1, 3, board=Board(2, 3)))),
    (Blocks("colour"), begun(coloured("r1 r2 x"))),
    (Blocks("colour"), begun(coloured("r1 r2 r3"))),
    (Blocks("colour"), begun(coloured("r1 b1 g1"))),
    (Blocks("colour"), begun(coloured("r1 r2 b1"), (0, 0), (2, 3))),
    (AT_ONCE, begun(coloured("r1 b1"), (1, 3))),
    (AT_ONCE, begun(coloured("r1 b1 b2"), (2, 3))),
    (AT_ONCE, begun(coloured("b1 g1 r1"), (2, 0), (0, 2))),
    (AT_ONCE, begun(coloured("b1 g1 r1"), (2, 0), (1, 2))),
    (AT_ONCE, begun(coloured("g1 r1"), (1, 0), (0, 2))),
    (AT_ONCE, begun(coloured("r1 b1"), (0, 3))),
    (Follows(RED, Either(RED, BLUE), line=Line.ROW), begun(coloured("b1 r1 r2"), (1, 0), (0, 2))),
    (
        Total("value", Comparison.AT_LEAST, 1),
        begun(coloured("r1 b1")),
    ),
]


@pytest.mark.parametrize(("rule", "play"), CORNERS)
def test_prospects_are_exact_in_corners(rule: Rule, play: Play) -> None:
    right = [rule.holds(way) for way in every_way_on(play)]
    assert rule.possible(play) is any(right)
    assert rule.certain(play) is all(right)


def test_a_total_of_tokens_without_numbers_needs_more_of_them() -> None:
    play = begun(coloured("r1 b1"))
    assert not Total("value", Comparison.EQUAL, 0).possible_with(play, 1)
    assert Total("value", Comparison.EQUAL, 0).possible_with(play, 0)


def test_the_careful_search_sees_that_tokens_are_too_few_without_trying_any() -> None:
    rules: tuple[Rule, ...] = (EveryToken(has("below-33", "value")), FullRow())
    careful = Search(Conjunction(rules, TEN), 1, careful=True)
    assert careful.complete(Play.begin(TEN)) is None


def test_moves_are_allowed_in_any_cell_where_no_order_of_filling_is_asked() -> None:
    moves = Conjunction((Ordered("value"), FullRow()), TEN).allowed_moves(Play.begin(TEN))
    assert moves == tuple((k + cell, cell) for cell in range(5) for k in range(6))
