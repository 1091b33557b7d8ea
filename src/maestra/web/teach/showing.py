"""A demonstration while it is being played: where the tokens were dealt, and what was touched.

A token put into the goal row is a move; one taken out of it again takes its move back; one moved
about in storage is another start. So the start and the moves follow from the touches, and the last
touch can always be undone.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final

from maestra.core.board import Board, Cell
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, TokenId
from maestra.learning.chance import shuffled

MAX_TOUCHES: Final = 1_000
"""Of one demonstration: a row has five cells, and whoever hesitates for an hour has fewer."""


@dataclass(frozen=True, slots=True)
class Touch:
    """A token was put on a cell."""

    token: TokenId
    cell: Cell


class CannotTouchError(ValueError):
    """The token cannot be put there."""


@dataclass(frozen=True, slots=True)
class _Row:
    """What the touches come to."""

    start: State
    moves: tuple[Move, ...]
    now: State

    def touched(self, touch: Touch) -> _Row:
        """The same after one more.

        Raises:
            CannotTouchError: the cell is taken, or the start would not be possible.
        """
        token, cell = touch.token, touch.cell
        home = self.now.cells.get(token)
        if home is None or cell not in self.now.board or cell in self.now.tokens:
            raise CannotTouchError(touch)
        goal = self.now.board.goal_row
        first = self.start.cells[token]
        if cell.row == goal and first.row != goal:
            moves = (*self._without(token), Move(token, first, cell))
            return replace(self, moves=moves, now=_moved(self.now, touch))
        start = self.start
        if cell != first:
            if cell in start.tokens:
                # It is the place of a token that lies in the row now, and may come back.
                raise CannotTouchError(touch)
            start = _moved(start, touch)
        return _Row(start, self._without(token), _moved(self.now, touch))

    def _without(self, token: TokenId) -> tuple[Move, ...]:
        return tuple(move for move in self.moves if move.token != token)


@dataclass(frozen=True)
class Showing:
    """A demonstration so far.

    Raises:
        CannotTouchError: a touch that no board could show.
    """

    dealt: State
    touches: tuple[Touch, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what cannot be."""
        _ = self._row

    @property
    def start(self) -> State:
        """Where the tokens lay before the first move."""
        return self._row.start

    @property
    def moves(self) -> tuple[Move, ...]:
        """Those that count."""
        return self._row.moves

    @property
    def now(self) -> State:
        """Where the tokens lie."""
        return self._row.now

    @property
    def is_full(self) -> bool:
        """Whether there is no room in the goal row, or no token left for it."""
        now = self.now
        goal = now.board.goal_row
        stored = any(cell.row != goal for cell in now.cells.values())
        return not stored or all(cell in now.tokens for cell in now.board.goal_cells)

    def after(self, touch: Touch) -> Showing:
        """With one more touch.

        Raises:
            CannotTouchError: the cell is taken, was another token's place, or it is too much.
        """
        if len(self.touches) >= MAX_TOUCHES:
            raise CannotTouchError(touch)
        return replace(self, touches=(*self.touches, touch))

    def before(self) -> Showing:
        """Without the last touch, of which there is one."""
        return replace(self, touches=self.touches[:-1])

    def demonstration(self, deck: Deck) -> Demonstration:
        """What was shown with these tokens."""
        return Demonstration(deck, self.start, self.moves)

    @cached_property
    def _row(self) -> _Row:
        row = _Row(self.dealt, (), self.dealt)
        for touch in self.touches:
            row = row.touched(touch)
        return row


def laid(state: State, touch: Touch) -> State:
    """The start with a token elsewhere, in the goal row too.

    Raises:
        CannotTouchError: the cell is taken, or there is no such token or cell.
    """
    if (
        touch.token not in state.cells
        or touch.cell not in state.board
        or touch.cell in state.tokens
    ):
        raise CannotTouchError(touch)
    return _moved(state, touch)


def dealt(deck: Deck, board: Board, seed: int) -> State:
    """The tokens anywhere in storage, each seed in its own way; as many as there is room for."""
    tokens = [token.id for token in deck.tokens]
    cells = shuffled(board.storage_cells, seed)
    return State(board, dict(zip(tokens, cells, strict=False)))


def _moved(state: State, touch: Touch) -> State:
    return State(state.board, {**state.cells, touch.token: touch.cell})
