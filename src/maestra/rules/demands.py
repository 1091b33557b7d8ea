"""What the preconditions of each step demand of the cells, as sets of tokens.

Tables over one model and one deck, filled as they are asked for; `completion` searches with them.
Tokens are bits in the deck's order, cells are places among the board's cells.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

from maestra.rules.features import FRAME
from maestra.rules.literals import Placed

if TYPE_CHECKING:
    from collections.abc import Mapping

    from maestra.core.board import Cell
    from maestra.core.tokens import Deck
    from maestra.rules.strips import ActionModel

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
    by_origin: tuple[tuple[int, int], ...]
    """The other tokens, each with what it demands of the cells, as a bit set."""


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
        self._from: dict[tuple[int, Place], tuple[Place, ...]] = {}
        self._relevant: dict[int, tuple[Place, ...]] = {}
        self._demanded: dict[tuple[int, Place], dict[int, Tokens]] = {}
        self._liked: dict[tuple[int, int], Tokens] = {}
        self._fitting: dict[tuple[int, Place, int], Tokens] = {}
        self._orders: dict[tuple[int, Place], tuple[int, ...]] = {}

    def reach(self, step: int) -> Reach:
        """Where the tokens may go at `step`, by the cells alone."""
        if step not in self._reach:
            anywhere: Domain = {}
            by_origin: list[tuple[int, int]] = []
            actions = self._model.by_step.get(step, {})
            some_origin = self.places[self._vocabulary.board.storage_cells[0]] if actions else 0
            for token, shown in enumerate(self.shown):
                if shown not in actions:
                    continue
                demanded = actions[shown] & self._of_move
                if demanded & ~self._of_destination:
                    by_origin.append((token, demanded))
                    continue
                for place in self.destinations(demanded, some_origin):
                    anywhere[place] = anywhere.get(place, 0) | 1 << token
            self._reach[step] = Reach(anywhere, tuple(by_origin))
        return self._reach[step]

    def destinations(self, demanded: int, origin: Place) -> tuple[Place, ...]:
        """The goal cells that a token may go to from `origin` when it demands this of the cells."""
        key = (demanded, origin)
        if key not in self._from:
            cells, placed = self._vocabulary.board.cells, self._vocabulary.placed
            self._from[key] = tuple(
                place for place in self.goal if not demanded & ~placed(cells[origin], cells[place])
            )
        return self._from[key]

    def relevant(self, step: int) -> tuple[Place, ...]:
        """The cells at whose content some precondition of `step` looks."""
        if step not in self._relevant:
            self._relevant[step] = tuple(
                place for place in self.watched if self._of_content(step, place).keys() - {0}
            )
        return self._relevant[step]

    def indifferent(self, step: int, place: Place) -> Tokens:
        """The tokens with an action at `step` that demands nothing of the content of `place`."""
        return self._of_content(step, place).get(0, 0)

    def fits(self, step: int, place: Place, shown: int) -> Tokens:
        """The tokens with an action at `step` that likes `shown` to lie on `place`."""
        key = (step, place, shown)
        if key not in self._fitting:
            self._fitting[key] = sum(
                whose & self._likers(demand, shown)
                for demand, whose in self._of_content(step, place).items()
            )
        return self._fitting[key]

    def order(self, step: int, place: Place) -> tuple[int, ...]:
        """The tokens, first those that, lying on `place`, leave most to the later steps."""
        key = (step, place)
        if key not in self._orders:
            later = range(step + 1, self._last + 1)
            room = {
                shown: -sum(self.fits(after, place, shown).bit_count() for after in later)
                for shown in set(self.shown)
            }
            tokens = range(len(self.shown))
            self._orders[key] = tuple(sorted(tokens, key=lambda token: room[self.shown[token]]))
        return self._orders[key]

    @cached_property
    def one_way(self) -> bool:
        """Whether every action takes a token from storage to the goal row."""
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

    def _of_content(self, step: int, place: Place) -> Mapping[int, Tokens]:
        """What preconditions of `step` demand of the content of `place`, and whose they are."""
        key = (step, place)
        if key not in self._demanded:
            vocabulary = self._vocabulary
            offset = vocabulary.offsets[vocabulary.board.cells[place]]
            block = (1 << vocabulary.block_size) - 1
            groups: dict[int, Tokens] = {}
            actions = self._model.by_step.get(step, {})
            for token, shown in enumerate(self.shown):
                if shown in actions:
                    demand = actions[shown] >> offset & block
                    groups[demand] = groups.get(demand, 0) | 1 << token
            self._demanded[key] = groups
        return self._demanded[key]

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
