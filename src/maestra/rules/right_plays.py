"""An exercise given by what is right: all of its plays, counted, numbered and enumerated.

Right is what a predicate says of the placements in time. Which storage cells the tokens come
from is a matter apart, so that start arrangements need not be enumerated: only sequences of
placements are, by a search that a predicate on beginnings prunes. Cost: the beginnings that are
right times tokens times goal cells.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.state import Move, State
from maestra.rules.arrangements import Arrangements

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from maestra.core.board import Board, Cell
    from maestra.core.tokens import Deck, TokenId

    Indices = np.ndarray[tuple[int, int], np.dtype[np.int16]]

MAX_SEQUENCES: Final = 1_000_000
"""Sequences kept at most: 30,240 on the paper's board; a million take half a gigabyte."""


@dataclass(frozen=True, slots=True)
class Placement:
    """A token put on a cell of the goal row."""

    token: TokenId
    destination: Cell


Placements: TypeAlias = tuple[Placement, ...]
"""In the order of time."""


def anything(_placements: Placements) -> bool:
    """Every play is right."""
    return True


def from_anywhere(_step: int, _placement: Placement) -> None:
    """Every storage cell may be the origin."""


class TooManyPlaysError(InvalidError):
    """There are more right sequences than can be enumerated."""


@dataclass(frozen=True, eq=False)
class PlayGroup:
    """Right sequences of one length whose tokens may come from the same cells."""

    arrangements: Arrangements
    tokens: Indices
    """One row for each sequence: the moved tokens, as indices into the deck's tokens."""
    destinations: Indices
    """Where they go, as indices into the board's goal cells."""

    @cached_property
    def sequences(self) -> tuple[tuple[tuple[int, int], ...], ...]:
        """The same as plain indices: for each sequence its pairs of token and goal cell."""
        rows = np.stack([self.tokens, self.destinations], axis=2).tolist()
        return tuple(tuple((token, cell) for token, cell in row) for row in rows)


