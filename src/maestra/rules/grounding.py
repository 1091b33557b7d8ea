"""Rules as the paper's actions: the preconditions that their right plays leave, where these do.

A precondition says what must lie on single cells before a move. Not every rule can be said so:
a count or a sum cannot. So the right plays of the rules are listed, what all of them leave is
worked out as in `ground_truth`, and then everything that these actions accept is listed too: the
two must be the same plays. Level C is of no use: where the start is free, what lies in storage
tells nothing that the goal row does not.

Cost: the plays of the rules and of the actions; 30,240 on the paper's board if anything is right.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final

from maestra.core.board import Cell
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import Deck, TokenId
from maestra.rules.exercise import GroundedExercise, Provenance, RuledExercise
from maestra.rules.features import (
    Feature,
    UnknownFeatureError,
    feature_names,
    select_features,
)
from maestra.rules.fitting import needs_of
from maestra.rules.ground_truth import ground_truth
from maestra.rules.right_plays import Placement, Placements, RightPlays
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW
from maestra.rules.strips.actions import ActionModel
from maestra.rules.strips.vocabulary import Level, Vocabulary
from maestra.rules.summaries.accepted import is_about_sources, plays_keeping

MAX_TRIED: Final = 150_000
"""Placements looked at before it is given up: some seconds. The paper's board has 36,100 rows and
beginnings of rows, filled from the left."""
_ORIGINS: Final = (ORIGIN_ROW, ORIGIN_COLUMN)


def grounded_from(exercise: RuledExercise) -> GroundedExercise:
    """The same exercise as actions, with the smallest vocabulary that can say it.

    Raises:
        InvalidError: no preconditions say the same, or there are too many plays to be compared.
    """
    plays = _right_plays(exercise)
    few, many = select_features(exercise.deck, None), _features(exercise.deck)
    # The strictest actions decide whether there are any; then fewer literals may do.
    model = _model(exercise, plays, Level.B, many)
    if model is None:
        found = "rules that preconditions of single cells cannot say"
        raise InvalidError([Fault("rules", found, "rules about what lies beside what, or where")])
    for level, features in ((Level.A, few), (Level.A, many), (Level.B, few)):
        smaller = _model(exercise, plays, level, features)
        if smaller is not None:
            model = smaller
            break
    whole = Provenance(sum(len(group.tokens) for group in plays.groups), ())
    provenance = dict.fromkeys(model.preconditions, whole)
    return GroundedExercise(model, provenance, plays.lengths, whole.seen)


def _features(deck: Deck) -> tuple[Feature, ...]:
    """All features of the deck but those with a parameter."""
    chosen = dict.fromkeys(select_features(deck, None))
    for name in feature_names(deck):
        try:
            chosen |= dict.fromkeys(select_features(deck, [name]))
        except UnknownFeatureError:
            continue
    return tuple(chosen)


def _right_plays(exercise: RuledExercise) -> RightPlays:
    for one in exercise.rules:
        if not is_about_sources(one.rule) and _looks_at_origins(one.rule):
            found = f"{one.id}, which looks at where other tokens began"
            raise InvalidError([Fault("rules", found, "rules that each start allows alike")])
    lengths = frozenset(range(exercise.board.columns + 1))
    plays = plays_keeping(
        exercise.conjunction, exercise.board, exercise.deck, lengths, max_tried=MAX_TRIED
    )
    if plays is None:
        found = "more right plays than can be compared"
        raise InvalidError([Fault("rules", found, "rules that allow fewer, or fewer tokens")])
    ends = frozenset(group.tokens.shape[1] for group in plays.groups)
    if not ends - {0}:
        raise InvalidError([Fault("rules", "no right play", "rules that can be kept together")])
    return RightPlays(
        plays.board, plays.deck, origins=plays.origins, lengths=ends, known=plays.known
    )


def _looks_at_origins(rule: Rule) -> bool:
    return any(attribute in _ORIGINS for attribute, _ in needs_of(rule))


def _model(
    exercise: RuledExercise, plays: RightPlays, level: Level, features: tuple[Feature, ...]
) -> ActionModel | None:
    """The actions at this level, if they accept just the right plays."""
    vocabulary = Vocabulary(exercise.board, exercise.deck, level, features)
    model = ground_truth(plays, vocabulary)
    accepted = _Accepted(model, plays.lengths)
    right = {
        plays.placements(group, row) for group in plays.groups for row in range(len(group.tokens))
    }
    for tried, placements in enumerate(accepted.sequences(()), start=1):
        if placements not in right or tried > len(right):
            return None
        for step, placement in enumerate(placements, start=1):
            if accepted.origins(step, placement) != _origins(plays, step, placement):
                return None
    return model


def _origins(plays: RightPlays, step: int, placement: Placement) -> frozenset[Cell]:
    found = plays.origins(step, placement)
    return frozenset(plays.board.storage_cells) if found is None else found


@dataclass(frozen=True)
class _Accepted:
    """What a model accepts, whose preconditions look at the goal row and the move's own cells."""

    model: ActionModel
    lengths: frozenset[int]

    def sequences(self, begun: Placements) -> Iterator[Placements]:
        """Every accepted sequence of placements, some of them again where nothing ends."""
        if len(begun) in self.lengths:
            yield begun
        if len(begun) < max(self.lengths):
            for placement in self._next(begun):
                yield from self.sequences((*begun, placement))

    def _next(self, begun: Placements) -> Iterator[Placement]:
        vocabulary = self.model.vocabulary
        contents = {one.destination: vocabulary.index_of_token[one.token] for one in begun}
        step = len(begun) + 1
        for moved, tokens in self._tokens.items():
            demanded = self.model.by_step.get(step, {}).get(moved)
            if demanded is None or demanded & ~vocabulary.lying(contents, moved) & ~self._of_move:
                continue
            for cell in vocabulary.board.goal_cells:
                if cell in contents:
                    continue
                for token in tokens:
                    placement = Placement(token, cell)
                    if all(one.token != token for one in begun) and self.origins(step, placement):
                        yield placement

    def origins(self, step: int, placement: Placement) -> frozenset[Cell]:
        """The storage cells from which the token of a placement may come."""
        vocabulary = self.model.vocabulary
        moved = vocabulary.index_of_token[placement.token]
        key = (step, moved, placement.destination)
        if key not in self._known:
            demanded = self.model.by_step[step][moved] & self._of_move
            self._known[key] = frozenset(
                cell
                for cell in vocabulary.board.storage_cells
                if not demanded & ~vocabulary.placed(cell, placement.destination)
            )
        return self._known[key]

    @cached_property
    def _known(self) -> dict[tuple[int, int, Cell], frozenset[Cell]]:
        return {}

    @cached_property
    def _of_move(self) -> int:
        return (1 << self.model.vocabulary.placed_size) - 1

    @cached_property
    def _tokens(self) -> dict[int, list[TokenId]]:
        """What can be shown, each with the tokens that show it."""
        tokens: dict[int, list[TokenId]] = {}
        for token, moved in self.model.vocabulary.index_of_token.items():
            tokens.setdefault(moved, []).append(token)
        return tokens
