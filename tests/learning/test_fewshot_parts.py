from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from itertools import permutations

import numpy as np
import pytest

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.hypotheses import as_number, surviving
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.prior import kind_of, surcharge
from maestra.learning.fewshot.questions import (
    QuestionKind,
    information,
    next_question,
    update,
)
from maestra.learning.fewshot.sampled import sampled
from maestra.learning.fewshot.space import (
    Context,
    how_many,
    looks_at_start,
    pack,
    rows_of,
    same_tokens,
    size_of,
    unpack,
)
from maestra.learning.fewshot.token_tests import MAX_EITHER, round_between, selecting, simple
from maestra.rules.answers import Answer, MoveQuestion, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.plays import NOBODY
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_ROW, Setting, play_of
from maestra.rules.token_tests import Among, Both, Compared, Comparison, Either, Extreme, Not, has
from tests.learning.fewshot_plays import DECK, shown, start

ODD = has("odd", "value")
FIRST_ROW = has("is-1", ORIGIN_ROW)


def small(given: bool = False) -> Setting:  # noqa: FBT001, FBT002 - a fixture's switch
    """Six tokens and three goal cells; perhaps one of them lies there already."""
    deck = Deck(DECK.tokens[:6], relations={"partner": frozenset({("a", "b")})}, lexicon=("CUR",))
    board = Board(4, 3)
    cells = [*board.storage_cells]
    placed = {t.id: cells[(5 * k) % 9] for k, t in enumerate(deck.tokens)}
    if given:
        placed[deck.tokens[0].id] = board.goal_cells[1]
    return Setting(deck, State(board, placed))


@pytest.mark.parametrize("full", [True, False])
@pytest.mark.parametrize("given", [True, False])
def test_rows_are_as_many_as_counted_and_all_different(given: bool, full: bool) -> None:  # noqa: FBT001 - pytest's way
    setting = small(given)
    rows = rows_of(setting, full=full)
    assert len(rows.row) == how_many(setting, full=full) == rows.size
    assert len(np.unique(rows.row, axis=0)) == len(rows.row)


@pytest.mark.parametrize("full", [True, False])
@pytest.mark.parametrize("given", [True, False])
def test_fast_truth_is_the_rules_own(given: bool, full: bool) -> None:  # noqa: FBT001 - pytest's way
    setting = small(given)
    rows = rows_of(setting, full=full)
    plays = [play_of(shown((0, 2, 4), deck=setting.deck, board=Board(4, 3)))]
    for order in ((0, 1, 2), (2, 0, 1)):
        context = Context(setting, order, rows)
        for one in surviving(plays, timed=True):
            assert (context.truth(one.rule) == one.rule.mask(context.plays)).all(), one.rule


def test_packing_loses_nothing() -> None:
    truth = np.arange(200) % 3 == 0
    rows = rows_of(small(), full=True)
    assert (unpack(pack(truth), 200) == truth).all()
    assert size_of(pack(np.ones(len(rows.row), np.bool_)), rows) == len(rows.row)


def test_sampled_rows_stand_for_all_rows() -> None:
    setting = Setting(DECK, start())
    rows = rows_of(setting, full=True)
    rules: list[Rule] = [Ordered("value"), EveryToken(ODD), EveryToken(has("is-red", "colour"))]
    for full in (True, False):
        exact = rows_of(setting, full=full)
        drawn = sampled(setting, rules, [rows.row[0]], full=full, seed=1)
        assert drawn.size == pytest.approx(exact.size, rel=0.15)
        for rule in rules:
            wanted = Context(setting, tuple(range(5)), exact).truth(rule).sum()
            found = pack(Context(setting, tuple(range(5)), drawn).truth(rule))
            assert size_of(found, drawn) == pytest.approx(wanted, rel=0.3)


def test_a_given_token_stays_in_sampled_rows() -> None:
    setting = small(given=True)
    drawn = sampled(
        setting, [Ordered("value")], [rows_of(setting, full=True).row[0]], full=True, seed=0
    )
    assert (drawn.row[:, 1] == 0).all()
    assert drawn.some(3) is drawn
    assert drawn.word_weight is not None
    assert (drawn.row != NOBODY).all()


def test_what_looks_at_the_start_is_told() -> None:
    tests = (
        FIRST_ROW,
        Compared(ORIGIN_ROW, Comparison.LESS, 2),
        Among(ORIGIN_ROW, Extreme.LOWEST),
        Not(FIRST_ROW),
        Either(ODD, FIRST_ROW),
        Both(FIRST_ROW, ODD),
    )
    assert all(looks_at_start(EveryToken(test)) for test in tests)
    assert looks_at_start(Ordered(ORIGIN_ROW))
    assert not looks_at_start(EveryToken(Either(ODD, Among("value", Extreme.LOWEST))))


def test_starts_with_other_tokens_are_not_the_same() -> None:
    assert same_tokens([small(), small()])
    assert not same_tokens([small(), small(given=True)])


def test_people_say_round_numbers() -> None:
    assert round_between(19, 23) == (20, 20)
    assert round_between(46, 51)[0] == 50
    assert round_between(Decimal("0.2"), Decimal("0.7")) == (Decimal("0.7"), Decimal("0.7"))


def test_a_third_cannot_be_written() -> None:
    assert as_number(Fraction(1, 3)) is None
    assert as_number(Fraction(1, 2)) is not None
    assert as_number(4) == 4


