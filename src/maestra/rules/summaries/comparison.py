"""Where an outline of rules accepts more than the preconditions: exact, without listing plays."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from maestra.core.board import Cell
from maestra.rules.setting import Index, Mask, bits
from maestra.rules.summaries.evidence import Bits, Evidence
from maestra.rules.summaries.outline import Outline, RightMove, Rows
from maestra.rules.summaries.right_rows import UndecidedError


@dataclass(slots=True)
class Wider:
    """What the rules accept and the preconditions do not, by step and what is moved."""

    unseen: dict[int, set[int]] = field(default_factory=dict[int, set[int]])
    """Moved then in some right play, but never shown."""
    falsified: dict[tuple[int, int], Bits] = field(default_factory=dict[tuple[int, int], int])
    """Literals of the action's precondition that some right play makes false."""

    def __bool__(self) -> bool:
        """Whether there is anything."""
        return bool(self.unseen or self.falsified)


def compare(evidence: Evidence, outline: Outline) -> Wider:
    """Where the rules of `outline` are wider than the preconditions.

    Every play that the preconditions accept must be right by the rules.

    Raises:
        UndecidedError: it cannot be found out.
    """
    wider = Wider()
    for length in sorted(outline.lengths - {0}):
        comparison = _Comparison(evidence, outline, length, outline.rows(length), wider)
        for step in range(1, length + 1):
            for cell in outline.cells_at(step):
                for token in bits(comparison.rows.possible(step, cell)):
                    comparison.add(RightMove(step, cell, token))
    return wider


@dataclass
class _Comparison:
    """The comparison for the plays with `length` moves; it adds to `wider`."""

    evidence: Evidence
    outline: Outline
    length: int
    rows: Rows
    wider: Wider

    def add(self, move: RightMove) -> None:
        """Compare all right plays with this move in them, before it."""
        evidence = self.evidence
        shown = evidence.shown_of[move.token]
        precondition = evidence.actions.get(move.step, {}).get(shown)
        if precondition is None:
            self.wider.unseen.setdefault(move.step, set()).add(shown)
            return
        false = precondition & self._of_move & ~self._always_placed(move.cell)
        content = precondition & ~self._of_move
        if content:
            vocabulary = evidence.vocabulary
            for cell, offset in vocabulary.offsets.items():
                demand = evidence.demanded(content, cell)
                if demand:
                    false |= self._false_on(move, cell, demand) << offset
        if false:
            key = (move.step, shown)
            self.wider.falsified[key] = self.wider.falsified.get(key, 0) | false

    @cached_property
    def _of_move(self) -> Bits:
        return (1 << self.evidence.vocabulary.placed_size) - 1

    @cached_property
    def _known_placed(self) -> dict[Index, Bits]:
        return {}

    def _always_placed(self, cell: Index) -> Bits:
        """The literals of a move's cells that hold wherever a token for `cell` comes from."""
        if cell not in self._known_placed:
            vocabulary = self.evidence.vocabulary
            held = self._of_move
            for origin in self.outline.origins(cell):
                held &= vocabulary.placed(origin, vocabulary.board.goal_cells[cell])
            self._known_placed[cell] = held
        return self._known_placed[cell]

    def _false_on(self, move: RightMove, cell: Cell, demand: Bits) -> Bits:
        """Those literals of `demand` about `cell` that some right play makes false."""
        if cell.row == self.evidence.vocabulary.board.goal_row:
            return self._false_in_row(move, cell.column - 1, demand)
        return self._false_in_storage(move, cell, demand)

    def _false_in_row(self, move: RightMove, cell: Index, demand: Bits) -> Bits:
        filled = self.outline.filled_before(move.step, move.cell, cell)
        if not filled:
            return demand
        return self._false_of(move, self.rows.together(move, cell, earlier=True), demand)

    def _false_of(self, move: RightMove, lying: Mask, demand: Bits) -> Bits:
        """Those literals that are false of one of the tokens that may lie there."""
        shown = self.evidence.shown_of[move.token]
        key = (shown, lying)
        if key not in self._known_patterns:
            patterns = self.evidence.vocabulary.patterns(shown)
            common = -1
            for other, tokens in enumerate(self.evidence.of_shown):
                if tokens & lying:
                    common &= patterns[other]
            self._known_patterns[key] = common
        return demand & ~self._known_patterns[key]

    @cached_property
    def _known_patterns(self) -> dict[tuple[int, Mask], Bits]:
        return {}

    def _false_in_storage(self, move: RightMove, cell: Cell, demand: Bits) -> Bits:
        """As `_false_on`, of a storage cell, where the start arrangement decides.

        Raises:
            UndecidedError: the board is so full that the arrangement is not free.
        """
        users = self._sure_users.get(cell)
        if users is not None:
            return self._false_of_users(move, users, demand)
        vocabulary = self.evidence.vocabulary
        if len(vocabulary.deck.tokens) < len(vocabulary.board.storage_cells):
            return demand
        raise UndecidedError

    def _false_of_users(self, move: RightMove, users: tuple[Index, ...], demand: Bits) -> Bits:
        """As `_false_on`, of a storage cell from which the token of a user surely comes."""
        lying = 0
        for user in users:
            if user == move.cell:
                lying |= 1 << move.token
            elif self.outline.filled_before(move.step, move.cell, user) is not False:
                return demand
            else:
                lying |= self.rows.together(move, user, earlier=False)
        return self._false_of(move, lying, demand)

    @cached_property
    def _sure_users(self) -> dict[Cell, tuple[Index, ...]]:
        """Storage cells that surely are an origin, with the goal cells it may be the origin for.

        So it is if the goal cells that share a set of origins are as many as these.
        """
        used = [cell for step in range(1, self.length + 1) for cell in self.outline.cells_at(step)]
        sharing: dict[frozenset[Cell], list[Index]] = {}
        for cell in dict.fromkeys(used):
            sharing.setdefault(self.outline.origins(cell), []).append(cell)
        if len(set(used)) > self.length:
            return {}
        return {
            origin: tuple(cells)
            for origins, cells in sharing.items()
            if len(origins) == len(cells)
            for origin in origins
        }
