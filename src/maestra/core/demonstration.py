"""What a caregiver played: a start state and the moves from it. A play and a position are alike."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from maestra.core.faults import Fault, refuse
from maestra.core.state import IllegalMoveError, State

if TYPE_CHECKING:
    from collections.abc import Iterator

    from maestra.core.board import Board
    from maestra.core.state import Move
    from maestra.core.tokens import Deck


@dataclass(frozen=True, slots=True)
class Demonstration:
    """A start state and the sequence of moves played from it.

    Raises:
        InvalidError: the start state lacks a token of the deck or has one more; a move that no
            board could make; as many times as there are not moves, or times that run backwards.
    """

    deck: Deck
    start: State
    moves: tuple[Move, ...]
    label: str | None = None
    times_ms: tuple[int, ...] | None = None
    """One for each move, from the start."""
    source: str | None = None
    """Where it was played: ``board``, ``file``, ``simulated``."""

    def __post_init__(self) -> None:
        """Refuse a demonstration that no board could show, naming every fault."""
        refuse(
            [
                *self._faults_of_start(),
                *self._faults_of_moves(),
                *self._faults_of_times(),
            ]
        )

    @property
    def board(self) -> Board:
        """The board it was played on."""
        return self.start.board

    def states(self) -> Iterator[State]:
        """The start state, then the state after each move: one more than there are moves."""
        state = self.start
        yield state
        for move in self.moves:
            state = state.after(move)
            yield state

    @property
    def end(self) -> State:
        """The state after the last move."""
        *_, last = self.states()
        return last

    def until(self, moves: int) -> Demonstration:
        """The position after the first `moves` moves."""
        times = None if self.times_ms is None else self.times_ms[:moves]
        return replace(self, moves=self.moves[:moves], times_ms=times)

    def _faults_of_start(self) -> list[Fault]:
        known, placed = self.deck.by_id.keys(), self.start.cells.keys()
        missing = [
            Fault(f"start.{token}", "missing", "a cell for each token")
            for token in sorted(known - placed)
        ]
        unknown = [
            Fault(f"start.{token}", "unknown token", "a token of the deck")
            for token in sorted(placed - known)
        ]
        return missing + unknown

    def _faults_of_moves(self) -> list[Fault]:
        """Every impossible move; each is passed over, so that later ones are still looked at."""
        faults: list[Fault] = []
        state = self.start
        for index, move in enumerate(self.moves):
            try:
                state = state.after(move)
            except IllegalMoveError as error:
                faults.extend(
                    replace(fault, where=f"moves[{index}].{fault.where}") for fault in error.faults
                )
        return faults

    def _faults_of_times(self) -> list[Fault]:
        if self.times_ms is None:
            return []
        faults: list[Fault] = []
        if len(self.times_ms) != len(self.moves):
            found = f"{len(self.times_ms)} times"
            faults.append(Fault("times_ms", found, f"{len(self.moves)}, one for each move"))
        if any(later < earlier for earlier, later in zip((0, *self.times_ms), self.times_ms)):
            faults.append(Fault("times_ms", "times that run backwards", "rising times from 0"))
        return faults
