"""A learned exercise as PDDL: what planners and other programs for action models read.

The domain has one action for each token and step, as the paper's Fig. 4 shows them: two cells as
parameters, the learned precondition, the effects of any pick-and-place. What the figure leaves
out stands as propositions: ``(now t2)`` keeps the steps in their order, and the relations between
tokens and the properties of cells are static facts. A plan is a right play.

Tokens that show the same are one object, for no rule can tell them apart; `plan_moves` finds the
token on the cell. The library `pddl` writes the texts; it is slow to load, so only then.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Final, assert_never

from maestra.core.board import Cell
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import Move, State
from maestra.learning.planning_pddl import safe_names
from maestra.rules.features import pair_feature_holds, token_feature_holds
from maestra.rules.strips.literals import Contains, Placed, Related, Shows, symbol

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from pddl.action import Action as PddlAction
    from pddl.core import Domain, Problem
    from pddl.logic.base import Formula
    from pddl.logic.predicates import Predicate
    from pddl.logic.terms import Constant, Term

    from maestra.core.demonstration import Demonstration
    from maestra.core.tokens import Attributes
    from maestra.rules.exercise import GroundedExercise
    from maestra.rules.strips.actions import Action
    from maestra.rules.strips.literals import Literal

_TYPES: Final = ("cell", "token", "step", "object")
_PREDICATES: Final = ("now", "contains", "empty", "goal", "storage", "same-column")
"""Those that speak of the play and the board, besides one for each row and column."""


@dataclass(frozen=True, slots=True)
class ExercisePddl:
    """The two texts, and what the names in them stand for."""

    domain: str
    problem: str
    cells: Mapping[str, Cell]
    actions: Mapping[str, Action]


def exercise_pddl(
    exercise: GroundedExercise, position: Demonstration | None = None
) -> ExercisePddl:
    """The exercise as a domain, and completing a play of it as a problem.

    Args:
        exercise: what was learned.
        position: the play to complete; None deals the exercise's own tokens into the storage
            cells row by row and asks for a whole play.

    Raises:
        InvalidError: the position is on another board, has a token that the exercise does not
            know, or as many moves as no play can have; or, without a position, the storage rows
            have no room for all tokens.
    """
    names = _Names.of(exercise)
    lying, made = _lying(exercise, position)
    if made > max(exercise.lengths):
        expected = f"at most {max(exercise.lengths)} moves"
        raise InvalidError([Fault("moves", f"{made} moves", expected)])
    writer = _Writer(exercise, names)
    domain = writer.domain()
    return ExercisePddl(
        f"{domain}\n",
        f"{writer.problem(domain, lying, made + 1)}\n",
        {name: cell for cell, name in names.cells.items()},
        {name: action for action, name in names.actions.items()},
    )


def plan_moves(
    texts: ExercisePddl, start: State, plan: Sequence[Sequence[str]]
) -> tuple[Move, ...]:
    """The moves of a plan that a planner found for `texts`.

    Args:
        texts: what the planner read.
        start: the state in which the plan begins.
        plan: for each step the names of the action and of its two cells.

    Raises:
        InvalidError: a step that is no action with the cell of a token and another cell.
        IllegalMoveError: a step that no board could make.
    """
    moves: list[Move] = []
    state = start
    for number, (action, *places) in enumerate(plan, start=1):
        cells = [texts.cells.get(name) for name in places]
        match cells:
            case [Cell() as origin, Cell() as destination] if origin in state.tokens:
                moves.append(Move(state.tokens[origin], origin, destination))
            case _:
                found = " ".join((action, *places))
                expected = "an action, the cell of a token, and another cell"
                raise InvalidError([Fault(f"step {number}", found, expected)])
        state = state.after(moves[-1])
    return tuple(moves)


def _lying(
    exercise: GroundedExercise, position: Demonstration | None
) -> tuple[dict[Cell, Attributes], int]:
    """What the token on each cell shows, and how many moves have been made."""
    board, deck = exercise.board, exercise.deck
    if position is None:
        cells = board.storage_cells
        if len(deck.tokens) > len(cells):
            found, expected = f"{len(deck.tokens)} tokens", f"a play, or at most {len(cells)}"
            raise InvalidError([Fault("tokens", found, expected)])
        dealt = zip(cells, deck.tokens, strict=False)
        return {cell: token.attributes for cell, token in dealt}, 0
    if position.board != board:
        raise InvalidError([Fault("board", "another board", "the board of the exercise")])
    exercise.model.vocabulary.indices(position.deck)
    by_id = position.deck.by_id
    lying = {cell: by_id[token].attributes for cell, token in position.end.tokens.items()}
    return lying, len(position.moves)


@dataclass(frozen=True, slots=True)
class _Names:
    """PDDL names, no two alike: domain and problem share them."""

    cells: Mapping[Cell, str]
    steps: Mapping[int, str]
    tokens: Mapping[Attributes, str]
    actions: Mapping[Action, str]
    features: Mapping[str, str]
    """Predicates by the features' labels."""

    @classmethod
    def of(cls, exercise: GroundedExercise) -> _Names:
        """Names for everything that the texts of `exercise` speak of."""
        vocabulary, board = exercise.model.vocabulary, exercise.board
        cells, shown = board.cells, vocabulary.shown
        steps = range(1, max(exercise.lengths) + 2)
        labels = [
            *(cell.name for cell in cells),
            *(f"t{step}" for step in steps),
            *(symbol(one) for one in shown),
        ]
        times = Counter(label.lower() for label in labels)
        unique = [
            label if times[label.lower()] == 1 else f"{label} {number}"
            for number, label in enumerate(labels)
        ]
        own = [*_TYPES, *_PREDICATES]
        own += [f"row-{row}" for row in range(1, board.rows + 1)]
        own += [f"column-{column}" for column in range(1, board.columns + 1)]
        labels_of_features = [
            *(feature.label for feature in vocabulary.pair_features),
            *(feature.label for feature in vocabulary.token_features),
        ]
        features = safe_names(labels_of_features, taken=own)
        # Some readers let a name be only one thing in the whole text.
        names = list(safe_names(unique, taken=[*own, *features.values()]).values())
        tokens = dict(zip(shown, names[-len(shown) :], strict=True))
        return cls(
            dict(zip(cells, names, strict=False)),
            dict(zip(steps, names[len(cells) :], strict=False)),
            tokens,
            {a: f"move-{tokens[a.shown]}-t{a.step}" for a in exercise.model.preconditions},
            features,
        )


