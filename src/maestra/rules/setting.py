"""A play as the rules see it: tokens and goal cells by number, sets of tokens as bit masks.

A play is a start state and the moves in time, each from a storage cell to an empty goal cell.
Tokens that lie in the goal row from the start belong to the row, but were never placed.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import Final, TypeAlias, TypeVar, assert_never, cast

from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.core.state import Move, State
from maestra.core.tokens import Attributes, Deck, Scale, TokenId, Value

Mask: TypeAlias = int
"""A set of tokens: bit k stands for token k of the deck."""
Rank: TypeAlias = int | Fraction
"""An exact number: what a token shows, or its place in the attribute's order."""
Index: TypeAlias = int
"""A token's place in the deck, or a goal cell's place in the row, from 0."""

ORIGIN_ROW: Final = "origin:row"
"""Where a token came from, as if it were an attribute: storage rows from 1, the goal row passed
over, so that 1 is the row next to a goal row at the edge. 0 for a token of the goal row."""
ORIGIN_COLUMN: Final = "origin:column"
"""The column a token came from, as if it were an attribute."""

_T = TypeVar("_T")


class Line(Enum):
    """What "first", "next" and "last" go by."""

    ROW = "row"
    """The goal row from left to right; the k-th is goal cell k, which may be empty."""
    TIME = "time"
    """The order of placement; the k-th is the k-th token placed."""


def bits(mask: Mask) -> Iterator[Index]:
    """The tokens of a set, in the deck's order."""
    while mask:
        low = mask & -mask
        yield low.bit_length() - 1
        mask ^= low


@dataclass(frozen=True)
class Setting:
    """The start of a play; remembers what has been worked out about its tokens."""

    deck: Deck
    start: State
    _known: dict[Hashable, object] = field(
        default_factory=dict[Hashable, object], init=False, compare=False, repr=False
    )

    def remember(self, key: Hashable, work_out: Callable[[], _T]) -> _T:
        """What `work_out` gives, worked out once for each `key`."""
        try:
            return cast("_T", self._known[key])
        except KeyError:
            found = self._known[key] = work_out()
            return found

    @cached_property
    def number_of(self) -> Mapping[TokenId, Index]:
        """Each token's number."""
        return MappingProxyType({token.id: k for k, token in enumerate(self.deck.tokens)})

    @cached_property
    def length(self) -> int:
        """How many goal cells there are."""
        return self.start.board.columns

    @cached_property
    def given(self) -> tuple[Index | None, ...]:
        """What lies in the goal row from the start, cell by cell."""
        lies = self.start.tokens
        cells = self.start.board.goal_cells
        return tuple(self.number_of[lies[cell]] if cell in lies else None for cell in cells)

    @cached_property
    def movable(self) -> Mask:
        """The tokens that lie in storage."""
        goal = self.start.board.goal_row
        return sum(
            1 << self.number_of[token]
            for token, cell in self.start.cells.items()
            if cell.row != goal
        )

    @cached_property
    def shown(self) -> tuple[Attributes, ...]:
        """What each token shows, and where it came from."""
        rows = list(range(1, self.start.board.rows + 1))
        rows.remove(self.start.board.goal_row)
        shown: list[Attributes] = []
        for token in self.deck.tokens:
            cell = self.start.cells[token.id]
            row = rows.index(cell.row) + 1 if cell.row in rows else 0
            own = [(k, v) for k, v in token.attributes if k not in (ORIGIN_ROW, ORIGIN_COLUMN)]
            shown.append((*own, (ORIGIN_COLUMN, int(cell.column)), (ORIGIN_ROW, row)))
        return tuple(shown)

    def values(self, attribute: str) -> tuple[Value | None, ...]:
        """What each token shows under `attribute`; None where it has no such attribute."""
        return self.remember(
            ("values", attribute),
            lambda: tuple(dict(shown).get(attribute) for shown in self.shown),
        )

    def ranks(self, attribute: str) -> tuple[Rank | None, ...]:
        """Each token's exact number or place in the order; None where there is none."""
        return self.remember(
            ("ranks", attribute),
            lambda: tuple(self.rank(attribute, value) for value in self.values(attribute)),
        )

    def rank(self, attribute: str, value: Value | None) -> Rank | None:
        """The exact number or place of one value; None for a nominal or missing one."""
        match value:
            case None:
                return None
            case int():
                return value
            case Decimal():
                return Fraction(value)
            case str():
                if self.deck.scales.get(attribute, Scale.NOMINAL) is Scale.NOMINAL:
                    return None
                return int(self.deck.rank(attribute, value))
            case _:
                assert_never(value)

    def mask(self, passes: Callable[[Index], bool]) -> Mask:
        """The set of the tokens that pass."""
        return sum(1 << k for k in range(len(self.deck.tokens)) if passes(k))

    def masks(self, relates: Callable[[Index, Index], bool]) -> tuple[Mask, ...]:
        """For each token as the first of a pair, the set of those that relate as the second."""
        count = range(len(self.deck.tokens))
        return tuple(sum(1 << b for b in count if relates(a, b)) for a in count)


