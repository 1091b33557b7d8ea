"""A play up to now, as it is judged: how it began, and the right moves since."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

from maestra.core.state import Move, State


@dataclass(frozen=True, slots=True)
class Position:
    """A play up to now."""

    start: State
    moves: tuple[Move, ...]
    """The right ones; what was refused is put back and forgotten."""
    now: State
    """What lies where after them."""

    @classmethod
    def begin(cls, start: State) -> Position:
        """Nothing moved yet."""
        return cls(start, (), start)

    def after(self, move: Move) -> Position:
        """The play with one more move.

        Raises:
            IllegalMoveError: no board could make it.
        """
        return Position(self.start, (*self.moves, move), self.now.after(move))

    def without_last(self) -> Position:
        """The play before its last move, of which there is one."""
        return reduce(Position.after, self.moves[:-1], Position.begin(self.start))
