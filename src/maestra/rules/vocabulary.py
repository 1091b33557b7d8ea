"""The literals that preconditions are made of, and which of them hold before a move.

A precondition is a set of literals; here it is one integer with a bit for each literal of the
vocabulary, so that intersecting two sets is one instruction a word however large the board is.
The bits that depend on a token lying on a cell are the same for every cell but for their place,
so they are computed once for each pair of tokens and shifted.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from maestra.core.faults import Fault, InvalidError
from maestra.rules.features import (
    CellFeature,
    PairFeature,
    TokenFeature,
    pair_feature_holds,
    token_feature_holds,
)
from maestra.rules.literals import Contains, Literal, Placed, Related, Shows

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
        """The different things that tokens of the deck show; elsewhere an index into this."""
        return tuple(dict.fromkeys(token.attributes for token in self.deck.tokens))

    @cached_property
    def index_of_shown(self) -> Mapping[Attributes, int]:
        """Where each stands in `shown`."""
        return {attributes: index for index, attributes in enumerate(self.shown)}

    @cached_property
    def index_of_token(self) -> Mapping[TokenId, int]:
        """For each token of the deck, where what it shows stands in `shown`."""
        return {token.id: self.index_of_shown[token.attributes] for token in self.deck.tokens}

    @cached_property
    def literals(self) -> tuple[Literal, ...]:
        """Every literal, in the order of the bits."""
        placed = (Placed(feature, value) for feature, value in self._placed_places)
        return (*placed, *(literal for cell in self.watched for literal in self._block(cell)))

    @cached_property
    def everything(self) -> Bits:
        """The set of all literals: the precondition that nothing satisfies."""
        return (1 << self._size) - 1

    @cached_property
    def placed_size(self) -> int:
        """How many literals, the first ones, speak of the move's cells."""
        return len(self._placed_places)

    @cached_property
    def offsets(self) -> Mapping[Cell, int]:
        """For each cell whose content is part of the vocabulary, where its bits begin."""
        first, size = self.placed_size, self.block_size
        return {cell: first + size * index for index, cell in enumerate(self.watched)}

    def placed(self, origin: Cell, destination: Cell) -> Bits:
        """The literals that hold because a move goes from `origin` to `destination`."""
        cache = self._placed_cache
        key = (origin, destination)
        if key not in cache:
            cells = self.cell_features
            values = [(feature, feature.of(self.board, origin, destination)) for feature in cells]
            places = self._placed_places
            cache[key] = sum(1 << places[pair] for pair in values if pair in places)
        return cache[key]

    def patterns(self, moved: int) -> tuple[Bits, ...]:
        """For each thing shown, the bits that a token showing it on a cell makes hold.

        To be shifted by the cell's offset; `moved` is what the moved token shows.
        """
        rows = self._pattern_rows
        if moved not in rows:
            rows[moved] = tuple(self._pattern(other, moved) for other in range(len(self.shown)))
        return rows[moved]

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
        row = self.patterns(moved)
        offsets = self.offsets
        for cell, other in contents.items():
            if cell in offsets:
                bits |= row[other] << offsets[cell]
        return bits

    def indices(self, deck: Deck) -> Mapping[TokenId, int]:
        """For each token of another deck, where what it shows stands in `shown`.

        Raises:
            InvalidError: a token shows what no token of this vocabulary's deck does.
        """
        if deck is self.deck:
            return self.index_of_token
        known = self.index_of_shown
        faults = [
            Fault(f"tokens.{token.id}", "unknown to this exercise", "a token like its own")
            for token in deck.tokens
            if token.attributes not in known
        ]
        if faults:
            raise InvalidError(faults)
        return {token.id: known[token.attributes] for token in deck.tokens}

    def select(self, bits: Bits) -> tuple[Literal, ...]:
        """The literals of a bit set."""
        return tuple(self.literals[index] for index in positions(bits))

    def bits(self, literals: Iterable[Literal]) -> Bits:
        """The bit set of some literals.

        Raises:
            KeyError: a literal that is not in the vocabulary.
        """
        return sum(1 << self._place_of[literal] for literal in frozenset(literals))

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
    def _placed_places(self) -> Mapping[tuple[CellFeature, CellValue], int]:
        board = self.board
        pairs = [
            (feature, value) for feature in self.cell_features for value in feature.values(board)
        ]
        return {pair: index for index, pair in enumerate(pairs)}

    @cached_property
    def watched(self) -> tuple[Cell, ...]:
        """The cells whose content literals speak of."""
        return self.board.cells if self.level is Level.C else self.board.goal_cells

    @cached_property
    def _sides(self) -> tuple[tuple[PairFeature, bool], ...]:
        """Each feature of two tokens, and its converse unless that says the same."""
        both = (
            (feature, converse) for feature in self.pair_features for converse in (False, True)
        )
        return tuple(side for side in both if not (side[1] and side[0].symmetric))

    @cached_property
    def _contained(self) -> tuple[Attributes, ...]:
        return () if self.level is Level.A else self.shown

    @cached_property
    def block_size(self) -> int:
        """How many literals speak of the content of one watched cell."""
        return len(self._sides) + len(self.token_features) + len(self._contained)

    @cached_property
    def _size(self) -> int:
        return self.placed_size + len(self.watched) * self.block_size

    def _block(self, cell: Cell) -> Iterator[Literal]:
        """The literals about the content of one cell, in the order of `_pattern`."""
        yield from (Related(cell, feature, converse) for feature, converse in self._sides)
        yield from (Shows(cell, feature) for feature in self.token_features)
        yield from (Contains(cell, shown) for shown in self._contained)

    def _pattern(self, other: int, moved: int) -> Bits:
        there, own = self.shown[other], self.shown[moved]
        truths = [
            pair_feature_holds(feature, self.deck, *((own, there) if converse else (there, own)))
            for feature, converse in self._sides
        ]
        truths += [token_feature_holds(feature, there) for feature in self.token_features]
        bits = sum(1 << place for place, true in enumerate(truths) if true)
        return bits | (1 << (len(truths) + other)) if self._contained else bits

    @cached_property
    def _place_of(self) -> Mapping[Literal, int]:
        return {literal: index for index, literal in enumerate(self.literals)}

    @cached_property
    def _placed_cache(self) -> dict[tuple[Cell, Cell], Bits]:
        return {}

    @cached_property
    def _pattern_rows(self) -> dict[int, tuple[Bits, ...]]:
        return {}


def positions(bits: Bits) -> Iterator[int]:
    """The places of the bits that are set, from the lowest."""
    while bits:
        lowest = bits & -bits
        yield lowest.bit_length() - 1
        bits ^= lowest
