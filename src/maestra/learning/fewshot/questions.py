"""What to ask next: the question whose answer tells most for the least effort.

Three kinds: is this finished row right, is this move right here, is this rule meant. What an
answer tells is the mutual information, in bits, of the answer and the hypotheses; answers are
trusted as `TRUST` says. Of rows that tell equally much the one most like what was shown is asked.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from enum import Enum
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from maestra.learning.fewshot.lesson import Belief, Lesson
from maestra.learning.fewshot.prior import OUTSIDE_YES, TRUST
from maestra.learning.fewshot.space import Context, follows, unpack
from maestra.rules.answers import MoveQuestion, Question, RowQuestion, RuleQuestion
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.timing import FillOrder
from maestra.rules.plays import NOBODY, Tokens
from maestra.rules.setting import Play

CONSIDERED: Final = 40
"""Hypotheses that questions are to tell apart, the likeliest."""
LEAST: Final = 0.01
"""Bits below which no question is worth asking."""
LIKENESS: Final = 1e-6
"""Bits that decide between rows that tell equally much, for each cell as shown."""


class QuestionKind(Enum):
    """What is asked about."""

    ROW = "row"
    MOVE = "move"
    RULE = "rule"


EFFORT: Final = {QuestionKind.ROW: 1.0, QuestionKind.MOVE: 0.9, QuestionKind.RULE: 1.2}
"""How hard each kind is to answer: a rule in words is harder than a row on the table, one move
a little easier. Our judgement, not a measurement."""

ALL_KINDS: Final = frozenset(QuestionKind)


class _Candidate(NamedTuple):
    worth: float
    question: Question


def next_question(lesson: Lesson, kinds: Collection[QuestionKind] = ALL_KINDS) -> Question | None:
    """The best question that was not asked yet; None when it is sure or nothing would help.

    Args:
        lesson: what is known.
        kinds: the kinds that may be asked.
    """
    if lesson.status is LearnStatus.LEARNED or not lesson.belief.classes:
        return None
    asked = {answer.question for answer in lesson.answers}
    candidates = [
        candidate
        for candidate in (*_rows_and_moves(lesson, kinds), *_rules(lesson, kinds))
        if candidate.worth >= LEAST and candidate.question not in asked
    ]
    return max(candidates, key=lambda c: c.worth).question if candidates else None


def _weights(belief: Belief) -> tuple[NDArray[np.float64], float]:
    """Those of the hypotheses considered, and of what cannot be said; together one."""
    weights = np.array(belief.weights[:CONSIDERED])
    total = weights.sum() + belief.outside
    return np.asarray(weights / total, np.float64), belief.outside / float(total)


def information(yes: NDArray[np.float64], outside: float = 0.0) -> NDArray[np.float64]:
    """Bits that an answer tells; answers are noisy.

    Args:
        yes: how likely it is that a hypothesis holds of which the true answer is yes.
        outside: how likely it is that the exercise is about what cannot be said; of that
            nothing is known but that the answer is seldom yes.
    """
    known = 1 - outside
    heard = yes * TRUST + (known - yes) * (1 - TRUST) + outside * OUTSIDE_YES
    noise = known * _entropy(np.array(TRUST)) + outside * _entropy(np.array(OUTSIDE_YES))
    return np.asarray(_entropy(heard) - noise, np.float64)


def _entropy(p: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(-p * np.log2(p) - (1 - p) * np.log2(1 - p), np.float64)


def _rows_and_moves(lesson: Lesson, kinds: Collection[QuestionKind]) -> Iterator[_Candidate]:
    belief = lesson.belief
    weights, outside = _weights(belief)
    for c in dict.fromkeys(belief.asked_in):
        context = belief.contexts[c]
        packed = np.array([one.words[c] for one in belief.classes[:CONSIDERED]])
        allowed = unpack(packed, len(context.rows.row))
        worth = information(weights @ allowed, outside)
        shown = _row(belief.plays[0])
        worth += LIKENESS * (context.rows.row == shown).sum(axis=1)
        for play in belief.plays:
            # What was shown is right: nobody has to be asked.
            worth[(context.rows.row == _row(play)).all(axis=1)] = 0.0
        asked = {a.question.play for a in lesson.answers if isinstance(a.question, RowQuestion)}
        for best in np.argsort(-worth, kind="stable")[: len(asked) + 1]:
            play = _played(context, int(best))
            if play in asked:
                continue
            if QuestionKind.ROW in kinds:
                yield _Candidate(float(worth[best]) / EFFORT[QuestionKind.ROW], RowQuestion(play))
            if QuestionKind.MOVE in kinds:
                yield from _moves(belief, context, play, allowed)


def _row(play: Play) -> Tokens:
    return np.array([NOBODY if token is None else token for token in play.row], np.intp)


def _played(context: Context, number: int) -> Play:
    play = Play.begin(context.setting)
    for cell in context.order:
        token = int(context.rows.row[number, cell])
        if token != NOBODY and play.row[cell] is None:
            play = play.after(token, cell)
    return play


def _moves(
    belief: Belief, context: Context, play: Play, allowed: NDArray[np.bool_]
) -> Iterator[_Candidate]:
    """The moves of a play, each asked about where it was made; the last is the row itself."""
    weights, outside = _weights(belief)
    position = Play.begin(context.setting)
    matching = np.ones(len(context.rows.row), np.bool_)
    for token, cell in play.placed[:-1]:
        after = position.after(token, cell)
        matching &= context.rows.row[:, cell] == token
        if not any(_leads_to(after, shown) for shown in belief.plays):
            yes = allowed[:, matching].any(axis=1)
            worth = float(information(np.array(weights @ yes), outside))
            yield _Candidate(
                worth / EFFORT[QuestionKind.MOVE], MoveQuestion(position, token, cell)
            )
        position = after


def _leads_to(position: Play, shown: Play) -> bool:
    """Whether all that lies there lies so at the end of a play that was shown."""
    return all(
        token is None or token == other
        for token, other in zip(position.row, shown.row, strict=True)
    )


def _rules(lesson: Lesson, kinds: Collection[QuestionKind]) -> Iterator[_Candidate]:
    if QuestionKind.RULE not in kinds:
        return
    belief = lesson.belief
    weights, outside = _weights(belief)
    considered = belief.classes[:CONSIDERED]
    for rule in dict.fromkeys(r for one in considered for r in belief.rules_of(one)):
        truth = [belief.truths.of_rule(rule, c) for c in range(len(belief.contexts))]
        yes = np.array([follows(one.words, truth) for one in considered])
        worth = float(information(np.array(weights @ yes), outside))
        yield _Candidate(worth / EFFORT[QuestionKind.RULE], RuleQuestion(rule))
    for filling, share in belief.orders.items():
        if filling is not None:
            worth = float(information(np.array(share)))
            yield _Candidate(worth / EFFORT[QuestionKind.RULE], RuleQuestion(FillOrder(filling)))
