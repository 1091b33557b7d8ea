"""The board as text: the goal row in heavy lines, so that it is told apart without colour."""

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Final, TypeAlias

from maestra.core.board import Board, Cell
from maestra.core.state import State
from maestra.core.tokens import LETTER, NAME, Deck, Token, TokenId

MIN_WIDTH: Final = 4
"""Of a cell, in characters, with its margins."""
MAX_LABEL: Final = 10
"""Characters of a token's label; what is longer is cut."""
_PREFERRED: Final = ("value", LETTER, NAME)
"""What a token is labelled with, if it shows several things."""


class Look(Enum):
    """What a piece of the drawing is: a terminal with colours gives each its own."""

    LINE = "line"
    GOAL = "goal"
    STORAGE = "storage"
    TOKEN = "token"
    NOTE = "note"


Piece: TypeAlias = tuple[str, Look]


@dataclass(frozen=True, slots=True)
class Strokes:
    """What a board is drawn with; a rule is its line, left end, crossings and right end."""

    top: str
    heavy_top: str
    light: str
    below_heavy: str
    above_heavy: str
    bottom: str
    heavy_bottom: str
    side: str
    heavy_side: str


UNICODE: Final = Strokes(
    top="─┌┬┐",
    heavy_top="━┏┳┓",
    light="─├┼┤",
    below_heavy="━┡╇┩",
    above_heavy="━┢╈┪",
    bottom="─└┴┘",
    heavy_bottom="━┗┻┛",
    side="│",
    heavy_side="┃",
)
ASCII: Final = Strokes(
    top="-+++",
    heavy_top="=+++",
    light="-+++",
    below_heavy="=+++",
    above_heavy="=+++",
    bottom="-+++",
    heavy_bottom="=+++",
    side="|",
    heavy_side="#",
)


def strokes_for(encoding: str | None) -> Strokes:
    """Those that a terminal of this encoding can show."""
    try:
        "━┏┳┓─├┼┤".encode(encoding or "ascii")
    except (LookupError, UnicodeEncodeError):
        return ASCII
    return UNICODE


def label(token: Token) -> str:
    """What is written on a token: the one thing it shows, or the first that people look for."""
    shown = dict(token.attributes)
    names = [*(name for name in _PREFERRED if name in shown), *shown]
    text = str(shown[names[0]]) if names else token.id
    return text if len(text) <= MAX_LABEL else f"{text[: MAX_LABEL - 1]}…"


def draw(state: State, deck: Deck, goal: str, strokes: Strokes) -> Iterator[list[Piece]]:
    """The board with its tokens, line by line.

    Args:
        state: what lies where.
        deck: its tokens.
        goal: what stands beside the goal row.
        strokes: what to draw with.
    """
    board = state.board
    labels = {token.id: label(token) for token in deck.tokens}
    width = max(MIN_WIDTH, *(len(text) + 2 for text in labels.values()))
    margin = max(len(goal), len(str(board.rows))) + 3
    numbers = "".join(f"{column:^{width + 1}}" for column in range(1, board.columns + 1))
    yield [(f"{'':{margin + 1}}{numbers}".rstrip(), Look.NOTE)]
    for row in range(1, board.rows + 1):
        yield [(" " * margin, Look.NOTE), (_rule_above(row, board, width, strokes), Look.LINE)]
        yield [*_row(row, state, labels, width, (goal, margin), strokes)]
    yield [(" " * margin, Look.NOTE), (_rule_below(board, width, strokes), Look.LINE)]


def board_lines(state: State, deck: Deck, goal: str) -> Iterator[str]:
    """The same as plain text, for standard output."""
    for pieces in draw(state, deck, goal, strokes_for(sys.stdout.encoding)):
        yield "".join(text for text, _ in pieces)


def _row(
    row: int,
    state: State,
    labels: dict[TokenId, str],
    width: int,
    beside: tuple[str, int],
    strokes: Strokes,
) -> Iterator[Piece]:
    board = state.board
    is_goal = row == board.goal_row
    goal, margin = beside
    side = strokes.heavy_side if is_goal else strokes.side
    yield (f" {goal if is_goal else row:>{margin - 2}} ", Look.NOTE)
    for cell in board.cells[(row - 1) * board.columns : row * board.columns]:
        yield (side, Look.LINE)
        yield _content(cell, state, labels, width, is_goal=is_goal)
    yield (side, Look.LINE)


def _content(
    cell: Cell, state: State, labels: dict[TokenId, str], width: int, *, is_goal: bool
) -> Piece:
    token = state.tokens.get(cell)
    if token is not None:
        return (f"{labels[token]:^{width}}", Look.TOKEN)
    return (" " * width, Look.GOAL if is_goal else Look.STORAGE)


def _rule_above(row: int, board: Board, width: int, strokes: Strokes) -> str:
    is_goal, below_goal = row == board.goal_row, row == board.goal_row + 1
    if row == 1:
        return _rule(strokes.heavy_top if is_goal else strokes.top, board, width)
    if is_goal:
        return _rule(strokes.above_heavy, board, width)
    return _rule(strokes.below_heavy if below_goal else strokes.light, board, width)


def _rule_below(board: Board, width: int, strokes: Strokes) -> str:
    is_goal = board.rows == board.goal_row
    return _rule(strokes.heavy_bottom if is_goal else strokes.bottom, board, width)


def _rule(ends: str, board: Board, width: int) -> str:
    between = ends[2].join([ends[0] * width] * board.columns)
    return f"{ends[1]}{between}{ends[3]}"
