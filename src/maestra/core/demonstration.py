"""What was played: a start and the moves from it, shown by a caregiver or tried by a patient."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final, Literal, TypeAlias, get_args

from maestra.core.board import Board
from maestra.core.faults import Fault, refuse, shorten
from maestra.core.state import IllegalMoveError, Move, State, off_board
from maestra.core.text import faults_of_text
from maestra.core.tokens import Deck

Source: TypeAlias = Literal["board", "file", "simulated"]
"""Where a demonstration was played."""
SOURCES: Final[tuple[str, ...]] = get_args(Source)

MAX_MOVES: Final = 10_000
"""A move every three seconds for a working day."""
MAX_TIME_MS: Final = 10**15
"""30,000 years: any clock fits, also one that counts from 1970."""


@dataclass(frozen=True, slots=True)
class Play:
    """A start state and the moves tried from it, of which some may have been put back.

    Which moves a board could make depends on those that were put back, and that only a judge
    of the exercise knows; so here a move has a token of the deck and two cells of the board.

    Raises:
        InvalidError: the start state lacks a token of the deck or has one more; a move of an
            unknown token or off the board, or more than `MAX_MOVES`; as many times as there are
            not moves, or times that run backwards; a label that is no plain text.
    """

    deck: Deck
    start: State
    moves: tuple[Move, ...]
    label: str | None = None
    times_ms: tuple[int, ...] | None = None
    """One for each move, from the start."""
    source: Source | None = None

    def __post_init__(self) -> None:
        """Refuse what no board could show, naming every fault."""
        refuse(
            [
                *self._faults_of_start(),
                *self._faults_of_moves(),
                *self._faults_of_times(),
                *([] if self.label is None else faults_of_text("label", self.label)),
                *self._faults_of_source(),
            ]
        )

    @property
    def board(self) -> Board:
        """The board it was played on."""
        return self.start.board

    def _faults_of_start(self) -> list[Fault]:
        known, placed = self.deck.by_id.keys(), self.start.cells.keys()
        if known == placed:
            return []
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
        if len(self.moves) > MAX_MOVES:
            return [Fault("moves", f"{len(self.moves)} moves", f"at most {MAX_MOVES}")]
        known, board = self.deck.by_id, self.start.board
        faults: list[Fault] = []
        for index, move in enumerate(self.moves):
            place = f"moves[{index}]"
            if move.token not in known:
                found = f"unknown token {move.token}"
                faults.append(Fault(f"{place}.token", found, "a token of the deck"))
            for name, cell in (("origin", move.origin), ("destination", move.destination)):
                if cell not in board:
                    faults.append(off_board(f"{place}.{name}", cell, board))
        return faults

    def _faults_of_times(self) -> list[Fault]:
        if self.times_ms is None:
            return []
        faults: list[Fault] = []
        if len(self.times_ms) != len(self.moves):
            expected = f"{len(self.moves)}, one for each move"
            faults.append(Fault("times_ms", f"length {len(self.times_ms)}", expected))
        if any(later < earlier for earlier, later in pairwise((0, *self.times_ms, MAX_TIME_MS))):
            expected = "times that rise from 0, up to 10^15"
            faults.append(Fault("times_ms", "times that run backwards or too far", expected))
        return faults

    def _faults_of_source(self) -> list[Fault]:
        if self.source is None or self.source in SOURCES:
            return []
        return [Fault("source", shorten(self.source), f"one of {', '.join(SOURCES)}")]


@dataclass(frozen=True, slots=True)
class Demonstration(Play):
    """A play whose every move a board could make, one after another.

    Raises:
        InvalidError: as `Play`, or a move that no board could make.
    """

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

    def until(self, moves: int) -> "Demonstration":
        """The position after the first `moves` moves.

        Raises:
            ValueError: there are not so many.
        """
        if not 0 <= moves <= len(self.moves):
            raise ValueError(f"{moves} of {len(self.moves)} moves")
        times = None if self.times_ms is None else self.times_ms[:moves]
        return replace(self, moves=self.moves[:moves], times_ms=times)

    def _faults_of_moves(self) -> list[Fault]:
        """Every impossible move; each is passed over, so that later ones are still looked at."""
        if len(self.moves) > MAX_MOVES:
            return [Fault("moves", f"{len(self.moves)} moves", f"at most {MAX_MOVES}")]
        faults: list[Fault] = []
        state = self.start
        for index, move in enumerate(self.moves):
            try:
                state = state.after(move)
            except IllegalMoveError as error:
                faults.extend(fault.under(f"moves[{index}]") for fault in error.faults)
        return faults
