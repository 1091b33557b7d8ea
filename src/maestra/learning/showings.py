"""How often each action must be shown, what that says of whole plays, and plays that do it.

A play shows an action at most once. What one showing settles is known from what lies in the goal
row before it and from the move's two cells; how many showings each of these two takes at least is
a covering problem of its own, and the greater number is how often the action must be shown.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np

from maestra.learning.covering import smallest_cover
from maestra.learning.telling import Open, never_seen
from maestra.rules.right_plays import PlayGroup, RightPlays
from maestra.rules.strips.vocabulary import Vocabulary

Integers: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.int64]]
Weights: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

MAX_NODES_AN_ACTION: Final = 500
"""Steps after which the showings of one action are bounded, not counted."""
ROUNDING: Final = 1e-6
"""Far above the error of a sum of weights, far below a play."""


@dataclass(frozen=True, slots=True, eq=False)
class Showings:
    """What sequences show, and how often each action must be shown."""

    sequences: Integers
    """One row for each right sequence: the actions it shows; the number of actions at the end of
    the shorter ones."""
    places: tuple[tuple[int, int], ...]
    """Where each sequence is found: its group and its row there."""
    needed: Integers
    """For each action how often it must be shown at least."""
    lower_bound: int
    """How many plays it takes at least to show all actions so often."""

    def covers(self, max_rows: int) -> Iterator[tuple[tuple[int, int], ...]]:
        """Choices of `lower_bound` sequences, by their places, that show all so often.

        Depth first, on the action that the fewest sequences can still show without showing more
        in vain than the number of plays allows; ends once `max_rows` sequences were looked at.
        """
        budget = [max_rows]
        # One entry more, so that the filling of shorter sequences has its place.
        left = np.append(self.needed, 0)
        for chosen in self._complete(left, self.lower_bound, budget):
            yield tuple(self.places[index] for index in chosen)

    def _complete(self, left: Integers, plays: int, budget: list[int]) -> Iterator[list[int]]:
        if not left.any():
            # What is over repeats any sequence: the starts may still settle something.
            yield [0] * plays
            return
        budget[0] -= len(self.sequences)
        if budget[0] < 0:
            return
        useful = (left[self.sequences] > 0).sum(axis=1)
        spare = plays * self.sequences.shape[1] - int(left.sum())
        usable = np.flatnonzero(useful >= max(1, self.sequences.shape[1] - spare))
        counts = np.bincount(self.sequences[usable].ravel(), minlength=len(left))
        open_actions = np.flatnonzero(left)
        rarest = open_actions[np.argmin(counts[open_actions])]
        showing = usable[(self.sequences[usable] == rarest).any(axis=1)]
        for index in showing[np.argsort(-useful[showing], kind="stable")]:
            rest = left.copy()
            rest[self.sequences[index]] = np.maximum(rest[self.sequences[index]] - 1, 0)
            for chosen in self._complete(rest, plays - 1, budget):
                yield [int(index), *chosen]


def count_showings(plays: RightPlays, vocabulary: Vocabulary, needed: Open) -> Showings:
    """How often the plays must show each action of `needed` to settle all of its literals."""
    number = {key: index for index, key in enumerate(needed)}
    indices = vocabulary.indices(plays.deck)
    shown = [indices[token.id] for token in plays.deck.tokens]
    longest = max((group.tokens.shape[1] for group in plays.groups), default=0)
    rows: list[list[int]] = []
    places: list[tuple[int, int]] = []
    for index, group in enumerate(plays.groups):
        for row in range(len(group.tokens)):
            steps = enumerate(group.sequences[row], start=1)
            actions = [number[shown[token], step] for step, (token, _) in steps]
            rows.append(actions + [len(number)] * (longest - len(actions)))
            places.append((index, row))
    times = _showings_of_each(plays, vocabulary, needed, shown)
    sequences = np.array(rows, np.int64).reshape(len(rows), longest)
    bound = _weighted_count(sequences, times)
    return Showings(sequences, tuple(places), times, bound)


def _showings_of_each(
    plays: RightPlays, vocabulary: Vocabulary, needed: Open, shown: list[int]
) -> Integers:
    """For each action how often it must be shown at least."""
    by_goal_row: dict[tuple[int, int], set[int]] = {}
    by_cells: dict[tuple[int, int], set[int]] = {}
    for group in plays.groups:
        for key, holding in _goal_rows(plays, vocabulary, group, shown):
            by_goal_row.setdefault(key, set()).add(needed[key] & ~holding)
        for key, holding in _cells(plays, vocabulary, group, shown):
            by_cells.setdefault(key, set()).add(needed[key] & ~holding)
    places = vocabulary.offsets
    goal = sum(((1 << _block(vocabulary)) - 1) << places[c] for c in plays.board.goal_cells)
    cells = (1 << min(places.values())) - 1
    seen = never_seen(vocabulary)
    return np.array(
        [
            max(
                _times([bits & (goal | seen) for bits in by_goal_row[key]]),
                _times([bits & (cells | seen) for bits in by_cells[key]]),
            )
            for key in needed
        ],
        np.int64,
    )


def _times(settled: list[int]) -> int:
    return smallest_cover(settled, MAX_NODES_AN_ACTION, at_least=1).lower_bound


def _block(vocabulary: Vocabulary) -> int:
    """How many literals there are about the content of one cell."""
    places = sorted(vocabulary.offsets.values())
    return never_seen(vocabulary).bit_length() - 1 - places[-1]


def _goal_rows(
    plays: RightPlays, vocabulary: Vocabulary, group: PlayGroup, shown: list[int]
) -> Iterator[tuple[tuple[int, int], int]]:
    """Each action with each set of literals about the goal row that can hold before it."""
    offsets = [vocabulary.offsets[cell] for cell in plays.board.goal_cells]
    seen: set[tuple[int, frozenset[tuple[int, int]]]] = set()
    for row in range(len(group.tokens)):
        lying: frozenset[tuple[int, int]] = frozenset()
        for step, (token, cell) in enumerate(group.sequences[row], start=1):
            moved = shown[token]
            if (moved, lying) not in seen:
                seen.add((moved, lying))
                pattern = vocabulary.patterns(moved)
                yield (moved, step), sum(pattern[other] << offsets[at] for other, at in lying)
            lying |= {(moved, cell)}


def _cells(
    plays: RightPlays, vocabulary: Vocabulary, group: PlayGroup, shown: list[int]
) -> Iterator[tuple[tuple[int, int], int]]:
    """Each action with each set of literals about the move's cells that can hold."""
    goal, storage = plays.board.goal_cells, plays.board.storage_cells
    for step in range(group.tokens.shape[1]):
        origins = [cell for cell in storage if group.arrangements.may_begin_at(step, cell)]
        pairs = zip(group.tokens[:, step], group.destinations[:, step], strict=True)
        for token, cell in {(int(token), int(cell)) for token, cell in pairs}:
            for origin in origins:
                yield (shown[token], step + 1), vocabulary.placed(origin, goal[cell])


def _weighted_count(sequences: Integers, times: Integers) -> int:
    """The bound by weights: equal shares of the longest play that shows an action, then raised."""
    if not len(times):
        return 0
    lengths = (sequences < len(times)).sum(axis=1)
    weights: Weights = np.zeros(len(times) + 1)
    shows = [np.flatnonzero((sequences == action).any(axis=1)) for action in range(len(times))]
    for action, rows in enumerate(shows):
        weights[action] = 1 / lengths[rows].max()
    for action in sorted(range(len(times)), key=lambda one: len(shows[one])):
        weights[action] += 1 - weights[sequences[shows[action]]].sum(axis=1).max()
    counted = math.ceil(float(weights[:-1] @ times) - ROUNDING)
    return max(counted, int(times.max()))