class _Writer:
    """Domain and problem of one exercise, as the library's objects."""

    def __init__(self, exercise: GroundedExercise, names: _Names) -> None:
        """Make the constants and variables that everything refers to."""
        from pddl.logic.terms import Constant, Variable

        self._exercise = exercise
        self._vocabulary = exercise.model.vocabulary
        self._names = names
        self._cells = {cell: Constant(name, "cell") for cell, name in names.cells.items()}
        self._tokens = {shown: Constant(name, "token") for shown, name in names.tokens.items()}
        self._steps = {step: Constant(name, "step") for step, name in names.steps.items()}
        self._origin = Variable("from", ["cell"])
        self._destination = Variable("to", ["cell"])
        self._other = Variable("other", ["token"])

    def domain(self) -> Domain:
        """The actions over cells, tokens and steps."""
        from pddl.core import Domain
        from pddl.requirements import Requirements

        requirements = [
            Requirements.STRIPS,
            Requirements.TYPING,
            Requirements.EQUALITY,
            Requirements.EXISTENTIAL_PRECONDITION,
        ]
        if len(self._exercise.lengths) > 1:
            requirements.append(Requirements.DIS_PRECONDITION)
        return Domain(
            "maestra-exercise",
            requirements=requirements,
            types={"cell": None, "token": None, "step": None},
            constants=[*self._cells.values(), *self._tokens.values(), *self._steps.values()],
            predicates=self._predicates(),
            actions=[self._action(action, name) for action, name in self._names.actions.items()],
        )

    def problem(self, domain: Domain, lying: Mapping[Cell, Attributes], step: int) -> Problem:
        """Completing a play: what lies where, which step is next, and how it may end."""
        from pddl.core import Problem
        from pddl.logic.base import Or

        facts = [_predicate("now", self._steps[step])]
        for cell, constant in self._cells.items():
            if cell in lying:
                facts.append(_predicate("contains", constant, self._tokens[lying[cell]]))
            else:
                facts.append(_predicate("empty", constant))
        ends = [
            _predicate("now", self._steps[length + 1]) for length in sorted(self._exercise.lengths)
        ]
        goal = Or(*ends) if len(ends) > 1 else ends[0]
        return Problem(
            "maestra-play",
            domain=domain,
            init=[*facts, *self._facts_of_cells(), *self._facts_of_tokens()],
            goal=goal,
        )

    def _predicates(self) -> list[Predicate]:
        """Each predicate of the texts once, with typed variables."""
        from pddl.logic.terms import Variable

        cell, other_cell = Variable("c", ["cell"]), Variable("d", ["cell"])
        token, other_token = Variable("v", ["token"]), Variable("w", ["token"])
        declared = [
            _predicate("now", Variable("t", ["step"])),
            _predicate("contains", cell, token),
            _predicate("empty", cell),
            _predicate("goal", cell),
            _predicate("storage", cell),
            _predicate("same-column", cell, other_cell),
        ]
        board = self._exercise.board
        declared += [_predicate(f"row-{row}", cell) for row in range(1, board.rows + 1)]
        declared += [_predicate(f"column-{one}", cell) for one in range(1, board.columns + 1)]
        pairs = self._vocabulary.pair_features
        declared += [
            _predicate(self._names.features[one.label], token, other_token) for one in pairs
        ]
        features = self._vocabulary.token_features
        return declared + [_predicate(self._names.features[one.label], token) for one in features]

    def _facts_of_cells(self) -> Iterator[Predicate]:
        """Which row, which column, and which cells share one."""
        board = self._exercise.board
        for cell, constant in self._cells.items():
            yield _predicate("goal" if cell.row == board.goal_row else "storage", constant)
            yield _predicate(f"row-{cell.row}", constant)
            yield _predicate(f"column-{cell.column}", constant)
            for other in board.cells:
                if other.column == cell.column:
                    yield _predicate("same-column", constant, self._cells[other])

    def _facts_of_tokens(self) -> Iterator[Predicate]:
        """Their features and the relations between them."""
        deck, tokens = self._vocabulary.deck, self._tokens
        for relation in self._vocabulary.pair_features:
            name = self._names.features[relation.label]
            for one, other in product(tokens, repeat=2):
                if pair_feature_holds(relation, deck, one, other):
                    yield _predicate(name, tokens[one], tokens[other])
        for feature in self._vocabulary.token_features:
            name = self._names.features[feature.label]
            for shown, constant in tokens.items():
                if token_feature_holds(feature, shown):
                    yield _predicate(name, constant)

    def _action(self, action: Action, name: str) -> PddlAction:
        from pddl.action import Action as PddlAction
        from pddl.logic.base import And, Not

        moved = self._tokens[action.shown]
        now, after = self._steps[action.step], self._steps[action.step + 1]
        held = _predicate("contains", self._origin, moved)
        free = _predicate("empty", self._destination)
        learned = [
            self._condition(one, moved) for one in self._exercise.model.precondition(action)
        ]
        return PddlAction(
            name,
            [self._origin, self._destination],
            And(_predicate("now", now), held, free, *learned),
            And(
                Not(held),
                _predicate("contains", self._destination, moved),
                _predicate("empty", self._origin),
                Not(free),
                Not(_predicate("now", now)),
                _predicate("now", after),
            ),
        )

    def _condition(self, literal: Literal, moved: Constant) -> Formula:
        from pddl.logic.base import And, ExistsCondition

        match literal:
            case Placed():
                return self._placed(literal)
            case Contains(cell, shown):
                return _predicate("contains", self._cells[cell], self._tokens[shown])
            case Related(cell, feature, converse):
                terms = (moved, self._other) if converse else (self._other, moved)
                there = _predicate(self._names.features[feature.label], *terms)
            case Shows(cell, feature):
                there = _predicate(self._names.features[feature.label], self._other)
            case _:
                assert_never(literal)
        lies = _predicate("contains", self._cells[cell], self._other)
        return ExistsCondition(And(lies, there), [self._other])

    def _placed(self, literal: Placed) -> Formula:
        from pddl.logic.predicates import EqualTo

        name, value = literal.feature.name, literal.value
        side = self._origin if name.startswith(("origin", "from")) else self._destination
        if isinstance(value, Cell):
            return EqualTo(side, self._cells[value])
        match name:
            case "same-column":
                return _predicate("same-column", self._origin, self._destination)
            case "from-storage" | "to-goal-row":
                return _predicate(name.partition("-")[2].removesuffix("-row"), side)
            case _:
                return _predicate(f"{name.rpartition('-')[2]}-{value}", side)


def _predicate(name: str, *terms: Term) -> Predicate:
    from pddl.logic.predicates import Predicate

    return Predicate(name, *terms)
