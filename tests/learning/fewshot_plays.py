"""Plays on the paper's board for the tests of the few-shot learner."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId

VALUES = (19, 23, 32, 34, 36, 46, 51, 67, 72, 85)
LETTERS = "CURIEAGBDO"
COLOURS = ("red", "blue", "red", "green", "blue", "green", "red", "blue", "green", "red")
DECK = Deck(
    tuple(
        Token(TokenId(f"t{k}"), (("value", v), ("letter", letter), ("colour", colour)))
        for k, (v, letter, colour) in enumerate(zip(VALUES, LETTERS, COLOURS, strict=True))
    )
)
BOARD = Board()


def start(turn: int = 0, deck: Deck = DECK, board: Board = BOARD) -> State:
    """The tokens in storage, `turn` cells further on."""
    cells = board.storage_cells
    return State(
        board, {t.id: cells[(7 * k + turn) % len(cells)] for k, t in enumerate(deck.tokens)}
    )


def shown(
    tokens: Sequence[int],
    turn: int = 0,
    order: Sequence[int] | None = None,
    deck: Deck = DECK,
    board: Board = BOARD,
) -> Demonstration:
    """These tokens on the goal cells from the left, placed in `order`."""
    state = start(turn, deck, board)
    ids = [deck.tokens[k].id for k in tokens]
    cells = list(order) if order is not None else list(range(len(ids)))
    moves = [Move(ids[c], state.cells[ids[c]], board.goal_cells[c]) for c in cells]
    return Demonstration(deck, state, tuple(moves))
