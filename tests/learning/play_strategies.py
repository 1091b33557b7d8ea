"""Random demonstrations on small boards: any moves a board allows, with or without a rule."""

from hypothesis import strategies as st

from maestra.core.board import Board, Row
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Attributes, Deck, Token, TokenId
from maestra.rules.strips.vocabulary import Level

LOOKS: tuple[Attributes, ...] = (
    (("value", 1),),
    (("value", 2),),
    (("value", 3),),
    # In formulas these look alike, as do the first two and the third above.
    (("colour", "dark red"),),
    (("colour", "dark-red"),),
    (("colour", "v3"),),
)

SELECTIONS = (None, ["cells"], ["same-column", "same"], ["destination", "origin-row", "different"])


@st.composite
def demonstrations(draw: st.DrawFn) -> list[Demonstration]:
    """One to four plays on one board with one deck."""
    rows, columns = draw(st.sampled_from([(2, 1), (2, 2), (3, 2), (2, 3)]))
    board = Board(rows, columns, Row(draw(st.integers(1, rows))))
    count = draw(st.integers(1, min(3, rows * columns - 1)))
    looks = draw(st.lists(st.sampled_from(LOOKS), min_size=count, max_size=count))
    deck = Deck(tuple(Token(TokenId(f"t{n}"), look) for n, look in enumerate(looks)))
    return [_play(draw, board, deck) for _ in range(draw(st.integers(1, 4)))]


def _play(draw: st.DrawFn, board: Board, deck: Deck) -> Demonstration:
    ids = [token.id for token in deck.tokens]
    cells = draw(st.permutations(board.cells))
    start = state = State(board, dict(zip(ids, cells, strict=False)))
    moves: list[Move] = []
    for _ in range(draw(st.integers(0, 4))):
        token = draw(st.sampled_from(ids))
        empty = [cell for cell in board.cells if cell not in state.tokens]
        moves.append(Move(token, state.cells[token], draw(st.sampled_from(empty))))
        state = state.after(moves[-1])
    return Demonstration(deck, start, tuple(moves))


levels = st.sampled_from(Level)
selections = st.sampled_from(SELECTIONS)
