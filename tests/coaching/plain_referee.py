"""Small games whose right plays are listed: the oracle of what a hint may say."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import permutations

from maestra.coaching.referee import Refused, Right, Ruling
from maestra.coaching.session import Game
from maestra.coaching.settings import Settings
from maestra.core.board import Board, Cell, Column
from maestra.core.board import Row as BoardRow
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.language.languages import speaker_for
from maestra.language.speaker import Speaker
from maestra.rules.position import Position

BOARD = Board(3, 3, BoardRow(1))
VALUES = (3, 5, 8, 13, 21)
DECK = Deck(tuple(Token(TokenId(f"t{value}"), (("value", value),)) for value in VALUES))
TOKENS = tuple(token.id for token in DECK.tokens)
Row = tuple[TokenId, ...]


def cell(row: int, column: int) -> Cell:
    return Cell(BoardRow(row), Column(column))


def start(cells: Sequence[Cell] = BOARD.storage_cells[: len(VALUES)]) -> State:
    return State(BOARD, dict(zip(TOKENS, cells, strict=True)))


START = start()
"""t13 t21 t3 in row 2, t5 t8 in row 3: ids are sorted as text."""


def token(value: int) -> TokenId:
    return TokenId(f"t{value}")


def row_of(*values: int) -> Row:
    return tuple(map(token, values))


ASCENDING = frozenset(row_of(*sorted(row)) for row in permutations(VALUES, 3))
ONE_OR_TWO_RISING = frozenset(
    row_of(*row)
    for length in (1, 2)
    for row in permutations(VALUES, length)
    if row == tuple(sorted(row))
)
ANYTHING = frozenset(row_of(*row) for row in permutations(VALUES, 3))
NOTHING: frozenset[Row] = frozenset()


@dataclass(frozen=True)
class PlainReferee:
    """Right is what begins, from the left, a row that is listed."""

    rows: frozenset[Row]
    rules: tuple[str, ...] = (
        "Each token must be larger than the one on its left.",
        "This is a sentence about the rule that is much too long for any patient to follow.",
    )
    language: Language = Language.EN
    deck: Deck = field(default=DECK)

    @property
    def speaker(self) -> Speaker:
        return speaker_for(self.language, BOARD, self.deck)

    def judge(self, position: Position, move: Move) -> Ruling:
        position.after(move)
        if move in self.right_moves(position):
            return Right()
        return Refused("It is not larger than the one on its left.", ("ascending",))

    def right_moves(self, position: Position) -> tuple[Move, ...]:
        placed = tuple(move.token for move in position.moves)
        made = len(placed)
        begun = sorted(
            {row[made] for row in self.rows if row[:made] == placed and len(row) > made}
        )
        destination = cell(1, made + 1)
        if destination in position.now.tokens:
            return ()
        cells = position.now.cells
        return tuple(Move(one, cells[one], destination) for one in begun)

    def may_end(self, position: Position) -> bool:
        return tuple(move.token for move in position.moves) in self.rows


def game(
    settings: Settings | None = None,
    rows: frozenset[Row] = ASCENDING,
    seed: int = 1,
    language: Language = Language.EN,
) -> Game:
    """A game with listed right rows; the settings are the defaults if none are given."""
    referee = PlainReferee(rows, language=language)
    return Game(referee, settings or Settings(language=language), START, seed)
