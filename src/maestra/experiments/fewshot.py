"""One sample of the few-shot learner: shown, asked about, learned, and exact or not.

The judge compares what was learned with the truth on right plays, near misses and random plays,
from fresh starts, and apart from that with a fresh deck of the same attributes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from random import Random
from typing import Final, assert_never

import numpy as np
from numpy.typing import NDArray

from maestra.core.demonstration import Demonstration
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.experiments.demonstrators import Mistake, demonstrate, visible
from maestra.experiments.random_exercises import (
    Person,
    Sample,
    deck_of,
    orders_for,
    sample_of,
    truths,
)
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson
from maestra.learning.fewshot.questions import ALL_KINDS, QuestionKind, next_question
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.answers import Answer, MoveQuestion, Question, Reply, RowQuestion, RuleQuestion
from maestra.rules.plays import Tokens
from maestra.rules.rule import Rule, holding
from maestra.rules.setting import Play, Setting

JUDGED: Final = 60
"""Plays of each of three kinds, from each of three starts."""
DECKS: Final = 20
"""Drawn to find another one that an exercise can be played with."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of one sample, after so many questions at most."""

    seed: int
    family: str
    person: str
    demonstrations: int
    questions: int
    """How many were allowed."""
    asked: int
    """How many there were."""
    status: str
    confidence: float
    exact: bool
    """On fresh starts."""
    exact_on_new_decks: bool
    slipped: Mistake | None
    """The mistake that was made."""
    slips: tuple[tuple[int, int], ...]
    """The demonstrations and moves that were pointed out."""
    rules: str
    truth: str

    @property
    def located(self) -> bool:
        """Whether the mistake was pointed out where it is."""
        return self.slipped is not None and any(
            demonstration == self.slipped.demonstration and move in self.slipped.moves
            for demonstration, move in self.slips
        )


@dataclass(frozen=True, slots=True)
class Circumstances:
    """What is out of the usual with a sample."""

    outside: bool = False
    """The rule is about what the learner is not shown."""
    slip: bool | None = None
    """One demonstration holds a mistake, or none does; as the person is, if not said."""
    kinds: frozenset[QuestionKind] = ALL_KINDS
    """What may be asked about."""
    wrong: float = 0.0
    """How often an answer is the wrong one."""


USUAL: Final = Circumstances()


def trials(
    seed: int, count: int, questions: Sequence[int], circumstances: Circumstances = USUAL
) -> tuple[Outcome, ...]:
    """One sample shown `count` times: what came of it after each of these numbers of questions.

    Args:
        seed: of the sample.
        count: of demonstrations.
        questions: how many may be asked, rising; one dialogue gives all outcomes.
        circumstances: what is out of the usual.
    """
    person = None if circumstances.slip is None else Person.UNIFORM
    sample = sample_of(seed, outside=circumstances.outside, person=person)
    shown, slipped = demonstrate(sample, count, forced=bool(circumstances.slip))
    known: dict[tuple[Rule, ...], tuple[bool, bool]] = {}
    outcomes: list[Outcome] = []
    for most, lesson in zip(
        questions, lessons(sample, shown, questions, circumstances), strict=True
    ):
        if lesson.rules not in known:
            known[lesson.rules] = _exact(sample, lesson.rules)
        outcomes.append(outcome(sample, most, lesson, known[lesson.rules], slipped))
    return tuple(outcomes)


def lessons(
    sample: Sample,
    shown: Sequence[Demonstration],
    questions: Sequence[int],
    circumstances: Circumstances = USUAL,
) -> Iterator[Lesson]:
    """What is learned after at most so many questions each, all of one dialogue."""
    rng = Random(f"{sample.seed} answers")  # noqa: S311 - what is drawn is no secret
    answers: list[Answer] = []
    lesson = learn(shown)
    for most in questions:
        while len(answers) < most:
            question = next_question(lesson, circumstances.kinds)
            if question is None:
                break
            reply = reply_to(sample, question)
            if rng.random() < circumstances.wrong:
                reply = _yes(reply is Reply.NO)
            answers.append(Answer(question, reply))
            lesson = learn(shown, answers)
        yield lesson


def outcome(
    sample: Sample,
    questions: int,
    lesson: Lesson,
    exact: tuple[bool, bool],
    slipped: Mistake | None = None,
) -> Outcome:
    """What came of a lesson that is exact, or not, on fresh starts and on new decks."""
    return Outcome(
        sample.seed,
        sample.family,
        sample.person.value,
        len(lesson.demonstrations),
        questions,
        len(lesson.answers),
        lesson.status.value,
        lesson.confidence,
        *exact,
        slipped,
        tuple((slip.demonstration, slip.move) for slip in lesson.slips),
        " & ".join(map(str, lesson.rules)),
        " & ".join(map(str, sample.truth)),
    )


def _exact(sample: Sample, rules: Sequence[Rule]) -> tuple[bool, bool]:
    return (
        agrees(sample, rules, sample.deck, f"{sample.seed} fresh"),
        agrees(sample, rules, new_deck(sample), f"{sample.seed} new"),
    )


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
    return np.array([*chosen, *near, *anyhow], np.intp)


def new_deck(sample: Sample) -> Deck:
    """Another deck of the same make that the exercise can be played with; else the same."""
    rng = Random(f"{sample.seed} deck")  # noqa: S311 - what is drawn is no secret
    for _ in range(DECKS):
        deck = deck_of(sample.make, rng)
        setting = Setting(deck, sample.start(deck, rng))
        order = orders_for(sample.truth, setting)[0]
        context = Context(setting, order, rows_of(setting, order, full=sample.full))
        if truths(sample.truth, context).any():
            return deck
    return sample.deck


def reply_to(sample: Sample, question: Question) -> Reply:
    """What the sample's person, who knows the truth, says."""
    match question:
        case RowQuestion(play):
            true = _true(sample, play)
            return _yes(all(rule.holds(true) for rule in sample.truth))
        case MoveQuestion(position, token, cell):
            return _yes(_completable(sample, _true(sample, position.after(token, cell))))
        case RuleQuestion(rule):
            return _yes(_follows(sample, rule))
        case _:
            assert_never(question)


def _yes(is_so: bool) -> Reply:  # noqa: FBT001 - reads as an assertion
    return Reply.YES if is_so else Reply.NO


def _completable(sample: Sample, after: Play) -> bool:
    """Whether a right play begins so."""
    order = tuple(cell for _, cell in after.placed)
    order = (*order, *(k for k in range(after.setting.length) if k not in order))
    context = Context(after.setting, order, rows_of(after.setting, order, full=sample.full))
    right = truths(sample.truth, context)
    for cell, lies in enumerate(after.row):
        if lies is not None:
            right &= context.rows.row[:, cell] == lies
    return bool(right.any())


def _follows(sample: Sample, rule: Rule) -> bool:
    """Whether all right plays keep the rule, from two starts and in two orders."""
    rng = Random(0)  # noqa: S311 - what is drawn is no secret
    for _ in range(2):
        setting = Setting(sample.deck, sample.start(sample.deck, rng))
        orders = orders_for(sample.truth, setting)
        for order in (orders[0], orders[-1]):
            context = Context(setting, order, rows_of(setting, order, full=sample.full))
            if (truths(sample.truth, context) & ~context.truth(rule)).any():
                return False
    return True


def _true(sample: Sample, play: Play) -> Play:
    """The play with the deck that the truth knows."""
    true = Setting(sample.deck, State(sample.board, play.setting.start.cells))
    again = Play.begin(true)
    for token, cell in play.placed:
        again = again.after(token, cell)
    return again
