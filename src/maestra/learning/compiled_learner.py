"""The learner `compiled`: from demonstrations to an exercise, by a planner, as in the paper.

What held before each move is observed as in `grounded`; which literals to delete is left to the
planner. The preconditions are the same; this learner is slower by two to three orders of
magnitude and there for comparison, audit and the paper's sake.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from maestra.learning.compiled import (
    ActionName,
    CompiledReport,
    DeletionTask,
    LiteralName,
    Transition,
    solve_compiled,
)
from maestra.learning.grounded import GroundedLearner, Observation, vocabulary_for
from maestra.rules.exercise import Deletion, GroundedExercise, Provenance
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.literals import formula
from maestra.rules.strips.vocabulary import Level, positions

if TYPE_CHECKING:
    from maestra.core.demonstration import Demonstration
    from maestra.learning.planning import Limits, Planner, Unsolved
    from maestra.rules.strips.vocabulary import Vocabulary

ActionKey: TypeAlias = tuple[int, int]
"""What the moved token shows, as an index into the vocabulary's, and the step."""


@dataclass(frozen=True, slots=True)
class CompiledLesson:
    """What was learned, and what the planner did for it."""

    exercise: GroundedExercise
    report: CompiledReport


@dataclass(frozen=True, slots=True)
class Statement:
    """Demonstrations as a deletion task, and what its names mean.

    Actions that no demonstration shows are left out: no move asks for a deletion from theirs.
    """

    vocabulary: Vocabulary
    observed: tuple[Sequence[Observation], ...]
    """What each demonstration shows, move by move."""
    task: DeletionTask
    actions: Mapping[ActionKey, ActionName]
    """Each action's name, in the order of steps."""
    literals: Mapping[ActionName, Sequence[LiteralName]]
    """For each action the names of all literals, in the order of the vocabulary's bits."""


def learn_compiled(
    demonstrations: Sequence[Demonstration],
    planner: Planner,
    limits: Limits,
    level: Level = Level.A,
    features: Sequence[str] | None = None,
    *,
    whole: bool | None = None,
) -> CompiledLesson | Unsolved:
    """The most specific preconditions that explain all `demonstrations` (at least one).

    Args:
        demonstrations: in any order.
        planner: who finds the deletions.
        limits: for the whole call; see `solve_compiled`.
        level: how much of the board preconditions may mention.
        features: the features that count; None takes the defaults.
        whole: one planning problem, or one for each action; None leaves it to the planner.

    Returns:
        The same exercise as `learn_grounded`, or why the planner found none.

    Raises:
        UnknownFeatureError: a feature that does not exist or does not apply.
        InvalidError: boards or decks that do not fit together.
        InvalidPlanError: the planner broke its contract.
    """
    statement = state(demonstrations, level, features)
    as_whole = planner.prefers_whole if whole is None else whole
    report = solve_compiled(statement.task, planner, limits, whole=as_whole)
    if not isinstance(report, CompiledReport):
        return report
    return CompiledLesson(_exercise(statement, report), report)


def state(
    demonstrations: Sequence[Demonstration],
    level: Level = Level.A,
    features: Sequence[str] | None = None,
) -> Statement:
    """`demonstrations` (at least one) as a deletion task; `compiled_pddl` writes it for audit.

    Raises:
        UnknownFeatureError: a feature that does not exist or does not apply.
        InvalidError: boards or decks that do not fit together.
    """
    vocabulary = vocabulary_for(demonstrations, level, features)
    learner = GroundedLearner(vocabulary)
    observed = tuple(learner.observe(demonstration) for demonstration in demonstrations)
    actions = _action_names(vocabulary, observed)
    literals = {name: _literal_names(vocabulary, moved) for (moved, _), name in actions.items()}
    task = DeletionTask(
        {name: frozenset(of_action) for name, of_action in literals.items()},
        tuple(
            tuple(_transition(vocabulary, seen, actions, literals) for seen in moves)
            for moves in observed
        ),
    )
    return Statement(vocabulary, observed, task, actions, literals)


def _transition(
    vocabulary: Vocabulary,
    seen: Observation,
    actions: Mapping[ActionKey, ActionName],
    literals: Mapping[ActionName, Sequence[LiteralName]],
) -> Transition:
    action = actions[seen.moved, seen.step]
    names = literals[action]
    false = vocabulary.everything & ~seen.holding
    return Transition(action, frozenset(names[place] for place in positions(false)))


def _action_names(
    vocabulary: Vocabulary, observed: Iterable[Sequence[Observation]]
) -> dict[ActionKey, ActionName]:
    keys = sorted(
        {(seen.moved, seen.step) for moves in observed for seen in moves},
        key=lambda key: (key[1], key[0]),
    )
    names = _distinct(Action(vocabulary.shown[moved], step).name for moved, step in keys)
    return {key: ActionName(name) for key, name in zip(keys, names, strict=True)}


def _literal_names(vocabulary: Vocabulary, moved: int) -> tuple[LiteralName, ...]:
    shown = vocabulary.shown[moved]
    formulas = (formula(literal, shown) for literal in vocabulary.literals)
    return tuple(LiteralName(name) for name in _distinct(formulas))


def _distinct(names: Iterable[str]) -> list[str]:
    """`names` with primes where one would be there twice; formulas do not tell all apart."""
    distinct: dict[str, None] = {}
    for name in names:
        primed = name
        while primed in distinct:
            primed += "'"
        distinct[primed] = None
    return list(distinct)


def _exercise(statement: Statement, report: CompiledReport) -> GroundedExercise:
    vocabulary = statement.vocabulary
    deleted: dict[ActionKey, int] = {}
    for key, name in statement.actions.items():
        gone = report.deletions[name]
        places = enumerate(statement.literals[name])
        deleted[key] = sum(1 << place for place, literal in places if literal in gone)
    actions = {key: Action(vocabulary.shown[key[0]], key[1]) for key in statement.actions}
    provenance = _provenance(statement.observed, deleted)
    return GroundedExercise(
        ActionModel(
            vocabulary,
            {action: vocabulary.everything ^ deleted[key] for key, action in actions.items()},
        ),
        {action: provenance[key] for key, action in actions.items()},
        frozenset(map(len, statement.observed)),
        len(statement.observed),
    )


def _provenance(
    observed: Sequence[Sequence[Observation]], deleted: Mapping[ActionKey, int]
) -> Mapping[ActionKey, Provenance]:
    """Each deletion laid to the first demonstration that asks for it; plans have no order."""
    left = dict(deleted)
    seen = dict.fromkeys(deleted, 0)
    deletions: dict[ActionKey, list[Deletion]] = {key: [] for key in deleted}
    for number, moves in enumerate(observed, start=1):
        for moved, step, holding in moves:
            key = (moved, step)
            seen[key] += 1
            if asked := left[key] & ~holding:
                deletions[key].append(Deletion(number, asked))
                left[key] ^= asked
    return {key: Provenance(seen[key], tuple(deletions[key])) for key in deleted}
