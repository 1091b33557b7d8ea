"""A board as pages show it; `parts/board.html` makes HTML of it, and nothing else draws boards."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import State
from maestra.core.tokens import Deck, TokenId
from maestra.language import NO_LEXICON, Language, Lexicon
from maestra.language.languages import speaker_for
from maestra.web.token_view import TokenView, token_view

NO_PICTURES: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class CellView:
    """One cell, and what is to be seen there."""

    row: Row
    column: Column
    token: TokenView | None = None
    is_goal: bool = False
    held: bool = False
    """Its token is in somebody's hand."""
    pointed: bool = False
    """The robot points here."""
    wrong: bool = False
    """What lies here is wrong, or probably a slip."""
    allowed: bool = False
    """What lies or may be put here is right."""

    @property
    def value(self) -> str:
        """What the form sends: ``2,3``."""
        return f"{self.row},{self.column}"


@dataclass(frozen=True, slots=True)
class BoardView:
    """A board row by row, each from the left."""

    rows: tuple[tuple[CellView, ...], ...]
    goal_row: Row
    held: TokenId | None = None
    """The token in somebody's hand."""

    @property
    def columns(self) -> int:
        """How many cells a row has."""
        return len(self.rows[0])

    @property
    def cells(self) -> tuple[CellView, ...]:
        """All cells, row by row."""
        return tuple(cell for row in self.rows for cell in row)

    @property
    def goal(self) -> tuple[CellView, ...]:
        """The goal row's cells."""
        return self.rows[self.goal_row - 1]


def board_view(  # noqa: PLR0913 - keywords that most callers leave out
    board: Board,
    deck: Deck,
    cells: Mapping[TokenId, Cell],
    *,
    language: Language = Language.EN,
    lexicon: Lexicon = NO_LEXICON,
    held: TokenId | None = None,
    pointed: Collection[Cell] = (),
    wrong: Collection[Cell] = (),
    allowed: Collection[Cell] = (),
    pictures: Mapping[str, str] = NO_PICTURES,
) -> BoardView:
    """The board with the tokens of `deck` where `cells` says.

    Args:
        board: its size.
        deck: what the tokens show.
        cells: where tokens lie; those that are not named are not on the board.
        language: for what stands on the tokens and is read aloud.
        lexicon: a caregiver's own words.
        held: the token in somebody's hand; it still shows on the cell that it comes from.
        pointed: where the robot points.
        wrong: cells to be marked as wrong.
        allowed: cells to be marked as right.
        pictures: what tokens show under `picture`, to addresses.
    """
    speaker = speaker_for(language, board, deck, lexicon)
    # Only those of the board: `State` refuses what cannot lie there.
    lying = State(board, cells).tokens
    views = [
        CellView(
            cell.row,
            cell.column,
            token_view(deck.by_id[lying[cell]], speaker, pictures) if cell in lying else None,
            is_goal=cell.row == board.goal_row,
            held=held is not None and lying.get(cell) == held,
            pointed=cell in pointed,
            wrong=cell in wrong,
            allowed=cell in allowed,
        )
        for cell in board.cells
    ]
    wide = board.columns
    rows = tuple(tuple(views[k * wide : (k + 1) * wide]) for k in range(board.rows))
    return BoardView(rows, board.goal_row, held if held in cells else None)


def tokens_by_id(
    deck: Deck,
    board: Board,
    language: Language,
    lexicon: Lexicon = NO_LEXICON,
    pictures: Mapping[str, str] = NO_PICTURES,
) -> Mapping[TokenId, TokenView]:
    """What each token of the deck looks like: for the stream."""
    speaker = speaker_for(language, board, deck, lexicon)
    return {token.id: token_view(token, speaker, pictures) for token in deck.tokens}
