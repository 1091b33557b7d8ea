"""The paper's exercise (ii), five numbers ascending, and a lesson that teaches it exactly."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.learning.grounded import learn_grounded
from maestra.rules.exercise import GroundedExercise
from maestra.rules.paper import NUMBER_DECK

BOARD = Board()
TOKENS = tuple(sorted(NUMBER_DECK.tokens, key=lambda token: token.attributes))
"""From the smallest number to the largest."""


def start(turned: int = 0) -> State:
    """The tokens in storage, in their order from the cell with this number on."""
    cells = (*BOARD.storage_cells[turned:], *BOARD.storage_cells[:turned])
    return State(BOARD, {token.id: cell for token, cell in zip(TOKENS, cells, strict=False)})


def moves(begin: State, chosen: Sequence[int]) -> tuple[Move, ...]:
    """The tokens of these ranks, from 0, into the goal row from the left."""
    ids = [TOKENS[rank].id for rank in chosen]
    pairs = zip(ids, BOARD.goal_cells, strict=False)
    return tuple(Move(token, begin.cells[token], goal) for token, goal in pairs)


def ascending(chosen: Sequence[int], turned: int = 0) -> Demonstration:
    """A play that puts these, in this order, into the goal row."""
    begin = start(turned)
    return Demonstration(NUMBER_DECK, begin, moves(begin, chosen))


def paper_lesson() -> list[Demonstration]:
    """Six windows of neighbouring numbers, each twice from different starts: twelve plays."""
    return [ascending(range(first, first + 5), turned) for first in range(6) for turned in (0, 7)]


def exercise_of(lesson: Sequence[Demonstration]) -> GroundedExercise:
    """What the lesson teaches."""
    return learn_grounded(lesson)
