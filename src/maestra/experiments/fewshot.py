"""How well the few-shot learner learns: random exercises, random people, exact or not.

The judge compares what was learned with the truth on right plays, near misses and random plays,
from fresh starts, and apart from that with a fresh deck of the same attributes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random
from typing import Final

import numpy as np
from numpy.typing import NDArray

from maestra.core.demonstration import Demonstration
from maestra.core.state import State
from maestra.core.tokens import Deck, Token
from maestra.experiments.random_exercises import (
    HIDDEN,
    Person,
    Sample,
    deck_of,
    orders_for,
    sample_of,
    truths,
)
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson
from maestra.learning.fewshot.questions import next_question
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.answers import Answer, MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.looks import lines_of
from maestra.rules.plays import NOBODY, Tokens, Truth
from maestra.rules.rule import Rule, holding
from maestra.rules.setting import Line, Play, Setting

REPEATS: Final = 0.6
"""How often a lazy person shows the last row again."""
SLIPS: Final = 0.15
"""How likely a slipping person makes a mistake in a demonstration; never more than one in all."""
FROM_THE_LEFT: Final = 0.6
"""How often people who are not asked for an order fill from the left."""
NEARNESS: Final = 1.0
WRONG_TOKEN: Final = 0.5
"""How many mistakes are a wrong token; the others are two in each other's place."""
JUDGED: Final = 60
"""Plays of each of three kinds, from each of three starts."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of one sample."""

    seed: int
    family: str
    person: str
    demonstrations: int
    asked: int
    status: str
    confidence: float
    exact: bool
    exact_on_new_decks: bool
    slipped: tuple[int, int] | None
    """The demonstration and move of the mistake that was made."""
    slips: tuple[tuple[int, int], ...]
    """Those that were pointed out."""
    rules: str
    truth: str


def demonstrate(
    sample: Sample, count: int, *, forced: bool = False
) -> tuple[list[Demonstration], tuple[int, int] | None]:
    """`count` demonstrations by the sample's person; and where the mistake is, if there is one.

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
    slipped = None
    slips = sample.person is Person.SLIPPING and any(rng.random() < SLIPS for _ in range(count))
    if slips or forced:
        which = rng.randrange(count)
        plays[which], move = _slip(sample, plays[which], rng)
        slipped = None if move is None else (which, move)
    return [_shown(sample, play) for play in plays], slipped


def _play(sample: Sample, setting: Setting, before: Sequence[Play], rng: Random) -> Play | None:
    order = _order(sample, setting, rng)
    context = Context(setting, order, rows_of(setting, order, full=sample.full))
    right = truths(sample.truth, context) & _without_gaps(context)
    if not right.any():
        return None
    if sample.person is Person.LAZY and before and rng.random() < REPEATS:
        again = _played(setting, before[-1].row, order)
        if all(rule.holds(again) for rule in sample.truth):
            return again
    weights = right.astype(float)
    if sample.person is Person.NEAR_SIGHTED:
        weights *= context.nearness(NEARNESS)
    chosen = rng.choices(range(len(weights)), weights.tolist())[0]
    return _played(setting, [int(t) for t in context.rows.row[chosen]], order)


def _without_gaps(context: Context) -> Truth:
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


def _played(setting: Setting, row: Sequence[int | None], order: Order) -> Play:
    play = Play.begin(setting)
    for cell in order:
        token = row[cell]
        if token is not None and token != NOBODY:
            play = play.after(token, cell)
    return play


def _slip(sample: Sample, play: Play, rng: Random) -> tuple[Play, int | None]:
    """The play with one token taken for another or two in each other's place, and the move."""
    order: Order = tuple(cell for _, cell in play.placed)
    left = [t for t in range(len(sample.deck.tokens)) if play.left >> t & 1]
    for _ in range(50):
        row = list(play.row)
        move = rng.randrange(len(order))
        if left and rng.random() < WRONG_TOKEN:
            row[order[move]] = rng.choice(left)
        else:
            other = rng.randrange(len(order))
            row[order[move]], row[order[other]] = row[order[other]], row[order[move]]
            move = max(move, other)
        tried = _played(play.setting, row, order)
        if not all(rule.holds(tried) for rule in sample.truth):
            return tried, move
    return play, None


def _shown(sample: Sample, play: Play) -> Demonstration:
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


def agrees(sample: Sample, rules: Sequence[Rule], deck: Deck, seed: str) -> bool:
    """Whether `rules` and the truth say the same of many plays with `deck` from fresh starts."""
    rng = Random(seed)  # noqa: S311 - what is drawn is no secret
    for _ in range(3):
        start = sample.start(deck, rng)
        setting = Setting(deck, start)
        shown = Setting(visible(deck), start)
        orders = orders_for(sample.truth, setting)
        usual: Order = tuple(range(setting.length))
        for order in dict.fromkeys((usual, usual[::-1], rng.choice(orders))):
            rows = rows_of(setting, order, full=sample.full)
            context = Context(setting, order, rows)
            right = np.flatnonzero(truths(sample.truth, context))
            judged = _judged(setting, rows.row, right, rng)
            here = Context(setting, order, type(rows)(judged, None))
            there = Context(shown, order, type(rows)(judged, None))
            true, said = holding(sample.truth, here.plays), holding(rules, there.plays)
            if (true != said).any():
                return False
    return True


