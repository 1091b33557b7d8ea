"""Rows of tokens, listed and drawn, and which of them a rule allows."""

from __future__ import annotations

from decimal import Decimal
from itertools import permutations
from random import Random

import numpy as np
import pytest

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.evidence import Evidence
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.proposals import proposed
from maestra.learning.fewshot.questions import next_question
from maestra.learning.fewshot.sampled import sampled
from maestra.learning.fewshot.space import (
    Context,
    how_many,
    looks_at_start,
    pack,
    row_number,
    rows_of,
    same_tokens,
    size_of,
    unpack,
)
from maestra.learning.fewshot.token_tests import round_between
from maestra.learning.fewshot.truths import Truths
from maestra.rules.answers import Answer, Reply, RowQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.base import Direction
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern, given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.plays import NOBODY
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_ROW, Setting, play_of
from maestra.rules.token_tests import Among, Both, Compared, Comparison, Either, Extreme, Not, has
from tests.learning.fewshot_plays import DECK, placed, rich, shown, small, start

ODD = has("odd", "value")
FIRST_ROW = has("is-1", ORIGIN_ROW)
RISING = Ordered("value", Direction.RISING)
GIVEN_AND_FULL = [(given, full) for given in (True, False) for full in (True, False)]


# ------------------------------------------------------------------ listed
@pytest.mark.parametrize(("given", "full"), GIVEN_AND_FULL)
def test_rows_are_as_many_as_can_be_played_and_all_different(*, given: bool, full: bool) -> None:
    setting = small(given=given)
    rows = rows_of(setting, (0, 1, 2), full=full)
    assert len(np.unique(rows.row, axis=0)) == len(rows.row) == rows.size
    if full:
        assert len(rows.row) == how_many(setting, full=True)
    assert len(rows.row) <= how_many(setting, full=full)


def test_full_rows_are_all_arrangements() -> None:
    rows = rows_of(small(), (0, 1, 2), full=True)
    assert {tuple(map(int, row)) for row in rows.row} == set(permutations(range(6), 3))


def test_rows_with_gaps_were_filled_in_order() -> None:
    rows = rows_of(small(), (2, 0, 1), full=False).row
    shapes = {tuple(map(bool, row != NOBODY)) for row in rows}
    assert shapes == {
        (False, False, False),
        (False, False, True),
        (True, False, True),
        (True, True, True),
    }


@pytest.mark.parametrize(("given", "full"), GIVEN_AND_FULL)
def test_the_fast_truth_is_the_rules_own(*, given: bool, full: bool) -> None:
    setting = small(given=given)
    token = 1 if given else 0
    play = placed(setting, (2, 0, 4) if not given else (2, NOBODY, 4), (0, 2) if given else None)
    for order in ((0, 1, 2), (2, token, 1 - token)):
        context = Context(setting, order, rows_of(setting, order, full=full))
        for one, _ in proposed([play], timed=True):
            for rule in one.rules:
                assert (context.truth(rule) == rule.mask(context.plays)).all(), rule


def test_the_fast_truth_is_the_rules_own_on_a_deck_of_everything() -> None:
    play = play_of(rich((0, 1, 3)))
    context = Context(play.setting, (2, 0, 1), rows_of(play.setting, (2, 0, 1), full=True))
    for one, _ in proposed([play], timed=True):
        for rule in one.rules:
            assert (context.truth(rule) == rule.mask(context.plays)).all(), rule


def test_packing_loses_nothing() -> None:
    truth = np.arange(200) % 3 == 0
    rows = rows_of(small(), (0, 1, 2), full=True)
    assert (unpack(pack(truth), 200) == truth).all()
    assert size_of(rows.everything, rows) == rows.size == 120


def test_a_play_is_found_among_the_rows() -> None:
    setting = small()
    rows = rows_of(setting, (0, 1, 2), full=True)
    assert rows.row[row_number(rows, placed(setting, (4, 0, 3)))].tolist() == [4, 0, 3]


def test_some_rows_are_spread_over_all_and_the_same_each_time() -> None:
    rows = rows_of(Setting(DECK, start()), tuple(range(5)), full=True)
    some = rows.some(2048)
    assert some is rows.some(2048)
    assert 1900 < len(some.row) <= 2048
    firsts = np.bincount(some.row[:, 0])
    assert firsts.min() > 0.8 * firsts.mean()


