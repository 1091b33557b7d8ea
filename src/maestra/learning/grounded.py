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
from typing import TYPE_CHECKING

from maestra.core.faults import Fault, InvalidError
from maestra.rules.decks import merge_decks
from maestra.rules.exercise import Deletion, GroundedExercise, Provenance
from maestra.rules.features import select_features
from maestra.rules.strips import Action, ActionModel
from maestra.rules.vocabulary import Level, Vocabulary

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from maestra.core.board import Cell
    from maestra.core.demonstration import Demonstration
    from maestra.core.tokens import Deck, TokenId


@dataclass(frozen=True, slots=True)
class Observation:
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
        self._lengths: set[int] = set()
        self._shown = 0
        self._indices: tuple[Deck, Mapping[TokenId, int]] = (
            vocabulary.deck,
            vocabulary.index_of_token,
        )

    def show(self, demonstration: Demonstration) -> None:
        """Relax the preconditions just so much that they explain `demonstration` too.

        Raises:
            InvalidError: another board, or a token that shows what no token of the vocabulary's
                deck does; nothing has been learned from it then.
        """
        observations = list(self.observe(demonstration))
        self._shown += 1
        self._lengths.add(len(observations))
        for seen in observations:
            key = (seen.moved, seen.step)
            record = self._records.get(key)
            if record is None:
                record = self._records[key] = _Record(self.vocabulary.everything)
            deleted = record.precondition & ~seen.holding
            if deleted:
                record.deletions.append(Deletion(self._shown, deleted))
                record.precondition ^= deleted
            record.seen += 1

    def observe(self, demonstration: Demonstration) -> Iterator[Observation]:
        """Each move of `demonstration` with the literals that held before it.

        Raises:
            InvalidError: as `show`.
        """
        vocabulary = self.vocabulary
        if demonstration.board != vocabulary.board:
            raise InvalidError([Fault("board", "another board", "the board of the others")])
        indices = self._indices_of(demonstration.deck)
        offsets = vocabulary.offsets
        contents: dict[Cell, int] = {
            cell: indices[token]
            for token, cell in demonstration.start.cells.items()
            if cell in offsets
        }
        for step, move in enumerate(demonstration.moves, start=1):
            moved = indices[move.token]
            row = vocabulary.patterns(moved)
            holding = vocabulary.placed(move.origin, move.destination)
            for cell, other in contents.items():
                holding |= row[other] << offsets[cell]
            yield Observation(moved, step, holding)
            contents.pop(move.origin, None)
            if move.destination in offsets:
                contents[move.destination] = moved

    def exercise(self) -> GroundedExercise:
        """What has been learned from the demonstrations so far."""
        shown = self.vocabulary.shown
        records = {
            Action(shown[moved], step): record
            for (moved, step), record in sorted(self._records.items(), key=_by_step)
        }
        return GroundedExercise(
            ActionModel(
                self.vocabulary,
                {action: record.precondition for action, record in records.items()},
            ),
            {
                action: Provenance(record.seen, tuple(record.deletions))
                for action, record in records.items()
            },
            frozenset(self._lengths),
            self._shown,
        )

    def _indices_of(self, deck: Deck) -> Mapping[TokenId, int]:
        """What each token shows, looked up once for plays that share a deck."""
        known, indices = self._indices
        if deck is not known and deck.tokens != known.tokens:
            indices = self.vocabulary.indices(deck)
            self._indices = (deck, indices)
        return indices


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


def _by_step(item: tuple[tuple[int, int], _Record]) -> tuple[int, int]:
    (moved, step), _ = item
    return step, moved
