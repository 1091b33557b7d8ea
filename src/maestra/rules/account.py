"""What there is to say of an exercise, whichever kind it is."""

from __future__ import annotations

from typing import TypeAlias

from maestra.core.tokens import Deck
from maestra.rules.exercise import Exercise, GroundedExercise, RuledExercise
from maestra.rules.summaries.blame import ids_against
from maestra.rules.summaries.summary import Summary, summarise
from maestra.rules.verdicts import (
    AfterTheEnd,
    BrokenPrecondition,
    DeadEnd,
    JudgedMove,
    NotShown,
    RulesBroken,
)

Account: TypeAlias = Summary | RuledExercise
"""Rules with their ids: those that sum up an exercise's actions, or the exercise's own."""


def account_of(exercise: Exercise) -> Account:
    """What there is to say of `exercise`; of single actions the rules are worked out."""
    return summarise(exercise) if isinstance(exercise, GroundedExercise) else exercise


def broken_ids(judged: JudgedMove, account: Account, deck: Deck) -> tuple[str, ...]:
    """The ids of the rules that a move goes against; of a summary's gaps, if of no rule.

    None for a move that was not refused, and for what a single rule does not forbid.

    Args:
        judged: a move with its verdict.
        account: of the exercise it was judged by.
        deck: the tokens it was played with.
    """
    verdict = judged.verdict
    match verdict:
        case RulesBroken(rules):
            return tuple(one.id for one in rules)
        case NotShown() | BrokenPrecondition() | DeadEnd() | AfterTheEnd() if isinstance(
            account, Summary
        ):
            return ids_against(verdict, judged.before, judged.move, account, deck)
        case _:
            return ()
