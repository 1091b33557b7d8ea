from __future__ import annotations

import pytest

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.learner import elsewhere, learn
from maestra.learning.fewshot.prior import rule_bits
from maestra.learning.fewshot.slips import wrong_move
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.rule import Rule, holds
from maestra.rules.setting import Setting, play_of
from maestra.rules.token_tests import has
from tests.learning.fewshot_plays import shown, start

RISING = Ordered("value", Direction.RISING)
FALLING = Ordered("value", Direction.FALLING)
ODD_ROW = (0, 1, 6, 7, 9)


def test_rising_numbers_are_learned_from_three_plays() -> None:
    lesson = learn([shown((0, 2, 5, 7, 8)), shown((1, 3, 4, 6, 9), 2), shown((2, 3, 6, 8, 9), 5)])
    assert lesson.rules == (FullRow(), RISING)
    assert lesson.confidence > 0.5
    assert lesson.slips == ()


def test_odd_and_rising_is_learned_from_two_starts() -> None:
    lesson = learn([shown(ODD_ROW), shown(ODD_ROW, 4), shown(ODD_ROW, 7)])
    assert set(lesson.rules) >= {RISING, EveryToken(has("odd", "value"))}
    assert lesson.status is LearnStatus.LEARNED
    assert len(lesson.confidences) == len(lesson.rules)


def test_one_play_leaves_it_ambiguous() -> None:
    lesson = learn([shown((0, 2, 5, 7, 8))])
    assert lesson.status is LearnStatus.AMBIGUOUS
    assert lesson.alternatives


def test_any_rows_are_outside() -> None:
    lesson = learn([shown((3, 0, 9, 2, 7)), shown((5, 8, 1, 6, 2), 3)])
    assert lesson.status is LearnStatus.OUTSIDE


def test_the_same_layout_counts_once() -> None:
    once = learn([shown((0, 2, 5, 7, 8))])
    twice = learn([shown((0, 2, 5, 7, 8))] * 2)
    assert twice.belief.classes[0].bits < once.belief.classes[0].bits + 6
    assert twice.status is not LearnStatus.LEARNED


def test_every_demonstration_is_right_by_the_rules_learned() -> None:
    plays = [shown((0, 2, 5, 7, 8)), shown((1, 3, 4, 6, 9), 2)]
    lesson = learn(plays)
    assert all(holds(rule, play_of(play)) for rule in lesson.rules for play in plays)
    assert all(holds(rule, play_of(play)) for rule in lesson.safe for play in plays)


def test_right_to_left_is_noticed() -> None:
    order = (4, 3, 2, 1, 0)
    plays = [shown((0, 2, 5, 7, 8), order=order), shown((1, 3, 4, 6, 9), 2, order)]
    belief = learn(plays).belief
    assert dict(belief.filling)[Filling.RIGHT_TO_LEFT] > 0.2


def test_left_to_right_alone_is_no_rule() -> None:
    lesson = learn([shown((0, 2, 5, 7, 8)), shown((1, 3, 4, 6, 9), 2)])
    assert lesson.belief.filling[0][0] is None


def test_ends_first_becomes_a_rule() -> None:
    plays = [
        shown((0, 2, 5, 7, 8), order=(0, 4, 1, 3, 2)),
        shown((1, 3, 4, 6, 9), 2, (4, 0, 1, 3, 2)),
    ]
    assert FillOrder(Filling.ENDS_FIRST) in learn(plays).rules


def test_a_slip_is_pointed_out_with_its_move() -> None:
    plays = [
        shown((0, 2, 5, 7, 8)),
        shown((1, 3, 4, 6, 9), 2),
        shown((2, 3, 6, 7, 9), 5),
        shown((0, 1, 4, 5, 6), 1),
        shown((1, 2, 4, 6, 5), 3),
    ]
    lesson = learn(plays)
    assert RISING in lesson.rules
    assert [slip.demonstration for slip in lesson.slips] == [4]
    assert lesson.slips[0].move in (3, 4)