@dataclass(frozen=True)
class RightPlays:
    """All right plays of an exercise: each token moves at most once, from storage to goal row.

    Raises:
        InvalidError: more tokens than storage cells.
        TooManyPlaysError: (when sequences are first asked for) more than `max_sequences`.
    """

    board: Board
    deck: Deck
    right: Callable[[Placements], bool] = anything
    """Whether a whole play with these placements is right."""
    may_begin: Callable[[Placements], bool] = anything
    """False only for placements that no right play begins with; the more often the faster."""
    origins: Callable[[int, Placement], frozenset[Cell] | None] = from_anywhere
    """The storage cells that the token of a step (from 1) may come from; None: any."""
    lengths: frozenset[int] = field(default_factory=frozenset[int])
    """After how many moves a play may end; by default when the goal row is full."""
    known: tuple[Placements, ...] | None = None
    """The right sequences if somebody has them: then nothing is asked of the predicates."""
    max_sequences: int = MAX_SEQUENCES

    def __post_init__(self) -> None:
        """Refuse a deck that has no room; a play ends with a full goal row if nobody says."""
        cells = len(self.board.storage_cells)
        if len(self.deck.tokens) > cells:
            fault = Fault("tokens", f"{len(self.deck.tokens)}", f"at most {cells} storage cells")
            refuse([fault])
        if not self.lengths:
            object.__setattr__(self, "lengths", frozenset({len(self.board.goal_cells)}))

    @cached_property
    def groups(self) -> tuple[PlayGroup, ...]:
        """All right sequences that some start arrangement allows, by their arrangements."""
        rows: dict[tuple[frozenset[Cell] | None, ...], list[Placements]] = {}
        sequences = self._search(()) if self.known is None else self.known
        for number, placements in enumerate(sequences, start=1):
            if number > self.max_sequences:
                found, expected = f"more than {self.max_sequences} sequences", "fewer right plays"
                raise TooManyPlaysError([Fault("", found, expected)])
            key = tuple(self.origins(step, one) for step, one in enumerate(placements, start=1))
            rows.setdefault(key, []).append(placements)
        groups = (self._group(origins, found) for origins, found in rows.items())
        return tuple(group for group in groups if group.arrangements.count)

    @cached_property
    def count(self) -> int:
        """How many right plays there are, different starts counted."""
        return sum(len(group.tokens) * group.arrangements.count for group in self.groups)

    def play(self, number: int) -> Demonstration:
        """The right play with this number, from 0 to below `count`: each has exactly one.

        Raises:
            IndexError: no play has this number.
        """
        if not 0 <= number < self.count:
            message = f"no play {number} of {self.count}"
            raise IndexError(message)
        ends = list(accumulate(len(one.tokens) * one.arrangements.count for one in self.groups))
        index = bisect_right(ends, number)
        group = self.groups[index]
        row, rest = divmod(number - (ends[index - 1] if index else 0), group.arrangements.count)
        first, second = divmod(rest, group.arrangements.of_unmoved)
        origins = group.arrangements.nth_origins(first)
        others = group.arrangements.nth_unmoved(origins, second)
        moved = [token for token, _ in group.sequences[row]]
        tokens = self.deck.tokens
        unmoved = [index for index in range(len(tokens)) if index not in moved]
        places = zip([*moved, *unmoved], [*origins, *others], strict=True)
        return self.demonstration(group, row, {tokens[index].id: at for index, at in places})

    def demonstration(
        self, group: PlayGroup, row: int, start: Mapping[TokenId, Cell]
    ) -> Demonstration:
        """The play of the group's sequence `row` from the arrangement `start`."""
        moves = tuple(
            Move(one.token, start[one.token], one.destination)
            for one in self.placements(group, row)
        )
        return Demonstration(self.deck, State(self.board, start), moves, source="simulated")

    def placements(self, group: PlayGroup, row: int) -> Placements:
        """The placements of the group's sequence `row`."""
        tokens, cells = self.deck.tokens, self.board.goal_cells
        pairs = group.sequences[row]
        return tuple(Placement(tokens[token].id, cells[cell]) for token, cell in pairs)

    def _search(self, begun: Placements) -> Iterator[Placements]:
        if len(begun) in self.lengths and self.right(begun):
            yield begun
        if len(begun) >= max(self.lengths):
            return
        taken = {one.destination for one in begun}
        moved = {one.token for one in begun}
        for cell in self.board.goal_cells:
            if cell in taken:
                continue
            for token in self.deck.tokens:
                if token.id not in moved:
                    longer = (*begun, Placement(token.id, cell))
                    if self.may_begin(longer):
                        yield from self._search(longer)

    def _group(
        self, origins: tuple[frozenset[Cell] | None, ...], found: Sequence[Placements]
    ) -> PlayGroup:
        token_index = {token.id: index for index, token in enumerate(self.deck.tokens)}
        cell_index = {cell: index for index, cell in enumerate(self.board.goal_cells)}
        shape = (len(found), len(origins))
        tokens = [[token_index[one.token] for one in placements] for placements in found]
        cells = [[cell_index[one.destination] for one in placements] for placements in found]
        unmoved = len(self.deck.tokens) - len(origins)
        return PlayGroup(
            Arrangements(self.board.storage_cells, origins, unmoved),
            np.array(tokens, dtype=np.int16).reshape(shape),
            np.array(cells, dtype=np.int16).reshape(shape),
        )


def plays_like(demonstrations: Sequence[Demonstration]) -> RightPlays:
    """The shown plays (at least one) from any start: the same tokens to the same destinations.

    Only of the first demonstration's board and deck, and only moves from storage to goal row.
    """
    first = demonstrations[0]
    board, deck = first.board, first.deck
    shown = dict.fromkeys(
        tuple(Placement(move.token, move.destination) for move in one.moves)
        for one in demonstrations
        if one.board == board and one.deck.tokens == deck.tokens and _fills_the_goal_row(one)
    )
    lengths = frozenset(len(one) for one in shown)
    return RightPlays(board, deck, shown.__contains__, lengths=lengths, known=tuple(shown))


def _fills_the_goal_row(play: Demonstration) -> bool:
    """Whether all tokens begin in storage, and each moved one goes to the goal row once."""
    row = play.board.goal_row
    tokens = [move.token for move in play.moves]
    return (
        all(cell.row != row for cell in play.start.cells.values())
        and all(move.destination.row == row for move in play.moves)
        and len(set(tokens)) == len(tokens)
    )
