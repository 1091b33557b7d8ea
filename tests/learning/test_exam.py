"""The exam: which plays are judged, and what the judgement says about all of them."""

from itertools import pairwise
from math import comb

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.learning.drawn_plays import Drawer
from maestra.learning.exam import ExamPlay, exam_plays, most_wrong, objections, result
from maestra.rules.answers import Answer, Reply, RowQuestion
from maestra.rules.exercise import Evidence, Exam, LearnStatus, RuledExercise, meant_rules
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.paper import BOARD, NUMBER_DECK
from maestra.rules.rule import Rule
from maestra.rules.setting import play_of
from maestra.rules.token_tests import has
from tests.learning.caregivers import SMALL_BOARD, SMALL_DECK, small

RISING = Ordered("value", Direction.RISING, strict=True)
RED = EveryToken(has("is-red", "colour"))


def told(*rules: Rule, shown: tuple[str, ...] = ()) -> RuledExercise:
    return RuledExercise(
        SMALL_BOARD,
        SMALL_DECK,
        meant_rules(rules, [1.0] * len(rules)),
        1.0,
        LearnStatus.TOLD,
        rules,
        evidence=Evidence(tuple(small(tokens) for tokens in shown)),
    )


def ascending_on_the_papers_board() -> RuledExercise:
    rules = (FullRow(), RISING)
    meant = meant_rules(rules, [1.0, 1.0])
    return RuledExercise(BOARD, NUMBER_DECK, meant, 1.0, LearnStatus.TOLD, rules)


@pytest.mark.parametrize("seed", range(3))
def test_as_many_right_plays_as_near_misses_are_shown(seed: int) -> None:
    exercise = ascending_on_the_papers_board()
    plays = exam_plays(exercise, 10, seed)
    right = [one.play for one in plays if one.is_right]
    wrong = [one.play for one in plays if not one.is_right]
    assert (len(set(right)), len(set(wrong))) == (10, 10)
    for play in right:
        assert all(rule.holds(play) for rule in exercise.conjunction)
    for play in wrong:
        drawer = Drawer(exercise.conjunction, play.setting)
        assert drawer.refusals(play) == 1
        assert drawer.broken(play) == {1}


def test_right_plays_and_near_misses_are_mixed() -> None:
    order = [one.is_right for one in exam_plays(ascending_on_the_papers_board(), 10, 0)]
    changes = sum(one is not other for one, other in pairwise(order))
    assert changes > 4


def test_the_same_seed_shows_the_same_plays_and_another_one_others() -> None:
    exercise = told(FullRow(), RISING)
    assert exam_plays(exercise, 3, 1) == exam_plays(exercise, 3, 1) != exam_plays(exercise, 3, 2)


def test_what_was_shown_is_not_shown_back_while_there_is_something_else() -> None:
    exercise = told(FullRow(), RISING, shown=("abc", "abd"))
    rows = {play_of(one).row for one in exercise.evidence.demonstrations}
    plays = exam_plays(exercise, 2, 0)
    assert rows.isdisjoint(one.play.row for one in plays if one.is_right)


def test_each_rule_is_broken_by_some_near_miss() -> None:
    exercise = told(FullRow(), RED, RISING)
    plays = exam_plays(exercise, 4, 0)
    broken = [
        Drawer(exercise.conjunction, one.play.setting).broken(one.play)
        for one in plays
        if not one.is_right
    ]
    assert {frozenset({1}), frozenset({2})} <= set(broken)


def test_one_right_row_is_shown_from_many_starts() -> None:
    plays = [one.play for one in exam_plays(told(FullRow(), RED, RISING), 4, 0) if one.is_right]
    assert len({play.row for play in plays}) == 1
    assert len({play.setting for play in plays}) == 4


def test_where_everything_is_right_there_are_no_near_misses() -> None:
    plays = exam_plays(told(FullRow()), 3, 0)
    assert [one.is_right for one in plays] == [True] * 3


def test_where_nothing_is_right_there_is_no_exam() -> None:
    assert exam_plays(told(FullRow(), EveryToken(has("is-blue", "colour"))), 3, 0) == ()


def test_where_only_one_play_is_right_it_is_shown_once() -> None:
    nothing = EveryToken(has("is-green", "colour"))
    plays = exam_plays(told(nothing), 2, 0)
    assert [one.play.placed for one in plays if one.is_right] == [(), ()]


ROW = play_of(small("abc"))
RIGHT, WRONG = ExamPlay(ROW, is_right=True), ExamPlay(ROW, is_right=False)
JUDGED = (
    (RIGHT, Reply.YES),
    (RIGHT, Reply.YES),
    (RIGHT, Reply.NO),
    (RIGHT, Reply.UNSURE),
    (WRONG, Reply.NO),
    (WRONG, Reply.YES),
    (WRONG, Reply.UNSURE),
)


def test_what_the_caregiver_was_unsure_of_does_not_count() -> None:
    assert result(JUDGED, "2026-11-22") == Exam("2026-11-22", 3, 2, 2, 1)


def test_what_was_judged_otherwise_goes_back_to_learning() -> None:
    question = RowQuestion(ROW)
    expected = (Answer(question, Reply.NO), Answer(question, Reply.YES))
    assert objections(JUDGED) == expected


def test_ten_of_ten_leaves_less_than_26_percent() -> None:
    assert most_wrong(10, 10) == pytest.approx(1 - 0.05 ** (1 / 10))


@given(st.integers(1, 30), st.data())
def test_the_bound_is_where_so_few_mistakes_come_up_in_5_percent(
    plays: int, data: st.DataObject
) -> None:
    wrong = data.draw(st.integers(0, plays - 1))
    share = most_wrong(plays, plays - wrong)
    seldom = sum(comb(plays, k) * share**k * (1 - share) ** (plays - k) for k in range(wrong + 1))
    assert seldom == pytest.approx(0.05)
    assert wrong / plays < share <= most_wrong(plays, plays - wrong - 1)


@pytest.mark.parametrize("plays", [0, 7])
def test_without_any_agreement_anything_may_be_wrong(plays: int) -> None:
    assert most_wrong(plays, 0) == 1.0
