"""The few-shot learner: from demonstrations and answers to a lesson.

The proposals that hold of what was shown are evaluated on the rows that could have been shown,
the search finds the conjunctions that explain it (`posterior`), people's habits are weighed in
(`weighing`), and what is believed then is told here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from maestra.core.demonstration import Demonstration
from maestra.learning.fewshot.evidence import Evidence
from maestra.learning.fewshot.lesson import Belief, Class, Hypothesis, Lesson, Slip
from maestra.learning.fewshot.prior import LEARNED_AT
from maestra.learning.fewshot.slips import wrong_move
from maestra.learning.fewshot.space import follows
from maestra.learning.fewshot.weighing import belief_from
from maestra.rules.answers import Answer, Reply
from maestra.rules.exercise import LearnStatus
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.rule import Rule

PLAUSIBLE: Final = 0.001
"""Weight from which a hypothesis counts for the safe bound."""
ALTERNATIVES: Final = 8
"""So many are told."""


def learn(
    demonstrations: Sequence[Demonstration],
    answers: Sequence[Answer] = (),
    seed: int = 0,
) -> Lesson:
    """The lesson of at least one demonstration, all on boards with as many goal cells.

    Args:
        demonstrations: what was shown.
        answers: what was said to questions; a shown row that is said to be right is no slip.
        seed: of the sample that stands for the rows where they are too many to list.

    Raises:
        ValueError: no demonstration.
        InvalidError: a move that is not from a storage cell to a goal cell.
    """
    if not demonstrations:
        raise ValueError("no demonstration")
    evidence = Evidence(tuple(demonstrations), tuple(answers), seed)
    return _told(evidence, belief_from(evidence))


def _told(evidence: Evidence, belief: Belief) -> Lesson:
    """What is believed, in rules."""
    length: tuple[Rule, ...] = (FullRow(),) if belief.full else ()
    best = belief.classes[0]
    order, sure = _order(belief, best)
    rules = belief.rules_of(best)
    # Whether a demonstration was a slip makes no difference to what is meant.
    meant = sum(w for one, w in belief.weighted if one.allows_the_same(best))
    confidence = sure * meant
    sures = (_sure(belief, rule) for rule in rules)
    alternatives = tuple(
        Hypothesis((*length, *belief.rules_of(one), *its_order), weight * its_sure)
        for one, weight in belief.weighted[1 : ALTERNATIVES + 1]
        for its_order, its_sure in (_order(belief, one),)
    )
    return Lesson(
        _status(evidence, belief, confidence),
        (*length, *rules, *order),
        (*(1.0 for _ in length), *sures, *(belief.orders[rule.filling] for rule in order)),
        confidence,
        alternatives,
        _slips(evidence, belief),
        (*length, *_bound(belief), *order),
        evidence.demonstrations,
        evidence.answers,
        belief,
    )


def _order(belief: Belief, one: Class) -> tuple[tuple[FillOrder, ...], float]:
    """The order of placement that goes with a class, if one is asked for, and how sure that is."""
    orders = belief.orders_of(one)
    filling = max(orders, key=lambda each: orders[each])
    return () if filling is None else (FillOrder(filling),), orders[filling]


def _status(evidence: Evidence, belief: Belief, confidence: float) -> LearnStatus:
    said = {r: {a.question for a in evidence.answers if a.reply is r} for r in Reply}
    if not said[Reply.YES].isdisjoint(said[Reply.NO]):
        return LearnStatus.CONTRADICTORY
    if belief.outside > 1 / 2 and len(evidence.distinct) > 1:
        return LearnStatus.OUTSIDE
    return LearnStatus.LEARNED if confidence >= LEARNED_AT else LearnStatus.AMBIGUOUS


def _sure(belief: Belief, rule: Rule) -> float:
    """The weight of the hypotheses from which a rule follows."""
    truth = belief.truths.everywhere(rule)
    return sum(weight for one, weight in belief.weighted if follows(one.words, truth))


def _bound(belief: Belief) -> tuple[Rule, ...]:
    """All rules that some plausible hypothesis has, without those that follow from others."""
    used: dict[Rule, None] = {}
    words = [context.rows.everything for context in belief.contexts]
    for one, weight in belief.weighted:
        if weight < PLAUSIBLE or one.slip != belief.classes[0].slip:
            continue
        for rule in belief.rules_of(one):
            truth = belief.truths.everywhere(rule)
            if not follows(words, truth):
                used[rule] = None
                words = [w & t for w, t in zip(words, truth, strict=True)]
    return tuple(used)


def _slips(evidence: Evidence, belief: Belief) -> tuple[Slip, ...]:
    """Layouts that are likelier a slip than not, and the move that is wrong."""
    found: list[Slip] = []
    for k, number in enumerate(evidence.distinct):
        mine = [(one, weight) for one, weight in belief.weighted if one.slip == k]
        likely = sum(weight for _, weight in mine)
        if likely > 1 / 2:
            rules = belief.rules_of(mine[0][0])
            found.append(Slip(number, wrong_move(rules, evidence.plays[number]), likely))
    return tuple(found)
