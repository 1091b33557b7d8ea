"""Most specific preconditions by deletion: O(moves x literals / 64), any order of demonstrations.

At first the precondition of each action holds every literal of the vocabulary, so that nothing
is applicable; each demonstrated move deletes those that were false before it. What is left is
the most specific precondition that explains all demonstrations. The paper [1, section 3.3] poses
this as planning; `compiled` does so and finds the same.

If the true precondition can be said in the vocabulary, it is a subset of what is left; so nothing
that is accepted is wrong, and more demonstrations only accept more.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from maestra.core.board import Cell, Column, Row
from maestra.core.faults import Fault, refuse
from maestra.rules.decks import merge_decks
from maestra.rules.exercise import Deletion, GroundedExercise, Provenance
from maestra.rules.features import select_features
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.vocabulary import Level, Vocabulary

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from maestra.core.demonstration import Demonstration
    from maestra.core.tokens import Deck, TokenId


class Observation(NamedTuple):
    """One demonstrated move as the learner sees it."""

    moved: int
    """What the token shows, as an index into the vocabulary's."""
    step: int
    holding: int
    """The literals that held before it, as a bit set."""


@dataclass(slots=True)
class _Record:
    """What is known of one action; grows with each demonstration that shows it."""

    precondition: int
    seen: int = 0
    deletions: list[Deletion] = field(default_factory=list[Deletion])


class GroundedLearner:
    """Learns one demonstration after another; none is kept or read again."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        """Begin with nothing shown: no action is applicable."""
        self.vocabulary = vocabulary
        self._records: dict[tuple[int, int], _Record] = {}
        """By what the moved token shows and the step."""
        self._lengths: set[int] = set()
        self._shown = 0
        self._deck, self._indices = vocabulary.deck, vocabulary.index_of_token
        board = vocabulary.board
        watched = vocabulary.watched if vocabulary.block_size else ()
        offsets = {cell: vocabulary.offsets[cell] for cell in watched}
        # By row and column, for to hash a cell takes longer than all else that is done with it.
        self._offsets = [
            [offsets.get(Cell(Row(row), Column(column))) for column in range(board.columns + 1)]
            for row in range(board.rows + 1)
        ]

    def show(self, demonstration: Demonstration) -> None:
        """Relax the preconditions just so much that they explain `demonstration` too.

        Raises:
            InvalidError: another board, or a token that shows what no token of the vocabulary's
                deck does; nothing has been learned from it then.
        """
        observed = self.observe(demonstration)
        self._shown += 1
        self._lengths.add(len(observed))
        records = self._records
        for moved, step, holding in observed:
            record = records.get((moved, step))
            if record is None:
                record = records[moved, step] = _Record(self.vocabulary.everything)
            record.seen += 1
            deleted = record.precondition & ~holding
            if deleted:
                record.deletions.append(Deletion(self._shown, deleted))
                record.precondition ^= deleted

    def observe(self, demonstration: Demonstration) -> list[Observation]:
        """Each move of `demonstration` with the literals that held before it.

        Raises:
            InvalidError: as `show`.
        """
        vocabulary, offsets = self.vocabulary, self._offsets
        start = demonstration.start
        if start.board is not vocabulary.board and start.board != vocabulary.board:
            refuse([Fault("board", "another board", "the board of the others")])
        indices = self._indices_of(demonstration.deck)
        # What lies on the watched cells, by their offsets.
        contents: dict[int, int] = {}
        for token, cell in start.cells.items():
            offset = offsets[cell.row][cell.column]
            if offset is not None:
                contents[offset] = indices[token]
        observed: list[Observation] = []
        for step, move in enumerate(demonstration.moves, start=1):
            origin, destination = move.origin, move.destination
            moved = indices[move.token]
            patterns = vocabulary.patterns(moved)
            holding = vocabulary.placed(origin, destination)
            for offset, other in contents.items():
                holding |= patterns[other] << offset
            observed.append(Observation(moved, step, holding))
            left = offsets[origin.row][origin.column]
            if left is not None:
                del contents[left]
            taken = offsets[destination.row][destination.column]
            if taken is not None:
                contents[taken] = moved
        return observed

    def exercise(self) -> GroundedExercise:
        """What has been learned from the demonstrations so far."""
        shown = self.vocabulary.shown
        by_step = sorted(self._records, key=lambda key: (key[1], key[0]))
        records = {Action(shown[key[0]], key[1]): self._records[key] for key in by_step}
        preconditions = {action: record.precondition for action, record in records.items()}
        provenance = {
            action: Provenance(record.seen, tuple(record.deletions))
            for action, record in records.items()
        }
        model = ActionModel(self.vocabulary, preconditions)
        return GroundedExercise(model, provenance, frozenset(self._lengths), self._shown)

    def _indices_of(self, deck: Deck) -> Mapping[TokenId, int]:
        """What each token shows, looked up once for plays that share a deck."""
        if deck is not self._deck and deck.tokens != self._deck.tokens:
            self._indices = self.vocabulary.indices(deck)
            self._deck = deck
        return self._indices


def learn_grounded(
    demonstrations: Sequence[Demonstration],
    level: Level = Level.A,
    features: Sequence[str] | None = None,
) -> GroundedExercise:
    """The most specific preconditions that explain all `demonstrations` (at least one).

    Args:
        demonstrations: in any order; the result does not depend on it, but for the numbers in
            its provenance.
        level: how much of the board preconditions may mention.
        features: the features that count; None takes the defaults.

    Raises:
        UnknownFeatureError: a feature that does not exist or does not apply.
        InvalidError: boards or decks that do not fit together.
    """
    learner = GroundedLearner(vocabulary_for(demonstrations, level, features))
    for demonstration in demonstrations:
        learner.show(demonstration)
    return learner.exercise()


def vocabulary_for(
    demonstrations: Sequence[Demonstration],
    level: Level = Level.A,
    features: Sequence[str] | None = None,
) -> Vocabulary:
    """The vocabulary over everything that tokens show in `demonstrations` (at least one).

    Raises:
        UnknownFeatureError: a feature that does not exist or does not apply.
        InvalidError: decks that do not fit together.
    """
    deck = merge_decks([demonstration.deck for demonstration in demonstrations])
    board = demonstrations[0].board
    return Vocabulary(board, deck, level, select_features(deck, features))
