"""macq's OBSERVER, a learner that is not ours, finds the preconditions that `grounded` finds.

OBSERVER [1] intersects the states that each action was seen in. It is given the demonstrations
as it wants them: before each move a state of named fluents, one for each literal that holds
then, found here from what a literal means and not from the bits that `grounded` counts with.

[1] Wang, Learning by observation and practice: an incremental approach for planning operator
acquisition, ICML 1995, as implemented in macq.extract.observer.
"""

import re
from collections.abc import Sequence
from typing import assert_never

from hypothesis import given, settings
from hypothesis import strategies as st
from macq.extract import Extract, modes
from macq.observation import IdentityObservation
from macq.trace import Action, Fluent, PlanningObject, State, Step, Trace, TraceList

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move
from maestra.core.state import State as Layout
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import GroundedLearner, vocabulary_for
from maestra.rules.features import pair_feature_holds, token_feature_holds
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows
from maestra.rules.strips.vocabulary import Level, Vocabulary

BOARD = Board(3, 3, Row(1))
DECK = Deck(
    tuple(
        Token(TokenId(f"T{value}"), (("value", value), ("letter", letter)))
        for value, letter in ((19, "C"), (23, "U"), (32, "R"), (34, "I"))
    )
)
STORAGE = tuple(cell for cell in BOARD.cells if cell.row != BOARD.goal_row)


@st.composite
def plays(draw: st.DrawFn) -> Demonstration:
    """Any tokens, from any storage cells, to any cells of the goal row."""
    tokens = draw(st.permutations([token.id for token in DECK.tokens]))
    lying = dict(zip(tokens, draw(st.permutations(STORAGE)), strict=False))
    columns = draw(st.permutations([Column(1), Column(2), Column(3)]))
    count = draw(st.integers(1, len(columns)))
    moves = tuple(
        Move(token, lying[token], Cell(BOARD.goal_row, column))
        for token, column in zip(tokens[:count], columns, strict=False)
    )
    return Demonstration(DECK, Layout(BOARD, lying), moves)


def holds(literal: Literal, layout: Layout, move: Move) -> bool:
    """Whether `literal` holds before `move`, read off its definition."""
    shown = {token.id: token.attributes for token in DECK.tokens}
    moved = shown[move.token]
    there = {cell: shown[token] for token, cell in layout.cells.items()}
    match literal:
        case Placed(feature, value):
            return feature.of(BOARD, move.origin, move.destination) == value
        case Related(cell, feature, converse):
            if cell not in there:
                return False
            pair = (moved, there[cell]) if converse else (there[cell], moved)
            return pair_feature_holds(feature, DECK, *pair)
        case Shows(cell, feature):
            return cell in there and token_feature_holds(feature, there[cell])
        case Contains(cell, attributes):
            return there.get(cell) == attributes
        case _:
            assert_never(literal)


def observed(play: Demonstration, vocabulary: Vocabulary) -> Trace:
    """`play` as macq records one, ending in a state that nothing is done in."""
    steps: list[Step] = []
    layout = play.start
    for number, move in enumerate(play.moves, start=1):
        truths = [holds(literal, layout, move) for literal in vocabulary.literals]
        steps.append(Step(state(truths), Action(f"{move.token}-t{number}", []), number))
        layout = layout.after(move)
    steps.append(Step(state([False] * len(vocabulary.literals)), None, len(steps) + 1))
    return Trace(steps)


def state(truths: Sequence[bool]) -> State:
    """One fluent a literal, named by its place in the vocabulary."""
    return State(
        {
            Fluent("holds", [PlanningObject("literal", f"l{place}")]): true
            for place, true in enumerate(truths)
        }
    )


def learned_by_macq(shown: Sequence[Demonstration], vocabulary: Vocabulary) -> dict[str, set[int]]:
    """For each action, the places of the literals that OBSERVER makes its precondition."""
    traces = TraceList([observed(play, vocabulary) for play in shown])
    model = Extract(traces.tokenize(IdentityObservation), modes.OBSERVER)
    return {
        action.name: {int(found) for found in re.findall(r"\bl(\d+)\b", " ".join(action.precond))}
        for action in model.actions
    }


def learned_by_us(shown: Sequence[Demonstration], vocabulary: Vocabulary) -> dict[str, set[int]]:
    """The same from `grounded`."""
    learner = GroundedLearner(vocabulary)
    for play in shown:
        learner.show(play)
    places = {literal: place for place, literal in enumerate(vocabulary.literals)}
    by_shown = {token.attributes: token.id for token in DECK.tokens}
    model = learner.exercise().model
    return {
        f"{by_shown[action.shown]}-t{action.step}": {
            places[literal] for literal in model.precondition(action)
        }
        for action in model.preconditions
    }


@settings(max_examples=200)
@given(st.lists(plays(), min_size=1, max_size=6), st.sampled_from(Level))
def test_observer_learns_the_same_preconditions(shown: list[Demonstration], level: Level) -> None:
    vocabulary = vocabulary_for(shown, level)
    assert learned_by_us(shown, vocabulary) == learned_by_macq(shown, vocabulary)
