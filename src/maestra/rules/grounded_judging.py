"""Is a move right, by the actions of an exercise; which moves are; may the play end."""

from __future__ import annotations

from collections.abc import Iterator

from maestra.core.board import Board
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.rules.exercise import GroundedExercise
from maestra.rules.strips.actions import Action
from maestra.rules.strips.completion import Completion, Prospect
from maestra.rules.verdicts import (
    AfterTheEnd,
    Allowed,
    BrokenPrecondition,
    DeadEnd,
    GroundedVerdict,
    NotShown,
)


class GroundedJudge:
    """Judges moves of one exercise with one deck; what it works out once serves every move.

    Preconditions look at what lies where and at how many moves were made, not at how it came.
    """

    def __init__(self, exercise: GroundedExercise, deck: Deck) -> None:
        """Prepare for plays of `exercise` with just the tokens of `deck`.

        Raises:
            InvalidError: a token of the deck shows what no token of the exercise's deck does.
        """
        self.exercise = exercise
        self.deck = deck
        self._model = exercise.model
        self._indices = self._model.vocabulary.indices(deck)
        self._completion = Completion(self._model, exercise.lengths, deck)

    def verdict(self, state: State, made: int, move: Move) -> GroundedVerdict:
        """Whether `move` is right in `state`, after `made` moves; if not, why.

        A move after which the search for a completion was given up is allowed.

        Raises:
            IllegalMoveError: no board could make this move.
            InvalidError: another board than the exercise's.
        """
        self.check_board(state)
        after = state.after(move)
        action = Action(self.deck.by_id[move.token].attributes, made + 1)
        if self.exercise.lengths and made >= max(self.exercise.lengths):
            return AfterTheEnd(action)
        if action not in self._model.preconditions:
            return NotShown(action)
        tokens = state.tokens
        watched = (cell for cell in self._model.vocabulary.watched if cell in tokens)
        contents = {cell: self._indices[tokens[cell]] for cell in watched}
        broken = self._model.broken(action, contents, move.origin, move.destination)
        if broken:
            return BrokenPrecondition(action, broken)
        if self._completion.prospect(after, made + 1) is Prospect.IMPOSSIBLE:
            return DeadEnd(action)
        return Allowed(action)

    def allowed_moves(self, state: State, made: int) -> Iterator[Move]:
        """Every move that is right in `state`, after `made` moves.

        Raises:
            InvalidError: another board than the exercise's.
        """
        self.check_board(state)
        contents = {cell: self._indices[token] for token, cell in state.cells.items()}
        for origin, destination in self._model.applicable(made + 1, contents):
            move = Move(state.tokens[origin], origin, destination)
            if self._completion.prospect(state.after(move), made + 1) is not Prospect.IMPOSSIBLE:
                yield move

    def may_end(self, made: int) -> bool:
        """Whether the exercise may end after `made` right moves."""
        return made in self.exercise.lengths

    def check_board(self, state: State) -> None:
        """Refuse to judge on another board.

        Raises:
            InvalidError: it is not the exercise's.
        """
        board = self._model.vocabulary.board
        if state.board != board:
            expected = f"the exercise's, {_describe(board)}"
            raise InvalidError([Fault("board", _describe(state.board), expected)])


def _describe(board: Board) -> str:
    return f"{board.rows} x {board.columns}, goal row {board.goal_row}"
