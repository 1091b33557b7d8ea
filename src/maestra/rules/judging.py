"""Is this move right here, and if not, why; which moves are; may the play end.

One judge for exercises of either kind: `grounded_judging` and `ruled_judging` say what is right.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from maestra.core.state import IllegalMoveError, Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.rules.exercise import Exercise, GroundedExercise
from maestra.rules.grounded_judging import GroundedJudge
from maestra.rules.position import Position
from maestra.rules.ruled_judging import RuledJudge
from maestra.rules.verdicts import (
    Allowed,
    JudgedMove,
    PutBack,
    Refused,
    RulesKept,
    Verdict,
)


class Judge:
    """Judges plays of one exercise with one deck; what it works out once serves every move."""

    def __init__(self, exercise: Exercise, deck: Deck) -> None:
        """Prepare for plays of `exercise` with just the tokens of `deck`.

        Raises:
            InvalidError: a token of the deck shows what an exercise made of actions does not
                know, or rules ask for what the deck does not have.
        """
        self.exercise = exercise
        self.deck = deck
        self._by: GroundedJudge | RuledJudge = (
            GroundedJudge(exercise, deck)
            if isinstance(exercise, GroundedExercise)
            else RuledJudge(exercise, deck)
        )

    def verdict(self, position: Position, move: Move) -> Verdict:
        """Whether `move` is right here; if not, why.

        A move after which the search for a completion was given up is allowed.

        Raises:
            IllegalMoveError: no board could make this move.
            InvalidError: a board on which the exercise cannot be played.
        """
        if isinstance(self._by, GroundedJudge):
            return self._by.verdict(position.now, len(position.moves), move)
        return self._by.verdict(position, move)

    def allowed_moves(self, position: Position) -> Iterator[Move]:
        """Every move that is right here.

        Raises:
            InvalidError: a board on which the exercise cannot be played.
        """
        if isinstance(self._by, GroundedJudge):
            return self._by.allowed_moves(position.now, len(position.moves))
        return self._by.allowed_moves(position)

    def may_end(self, position: Position) -> bool:
        """Whether the exercise may end here.

        Raises:
            InvalidError: a board on which the exercise cannot be played.
        """
        if isinstance(self._by, GroundedJudge):
            return self._by.may_end(len(position.moves))
        return self._by.may_end(position)

    def judge(self, start: State, moves: Sequence[Move]) -> tuple[JudgedMove, ...]:
        """Each of the `moves` played from `start`, with its verdict.

        A refused move is put back, and the next one is judged without it. A play may have been
        written down in three ways, with the token on its old cell again, still where it was
        refused, or moved back by a move of its own; all are read as the board stands after the
        putting back.

        Raises:
            IllegalMoveError: no board could make a move; its place is in the faults.
            InvalidError: a board on which the exercise cannot be played.
        """
        return self.read(start, moves)[0]

    def read(self, start: State, moves: Sequence[Move]) -> tuple[tuple[JudgedMove, ...], Position]:
        """As `judge`, and the position that the right moves lead to."""
        self._by.check_board(start)
        position = Position.begin(start)
        refused: dict[TokenId, tuple[Move, Refused]] = {}
        judged: list[JudgedMove] = []
        for index, written in enumerate(moves):
            wrong = refused.get(written.token)
            away = wrong is not None and wrong[0].destination == written.origin
            if wrong is not None and away and written.destination == wrong[0].origin:
                judged.append(JudgedMove(position.now, written, PutBack(wrong[1])))
                del refused[written.token]
                continue
            origin = position.now.cells[written.token] if away else written.origin
            actual = replace(written, origin=origin)
            verdict = self._said(position, actual, index)
            judged.append(JudgedMove(position.now, actual, verdict))
            if isinstance(verdict, Allowed | RulesKept):
                position = position.after(actual)
                refused.pop(actual.token, None)
            else:
                refused[actual.token] = actual, verdict
        return tuple(judged), position

    def _said(self, position: Position, move: Move, index: int) -> Verdict:
        try:
            return self.verdict(position, move)
        except IllegalMoveError as error:
            place = f"moves[{index}]"
            raise IllegalMoveError([fault.under(place) for fault in error.faults]) from None