def _judged(setting: Setting, rows: Tokens, right: NDArray[np.intp], rng: Random) -> Tokens:
    chosen = [rows[rng.choice(right)] for _ in range(JUDGED)] if len(right) else []
    near: list[Tokens] = []
    tokens = list(range(len(setting.deck.tokens)))
    for row in chosen:
        changed = row.copy()
        cell = rng.randrange(setting.length)
        token = rng.choice(tokens)
        changed[changed == token] = changed[cell]
        changed[cell] = token
        near.append(changed)
    anyhow = [rows[rng.randrange(len(rows))] for _ in range(JUDGED)]
    return np.array([*chosen, *near, *anyhow], np.int16)


def reply_to(sample: Sample, question: Question) -> Reply:
    """What the sample's person, who knows the truth, says."""
    match question:
        case RowQuestion(play):
            true = _true(sample, play)
            return _yes(all(rule.holds(true) for rule in sample.truth))
        case MoveQuestion(position, token, cell):
            after = _true(sample, position.after(token, cell))
            order = tuple(c for _, c in after.placed)
            rest = tuple(k for k in range(after.setting.length) if k not in order)
            context = Context(
                after.setting,
                (*order, *rest),
                rows_of(after.setting, (*order, *rest), full=sample.full),
            )
            right = truths(sample.truth, context)
            for cell_, lies in enumerate(after.row):
                if lies is not None:
                    right &= context.rows.row[:, cell_] == lies
            return _yes(bool(right.any()))
        case RuleQuestion(rule):
            rng = Random(0)  # noqa: S311 - what is drawn is no secret
            for _ in range(2):
                setting = Setting(sample.deck, sample.start(sample.deck, rng))
                for order in (
                    orders_for(sample.truth, setting)[0],
                    orders_for(sample.truth, setting)[-1],
                ):
                    context = Context(setting, order, rows_of(setting, order, full=sample.full))
                    if (truths(sample.truth, context) & ~context.truth(rule)).any():
                        return Reply.NO
            return Reply.YES


def _yes(is_so: bool) -> Reply:  # noqa: FBT001 - reads as an assertion
    return Reply.YES if is_so else Reply.NO


def _true(sample: Sample, play: Play) -> Play:
    """The play with the deck that the truth knows."""
    true = Setting(sample.deck, State(sample.board, play.setting.start.cells))
    again = Play.begin(true)
    for token, cell in play.placed:
        again = again.after(token, cell)
    return again


def trial(
    seed: int, count: int, *, asked: int = 0, outside: bool = False, slip: bool | None = None
) -> Outcome:
    """One sample shown `count` times, with at most `asked` questions, learned and judged.

    Args:
        seed: of the sample.
        count: of demonstrations.
        asked: questions at most.
        outside: the rule is about what the learner is not shown.
        slip: one demonstration holds a mistake, or none does; as the person is, if not said.
    """
    person = None if slip is None else Person.UNIFORM
    sample = sample_of(seed, outside=outside, person=person)
    shown, slipped = demonstrate(sample, count, forced=bool(slip))
    lesson = learn(shown)
    answers: list[Answer] = []
    while len(answers) < asked:
        question = next_question(lesson)
        if question is None:
            break
        answers.append(Answer(question, reply_to(sample, question)))
        lesson = learn(shown, answers)
    return judged(sample, count, len(answers), lesson, slipped)


def judged(
    sample: Sample, count: int, asked: int, lesson: Lesson, slipped: tuple[int, int] | None
) -> Outcome:
    """What came of a lesson."""
    other = new_deck(sample)
    return Outcome(
        sample.seed,
        sample.family,
        sample.person.value,
        count,
        asked,
        lesson.status.value,
        lesson.confidence,
        agrees(sample, lesson.rules, sample.deck, f"{sample.seed} fresh"),
        agrees(sample, lesson.rules, other, f"{sample.seed} new"),
        slipped,
        tuple((slip.demonstration, slip.move) for slip in lesson.slips),
        " & ".join(map(str, lesson.rules)),
        " & ".join(map(str, sample.truth)),
    )


def new_deck(sample: Sample) -> Deck:
    """Another deck of the same make that the exercise can be played with; else the same."""
    rng = Random(f"{sample.seed} deck")  # noqa: S311 - what is drawn is no secret
    for _ in range(20):
        deck = deck_of(sample.make, rng)
        setting = Setting(deck, sample.start(deck, rng))
        order = orders_for(sample.truth, setting)[0]
        context = Context(setting, order, rows_of(setting, order, full=sample.full))
        if truths(sample.truth, context).any():
            return deck
    return sample.deck


def learned_wrongly(outcome: Outcome) -> bool:
    """Whether it said "learned" and was not exact."""
    return outcome.status == LearnStatus.LEARNED.value and not outcome.exact
