"""What the preconditions of a model say about its plays, before any rule is thought of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

from maestra.core.board import Cell
from maestra.rules.exercise import GroundedExercise
from maestra.rules.features import FRAME
from maestra.rules.setting import Index, Mask
from maestra.rules.strips.literals import Placed
from maestra.rules.strips.vocabulary import Vocabulary, positions

Bits: TypeAlias = int
"""A set of the vocabulary's literals."""


@dataclass(frozen=True)
class Evidence:
    """An exercise's actions, looked at together; sets of tokens are over its deck."""

    exercise: GroundedExercise

    @property
    def vocabulary(self) -> Vocabulary:
        """What its literals mean."""
        return self.exercise.model.vocabulary

    @property
    def actions(self) -> Mapping[int, Mapping[int, Bits]]:
        """Step to what is moved (an index) to its precondition."""
        return self.exercise.model.by_step

    @cached_property
    def of_shown(self) -> tuple[Mask, ...]:
        """For each thing shown, the tokens that show it."""
        masks = [0] * len(self.vocabulary.shown)
        for place, token in enumerate(self.vocabulary.deck.tokens):
            masks[self.vocabulary.index_of_shown[token.attributes]] |= 1 << place
        return tuple(masks)

    @cached_property
    def shown_of(self) -> tuple[int, ...]:
        """For each token, what it shows, as an index."""
        index = self.vocabulary.index_of_shown
        return tuple(index[token.attributes] for token in self.vocabulary.deck.tokens)

    @cached_property
    def only_places(self) -> bool:
        """Whether every action takes a token from storage to the goal row, empty at the start."""
        vocabulary = self.vocabulary
        frame = vocabulary.bits(Placed(feature, value=True) for feature in FRAME)
        filled: set[Cell] = set()
        for step in sorted(self.actions):
            for precondition in self.actions[step].values():
                if frame & ~precondition:
                    return False
                given = (
                    cell
                    for cell in vocabulary.board.goal_cells
                    if cell not in filled and self.demanded(precondition, cell)
                )
                if any(given):
                    return False
            filled.update(self.destinations[step])
        return True

    def demanded(self, precondition: Bits, cell: Cell) -> Bits:
        """The literals about what lies on `cell`, as `Vocabulary.patterns` counts them."""
        block = (1 << self.vocabulary.block_size) - 1
        return precondition >> self.vocabulary.offsets[cell] & block

    @cached_property
    def tokens(self) -> Mapping[int, Mask]:
        """For each step the tokens it was shown with."""
        return {
            step: sum(self.of_shown[shown] for shown in actions)
            for step, actions in self.actions.items()
        }

    @cached_property
    def routes(self) -> Mapping[int, Mapping[int, frozenset[tuple[Cell, Cell]]]]:
        """Step to what is moved to every origin and destination its precondition leaves."""
        return {
            step: {shown: self._routes(precondition) for shown, precondition in actions.items()}
            for step, actions in self.actions.items()
        }

    @cached_property
    def destinations(self) -> Mapping[int, frozenset[Cell]]:
        """For each step the goal cells that a token may go to."""
        return {
            step: frozenset(cell for routes in by_shown.values() for _, cell in routes)
            for step, by_shown in self.routes.items()
        }

    def _routes(self, precondition: Bits) -> frozenset[tuple[Cell, Cell]]:
        demanded = precondition & ((1 << self.vocabulary.placed_size) - 1)
        if demanded not in self._known_routes:
            self._known_routes[demanded] = self._find_routes(demanded)
        return self._known_routes[demanded]

    @cached_property
    def _known_routes(self) -> dict[Bits, frozenset[tuple[Cell, Cell]]]:
        return {}

    def _find_routes(self, demanded: Bits) -> frozenset[tuple[Cell, Cell]]:
        vocabulary = self.vocabulary
        fixed: dict[str, Cell] = {}
        for place in positions(demanded):
            literal = vocabulary.literals[place]
            if isinstance(literal, Placed) and isinstance(literal.value, Cell):
                fixed[literal.feature.name] = literal.value
        board = vocabulary.board
        origins = (fixed["origin"],) if "origin" in fixed else board.storage_cells
        ends = (fixed["destination"],) if "destination" in fixed else board.goal_cells
        return frozenset(
            (origin, end)
            for origin in origins
            for end in ends
            if not demanded & ~vocabulary.placed(origin, end)
        )

    def fit(self, step: int, cell: Cell, token: Index) -> Mask:
        """The tokens on `cell` that let `token` be moved as this step, if its action is known."""
        shown = self.shown_of[token]
        demand = self.demanded(self.actions[step][shown], cell)
        key = (shown, demand)
        if key not in self._known_fits:
            patterns = self.vocabulary.patterns(shown)
            self._known_fits[key] = sum(
                mask for other, mask in enumerate(self.of_shown) if not demand & ~patterns[other]
            )
        return self._known_fits[key] & ~(1 << token)

    @cached_property
    def _known_fits(self) -> dict[tuple[int, Bits], Mask]:
        return {}