@dataclass(frozen=True, slots=True)
class Play:
    """A play, finished or not; `after` makes the longer one.

    The slots of a line are its places in order: all goal cells, or the tokens placed so far and
    as many more as can still be placed.
    """

    setting: Setting
    placed: tuple[tuple[Index, Index], ...]
    """Token and goal cell of each move, in time."""
    row: tuple[Index | None, ...]
    """What lies on each goal cell."""
    left: Mask
    """The tokens that still lie in storage."""

    @classmethod
    def begin(cls, setting: Setting) -> Play:
        """Nothing placed yet."""
        return cls(setting, (), setting.given, setting.movable)

    def after(self, token: Index, cell: Index) -> Play:
        """The play with one more token placed; `token` is left and `cell` is free."""
        row = (*self.row[:cell], token, *self.row[cell + 1 :])
        return Play(self.setting, (*self.placed, (token, cell)), row, self.left & ~(1 << token))

    @property
    def free(self) -> tuple[Index, ...]:
        """The empty goal cells from left to right."""
        return tuple(k for k, token in enumerate(self.row) if token is None)

    @property
    def room(self) -> int:
        """How many more tokens can be placed."""
        return min(self.row.count(None), self.left.bit_count())

    @property
    def tokens(self) -> tuple[Index, ...]:
        """The tokens of the row from left to right."""
        return tuple(token for token in self.row if token is not None)

    def slots(self, line: Line) -> tuple[Index | None, ...]:
        """What lies in each slot of `line`; None where a token can still come."""
        if line is Line.ROW:
            return self.row
        return (*(token for token, _ in self.placed), *((None,) * self.room))

    def count(self, mask: Mask) -> int:
        """How many tokens of the row are in a set."""
        return sum(mask >> token & 1 for token in self.tokens)

    def extensions(self) -> Iterator[Play]:
        """Every play that continues this one by one move."""
        for cell in self.free:
            for token in bits(self.left):
                yield self.after(token, cell)

    def moves(self) -> tuple[Move, ...]:
        """The moves as the board saw them."""
        setting = self.setting
        goal = setting.start.board.goal_cells
        ids = [token.id for token in setting.deck.tokens]
        return tuple(
            Move(ids[token], setting.start.cells[ids[token]], goal[cell])
            for token, cell in self.placed
        )


def play_of(demonstration: Demonstration, setting: Setting | None = None) -> Play:
    """A demonstration or position as the rules see it.

    Args:
        demonstration: what was played.
        setting: that of an earlier play from the same start, to use what it remembers.

    Raises:
        InvalidError: a move that is not from a storage cell to a goal cell.
    """
    setting = setting or Setting(demonstration.deck, demonstration.start)
    play = Play.begin(setting)
    goal = demonstration.board.goal_row
    for number, move in enumerate(demonstration.moves):
        if move.origin.row == goal or move.destination.row != goal:
            found = f"a move from row {move.origin.row} to row {move.destination.row}"
            expected = f"one from a storage row to the goal row, {goal}"
            raise InvalidError([Fault(f"moves[{number}]", found, expected)])
        play = play.after(setting.number_of[move.token], move.destination.column - 1)
    return play
