"""Is this move right here, and if not, why; which moves are; may the play end."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias

from maestra.core.faults import Fault, InvalidError
from maestra.core.state import IllegalMoveError, Move
from maestra.rules.completion import Completion, Prospect
from maestra.rules.strips import Action

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from maestra.core.board import Cell
    from maestra.core.state import State
    from maestra.core.tokens import Deck, TokenId
    from maestra.rules.exercise import GroundedExercise
    from maestra.rules.literals import Literal


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


Refused: TypeAlias = NotShown | BrokenPrecondition | DeadEnd | AfterTheEnd
Verdict: TypeAlias = Allowed | Refused


@dataclass(frozen=True, slots=True)
class JudgedMove:
    """A move of a play, what was on the board before it, and what is to be said of it."""

    before: State
    move: Move
    verdict: Verdict


class Judge:
    """Judges plays of one exercise with one deck; what it works out once serves every move.

    Raises:
        InvalidError: a token of the deck shows what no token of the exercise's deck does.
    """

    def __init__(self, exercise: GroundedExercise, deck: Deck) -> None:
        """Prepare for plays of `exercise` with the tokens of `deck`."""
        self.exercise = exercise
        self.deck = deck
        self._model = exercise.model
        self._indices = self._model.vocabulary.indices(deck)
        self._completion = Completion(self._model, exercise.lengths, deck)

    def verdict(self, state: State, made: int, move: Move) -> Verdict:
        """Whether `move` is right in `state`, after `made` moves; if not, why.

        Raises:
            IllegalMoveError: no board could make this move.
            InvalidError: another board than the exercise's.
        """
        self._check_board(state)
        after = state.after(move)
        action = Action(self.deck.by_id[move.token].attributes, made + 1)
        if made + 1 > self._last:
            return AfterTheEnd(action)
        if action not in self._model.preconditions:
            return NotShown(action)
        watched = self._model.vocabulary.watched
        lying = {cell: self._indices[state.tokens[cell]] for cell in watched if cell in state.tokens}
        broken = self._model.broken(action, lying, move.origin, move.destination)
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
        contents = self._contents(state)
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
        written down either way, with the token on its old cell again or still where it was
        refused; both are read as the board stands after the putting back.

        Raises:
            IllegalMoveError: no board could make a move; its place is in the faults.
            InvalidError: another board than the exercise's.
        """
        state, made = start, 0
        refused: dict[TokenId, Cell] = {}
        judged: list[JudgedMove] = []
        for index, written in enumerate(moves):
            put_back = refused.get(written.token) == written.origin
            actual = replace(written, origin=state.cells[written.token]) if put_back else written
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
                refused[actual.token] = actual.destination
        return tuple(judged)

    def _contents(self, state: State) -> dict[Cell, int]:
        return {cell: self._indices[token] for token, cell in state.cells.items()}

    @cached_property
    def _last(self) -> int:
        return max(self.exercise.lengths)

    def _check_board(self, state: State) -> None:
        board = self.exercise.model.vocabulary.board
        if state.board != board:
            found = f"{state.board.rows} x {state.board.columns}"
            expected = f"the exercise's, {board.rows} x {board.columns}, goal row {board.goal_row}"
            raise InvalidError([Fault("board", found, expected)])
