"""Plays drawn by rules: the right ones are right, the near misses are not."""

from itertools import islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from maestra.learning.drawn_plays import Drawer, distance, starts
from maestra.rules.forms.base import Direction
from maestra.rules.forms.counting import Count, Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Play, Setting, play_of
from maestra.rules.token_tests import Anything, Comparison, has
from tests.learning.caregivers import SMALL_BOARD, SMALL_DECK, small
from tests.rules.rule_strategies import decks, rules_for, settings_with

RISING = Ordered("value", Direction.RISING, strict=True)
RED = EveryToken(has("is-red", "colour"))
SETTING = play_of(small("abc")).setting


def drawn(*rules: Rule, number: int = 30) -> list[Play]:
    drawer = Drawer(rules, SETTING)
    plays = [drawer.right(seed) for seed in range(number)]
    return [play for play in plays if play is not None]


@settings(max_examples=15)
@given(st.data())
def test_a_drawn_play_keeps_all_rules_and_a_near_miss_does_not(data: st.DataObject) -> None:
    deck = data.draw(decks())
    setting = data.draw(settings_with(deck))
    rules = tuple(data.draw(st.lists(rules_for(deck, setting.start.board), max_size=2)))
    drawer = Drawer(rules, setting)
    play = drawer.right(data.draw(st.integers(0, 99)))
    if play is not None:
        assert all(rule.holds(play) for rule in rules)
        for miss in islice(drawer.near_misses(play), 5):
            assert drawer.broken(miss)
            assert len(miss.placed) == len(play.placed)
            assert 1 <= drawer.refusals(miss) <= max(1, len(miss.placed))


@pytest.mark.parametrize(
    ("rules", "many"),
    [
        ((FullRow(), RISING), 10),
        ((FullRow(), RED), 6),
        ((FullRow(), RED, RISING), 1),
        ((FullRow(), Total("value", Comparison.EQUAL, 17)), 6),
        ((FullRow(), FillOrder(Filling.RIGHT_TO_LEFT), RED), 6),
    ],
)
def test_every_right_row_is_drawn_sooner_or_later(rules: tuple[Rule, ...], many: int) -> None:
    rows = {play.row for play in drawn(*rules, number=100)}
    assert len(rows) == many


def test_a_play_ends_where_nothing_more_may_come() -> None:
    one = Count(Anything(), Comparison.AT_MOST, 1)
    assert {len(play.placed) for play in drawn(one)} == {0, 1}


def test_where_only_the_order_in_time_counts_any_cell_may_come_first() -> None:
    falling = Ordered("value", Direction.FALLING, strict=True, line=Line.TIME)
    orders = {tuple(cell for _, cell in play.placed) for play in drawn(FullRow(), falling)}
    assert len(orders) == 6


def test_a_play_may_end_wherever_the_rules_let_it() -> None:
    assert {len(play.placed) for play in drawn(RED)} == {0, 1, 2, 3}


def test_nothing_is_drawn_where_nothing_is_right() -> None:
    assert drawn(FullRow(), EveryToken(has("is-blue", "colour"))) == []


def test_a_swap_in_an_ascending_row_is_refused_at_one_place() -> None:
    drawer = Drawer((FullRow(), RISING), SETTING)
    assert drawer.refusals(play_of(small("acb"), SETTING)) == 1
    assert drawer.refusals(play_of(small("edc"), SETTING)) == 2
    assert drawer.refusals(play_of(small("ab"), SETTING)) == 1
    assert drawer.broken(play_of(small("cb"), SETTING)) == {0, 1}


def test_near_misses_change_one_thing() -> None:
    drawer = Drawer((FullRow(), RISING, FillOrder(Filling.LEFT_TO_RIGHT)), SETTING)
    rows = [
        ("".join("abcde"[t] for t in miss.tokens), [cell for _, cell in miss.placed])
        for miss in drawer.near_misses(play_of(small("abc"), SETTING))
    ]
    inorder = [0, 1, 2]
    assert rows == [
        ("dbc", inorder),
        ("ebc", inorder),
        ("adc", inorder),
        ("aec", inorder),
        ("bac", inorder),
        ("cba", inorder),
        ("acb", inorder),
        ("abc", [1, 0, 2]),
        ("abc", [0, 2, 1]),
    ]


@settings(max_examples=20)
@given(st.integers())
def test_the_tokens_of_a_shown_start_change_places(seed: int) -> None:
    given_start = SETTING.start
    some = list(islice(starts(SMALL_DECK, SMALL_BOARD, [given_start], seed), 20))
    assert all(set(s.start.cells.values()) == set(given_start.cells.values()) for s in some)
    assert len({one.start for one in some}) > 10


def test_a_token_of_the_goal_row_stays_there() -> None:
    moved = play_of(small("abc")).setting
    start = small("b", cells=[1]).end
    others = islice(starts(SMALL_DECK, SMALL_BOARD, [start], 3), 5)
    assert all(one.given == (None, 1, None) for one in others)
    assert moved.given == (None, None, None)


def test_where_nothing_was_shown_tokens_lie_anywhere_in_storage() -> None:
    some = list(islice(starts(SMALL_DECK, SMALL_BOARD, [], 0), 50))
    used = {cell for one in some for cell in one.start.cells.values()}
    assert used == set(SMALL_BOARD.storage_cells)


def test_plays_are_as_far_apart_as_their_cells_differ() -> None:
    one = play_of(small("abc"), SETTING)
    assert distance(one, one) == 0
    assert distance(one, play_of(small("abd"), SETTING)) == pytest.approx(1 / 3)
    assert distance(one, play_of(small("edd"[:2] + "a"), SETTING)) == pytest.approx(1)
    turned = Setting(SMALL_DECK, small("abc", turn=1).start)
    assert distance(one, play_of(small("abc", turn=1), turned)) == pytest.approx(0.25)
    backwards = play_of(small("cba", cells=[2, 1, 0]), SETTING)
    assert distance(one, backwards) == pytest.approx(2 / 4 / 3)
    assert distance(Play.begin(SETTING), Play.begin(SETTING)) == 0
