"""Rules as actions: where these exist they allow the same plays, from any start."""

from __future__ import annotations

import random
from collections.abc import Sequence

import pytest

from maestra.core.board import Board
from maestra.core.faults import InvalidError
from maestra.core.state import State
from maestra.rules import grounding
from maestra.rules.exercise import RuledExercise
from maestra.rules.forms.base import Position as Place
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.counting import Count
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.relations import EachPair, Pairs
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, TakeExtreme, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.grounding import grounded_from
from maestra.rules.judging import Judge
from maestra.rules.pairs import Apart
from maestra.rules.position import Position
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_ROW
from maestra.rules.strips.vocabulary import Level
from maestra.rules.token_tests import Comparison, Extreme, Not, has
from tests.rules.told_exercises import FULL, ODD, RISING, deck_of, told

DECK = deck_of("value", (1, 2, 3, 5, 6))
SMALL = Board(3, 3)
LEFT = FillOrder(Filling.LEFT_TO_RIGHT)
PRIME = has("prime", "value")


def small(*rules: Rule) -> RuledExercise:
    return told(*rules, deck=DECK, board=SMALL)


SAYABLE: dict[str, tuple[Rule, ...]] = {
    "ascending": (RISING, FULL, LEFT),
    "ascending, of any length": (RISING, LEFT),
    "a given row in any order": (given_row("value", (3, 1, 6)), FULL),
    "straight up": (StraightUp(), FULL, LEFT),
    "mirrored": (StraightUp(mirrored=True), FULL, LEFT),
    "from the first row": (from_row(1), FULL, LEFT),
    "not from the first row": (EveryToken(Not(has("is-1", ORIGIN_ROW))), LEFT),
    "only odd": (ODD, FULL, LEFT),
    "steps of one": (EachPair(Pairs.NEIGHBOURS, Apart("value", 1)), FULL, LEFT),
    "even after odd": (
        IfThen(At(Place(1), has("odd", "value")), At(Place(2), has("even", "value"))),
        FULL,
        LEFT,
    ),
    "a prime only after a prime": (
        IfThen(At(Place(1), Not(PRIME)), At(Place(2), Not(PRIME))),
        FULL,
        LEFT,
    ),
    "the smallest left": (TakeExtreme("value", Extreme.LOWEST), LEFT),
}


def starts(count: int) -> Sequence[State]:
    dealer = random.Random(7)  # noqa: S311 - it deals tokens
    ids = [token.id for token in DECK.tokens]
    cells = SMALL.storage_cells
    return [
        State(SMALL, dict(zip(ids, dealer.sample(cells, 5), strict=True))) for _ in range(count)
    ]


@pytest.mark.parametrize("name", SAYABLE)
def test_the_actions_allow_the_same_plays(name: str) -> None:
    exercise = small(*SAYABLE[name])
    judges = [Judge(one, DECK) for one in (exercise, grounded_from(exercise))]
    for start in starts(4):
        todo = [Position.begin(start)]
        while todo:
            position = todo.pop()
            by_rules, by_actions = (set(judge.allowed_moves(position)) for judge in judges)
            assert by_rules == by_actions
            by_rules_over, by_actions_over = (judge.may_end(position) for judge in judges)
            assert by_rules_over == by_actions_over
            todo += [position.after(move) for move in by_rules]


def test_the_smallest_vocabulary_is_taken() -> None:
    plain = grounded_from(small(RISING, FULL, LEFT)).model.vocabulary
    assert plain.level is Level.A
    seen = grounded_from(small(*SAYABLE["even after odd"])).model.vocabulary
    assert (seen.level, seen.features) == (Level.B, plain.features)
    whole = grounded_from(small(*SAYABLE["a prime only after a prime"])).model.vocabulary
    assert whole.level is Level.B
    assert len(whole.features) > len(plain.features)
    wide = grounded_from(small(StraightUp(), FULL, LEFT)).model.vocabulary
    assert (wide.level, wide.features) == (Level.A, whole.features)


@pytest.mark.parametrize(
    ("rules", "told_line"),
    [
        ((Count(has("odd", "value"), Comparison.EQUAL, 1), FULL), "cannot say"),
        ((RISING, FULL), "cannot say"),
        ((TakeExtreme(ORIGIN_ROW, Extreme.LOWEST),), "looks at where other tokens began"),
        ((ODD, given_row("value", (2, 6, 2)), FULL), "no right play"),
        ((EveryToken(has("is-9", "value")),), "no right play"),
    ],
)
def test_what_actions_cannot_say_is_refused(rules: tuple[Rule, ...], told_line: str) -> None:
    with pytest.raises(InvalidError, match=told_line):
        grounded_from(small(*rules))


def test_too_many_plays_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(grounding, "MAX_TRIED", 10)
    with pytest.raises(InvalidError, match="more right plays than can be compared"):
        grounded_from(small(RISING, FULL, LEFT))
