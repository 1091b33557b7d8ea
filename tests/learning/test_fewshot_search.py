"""The search finds what scoring every conjunction one by one finds."""

from __future__ import annotations

from itertools import combinations
from math import inf, log2

import numpy as np
import pytest

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck
from maestra.learning.fewshot.evidence import Evidence
from maestra.learning.fewshot.posterior import WITHIN, Search
from maestra.learning.fewshot.prior import FREE_BITS, SLIP, TRUST, and_bits
from maestra.learning.fewshot.proposals import Survivor
from maestra.learning.fewshot.truths import SAMPLE, Truths
from maestra.rules.answers import Answer, Reply, RowQuestion
from maestra.rules.plays import Plays
from maestra.rules.setting import play_of
from tests.learning.fewshot_plays import DECK, SMALL_BOARD, shown

SMALL = Deck(DECK.tokens[:6])
LARGER, WIDE = Deck(DECK.tokens[:8]), Board(4, 5)


def evidence_of(*plays: Demonstration, answers: tuple[Answer, ...] = ()) -> Evidence:
    return Evidence(plays, answers, 0)


def on_small(*rows: tuple[int, ...]) -> tuple[Demonstration, ...]:
    return tuple(shown(row, k, deck=SMALL, board=SMALL_BOARD) for k, row in enumerate(rows))


def on_larger(*rows: tuple[int, ...]) -> tuple[Demonstration, ...]:
    return tuple(shown(row, k, deck=LARGER, board=WIDE) for k, row in enumerate(rows))


def search_of(evidence: Evidence) -> Search:
    truths = Truths(evidence.survivors, evidence.contexts)
    return Search(truths, evidence.layouts, evidence.answered)


def scored_one_by_one(evidence: Evidence) -> dict[tuple[int, ...], float]:
    """The score of every conjunction of at most two proposals, from the definitions."""
    whole = [k for k, one in enumerate(evidence.survivors) if not one.broken]
    plays = [evidence.plays[k] for k in evidence.distinct]
    truths: list[np.ndarray] = []
    for play in plays:
        context = next(c for c in evidence.contexts if c.setting == play.setting)
        rows = Plays.layouts(play.setting, context.rows.row, context.order)
        truths.append(np.array([allowed(evidence.survivors[k], rows) for k in whole], np.bool_))
    scores: dict[tuple[int, ...], float] = {
        (): FREE_BITS + sum(log2(truth.shape[1]) for truth in truths)
    }
    for a, b in [*((k, k) for k in range(len(whole))), *combinations(range(len(whole)), 2)]:
        parts = sorted({a, b})
        own = [evidence.survivors[whole[k]] for k in parts]
        both = [truth[a] & truth[b] for truth in truths]
        idle = a != b and any(
            all((t[k] == together).all() for t, together in zip(truths, both, strict=True))
            for k in parts
        )
        if not idle:
            prior = sum(one.bits for one in own) + and_bits([one.added for one in own])
            likely = sum(log2(together.sum()) for together in both)
            scores[tuple(whole[k] for k in parts)] = prior + likely
    return scores


def allowed(one: Survivor, rows: Plays) -> np.ndarray:
    return np.asarray(np.logical_and.reduce([rule.mask(rows) for rule in one.rules]))


@pytest.mark.parametrize(
    "plays",
    [
        on_small((0, 2, 4)),
        on_small((0, 2, 4), (1, 2, 5)),
        on_small((5, 0, 3), (1, 4, 2)),
        on_larger((0, 2, 4, 5, 7), (1, 2, 3, 5, 6)),
    ],
    ids=["one", "two", "no order", "sampled"],
)
def test_the_search_finds_the_best_of_all_conjunctions(plays: tuple[Demonstration, ...]) -> None:
    evidence = evidence_of(*plays)
    exact = scored_one_by_one(evidence)
    found = {one.parts: one.bits for one in search_of(evidence).best() if one.slip is None}
    for parts, bits in found.items():
        if len(parts) <= 2 and parts in exact:
            assert bits == pytest.approx(exact[parts])
    best = sorted(exact, key=exact.__getitem__)
    # What the sample does not show may be missing further down.
    sampled = evidence.contexts[0].rows.size > SAMPLE
    assert set(best[: 5 if sampled else 12]) <= set(found)
    assert min(found.values()) <= exact[best[0]] + 1e-9


def test_nothing_found_is_much_worse_than_the_best() -> None:
    bits = [one.bits for one in search_of(evidence_of(*on_small((0, 2, 4), (1, 2, 5)))).best()]
    assert bits == sorted(bits)
    assert bits[-1] <= bits[0] + WITHIN
    assert inf not in bits


def test_who_takes_one_for_a_slip_pays_for_it() -> None:
    evidence = evidence_of(
        *on_larger((0, 2, 4, 5, 7), (1, 2, 3, 5, 6), (0, 1, 3, 4, 6), (0, 3, 2, 5, 7))
    )
    found = search_of(evidence).best()
    slips = [one for one in found if one.slip is not None]
    assert {one.slip for one in slips} == {3}
    survivors = evidence.survivors
    for one in slips:
        assert any(survivors[part].broken for part in one.parts)
        prior = sum(survivors[part].bits for part in one.parts)
        assert one.bits > prior - log2(SLIP)


def test_answers_count_as_often_as_they_are_meant() -> None:
    plays = on_small((0, 2, 4))
    right = play_of(shown((1, 2, 3), deck=SMALL, board=SMALL_BOARD))
    before = {one.parts: one.bits for one in search_of(evidence_of(*plays)).best()}
    answers = (Answer(RowQuestion(right), Reply.YES),)
    evidence = evidence_of(*plays, answers=answers)
    search = search_of(evidence)
    for one in search.best():
        if one.parts in before:
            says = (search.truths.of_all(one.parts, 0) & evidence.answered[0].rows).any()
            cost = -log2(TRUST if says else 1 - TRUST)
            assert one.bits == pytest.approx(before[one.parts] + cost)


def test_without_proposals_any_row_is_right() -> None:
    evidence = evidence_of(*on_small((0, 2, 4)))
    search = Search(Truths((), evidence.contexts), evidence.layouts)
    assert [(one.parts, one.slip) for one in search.best()] == [((), None)]


def test_a_slip_is_not_looked_for_where_all_else_is_much_better() -> None:
    plays = on_larger((0, 2, 4, 5, 7), (1, 2, 3, 5, 6), (0, 1, 3, 4, 6), (0, 3, 2, 5, 7))
    search = search_of(evidence_of(*plays))
    assert search.explaining(3, inf) != []
    assert search.explaining(3, -1_000.0) == []
