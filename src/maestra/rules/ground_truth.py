"""The preconditions that all right plays of an exercise together leave: what can be learned of it.

A literal stays for an action unless some right play makes it false before that action. A literal
is about one cell or about the move's own two, so it is enough to know, for each action and cell,
everything that can lie there: no start arrangement is enumerated and none is drawn. On a storage
cell may lie

- the token of this or a later step, if it may begin there;
- any token that is never moved, if the moved ones can all begin elsewhere;
- nothing, if a token that was moved before may have begun there, or if there are more storage
  cells than tokens and the moved ones can all begin elsewhere.

Cost: right sequences x moves x goal cells, vectorised, and the square of the tokens for each
watched cell.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from maestra.core.faults import Fault, refuse
from maestra.rules.strips.actions import Action, ActionModel

if TYPE_CHECKING:
    from collections.abc import Iterator

    from maestra.core.board import Cell
    from maestra.rules.arrangements import Arrangements
    from maestra.rules.right_plays import PlayGroup, RightPlays
    from maestra.rules.strips.vocabulary import Vocabulary

    Indices = np.ndarray[tuple[int, ...], np.dtype[np.intp]]
    Flags = np.ndarray[tuple[int, ...], np.dtype[np.bool_]]


def ground_truth(plays: RightPlays, vocabulary: Vocabulary) -> ActionModel:
    """For each action of a right play the literals that no right play makes false before it.

    Raises:
        InvalidError: the plays are on another board than the vocabulary's, or with tokens that
            show what none of its deck does.
        TooManyPlaysError: the right sequences cannot be enumerated.
    """
    if plays.board != vocabulary.board:
        refuse([Fault("board", "another board", "the vocabulary's")])
    steps: dict[int, _Step] = {}
    for group in plays.groups:
        for step, contexts in enumerate(_contexts(plays, vocabulary, group), start=1):
            known = steps.setdefault(step, contexts)
            if known is not contexts:
                known.merge(contexts)
    preconditions = {
        Action(vocabulary.shown[moved], step): _left(vocabulary, contexts, moved)
        for step, contexts in sorted(steps.items())
        for moved in sorted(contexts.placed)
    }
    return ActionModel(vocabulary, preconditions)


@dataclass(slots=True)
class _Step:
    """What can be the case before the moves of one step."""

    placed: dict[int, int]
    """For each thing moved, the literals about origin and destination that hold in all plays."""
    contents: dict[Cell, Flags] = field(default_factory=dict["Cell", "Flags"])
    """For each watched cell: [moved, other], whether `other` can lie there; last: nothing."""

    def merge(self, other: _Step) -> None:
        """Take in what can be the case in further plays."""
        for moved, bits in other.placed.items():
            self.placed[moved] = self.placed.get(moved, bits) & bits
        for cell, flags in other.contents.items():
            self.contents[cell] |= flags


def _left(vocabulary: Vocabulary, contexts: _Step, moved: int) -> int:
    """The precondition's bits: those that hold whatever can be the case."""
    bits = contexts.placed[moved]
    row = (*vocabulary.patterns(moved), 0)
    for cell, flags in contexts.contents.items():
        block = ~0
        for other in np.flatnonzero(flags[moved]):
            block &= row[other]
        bits |= block << vocabulary.offsets[cell]
    return bits


def _contexts(plays: RightPlays, vocabulary: Vocabulary, group: PlayGroup) -> Iterator[_Step]:
    """What can be the case before each step of the group's plays."""
    indices = vocabulary.indices(plays.deck)
    shown = np.array([indices[token.id] for token in plays.deck.tokens], dtype=np.intp)
    tokens = group.tokens.astype(np.intp)
    destinations = group.destinations.astype(np.intp)
    nothing = len(vocabulary.shown)
    goal = np.full((len(tokens), len(plays.board.goal_cells)), nothing, dtype=np.intp)
    rows = np.arange(len(tokens))
    storage = [cell for cell in plays.board.storage_cells if cell in vocabulary.offsets]
    for step in range(tokens.shape[1]):
        moved = shown[tokens[:, step]]
        context = _Step(_placed(plays, vocabulary, group, step, moved))
        for index, cell in enumerate(plays.board.goal_cells):
            context.contents[cell] = _pairs(nothing, moved, goal[:, index])
        if storage:
            _add_storage(
                context, storage, group.arrangements, _Lying(shown, tokens, step, nothing)
            )
        yield context
        goal[rows, destinations[:, step]] = moved


def _placed(
    plays: RightPlays, vocabulary: Vocabulary, group: PlayGroup, step: int, moved: Indices
) -> dict[int, int]:
    arrangements = group.arrangements
    origins = [c for c in plays.board.storage_cells if arrangements.may_begin_at(step, c)]
    cells = plays.board.goal_cells
    placed: dict[int, int] = {}
    for shown, index in set(
        zip(moved.tolist(), group.destinations[:, step].tolist(), strict=True)
    ):
        bits = placed.get(shown, ~0)
        for origin in origins:
            bits &= vocabulary.placed(origin, cells[int(index)])
        placed[shown] = bits
    return placed


def _pairs(nothing: int, moved: Indices, others: Indices) -> Flags:
    """The table of those pairs that occur."""
    flags = np.zeros((nothing, nothing + 1), dtype=np.bool_)
    flags[moved, others] = True
    return flags


@dataclass(slots=True)
class _Lying:
    """Which tokens are still in storage before a step, for each thing moved in it."""

    shown: Indices
    tokens: Indices
    step: int
    nothing: int

    @property
    def moved(self) -> Indices:
        """What is moved in each sequence."""
        return self.shown[self.tokens[:, self.step]]

    def of_step(self, later: int) -> Flags:
        """The pairs of what is moved now and what is moved in the step `later`."""
        return _pairs(self.nothing, self.moved, self.shown[self.tokens[:, later]])

    def unmoved(self) -> Flags:
        """The pairs of what is moved now and what is never moved."""
        flags = np.zeros((self.nothing, self.nothing + 1), dtype=np.bool_)
        for index, other in enumerate(self.shown):
            absent = ~(self.tokens == index).any(axis=1)
            flags[self.moved[absent], other] = True
        return flags


def _add_storage(
    context: _Step, storage: list[Cell], arrangements: Arrangements, lying: _Lying
) -> None:
    """Add what can lie on the storage cells before the step."""
    length = lying.tokens.shape[1]
    by_step = {later: lying.of_step(later) for later in range(lying.step, length)}
    unmoved = lying.unmoved()
    for cell in storage:
        flags = np.zeros_like(unmoved)
        spared = arrangements.may_be_spared(cell)
        for later, pairs in by_step.items():
            if arrangements.may_begin_at(later, cell):
                flags |= pairs
        if spared:
            flags |= unmoved
        flags[lying.moved, -1] = (spared and arrangements.has_spare_cells) or any(
            arrangements.may_begin_at(earlier, cell) for earlier in range(lying.step)
        )
        context.contents[cell] = flags
