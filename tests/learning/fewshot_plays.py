"""Decks, boards and plays for the tests of the few-shot learner."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.lesson import Lesson
from maestra.rules.answers import Answer, Question, Reply
from maestra.rules.setting import Play, Setting, play_of

VALUES = (19, 23, 32, 34, 36, 46, 51, 67, 72, 85)
LETTERS = "CURIEAGBDO"
COLOURS = ("red", "blue", "red", "green", "blue", "green", "red", "blue", "green", "red")
DECK = Deck(
    tuple(
        Token(TokenId(f"t{k}"), (("value", v), ("letter", letter), ("colour", colour)))
        for k, (v, letter, colour) in enumerate(zip(VALUES, LETTERS, COLOURS, strict=True))
    )
)
"""The tokens are numbered by their value."""
BOARD = Board()

DAYS, SIZES = ("Mon", "Tue", "Wed", "Thu"), ("small", "large")
RICH_DECK = Deck(
    tuple(
        Token(
            TokenId(f"t{k}"),
            (
                ("value", (1, 2, 4, 8, 5, 9)[k]),
                ("day", DAYS[k % 4]),
                ("size", SIZES[k % 2]),
                ("name", "abcdef"[k]),
                ("letter", "CURATE"[k]),
                ("kind", ("red", "blue", "red", "blue", "red", "green")[k]),
                ("sort", ("red", "red", "blue", "blue", "green", "green")[k]),
            ),
        )
        for k in range(6)
    ),
    {"size": SIZES},
    {"day": DAYS},
    {
        "partner": frozenset({("a", "b"), ("c", "d"), ("e", "f")}),
        "category": frozenset({("CUR", "dog"), ("RAT", "rodent")}),
    },
    ("CUR", "RAT", "TEA"),
)
"""Something of every scale, relations and a lexicon."""
SMALL_BOARD = Board(4, 3)


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


def rich(
    tokens: Sequence[int], turn: int = 0, order: Sequence[int] | None = None
) -> Demonstration:
    """These tokens of the rich deck on the small board."""
    return shown(tokens, turn, order, RICH_DECK, SMALL_BOARD)


def small(*, given: bool = False) -> Setting:
    """Six tokens and three goal cells; perhaps one of them lies there already."""
    placed = dict(start(0, Deck(DECK.tokens[:6]), SMALL_BOARD).cells)
    if given:
        placed[DECK.tokens[0].id] = SMALL_BOARD.goal_cells[1]
    return Setting(Deck(DECK.tokens[:6]), State(SMALL_BOARD, placed))


def anywhere(deck: Deck, board: Board, rng: Random) -> Setting:
    """The tokens anywhere in storage."""
    cells = rng.sample(board.storage_cells, len(deck.tokens))
    return Setting(
        deck, State(board, {t.id: cell for t, cell in zip(deck.tokens, cells, strict=True)})
    )


def placed(setting: Setting, row: Sequence[int], order: Sequence[int] | None = None) -> Play:
    """These tokens on the goal cells, cell by cell in `order`."""
    play = Play.begin(setting)
    for cell in order or range(len(row)):
        play = play.after(row[cell], cell)
    return play


def demonstrated(play: Play) -> Demonstration:
    """The play as it was shown."""
    return Demonstration(play.setting.deck, play.setting.start, play.moves())


def row(tokens: Sequence[int], turn: int = 0) -> Play:
    """A play of these tokens of the deck."""
    return play_of(shown(tokens, turn))


def answered(lesson: Lesson, question: Question, reply: Reply) -> Lesson:
    """The lesson with one more answer."""
    return learn(lesson.demonstrations, (*lesson.answers, Answer(question, reply)))