# ------------------------------------------------------------------ drawn
@pytest.mark.parametrize("full", [True, False])
def test_drawn_rows_stand_for_all_rows_within_the_stated_error(*, full: bool) -> None:
    setting = Setting(DECK, start())
    order = tuple(range(5))
    exact = rows_of(setting, order, full=full)
    rules: list[Rule] = [
        RISING,
        EveryToken(ODD),
        EveryToken(has("is-red", "colour")),
        given_row("value", (19, 23, 32, 34, 36)),
    ]
    drawn = sampled(setting, rules, [exact.row[0]], full=full, seed=1)
    if full:
        assert drawn.size == pytest.approx(exact.size, rel=0.05)
    for rule in rules[:3]:
        wanted = Context(setting, order, exact).truth(rule).sum()
        found = size_of(pack(Context(setting, order, drawn).truth(rule)), drawn)
        assert full is False or found == pytest.approx(wanted, rel=0.15)
    for row in (exact.row[0],):
        assert (drawn.row == row).all(axis=1).any()


def test_a_given_token_stays_in_drawn_rows() -> None:
    setting = small(given=True)
    order = (0, 1, 2)
    drawn = sampled(
        setting, [RISING], [rows_of(setting, order, full=True).row[0]], full=True, seed=0
    )
    assert (drawn.row[:, 1] == 0).all()
    assert drawn.some(3) is drawn
    assert drawn.word_weight is not None
    assert (drawn.row != NOBODY).all()


def test_only_the_seed_decides_what_is_drawn() -> None:
    setting = Setting(DECK, start())
    first = np.arange(5, dtype=np.intp)
    draws = [sampled(setting, [RISING], [first], full=True, seed=s).row for s in (1, 1, 2)]
    assert np.array_equal(draws[0], draws[1])
    assert not np.array_equal(draws[0], draws[2])


def big(tokens: int) -> Deck:
    """Numbers and three colours."""
    return Deck(
        tuple(
            Token(TokenId(f"t{k:03}"), (("value", 5 * k + k * k % 4), ("colour", "rgb"[k % 3])))
            for k in range(tokens)
        )
    )


@pytest.mark.parametrize(
    ("tokens", "board"), [(20, Board(5, 8)), (100, Board(20, 10))], ids=["20 tokens", "100 tokens"]
)
def test_boards_too_large_to_list_are_learned_on(tokens: int, board: Board) -> None:
    deck = big(tokens)
    rng = Random(1)  # noqa: S311 - what is drawn is no secret
    rows = [sorted(rng.sample(range(tokens), board.columns)) for _ in range(4)]
    plays = [shown(row, k, deck=deck, board=board) for k, row in enumerate(rows)]
    answer = Answer(RowQuestion(play_of(plays[3])), Reply.YES)
    lesson = learn(plays[:2], [answer], seed=3)
    assert RISING in lesson.rules
    rows_ = lesson.belief.contexts[0].rows
    assert rows_.size == pytest.approx(
        how_many(lesson.belief.plays[0].setting, full=True), rel=0.2
    )
    if lesson.status is LearnStatus.AMBIGUOUS:
        assert next_question(lesson) is not None


def test_rows_from_one_start_are_drawn_once() -> None:
    plays = [
        shown(tokens, 0, order, big(20), Board(5, 8))
        for tokens, order in ((range(8), range(8)), (range(1, 9), range(7, -1, -1)))
    ]
    one, other, elsewhere = Evidence(tuple(plays), (), 0).contexts
    assert one.order != other.order
    assert one.rows is other.rows is not elsewhere.rows


# ------------------------------------------------------------------ starts
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
    assert looks_at_start(StraightUp())
    assert not looks_at_start(EveryToken(Either(ODD, Among("value", Extreme.LOWEST))))
    assert not looks_at_start(Pattern((ODD,)))


def test_starts_with_other_tokens_are_not_the_same() -> None:
    assert same_tokens([small(), small()])
    assert not same_tokens([small(), small(given=True)])


def test_what_one_start_says_serves_another_where_it_cannot_differ() -> None:
    belief = learn([shown((0, 2, 5, 7, 8)), shown((1, 3, 4, 6, 9), 2)]).belief
    truths: Truths = belief.truths
    for part, survivor in enumerate(truths.survivors[::9]):
        for context, where in enumerate(belief.contexts):
            whole = np.logical_and.reduce([where.truth(rule) for rule in survivor.rules])
            assert np.array_equal(truths.of(9 * part, context), pack(whole))


# ------------------------------------------------------------------ numbers people say
def test_people_say_round_numbers() -> None:
    assert round_between(19, 23) == (20, 20)
    assert round_between(46, 51)[0] == 50
    assert round_between(Decimal("0.2"), Decimal("0.7")) == (Decimal("0.7"), Decimal("0.7"))
