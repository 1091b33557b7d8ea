"""The literals that preconditions are made of, and which of them hold before a move.

A precondition is a set of literals; here it is one integer with a bit for each literal of the
vocabulary, so that intersecting two sets is one instruction a word however large the board is.
The literals about what lies on a cell are the same for every cell; each watched cell has a block
of them at its own offset. So what a token makes true by lying on a cell is worked out once for
each pair of tokens, as a pattern to be shifted.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from decimal import Decimal
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from maestra.core.faults import Fault, refuse
from maestra.core.tokens import Scale
from maestra.rules.features import (
    CellFeature,
    PairFeature,
    TokenFeature,
    pair_feature_table,
    token_feature_holds,
)
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from maestra.core.board import Board, Cell
    from maestra.core.tokens import Attributes, Deck, TokenId
    from maestra.rules.features import Feature
    from maestra.rules.registry import CellValue

    Bits = int


class Level(Enum):
    """How much of the board preconditions may mention."""

    A = "A"
    """The move's cells, and relations to tokens in the goal row: the paper's own rules."""
    B = "B"
    """A, and what the tokens in the goal row are."""
    C = "C"
    """The same over all cells."""


@dataclass(frozen=True)
class Vocabulary:
    """All literals over `features` on `board` with what the tokens of `deck` show.

    Its bit sets count literals from the lowest bit, in the order of `literals`.
    """

    board: Board
    deck: Deck
    level: Level
    features: tuple[Feature, ...]

    @cached_property
    def shown(self) -> tuple[Attributes, ...]:
        """The different things that tokens of the deck show; elsewhere an index into this.

        In the order of their values, so that people find 19 before 23 wherever it is listed.
        """
        different = {token.attributes for token in self.deck.tokens}
        return tuple(sorted(different, key=self._in_order))

    def _in_order(self, shown: Attributes) -> list[tuple[str, bool, int | Decimal, str]]:
        scales, rank = self.deck.scales, self.deck.rank
        return [
            (name, True, 0, str(value))
            if scales[name] is Scale.NOMINAL
            else (name, False, rank(name, value), "")
            for name, value in shown
        ]

    @cached_property
    def index_of_shown(self) -> Mapping[Attributes, int]:
        """Where each stands in `shown`."""
        return {attributes: index for index, attributes in enumerate(self.shown)}

    @cached_property
    def index_of_token(self) -> Mapping[TokenId, int]:
        """For each token of the deck, where what it shows stands in `shown`."""
        return {token.id: self.index_of_shown[token.attributes] for token in self.deck.tokens}

    def indices(self, deck: Deck) -> Mapping[TokenId, int]:
        """For each token of another deck, where what it shows stands in `shown`.

        What that deck declares (orders, relations...) does not count: this vocabulary's does.

        Raises:
            InvalidError: a token shows what no token of this vocabulary's deck does.
        """
        if deck is self.deck:
            return self.index_of_token
        known = self.index_of_shown
        expected = "a token that shows the same as one of its own"
        refuse(
            [
                Fault(f"tokens.{token.id}", "unknown to this exercise", expected)
                for token in deck.tokens
                if token.attributes not in known
            ]
        )
        return {token.id: known[token.attributes] for token in deck.tokens}

    @cached_property
    def cell_features(self) -> tuple[CellFeature, ...]:
        """Those of `features` that look at the move's cells."""
        return tuple(feature for feature in self.features if isinstance(feature, CellFeature))

    @cached_property
    def pair_features(self) -> tuple[PairFeature, ...]:
        """Those of `features` that look at two tokens."""
        return tuple(feature for feature in self.features if isinstance(feature, PairFeature))

    @cached_property
    def token_features(self) -> tuple[TokenFeature, ...]:
        """Those of `features` that look at the token on a cell: none at level A."""
        if self.level is Level.A:
            return ()
        return tuple(feature for feature in self.features if isinstance(feature, TokenFeature))

    @cached_property
    def literals(self) -> tuple[Literal, ...]:
        """Every literal, in the order of the bits."""
        return tuple(self.literal_at(place) for place in range(self.size))

    @cached_property
    def size(self) -> int:
        """How many literals there are."""
        return self.placed_size + len(self.watched) * self.block_size

    @cached_property
    def everything(self) -> Bits:
        """The set of all literals: the precondition that nothing satisfies."""
        return (1 << self.size) - 1

    @cached_property
    def placed_size(self) -> int:
        """How many literals, the first ones, speak of the move's cells."""
        return len(self._placed)

    @cached_property
    def block_size(self) -> int:
        """How many literals speak of the content of one watched cell."""
        return len(self._block)

    @cached_property
    def watched(self) -> tuple[Cell, ...]:
        """The cells whose content literals speak of."""
        return self.board.cells if self.level is Level.C else self.board.goal_cells

    @cached_property
    def offsets(self) -> Mapping[Cell, int]:
        """For each watched cell, where its block of bits begins."""
        first, size = self.placed_size, self.block_size
        return {cell: first + size * index for index, cell in enumerate(self.watched)}

    def literal_at(self, place: int) -> Literal:
        """The literal of one bit.

        Raises:
            IndexError: there are not so many.
        """
        if place < self.placed_size:
            return self._placed[place]
        index, within = divmod(place - self.placed_size, self.block_size)
        return replace(self._block[within], cell=self.watched[index])

    def place_of(self, literal: Literal) -> int:
        """The bit of a literal.

        Raises:
            KeyError: it is not in the vocabulary.
        """
        if isinstance(literal, Placed):
            return self._placed_places[literal]
        on_first_cell = replace(literal, cell=self.watched[0])
        return self.offsets[literal.cell] + self._block_places[on_first_cell]

    def select(self, bits: Bits) -> tuple[Literal, ...]:
        """The literals of a bit set."""
        return tuple(self.literal_at(place) for place in positions(bits))

    def bits(self, literals: Iterable[Literal]) -> Bits:
        """The bit set of some literals.

        Raises:
            KeyError: a literal that is not in the vocabulary.
        """
        bits = 0
        for literal in literals:
            bits |= 1 << self.place_of(literal)
        return bits

    def placed(self, origin: Cell, destination: Cell) -> Bits:
        """The literals that hold because a move goes from `origin` to `destination`."""
        # A number is found faster than a pair of cells.
        key = ((origin.row << 8 | origin.column) << 8 | destination.row) << 8 | destination.column
        known = self._placed_by_move.get(key)
        if known is None:
            known = self._placed_by_move[key] = self._work_out_placed(origin, destination)
        return known

    def patterns(self, moved: int) -> tuple[Bits, ...]:
        """For each thing shown, the bits that a token showing it on a cell makes hold.

        To be shifted by the cell's offset; `moved` is what the moved token shows.
        """
        known = self._patterns[moved]
        if known is None:
            known = self._patterns[moved] = self._work_out_patterns(moved)
        return known

    def holding(
        self, contents: Mapping[Cell, int], moved: int, origin: Cell, destination: Cell
    ) -> Bits:
        """The literals that hold before a move.

        Args:
            contents: what lies on the cells, as indices into `shown`; cells that the vocabulary
                does not look at may be there or not.
            moved: what the moved token shows.
            origin: where it lies.
            destination: where it goes.
        """
        return self.placed(origin, destination) | self.lying(contents, moved)

    def lying(self, contents: Mapping[Cell, int], moved: int) -> Bits:
        """The literals that hold before a move because of what lies on the cells."""
        bits = 0
        patterns = self.patterns(moved)
        offsets = self.offsets
        for cell, other in contents.items():
            if cell in offsets:
                bits |= patterns[other] << offsets[cell]
        return bits

    @cached_property
    def _placed(self) -> tuple[Placed, ...]:
        return tuple(
            Placed(feature, value)
            for feature in self.cell_features
            for value in feature.values(self.board)
        )

    @cached_property
    def _placed_places(self) -> Mapping[Placed, int]:
        return {literal: place for place, literal in enumerate(self._placed)}

    @cached_property
    def _placed_by_move(self) -> dict[int, Bits]:
        return {}

    def _work_out_placed(self, origin: Cell, destination: Cell) -> Bits:
        board = self.board
        return sum(
            bits.get(feature.of(board, origin, destination), 0)
            for feature, bits in self._placed_bits.items()
        )

    @cached_property
    def _placed_bits(self) -> Mapping[CellFeature, Mapping[CellValue, Bits]]:
        """For each feature of the move's cells, the bit of each of its values."""
        bits: dict[CellFeature, dict[CellValue, Bits]] = {}
        for place, literal in enumerate(self._placed):
            bits.setdefault(literal.feature, {})[literal.value] = 1 << place
        return bits

    @cached_property
    def _block(self) -> tuple[Related | Shows | Contains, ...]:
        """The literals about the content of the first watched cell."""
        cell = self.watched[0]
        # A relation that holds both ways or neither needs no converse.
        relations = [
            Related(cell, feature, converse)
            for feature in self.pair_features
            for converse in (False, True)
            if not (converse and feature.symmetric)
        ]
        tests = (Shows(cell, feature) for feature in self.token_features)
        contained = () if self.level is Level.A else self.shown
        return (*relations, *tests, *(Contains(cell, shown) for shown in contained))

    @cached_property
    def _block_places(self) -> Mapping[Related | Shows | Contains, int]:
        return {literal: place for place, literal in enumerate(self._block)}

    @cached_property
    def _patterns(self) -> list[tuple[Bits, ...] | None]:
        return [None] * len(self.shown)

    def _work_out_patterns(self, moved: int) -> tuple[Bits, ...]:
        patterns = list(self._of_itself)
        for place, (holds, converse) in enumerate(self._relations):
            for other in range(len(patterns)):
                true = holds[moved] >> other if converse else holds[other] >> moved
                if true & 1:
                    patterns[other] |= 1 << place
        return tuple(patterns)

    @cached_property
    def _relations(self) -> tuple[tuple[tuple[Bits, ...], bool], ...]:
        """The first literals of a block, which depend on what is moved.

        Each as the table of its feature, and whether it is the converse.
        """
        tables = {
            feature: pair_feature_table(feature, self.deck, self.shown)
            for feature in self.pair_features
        }
        relations = (one for one in self._block if isinstance(one, Related))
        return tuple((tables[one.feature], one.converse) for one in relations)

    @cached_property
    def _of_itself(self) -> tuple[Bits, ...]:
        """For each thing shown, the literals of a block that hold whatever is moved."""
        first = len(self._relations)
        contained = first + len(self.token_features)
        bits: list[Bits] = []
        for index, shown in enumerate(self.shown):
            tests = enumerate(self.token_features, start=first)
            own = sum(1 << place for place, one in tests if token_feature_holds(one, shown))
            bits.append(own if self.level is Level.A else own | 1 << contained + index)
        return tuple(bits)


def positions(bits: Bits) -> Iterator[int]:
    """The places of the bits that are set, from the lowest."""
    while bits:
        lowest = bits & -bits
        yield lowest.bit_length() - 1
        bits ^= lowest