def test_every_rule_has_a_kind_and_a_cost() -> None:
    setting = play_of(shown((0, 1, 2, 3, 4))).setting
    for one in surviving([play_of(shown((0, 1, 2, 3, 4)))], timed=True):
        assert kind_of(one.rule)[0] is type(one.rule)
        assert surcharge(one.rule, setting) >= 0
        assert one.bits > 0


def test_decks_with_orders_cycles_and_words_suggest_rules_about_them() -> None:
    days, sizes = ("Mon", "Tue", "Wed", "Thu"), ("small", "large")
    deck = Deck(
        tuple(
            Token(
                TokenId(f"t{k}"),
                (
                    ("day", days[k % 4]),
                    ("size", sizes[k % 2]),
                    ("name", "ab"[k % 2]),
                    ("letter", "CURCUR"[k]),
                    ("kind", "ab"[k // 3]),
                ),
            )
            for k in range(6)
        ),
        {"size": sizes},
        {"day": days},
        {"partner": frozenset({("a", "b")})},
        ("CUR",),
    )
    play = play_of(shown((0, 1, 2), deck=deck, board=Board(4, 3)))
    found = {type(one.rule).__name__ for one in surviving([play], timed=True)}
    assert {"CyclicOrdered", "Word", "EachPair", "Cue", "Compare"} - found == {"Compare"}


def test_answers_of_even_odds_tell_most() -> None:
    worth = information(np.array([0.0, 0.5, 1.0]))
    assert worth[1] > 0.7
    assert worth[0] == pytest.approx(0, abs=1e-9)
    assert worth[2] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("kind", list(QuestionKind))
def test_only_the_wanted_kinds_are_asked(kind: QuestionKind) -> None:
    lesson = learn([shown((0, 2, 5, 7, 8))])
    question = next_question(lesson, {kind})
    assert isinstance(
        question,
        {
            QuestionKind.ROW: RowQuestion,
            QuestionKind.MOVE: MoveQuestion,
            QuestionKind.RULE: RuleQuestion,
        }[kind],
    )


def test_questions_lead_to_rising_numbers() -> None:
    rule = Ordered("value")
    lesson = learn([shown((0, 2, 5, 7, 8))])
    asked = 0
    while (question := next_question(lesson, {QuestionKind.ROW})) is not None and asked < 5:
        assert isinstance(question, RowQuestion)
        assert question not in {answer.question for answer in lesson.answers}
        lesson = update(lesson, question, Reply.YES if rule.holds(question.play) else Reply.NO)
        asked += 1
    assert rule in lesson.rules


def test_who_is_sure_asks_nothing() -> None:
    row = (0, 1, 6, 7, 9)
    lesson = learn([shown(row), shown(row, 4), shown(row, 7)])
    assert next_question(lesson) is None


def test_a_filling_that_was_answered_both_ways_stays_open() -> None:
    right = FillOrder(Filling.RIGHT_TO_LEFT)
    orders = [(4, 3, 2, 1, 0)] * 2
    plays = [shown((0, 2, 5, 7, 8), 0, orders[0]), shown((1, 3, 4, 6, 9), 2, orders[1])]
    yes = learn(plays, [Answer(RuleQuestion(right), Reply.YES)])
    assert right in yes.rules


def test_permutations_of_a_row_are_all_there() -> None:
    rows = {tuple(int(t) for t in row) for row in rows_of(small(), full=True).row}
    assert rows == set(permutations(range(6), 3))


def test_a_pattern_that_ends_early_leaves_the_rest_free() -> None:
    setting = small()
    context = Context(setting, (0, 1, 2), rows_of(setting, full=True))
    rule = Pattern((ODD,))
    assert (context.truth(rule) == rule.mask(context.plays)).all()


def test_of_many_values_no_two_are_paired_by_or() -> None:
    tokens = [Token(TokenId(f"t{k:03}"), (("name", f"n{k // 2}"),)) for k in range(100)]
    setting = Setting(Deck(tuple(tokens)), start(0, Deck(tuple(tokens)), Board(12, 10)))
    basic = simple(setting)
    assert len(basic) > MAX_EITHER
    assert not any(isinstance(test, Either) for test in selecting(setting, basic))


def test_an_unsure_answer_is_not_asked_for_again() -> None:
    lesson = learn([shown((0, 2, 5, 7, 8))])
    first = next_question(lesson, {QuestionKind.ROW})
    assert first is not None
    again = next_question(update(lesson, first, Reply.UNSURE), {QuestionKind.ROW})
    assert again is not None
    assert again != first


def test_rows_with_gaps_are_asked_about() -> None:
    lesson = learn([shown((2, 4, 5)), shown((4, 6, 8), 3)])
    asked = lesson
    for _ in range(3):
        question = next_question(asked, {QuestionKind.ROW})
        assert isinstance(question, RowQuestion)
        asked = update(asked, question, Reply.YES)


def test_where_nothing_can_differ_nothing_is_learned() -> None:
    deck = Deck((Token(TokenId("a"), ()),))
    lesson = learn([shown((0,), deck=deck, board=Board(2, 1))])
    assert lesson.status is LearnStatus.OUTSIDE
    assert next_question(lesson) is None


def test_two_tokens_leave_little_to_say() -> None:
    deck = Deck(DECK.tokens[:2])
    lesson = learn([shown((0, 1), deck=deck, board=Board(2, 2))])
    assert lesson.belief.classes


def test_as_many_tokens_as_seven_are_moved_elsewhere() -> None:
    deck = Deck(DECK.tokens[:7])
    lesson = learn([shown((0, 1, 2), deck=deck, board=Board(5, 3))])
    assert lesson.belief.contexts[-1].setting.start != lesson.belief.contexts[0].setting.start
