"""Is this move right here, and if not, why; which moves are; may the play end."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeAlias

from maestra.core.faults import Fault, InvalidError
from maestra.core.state import IllegalMoveError, Move
from maestra.rules.strips.actions import Action
from maestra.rules.strips.completion import Completion, Prospect

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from maestra.core.board import Board
    from maestra.core.state import State
    from maestra.core.tokens import Deck, TokenId
    from maestra.rules.exercise import GroundedExercise
    from maestra.rules.strips.literals import Literal


@dataclass(frozen=True, slots=True)
class Allowed:
    """The move keeps all rules, and the exercise can still be completed after it."""

    action: Action


@dataclass(frozen=True, slots=True)
class NotShown:
    """No demonstration showed such a token as this move of a play."""

    action: Action


@dataclass(frozen=True, slots=True)
class BrokenPrecondition:
    """The action's precondition does not hold here."""

    action: Action
    literals: tuple[Literal, ...]
    """Those of it that are false; at least one."""


@dataclass(frozen=True, slots=True)
class DeadEnd:
    """The move itself breaks no rule, but after it the exercise cannot be completed."""

    action: Action


@dataclass(frozen=True, slots=True)
class AfterTheEnd:
    """The play was already complete."""

    action: Action


@dataclass(frozen=True, slots=True)
class PutBack:
    """No move of the play: a refused token is moved back to where it was taken from."""

    action: Action
    """The one that was refused."""


Refused: TypeAlias = NotShown | BrokenPrecondition | DeadEnd | AfterTheEnd
Verdict: TypeAlias = Allowed | Refused
"""What `Judge.verdict` says of a move."""


@dataclass(frozen=True, slots=True)
class JudgedMove:
    """A move of a play, and what is to be said of it."""

    before: State
    """What was on the board before it, all refused tokens put back."""
    move: Move
    """With the origin where the token lies in `before`; but of `PutBack` as it was written."""
    verdict: Verdict | PutBack


class Judge:
    """Judges plays of one exercise with one deck; what it works out once serves every move."""

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

    def verdict(self, state: State, made: int, move: Move) -> Verdict:
        """Whether `move` is right in `state`, after `made` moves; if not, why.

        A move after which the search for a completion was given up is allowed.

        Raises:
            IllegalMoveError: no board could make this move.
            InvalidError: another board than the exercise's.
        """
        self._check_board(state)
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
        self._check_board(state)
        contents = {cell: self._indices[token] for token, cell in state.cells.items()}
        for origin, destination in self._model.applicable(made + 1, contents):
            move = Move(state.tokens[origin], origin, destination)
            if self._completion.prospect(state.after(move), made + 1) is not Prospect.IMPOSSIBLE:
                yield move

    def may_end(self, made: int) -> bool:
        """Whether the exercise may end after `made` right moves."""
        return made in self.exercise.lengths

    def judge(self, start: State, moves: Sequence[Move]) -> tuple[JudgedMove, ...]:
        """Each of the `moves` played from `start`, with its verdict.

        A refused move is put back, and the next one is judged without it. A play may have been
        written down in three ways, with the token on its old cell again, still where it was
        refused, or moved back by a move of its own; all are read as the board stands after the
        putting back.

        Raises:
            IllegalMoveError: no board could make a move; its place is in the faults.
            InvalidError: another board than the exercise's.
        """
        self._check_board(start)
        state, made = start, 0
        refused: dict[TokenId, JudgedMove] = {}
        judged: list[JudgedMove] = []
        for index, written in enumerate(moves):
            wrong = refused.get(written.token)
            away = wrong is not None and wrong.move.destination == written.origin
            if wrong is not None and away and written.destination == wrong.move.origin:
                judged.append(JudgedMove(state, written, PutBack(wrong.verdict.action)))
                del refused[written.token]
                continue
            actual = replace(written, origin=state.cells[written.token]) if away else written
            try:
                verdict = self.verdict(state, made, actual)
            except IllegalMoveError as error:
                place = f"moves[{index}]"
                raise IllegalMoveError([fault.under(place) for fault in error.faults]) from None
            judged.append(JudgedMove(state, actual, verdict))
            if isinstance(verdict, Allowed):
                state, made = state.after(actual), made + 1
                refused.pop(actual.token, None)
            else:
                refused[actual.token] = judged[-1]
        return tuple(judged)

    def _check_board(self, state: State) -> None:
        board = self.exercise.model.vocabulary.board
        if state.board != board:
            expected = f"the exercise's, {_describe(board)}"
            raise InvalidError([Fault("board", _describe(state.board), expected)])


def _describe(board: Board) -> str:
    return f"{board.rows} x {board.columns}, goal row {board.goal_row}"
