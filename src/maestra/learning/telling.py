"""Which right play tells most: settles most of the literals that are open.

An open literal of an action is settled by a play that shows the action while the literal is
false. Of a sequence of placements, what lies in the goal row before each move is fixed; what a
start arrangement adds is a sum over tokens and the cells they begin on, because each literal is
about one cell. So the best start is an assignment of tokens to cells, found exactly. Sequences
are tried from the most promising, by a bound on what any start could settle: what the goal row
holds is the sum of what each token there holds, so it is counted once for all sequences that agree
in a token, its cell and the token moved.

Cost of a play: sequences x the square of their moves, vectorised, and for each sequence tried
its moves x tokens x storage cells and the assignment.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final, TypeAlias

import numpy as np

from maestra.core.board import Cell
from maestra.core.demonstration import Demonstration
from maestra.core.tokens import TokenId
from maestra.learning.assignment import FORBIDDEN, cheapest_assignment
from maestra.learning.grounded import GroundedLearner
from maestra.rules.right_plays import PlayGroup, RightPlays
from maestra.rules.strips.vocabulary import Vocabulary

MAX_ARRANGED: Final = 64
"""Sequences for which the best start is computed before the best so far is good enough."""
MAX_COSTS: Final = 1_500_000
"""Costs of a token on a cell in a step that are summed up for that: a second."""

Counts: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.int64]]
Open: TypeAlias = Mapping[tuple[int, int], int]
"""For what is moved (an index into the vocabulary's) and the step: the open literals' bits."""


@dataclass(frozen=True, slots=True)
class Telling:
    """A play, and how many open literals it settles."""

    demonstration: Demonstration
    settled: int


def never_seen(vocabulary: Vocabulary) -> int:
    """The bit of a literal more, false before every move: open for an action never shown."""
    return vocabulary.everything + 1


class MostTelling:
    """Finds the play that tells most, again and again while literals are settled."""

    def __init__(self, plays: RightPlays, vocabulary: Vocabulary, open_literals: Open) -> None:
        """Begin with these open literals; actions that are not there have none."""
        self._plays = plays
        self._vocabulary = vocabulary
        self._open = {key: bits for key, bits in open_literals.items() if bits}
        self._learner = GroundedLearner(vocabulary)
        indices = vocabulary.indices(plays.deck)
        self._shown = [indices[token.id] for token in plays.deck.tokens]

    @property
    def open_literals(self) -> Open:
        """What is still open."""
        return self._open

    def settle(self, demonstration: Demonstration) -> None:
        """Take as settled what this play settles."""
        for key, bits in self._left_by(demonstration):
            if bits:
                self._open[key] = bits
            else:
                del self._open[key]

    def most_telling(self) -> Telling | None:
        """The play that settles most; None if no right play settles anything.

        The very most if the bounds show it after as many sequences as the limits allow, else
        the best of these.
        """
        costs = len(self._shown) * len(self._plays.board.storage_cells)
        limit = min(MAX_ARRANGED, MAX_COSTS // (costs * max(1, *self._plays.lengths)))
        best: Telling | None = None
        bounds = [self._bounds(index) for index in range(len(self._plays.groups))]
        places = [(index, row) for index, one in enumerate(bounds) for row in range(len(one))]
        every = np.array([bound for one in bounds for bound in one], np.int64)
        for tried, place in enumerate(np.argsort(-every, kind="stable")):
            enough = best.settled if best else 0
            if every[place] <= enough or (best and tried >= limit):
                break
            group, row = places[int(place)]
            telling = self.arrange(self._plays.groups[group], row)
            if telling.settled > enough:
                best = telling
        return best

    def arrange(self, group: PlayGroup, row: int) -> Telling:
        """The group's sequence `row` from the start that settles most."""
        places = self._best_places(group, row)
        tokens, storage = self._plays.deck.tokens, self._plays.board.storage_cells
        start: dict[TokenId, Cell] = {
            tokens[token].id: storage[place] for token, place in enumerate(places)
        }
        demonstration = self._plays.demonstration(group, row, start)
        return Telling(demonstration, self._settled_by(demonstration))

    def _left_by(self, demonstration: Demonstration) -> Iterator[tuple[tuple[int, int], int]]:
        """The actions shown that have open literals, with those that stay open."""
        for seen in self._learner.observe(demonstration):
            key = (seen.moved, seen.step)
            if key in self._open:
                yield key, self._open[key] & seen.holding

    def _settled_by(self, demonstration: Demonstration) -> int:
        return sum(
            (self._open[key] & ~bits).bit_count() for key, bits in self._left_by(demonstration)
        )

    def _bounds(self, index: int) -> Counts:
        """For each sequence of a group, at most how many open literals it settles."""
        group = self._plays.groups[index]
        shown: Counts = np.array(self._shown, np.int64)[group.tokens]
        destinations: Counts = group.destinations.astype(np.int64)
        bounds = np.zeros(len(shown), np.int64)
        for step in range(shown.shape[1]):
            moved, cells = shown[:, step], destinations[:, step]
            placed = self._surely_placed(group, step)
            bounds += _for_each(partial(self._still_open, placed, step), moved, cells)
            for earlier in range(step):
                there, at = shown[:, earlier], destinations[:, earlier]
                bounds -= _for_each(partial(self._held, step), moved, there, at)
        return bounds

    def _still_open(self, placed: Sequence[int], step: int, moved: int, cell: int) -> int:
        """The open literals that do not hold wherever the move begins."""
        return (self._open.get((moved, step + 1), 0) & ~placed[cell]).bit_count()

    def _surely_placed(self, group: PlayGroup, step: int) -> list[int]:
        """For each goal cell the literals that hold of a move there, wherever it begins."""
        storage, goal = self._plays.board.storage_cells, self._plays.board.goal_cells
        origins = [cell for cell in storage if group.arrangements.may_begin_at(step, cell)]
        placed = [~0] * len(goal)
        for index in {int(cell) for cell in group.destinations[:, step]}:
            for origin in origins:
                placed[index] &= self._vocabulary.placed(origin, goal[index])
        return placed

    def _held(self, step: int, moved: int, other: int, cell: int) -> int:
        """The open literals that hold while a token showing `other` lies on a goal cell."""
        bits = self._open.get((moved, step + 1), 0)
        offset = self._vocabulary.offsets[self._plays.board.goal_cells[cell]]
        return (bits >> offset & self._vocabulary.patterns(moved)[other]).bit_count()

    def _best_places(self, group: PlayGroup, row: int) -> tuple[int, ...]:
        """For each token of the deck the storage cell, by index, where it had best begin.

        What a token on a cell costs is the open literals that it makes hold: those about the
        cell in all steps until it is moved, those about the origin in its own.
        """
        storage = self._plays.board.storage_cells
        moved_so_far: set[int] = set()
        costs = np.zeros((len(self._shown), len(storage)), np.int64)
        for step, (token, cell_index) in enumerate(group.sequences[row]):
            moved = self._shown[token]
            bits = self._open.get((moved, step + 1), 0)
            goal = self._plays.board.goal_cells[cell_index]
            allowed = group.arrangements.origins[step]
            for place, cell in enumerate(storage):
                if allowed is not None and cell not in allowed:
                    costs[token, place] += FORBIDDEN
                costs[token, place] += (bits & self._vocabulary.placed(cell, goal)).bit_count()
            lying = [other for other in range(len(self._shown)) if other not in moved_so_far]
            self._add_contents(costs, moved, bits, lying)
            moved_so_far.add(token)
        return cheapest_assignment(costs)

    def _add_contents(
        self,
        costs: Counts,
        moved: int,
        bits: int,
        lying: list[int],
    ) -> None:
        """Add what the tokens that are still in storage make hold before this move."""
        offsets, pattern = self._vocabulary.offsets, self._vocabulary.patterns(moved)
        for place, cell in enumerate(self._plays.board.storage_cells):
            if bits and cell in offsets:
                block = bits >> offsets[cell]
                for token in lying:
                    costs[token, place] += (block & pattern[self._shown[token]]).bit_count()


def _for_each(count: Callable[..., int], *columns: Counts) -> Counts:
    """`count` of each row of these columns; rows that are equal are counted once."""
    sizes = [int(column.max(initial=0)) + 1 for column in columns]
    keys = np.ravel_multi_index(list(columns), sizes)
    different, which = np.unique(keys, return_inverse=True)
    rows = zip(*(part.tolist() for part in np.unravel_index(different, sizes)), strict=True)
    counts = np.array([count(*row) for row in rows], np.int64)
    return counts[which]
