"""Random exercises, so small that every right play can be listed: the oracle of what is exact."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import permutations

from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.features import feature_names, select_features
from maestra.rules.right_plays import Placement, Placements, RightPlays
from maestra.rules.strips.vocabulary import Level, Vocabulary

Origins = Mapping[tuple[int, TokenId], frozenset[Cell] | None]

SELECTIONS = (None, ["cells"], ["same-column", "odd", "same"], ["less-than", "origin-row"])


@st.composite
def small_exercises(draw: st.DrawFn, *, tokens: int = 4, cells: int = 6) -> RightPlays:
    """Right plays drawn from all that a board with at most `cells` storage cells allows."""
    rows, columns = draw(st.sampled_from([(2, 1), (2, 2), (3, 1), (3, 2), (2, 3), (3, 3)]))
    goal = draw(st.integers(1, rows))
    board = Board(rows, columns, Row(goal))
    storage = board.storage_cells[:cells]
    count = draw(st.integers(1, min(tokens, len(storage))))
    values = draw(st.lists(st.integers(1, 5), min_size=count, max_size=count))
    deck = Deck(tuple(Token(TokenId(f"t{n}"), (("value", v),)) for n, v in enumerate(values)))
    most = min(count, columns)
    lengths = draw(st.frozensets(st.integers(1, most), min_size=1, max_size=2))
    possible = [one for length in sorted(lengths) for one in sequences(board, deck, length)]
    right = frozenset(draw(st.lists(st.sampled_from(possible), min_size=1, max_size=6)))
    beginnings = frozenset(one[:end] for one in right for end in range(len(one) + 1))
    some = st.one_of(st.none(), st.frozensets(st.sampled_from(board.storage_cells), min_size=1))
    keys = [(step, token.id) for step in range(1, most + 1) for token in deck.tokens]
    allowed: Origins = {key: draw(some) for key in keys} if draw(st.booleans()) else {}
    return RightPlays(
        board,
        deck,
        right.__contains__,
        beginnings.__contains__,
        lambda step, one: allowed.get((step, one.token)),
        lengths,
    )


@st.composite
def vocabularies(draw: st.DrawFn, plays: RightPlays) -> Vocabulary:
    """A vocabulary over the exercise's board and deck."""
    names = draw(st.sampled_from(SELECTIONS))
    level = draw(st.sampled_from(Level))
    assert names is None or set(names) <= set(feature_names(plays.deck))
    return Vocabulary(plays.board, plays.deck, level, select_features(plays.deck, names))


def sequences(board: Board, deck: Deck, length: int) -> Iterator[Placements]:
    """Every sequence of placements of this length, by the shortest program."""
    for cells in permutations(board.goal_cells, length):
        for tokens in permutations(deck.tokens, length):
            yield tuple(
                Placement(token.id, cell) for token, cell in zip(tokens, cells, strict=True)
            )


def every_play(plays: RightPlays) -> Iterator[Demonstration]:
    """Every right play from every start arrangement, by the shortest program."""
    tokens = [token.id for token in plays.deck.tokens]
    for length in plays.lengths:
        for placements in sequences(plays.board, plays.deck, length):
            if not plays.right(placements):
                continue
            for cells in permutations(plays.board.storage_cells, len(tokens)):
                start = dict(zip(tokens, cells, strict=True))
                allowed = [
                    plays.origins(step, one) for step, one in enumerate(placements, start=1)
                ]
                if all(
                    some is None or start[one.token] in some
                    for some, one in zip(allowed, placements, strict=True)
                ):
                    moves = [Move(o.token, start[o.token], o.destination) for o in placements]
                    state = State(plays.board, start)
                    yield Demonstration(plays.deck, state, tuple(moves), source="simulated")
