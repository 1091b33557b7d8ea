"""Random lessons, small enough to be searched by brute force: any board, deck and moves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

from hypothesis import strategies as st

from maestra.core.board import Board, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.features import select_features
from maestra.rules.strips.vocabulary import Level, Vocabulary

DAYS = ("Mon", "Tue", "Wed")
VALUES: Mapping[str, tuple[Value, ...]] = {
    "value": (1, 2, 3, 4, -7, 10, Decimal("2.5")),
    "letter": ("a", "Á", "n", "ñ", "o"),
    "colour": ("red", "blue"),
    "day": DAYS,
    "name": ("cup", "saucer"),
}
FEATURES: Mapping[str, tuple[str, ...]] = {
    "value": ("odd", "prime", "multiple-of-5", "digits-2", "above-2", "below-2", "twice"),
    "letter": ("vowel", "consonant", "before", "successor:letter"),
    "colour": ("same:colour", "different:colour"),
    "day": ("predecessor:day", "different:day"),
    "name": ("partner", "same:name"),
}
"""Some features of each attribute; `less-than`, `before`... come by default."""
CELL_SELECTIONS: tuple[tuple[str, ...], ...] = (
    ("cells",),
    ("destination",),
    ("same-column", "origin-row"),
    ("origin-column", "destination-column"),
    ("from-storage",),
)


@dataclass(frozen=True)
class Lesson:
    """Demonstrations on one board with one deck, and what counts."""

    demonstrations: tuple[Demonstration, ...]
    vocabulary: Vocabulary

    @property
    def deck(self) -> Deck:
        """Of all plays."""
        return self.demonstrations[0].deck


@st.composite
def lessons(draw: st.DrawFn, *, most: int = 4) -> Lesson:
    """One to `most` plays; in half of the lessons all moves go from storage to the goal row."""
    rows, columns = draw(st.sampled_from([(1, 3), (2, 2), (3, 2), (2, 3), (4, 1)]))
    board = Board(rows, columns, Row(draw(st.integers(1, rows))))
    deck = draw(decks(draw(st.integers(1, min(4, rows * columns - 1)))))
    one_way = draw(st.booleans())
    plays = tuple(draw(play(deck, board, one_way)) for _ in range(draw(st.integers(1, most))))
    return Lesson(plays, draw(vocabularies(board, deck)))


@st.composite
def decks(draw: st.DrawFn, count: int) -> Deck:
    """Tokens of few values, so that some look the same; what they show is declared or not."""
    names = draw(st.sampled_from(sorted(VALUES)) | st.just("value"))
    chosen = sorted({names, *draw(st.sets(st.sampled_from(sorted(VALUES)), max_size=1))})
    optional = {name: st.sampled_from(VALUES[name]) for name in chosen}
    tokens = [
        Token(TokenId(f"t{n}"), tuple(draw(st.fixed_dictionaries({}, optional=optional)).items()))
        for n in range(count)
    ]
    declared = draw(st.sampled_from([{}, {"day": DAYS}]))
    cyclic = draw(st.booleans())
    return Deck(
        tuple(tokens),
        {} if cyclic else declared,
        declared if cyclic else {},
        {"partner": frozenset({("cup", "saucer")})},
    )


@st.composite
def vocabularies(draw: st.DrawFn, board: Board, deck: Deck) -> Vocabulary:
    """A vocabulary of the deck's own features."""
    names: list[str] | None = None
    if draw(st.booleans()):
        names = list(draw(st.sampled_from(CELL_SELECTIONS)))
        scales = {scale.value for name, scale in deck.scales.items() if name == "day"}
        for attribute in deck.scales:
            able = [
                f for f in FEATURES[attribute] if "predecessor" not in f or "nominal" not in scales
            ]
            names += draw(st.lists(st.sampled_from(able), max_size=3))
    return Vocabulary(board, deck, draw(st.sampled_from(Level)), select_features(deck, names))


@st.composite
def play(draw: st.DrawFn, deck: Deck, board: Board, one_way: bool) -> Demonstration:  # noqa: FBT001 - drawn, not set
    """Up to three legal moves."""
    ids = [token.id for token in deck.tokens]
    cells = draw(st.permutations(board.cells))
    start = state = State(board, dict(zip(ids, cells, strict=False)))
    moves: list[Move] = []
    for _ in range(draw(st.integers(0, 3))):
        able = _moves(state, one_way=one_way)
        if not able:
            break
        moves.append(draw(st.sampled_from(able)))
        state = state.after(moves[-1])
    return Demonstration(deck, start, tuple(moves))


def _moves(state: State, *, one_way: bool) -> Sequence[Move]:
    goal = state.board.goal_row
    return [
        Move(token, origin, destination)
        for token, origin in state.cells.items()
        for destination in state.board.cells
        if destination not in state.tokens
        and not (one_way and (origin.row == goal or destination.row != goal))
    ]
