"""What the preconditions of each step demand of the cells, as sets of tokens.

Tables over one model and one deck, filled as they are asked for; `completion` searches with them.
Tokens are bits in the deck's order, cells are places among the board's cells.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from maestra.rules.features import FRAME
from maestra.rules.strips.literals import Placed

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from maestra.core.board import Cell
    from maestra.core.tokens import Deck
    from maestra.rules.strips.actions import ActionModel

    Tokens = int
    """A set of the deck's tokens, a bit each."""
    Place = int
    """A cell, as its place among the board's cells: hashed a thousand times a search."""
    Domain = dict[Place, Tokens]
    """For each destination, the tokens that may still go there at a step."""

_OF_DESTINATION: Final = {"destination", "destination-column", "to-goal-row", "from-storage"}
"""Cell features that are the same from whatever storage cell a token comes."""


@dataclass(frozen=True, slots=True)
class Reach:
    """Where the tokens may go at a step, by the two cells of the move alone."""

    from_anywhere: Domain
    """Those to whom it does not matter which storage cell they come from."""
    by_origin: tuple[tuple[int, int, tuple[Place, ...]], ...]
    """Each other token, what it demands of the move's cells as a bit set, and the goal cells that
    may meet it."""


class Demands:
    """What each step's preconditions demand, for the tokens of one deck."""

    def __init__(self, model: ActionModel, deck: Deck, last: int) -> None:
        """Prepare for plays of at most `last` moves.

        Raises:
            InvalidError: a token of the deck shows what the model does not know.
        """
        self._model = model
        self._vocabulary = model.vocabulary
        self._last = last
        indices = self._vocabulary.indices(deck)
        self.shown = tuple(indices[token.id] for token in deck.tokens)
        """What each token shows, as an index into the vocabulary's `shown`."""
        cells = self._vocabulary.board.cells
        self.places: Mapping[Cell, Place] = {cell: place for place, cell in enumerate(cells)}
        self.goal = tuple(self.places[cell] for cell in self._vocabulary.board.goal_cells)
        self.watched = tuple(self.places[cell] for cell in self._vocabulary.watched)
        self._reach: dict[int, Reach] = {}
        self._placed: dict[int, int] = {}
        self._meeting: dict[int, tuple[Place, ...]] = {}
        self._relevant: dict[int, tuple[Place, ...]] = {}
        self._demanded: dict[Place, Mapping[int, Sequence[Tokens]]] = {}
        self._liked: dict[tuple[int, int], Tokens] = {}
        self._fitting: dict[tuple[Place, int], tuple[Tokens, ...]] = {}
        self._orders: dict[tuple[int, Place], tuple[int, ...]] = {}

    def reach(self, step: int) -> Reach:
        """Where the tokens may go at `step`, by the cells alone."""
        if step not in self._reach:
            anywhere: Domain = {}
            by_origin: list[tuple[int, int, tuple[Place, ...]]] = []
            actions = self._model.by_step.get(step, {})
            for token, shown in enumerate(self.shown):
                if shown not in actions:
                    continue
                demanded = actions[shown] & self._of_move
                places = self._goals_meeting(demanded & self._of_destination)
                if demanded & ~self._of_destination:
                    by_origin.append((token, demanded, places))
                    continue
                for place in places:
                    anywhere[place] = anywhere.get(place, 0) | 1 << token
            self._reach[step] = Reach(anywhere, tuple(by_origin))
        return self._reach[step]

    def meets(self, demanded: int, origin: Place, destination: Place) -> bool:
        """Whether a move between these cells meets what is demanded of its cells."""
        key = origin * len(self.places) + destination
        placed = self._placed.get(key)
        if placed is None:
            cells = self._vocabulary.board.cells
            placed = self._vocabulary.placed(cells[origin], cells[destination])
            self._placed[key] = placed
        return not demanded & ~placed

    def _goals_meeting(self, demanded: int) -> tuple[Place, ...]:
        """The goal cells of which this may be demanded, from whatever storage cell."""
        if demanded not in self._meeting:
            some = self.places[self._vocabulary.board.storage_cells[0]]
            self._meeting[demanded] = tuple(
                place for place in self.goal if self.meets(demanded, some, place)
            )
        return self._meeting[demanded]

    def relevant(self, step: int) -> tuple[Place, ...]:
        """The cells at whose content some precondition of `step` looks."""
        if step not in self._relevant:
            self._relevant[step] = tuple(
                place
                for place in self.watched
                if any(d and whose[step] for d, whose in self._demanding(place).items())
            )
        return self._relevant[step]

    def indifferent(self, step: int, place: Place) -> Tokens:
        """The tokens with an action at `step` that demands nothing of the content of `place`."""
        whose = self._demanding(place).get(0)
        return whose[step] if whose else 0

    def fitting(self, place: Place, shown: int) -> tuple[Tokens, ...]:
        """For each step, from 0, the tokens with an action that likes `shown` on `place`."""
        key = (place, shown)
        if key not in self._fitting:
            fitting = [0] * (self._last + 1)
            for demand, whose in self._demanding(place).items():
                likers = self._likers(demand, shown)
                fitting = [one | own & likers for one, own in zip(fitting, whose, strict=True)]
            self._fitting[key] = tuple(fitting)
        return self._fitting[key]

    def order(self, step: int, place: Place) -> tuple[int, ...]:
        """The tokens, first those that, lying on `place`, leave most to the later steps."""
        key = (step, place)
        if key not in self._orders:
            room = {
                shown: sum(map(int.bit_count, self.fitting(place, shown)[step + 1 :]))
                for shown in set(self.shown)
            }
            tokens = range(len(self.shown))
            self._orders[key] = tuple(sorted(tokens, key=lambda token: -room[self.shown[token]]))
        return self._orders[key]

    @cached_property
    def one_way(self) -> bool:
        """Whether every action takes a token from storage to the goal row, and both exist."""
        board, features = self._vocabulary.board, self._vocabulary.features
        if not board.storage_cells or not set(FRAME) <= set(features):
            return False
        frame = self._vocabulary.bits(Placed(feature, value=True) for feature in FRAME)
        return all(not frame & ~bits for bits in self._model.preconditions.values())

    @cached_property
    def _of_move(self) -> int:
        return (1 << self._vocabulary.placed_size) - 1

    @cached_property
    def _of_destination(self) -> int:
        literals = self._vocabulary.select(self._of_move)
        return self._vocabulary.bits(
            literal
            for literal in literals
            if isinstance(literal, Placed) and literal.feature.name in _OF_DESTINATION
        )

    def _demanding(self, place: Place) -> Mapping[int, Sequence[Tokens]]:
        """What preconditions demand of the content of `place`, and whose they are at each step."""
        if place not in self._demanded:
            vocabulary = self._vocabulary
            offset = vocabulary.offsets[vocabulary.board.cells[place]]
            block = (1 << vocabulary.block_size) - 1
            demanded: dict[int, list[Tokens]] = {}
            for step in range(self._last + 1):
                actions = self._model.by_step.get(step, {})
                for token, shown in enumerate(self.shown):
                    if shown in actions:
                        demand = actions[shown] >> offset & block
                        whose = demanded.setdefault(demand, [0] * (self._last + 1))
                        whose[step] |= 1 << token
            self._demanded[place] = demanded
        return self._demanded[place]

    def _likers(self, demand: int, shown: int) -> Tokens:
        """The tokens for whose move a cell with `shown` on it meets `demand`."""
        key = (demand, shown)
        if key not in self._liked:
            patterns = self._vocabulary.patterns
            self._liked[key] = sum(
                1 << token
                for token, moved in enumerate(self.shown)
                if not demand & ~patterns(moved)[shown]
            )
        return self._liked[key]
