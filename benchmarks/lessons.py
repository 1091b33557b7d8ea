"""The lessons that the benchmarks learn: the paper's, and one on the largest board promised."""

from __future__ import annotations

from random import Random
from typing import Final

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId

PAPER_BOARD: Final = Board()
PAPER_VALUES: Final = (19, 23, 32, 34, 36, 46, 51, 55, 67, 72)
LARGE_BOARD: Final = Board(20, 20)


def deck_of(values: tuple[int, ...]) -> Deck:
    """A token for each value."""
    return Deck(tuple(Token(TokenId(f"t{n:03}"), (("value", v),)) for n, v in enumerate(values)))


PAPER_DECK: Final = deck_of(PAPER_VALUES)
LARGE_DECK: Final = deck_of(tuple(range(1, 101)))


def ascending(board: Board, deck: Deck, chosen: list[int], rng: Random) -> Demonstration:
    """The chosen tokens, smallest first, into the goal row from its left, from a random start."""
    cells = rng.sample(board.storage_cells, len(deck.tokens))
    start = {token.id: cell for token, cell in zip(deck.tokens, cells, strict=True)}
    moves = tuple(
        Move(deck.tokens[index].id, start[deck.tokens[index].id], goal)
        for index, goal in zip(sorted(chosen), board.goal_cells, strict=False)
    )
    return Demonstration(deck, State(board, start), moves)


def paper_lesson(rng: Random) -> list[Demonstration]:
    """Six windows of neighbouring values, each twice: all that "ascending" needs."""
    windows = [list(range(first, first + 5)) for first in range(6)]
    return [
        ascending(PAPER_BOARD, PAPER_DECK, window, rng) for window in windows for _ in range(2)
    ]


def random_lesson(board: Board, deck: Deck, count: int, rng: Random) -> list[Demonstration]:
    """Random right plays of "ascending"."""
    tokens, length = len(deck.tokens), board.columns
    return [ascending(board, deck, rng.sample(range(tokens), length), rng) for _ in range(count)]
