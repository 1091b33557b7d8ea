"""Literals that may be spurious, and the next demonstration that would settle most of them.

What held in all demonstrations of an action by chance stays in its precondition as if it were a
rule. With a rule that generalises what was shown, a literal is suspect if some play that the
rule accepts makes it false. Without one every literal is, but those that are true of every play;
the less often its action was shown, the more.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from maestra.core.demonstration import Demonstration
from maestra.learning.telling import MostTelling, Open, never_seen
from maestra.rules.exercise import GroundedExercise
from maestra.rules.features import FRAME
from maestra.rules.ground_truth import ground_truth
from maestra.rules.right_plays import RightPlays, plays_like
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Literal, Placed
from maestra.rules.strips.vocabulary import positions


@dataclass(frozen=True, slots=True)
class Suspect:
    """A literal that may be in an action's precondition by chance only."""

    action: Action
    literal: Literal
    seen: int
    """In how many demonstrations the action was shown."""


@dataclass(frozen=True, slots=True)
class Doubts:
    """What is unclear about a learned exercise, and what would settle most of it."""

    suspects: tuple[Suspect, ...]
    """Those of the actions that were shown least often first."""
    unseen: tuple[Action, ...]
    """Actions of accepted plays that were never shown."""
    next_demonstration: Demonstration | None
    """The play to show next; None if none would settle anything."""
    settled: int
    """How many suspect literals and unseen actions that play would settle; of an unseen action
    also the literals that would never be suspect."""


def doubts(exercise: GroundedExercise, accepted: RightPlays) -> Doubts:
    """What is unclear if the right plays are those `accepted`, and what to show next.

    Args:
        exercise: what was learned.
        accepted: the plays that a generalisation of it accepts, on its board with its deck.

    Raises:
        InvalidError: plays on another board or with tokens unknown to the exercise.
        TooManyPlaysError: the accepted sequences cannot be enumerated.
    """
    vocabulary, learned = exercise.model.vocabulary, exercise.model.preconditions
    truth = ground_truth(accepted, vocabulary).preconditions
    suspect = {
        action: learned[action] & ~bits for action, bits in truth.items() if action in learned
    }
    unseen = tuple(action for action in truth if action not in learned)
    to_come = {
        action: vocabulary.everything & ~truth[action] | never_seen(vocabulary)
        for action in unseen
    }
    return _doubts(exercise, accepted, suspect, to_come)


def doubts_without_rule(
    exercise: GroundedExercise, demonstrations: Sequence[Demonstration]
) -> Doubts:
    """What is unclear as long as no rule is known, and which shown play to show rearranged.

    The next demonstration has the tokens and destinations of a shown one, from another start.

    Args:
        exercise: what was learned.
        demonstrations: from what; at least one.
    """
    vocabulary = exercise.model.vocabulary
    frame = vocabulary.bits(
        literal
        for literal in vocabulary.literals
        if isinstance(literal, Placed) and literal.feature in FRAME
    )
    learned = exercise.model.preconditions
    suspect = {action: bits & ~frame for action, bits in learned.items()}
    return _doubts(exercise, plays_like(demonstrations), suspect, {})


def _doubts(
    exercise: GroundedExercise,
    plays: RightPlays,
    suspect: dict[Action, int],
    to_come: dict[Action, int],
) -> Doubts:
    vocabulary, provenance = exercise.model.vocabulary, exercise.provenance
    literals = vocabulary.literals
    suspects = [
        Suspect(action, literals[place], provenance[action].seen)
        for action, bits in suspect.items()
        for place in positions(bits)
    ]
    index = vocabulary.index_of_shown
    unclear: Open = {
        (index[action.shown], action.step): bits for action, bits in (suspect | to_come).items()
    }
    telling = MostTelling(plays, vocabulary, unclear).most_telling()
    return Doubts(
        tuple(sorted(suspects, key=lambda one: one.seen)),
        tuple(to_come),
        telling.demonstration if telling else None,
        telling.settled if telling else 0,
    )
