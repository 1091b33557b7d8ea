"""What has been learned and can be played: an exercise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from maestra.core.board import Board
    from maestra.core.tokens import Deck
    from maestra.rules.strips.actions import Action, ActionModel


@dataclass(frozen=True, slots=True)
class Deletion:
    """Literals that one demonstration showed not to be needed."""

    demonstration: int
    """From 1, in the order they were shown."""
    literals: int
    """A bit set over the vocabulary."""


@dataclass(frozen=True, slots=True)
class Provenance:
    """Where an action's precondition comes from."""

    seen: int
    """In how many demonstrations it was shown: each literal that is left held in all of them."""
    deletions: tuple[Deletion, ...]


@dataclass(frozen=True, slots=True)
class GroundedExercise:
    """An exercise as the paper learns it: an action for each token and step."""

    model: ActionModel
    provenance: Mapping[Action, Provenance]
    """For each action of the model."""
    lengths: frozenset[int]
    """After how many moves a play may end: after as many as some demonstration had."""
    demonstrations: int
    """How many were shown."""

    @property
    def board(self) -> Board:
        """The board it is played on."""
        return self.model.vocabulary.board

    @property
    def deck(self) -> Deck:
        """The tokens it was learned with."""
        return self.model.vocabulary.deck
