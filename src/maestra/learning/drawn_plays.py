"""Plays drawn by rules: right ones, and ones that are nearly right.

A right play is drawn move by move: any token that the rules allow here and that leaves a way to
go on. Where few tokens do, the search for a completion names one. So every right play that fills
the row in a natural order can be drawn, but not each with the same chance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, pairwise
from typing import Final, TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.state import State
from maestra.core.tokens import Deck, TokenId
from maestra.learning.chance import hashed, shuffled
from maestra.rules.completability import Completable, Conjunction, MoveAllowed
from maestra.rules.looks import lines_of
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Line, Play, Setting, bits

TRIED: Final = 8
"""Tokens tried for a move before the search is asked for one."""

Placement: TypeAlias = tuple[Index, Index]
"""A token and the goal cell it is put on."""


def starts(deck: Deck, board: Board, shown: Sequence[State], seed: int) -> Iterator[Setting]:
    """Arrangements to begin from, without end: the tokens of those shown change places.

    Tokens of the goal row stay. Where nothing was shown, the tokens lie anywhere in storage.
    """
    ids = [token.id for token in deck.tokens]
    number = 0
    while True:
        given = shown[number % len(shown)].cells if shown else dict[TokenId, Cell]()
        stored = {t: c for t, c in given.items() if c.row != board.goal_row}
        cells = shuffled(sorted(stored.values()) or board.storage_cells, seed, number)
        moved = dict(zip(sorted(stored) or ids, cells, strict=False))
        yield Setting(deck, State(board, {**given, **moved}))
        number += 1


@dataclass(frozen=True)
class Drawer:
    """Draws plays of one exercise from one start."""

    rules: tuple[Rule, ...]
    setting: Setting

    @cached_property
    def all(self) -> Conjunction:
        """All rules together."""
        return Conjunction(self.rules, self.setting)

    @cached_property
    def _timed(self) -> bool:
        return any(Line.TIME in lines_of(rule) for rule in self.rules)

    def right(self, seed: int) -> Play | None:
        """A right play; None where none was found from this start."""
        play, step = Play.begin(self.setting), 0
        if not isinstance(self.all.outlook(play), Completable):
            return None
        while not (self.all.may_end(play) and (not play.room or hashed(seed, step, 1) % 2)):
            after = self._one_more(play, seed, step)
            if after is None:
                break
            play, step = after, step + 1
        return play

    def _one_more(self, play: Play, seed: int, step: int) -> Play | None:
        """The play after one more right move; None where it has to end here."""
        for token, cell in self._promising(play, seed, step):
            if isinstance(self.all.judge(play, token, cell), MoveAllowed):
                return play.after(token, cell)
        outlook = self.all.outlook(play)
        example = outlook.example if isinstance(outlook, Completable) else play
        more = example.placed[len(play.placed) :]
        return play.after(*more[0]) if more else None

    def _promising(self, play: Play, seed: int, step: int) -> list[Placement]:
        """Moves to try: from left to right, unless the order in time counts."""
        cells = play.free if self._timed else play.free[:1]
        moves = [(token, cell) for cell in cells for token in bits(play.left)]
        return shuffled(moves, seed, step)[:TRIED]

    def near_misses(self, play: Play, seed: int | None = None) -> Iterator[Play]:
        """What one change makes of a right play, where that is no longer right.

        Args:
            play: the right play.
            seed: of the order they come in; None: those with another token first, from the left.
        """
        changes = list(dict.fromkeys(_changed(play)))
        for placed in changes if seed is None else shuffled(changes, seed):
            changed = played(self.setting, placed)
            if not self.all.may_end(changed):
                yield changed

    def refusals(self, play: Play) -> int:
        """At how many places a play that is not right is refused; if at none, at its end."""
        position, refused = Play.begin(self.setting), 0
        for token, cell in play.placed:
            if isinstance(self.all.judge(position, token, cell), MoveAllowed):
                position = position.after(token, cell)
            else:
                refused += 1
        return max(refused, 1)

    def broken(self, play: Play) -> frozenset[Index]:
        """Which rules a finished play breaks, by their number."""
        return frozenset(k for k, rule in enumerate(self.rules) if not rule.holds(play))


def played(setting: Setting, placed: Sequence[Placement]) -> Play:
    """The play of these placements."""
    play = Play.begin(setting)
    for token, cell in placed:
        play = play.after(token, cell)
    return play


def _changed(play: Play) -> Iterator[tuple[Placement, ...]]:
    """One token for another, two that change places, two moves in the other order."""
    placed = play.placed
    for k, (_, cell) in enumerate(placed):
        for token in bits(play.left):
            yield (*placed[:k], (token, cell), *placed[k + 1 :])
    for one, two in combinations(range(len(placed)), 2):
        swapped = list(placed)
        swapped[one] = (placed[two][0], placed[one][1])
        swapped[two] = (placed[one][0], placed[two][1])
        yield tuple(swapped)
    for one, two in pairwise(range(len(placed))):
        yield (*placed[:one], placed[two], placed[one], *placed[two + 1 :])


def distance(one: Play, other: Play) -> float:
    """How different two plays look: 1 for each other token, less for how the same one came."""
    cells = one.setting.length
    looks = sum(
        1.0 if a != b else _origin_differs(one, other, a)
        for a, b in zip(one.row, other.row, strict=False)
    )
    order = sum(a[1] != b[1] for a, b in zip(one.placed, other.placed, strict=False))
    return (looks + order / 4) / cells


def _origin_differs(one: Play, other: Play, token: Index | None) -> float:
    if token is None:
        return 0.0
    where = [play.setting.start.cells[play.setting.deck.tokens[token].id] for play in (one, other)]
    return 0.25 if where[0] != where[1] else 0.0
