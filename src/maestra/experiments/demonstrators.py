"""Random people who show an exercise: each of their habits, and their mistakes.

Everything is a pure function of the sample's seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random
from typing import Final

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.core.tokens import Deck, Token
from maestra.experiments.random_exercises import HIDDEN, Person, Sample, orders_for, truths
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.looks import lines_of
from maestra.rules.plays import NOBODY, Truth
from maestra.rules.setting import Line, Play, Setting

REPEATS: Final = 0.6
"""How often a lazy person shows the last row again."""
SLIPS: Final = 0.15
"""How likely a slipping person makes a mistake in a demonstration; never more than one in all."""
FROM_THE_LEFT: Final = 0.6
"""How often people who are not asked for an order fill from the left."""
NEARNESS: Final = 1.0
"""How much likelier a near-sighted person takes what is near."""
WRONG_TOKEN: Final = 0.5
"""How many mistakes are a wrong token; the others are two in each other's place."""
TRIES: Final = 50
"""To find a mistake that is one: with a lenient rule many are right too."""


@dataclass(frozen=True, slots=True)
class Mistake:
    """The one mistake in somebody's demonstrations."""

    demonstration: int
    """From 0."""
    moves: tuple[int, ...]
    """From 0: of two tokens in each other's place both, for taking back either mends it."""


def demonstrate(
    sample: Sample, count: int, *, forced: bool = False
) -> tuple[list[Demonstration], Mistake | None]:
    """`count` demonstrations by the sample's person; and the mistake, if there is one.

    Args:
        sample: the exercise and the person.
        count: how many.
        forced: make a mistake in one of them for certain.
    """
    rng = Random(f"{sample.seed} shows")  # noqa: S311 - what is drawn is no secret
    start = sample.start(sample.deck, rng)
    plays: list[Play] = []
    while len(plays) < count:
        if sample.moves_tokens:
            start = sample.start(sample.deck, rng)
        play = _play(sample, Setting(sample.deck, start), plays, rng)
        if play is not None:
            plays.append(play)
        elif not plays:
            start = sample.start(sample.deck, rng)
    slipped = None
    slips = sample.person is Person.SLIPPING and any(rng.random() < SLIPS for _ in range(count))
    if slips or forced:
        which = rng.randrange(count)
        plays[which], moves = _slip(sample, plays[which], rng)
        slipped = Mistake(which, moves) if moves else None
    return [shown(sample, play) for play in plays], slipped


def _play(sample: Sample, setting: Setting, before: Sequence[Play], rng: Random) -> Play | None:
    order = _order(sample, setting, rng)
    context = Context(setting, order, rows_of(setting, order, full=sample.full))
    right = truths(sample.truth, context) & without_gaps(context)
    if not right.any():
        return None
    if sample.person is Person.LAZY and before and rng.random() < REPEATS:
        again = played(setting, before[-1].row, order)
        if all(rule.holds(again) for rule in sample.truth):
            return again
    weights = right.astype(float)
    if sample.person is Person.NEAR_SIGHTED:
        weights *= context.nearness(NEARNESS)
    chosen = rng.choices(range(len(weights)), weights.tolist())[0]
    return played(setting, [int(t) for t in context.rows.row[chosen]], order)


def without_gaps(context: Context) -> Truth:
    """The rows that leave no goal cell free before one that is filled: so people fill."""
    filled = context.rows.row[:, list(context.order)] != NOBODY
    return np.asarray((filled[:, 1:] <= filled[:, :-1]).all(axis=1))


def _order(sample: Sample, setting: Setting, rng: Random) -> Order:
    allowed = orders_for(sample.truth, setting)
    usual: Order = tuple(range(setting.length))
    timed = any(Line.TIME in lines_of(rule) for rule in sample.truth)
    if not sample.full:
        return usual[::-1] if sample.person is Person.LEFT_HANDER else usual
    if sample.person is Person.LEFT_HANDER and usual[::-1] in allowed:
        return usual[::-1]
    if not timed and rng.random() < FROM_THE_LEFT:
        return usual
    return rng.choice(allowed)


def played(setting: Setting, row: Sequence[int | None], order: Order) -> Play:
    """The play that puts the tokens of `row` on the goal cells in this order."""
    play = Play.begin(setting)
    for cell in order:
        token = row[cell]
        if token is not None and token != NOBODY:
            play = play.after(token, cell)
    return play


def _slip(sample: Sample, play: Play, rng: Random) -> tuple[Play, tuple[int, ...]]:
    """The play with one token taken for another or two in each other's place, and those moves.

    Without any move when every mistake that was tried is right as well.
    """
    order: Order = tuple(cell for _, cell in play.placed)
    left = [t for t in range(len(sample.deck.tokens)) if play.left >> t & 1]
    for _ in range(TRIES):
        row = list(play.row)
        move = rng.randrange(len(order))
        moves = {move}
        if left and rng.random() < WRONG_TOKEN:
            row[order[move]] = rng.choice(left)
        else:
            other = rng.randrange(len(order))
            row[order[move]], row[order[other]] = row[order[other]], row[order[move]]
            moves.add(other)
        tried = played(play.setting, row, order)
        if not all(rule.holds(tried) for rule in sample.truth):
            return tried, tuple(sorted(moves))
    return play, ()


def shown(sample: Sample, play: Play) -> Demonstration:
    """The play as the learner may see it: without the hidden attribute."""
    deck = visible(sample.deck)
    return Demonstration(deck, play.setting.start, play.moves())


def visible(deck: Deck) -> Deck:
    """The deck without the hidden attribute."""
    tokens = [
        Token(t.id, tuple((k, v) for k, v in t.attributes if not k.startswith(HIDDEN)))
        for t in deck.tokens
    ]
    return Deck(tuple(tokens), deck.orders, deck.cycles, deck.relations, deck.lexicon)