def test_answers_move_the_belief() -> None:
    shown_ = [shown((0, 2, 5, 7, 8))]
    play = play_of(shown((1, 2, 3, 4, 5)))
    wrong = play_of(shown((5, 4, 3, 2, 1)))
    before = learn(shown_)
    after = learn(
        shown_,
        [
            Answer(RowQuestion(play), Reply.YES),
            Answer(RowQuestion(wrong), Reply.NO),
            Answer(RowQuestion(wrong), Reply.UNSURE),
            Answer(RuleQuestion(RISING), Reply.YES),
            Answer(RuleQuestion(FALLING), Reply.NO),
            Answer(RuleQuestion(FillOrder(Filling.RIGHT_TO_LEFT)), Reply.NO),
            Answer(RuleQuestion(FillOrder(Filling.LEFT_TO_RIGHT)), Reply.UNSURE),
        ],
    )
    assert after.confidence > before.confidence
    assert after.rules == (FullRow(), RISING)


def test_a_move_that_is_right_leaves_only_rules_that_allow_it() -> None:
    position = play_of(shown((9, 1, 2, 3, 4))).setting
    begin = play_of(shown((9, 1, 2, 3, 4)).until(0), position)
    answers = [Answer(MoveQuestion(begin, token, 0), Reply.YES) for token in (7, 8, 9)]
    lesson = learn([shown((0, 2, 5, 7, 8))], answers)
    assert RISING not in lesson.rules


def test_contradicting_answers_are_not_resolved_silently() -> None:
    shown_ = [shown((0, 2, 5, 7, 8)), shown((1, 3, 4, 6, 9), 2)]
    row = RowQuestion(play_of(shown((1, 2, 3, 4, 5))))
    lesson = learn(shown_, [Answer(row, Reply.YES), Answer(row, Reply.NO)])
    assert lesson.status is LearnStatus.CONTRADICTORY


def test_nothing_shown_is_refused() -> None:
    with pytest.raises(ValueError, match="no demonstration"):
        learn([])


def test_as_many_as_there_are_is_learned_with_gaps() -> None:
    lesson = learn([shown((2, 4, 5)), shown((5, 2, 4), 3), shown((4, 5, 2), 6)])
    assert FullRow() not in lesson.rules


def test_a_large_board_is_sampled() -> None:
    deck = Deck(
        tuple(
            Token(TokenId(f"t{k:02}"), (("value", 7 * k % 40), ("colour", "rgb"[k % 3])))
            for k in range(20)
        )
    )
    board = Board(5, 8)
    ranked = sorted(range(20), key=lambda k: 7 * k % 40)
    plays = [
        shown(ranked[:8], 0, deck=deck, board=board),
        shown(ranked[2:18:2], 1, deck=deck, board=board),
        shown(ranked[4:20:2], 1, deck=deck, board=board),
    ]
    answer = Answer(
        RowQuestion(play_of(shown(ranked[9:17], 5, deck=deck, board=board))), Reply.YES
    )
    lesson = learn(plays, [answer], seed=3)
    assert Ordered("value", Direction.RISING) in lesson.rules
    size = lesson.belief.contexts[0].rows.size
    assert size == pytest.approx(20 * 19 * 18 * 17 * 16 * 15 * 14 * 13, rel=0.2)


def test_another_start_moves_the_tokens() -> None:
    setting = Setting(shown(ODD_ROW).deck, start())
    other = elsewhere(setting)
    assert other.start != setting.start
    assert other.movable == setting.movable


def test_a_given_row_costs_its_place_among_all_rows() -> None:
    setting = play_of(shown(ODD_ROW)).setting
    row = given_row("letter", tuple("CURIE"))
    assert 15 < rule_bits(row, setting) < 25


def test_the_wrong_move_is_the_one_that_changed_makes_it_right() -> None:
    rules: tuple[Rule, ...] = (EveryToken(has("odd", "value")),)
    assert wrong_move(rules, play_of(shown((0, 1, 2, 7, 9)))) == 2
    assert wrong_move((RISING,), play_of(shown((9, 8, 7, 6, 5)))) == 1
    swapped = (given_row("letter", tuple("CURIE")),)
    assert wrong_move(swapped, play_of(shown((0, 2, 1, 3, 4)))) == 2
    assert wrong_move((given_row("letter", ("Z",) * 5),), play_of(shown(ODD_ROW).until(0))) == -1
