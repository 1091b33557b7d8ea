"""Hypothesis strategies for the things of the core: boards, decks, states, demonstrations.

All are small, so that examples are read and shrunk quickly, and legal: no board is too small
for its deck, no move impossible. What is illegal is spelled out by the tests that refuse it.
"""

from collections.abc import Mapping
from decimal import Decimal
from typing import get_args

from hypothesis import strategies as st

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.demonstration import Demonstration, Source
from maestra.core.state import Move, State
from maestra.core.tokens import MAX_NUMBER, NAME, Deck, Token, TokenId, Value

MAX_TOKENS = 6


def texts(min_size: int = 0, max_size: int = 8) -> st.SearchStrategy[str]:
    """Text that may be a value, or with `min_size` 1 an id or a name."""
    signs = st.characters(exclude_categories=["Cc", "Cs"])
    return st.text(signs, min_size=min_size, max_size=max_size)


def names() -> st.SearchStrategy[str]:
    """An id, a name, a word."""
    return texts(min_size=1)


def token_ids() -> st.SearchStrategy[TokenId]:
    """Mostly as tags have them, sometimes any text."""
    uids = st.binary(min_size=4, max_size=10).map(lambda uid: uid.hex().upper())
    return st.builds(TokenId, uids | names())


def decimals() -> st.SearchStrategy[Decimal]:
    """Numbers with a fraction that 64 bits hold: 15 digits at most."""
    digits = st.integers(-MAX_NUMBER + 1, MAX_NUMBER - 1)
    return st.builds(_scaled, digits, st.integers(0, 20))


def _scaled(number: int, places: int) -> Decimal:
    return Decimal(number).scaleb(-places)


def numbers() -> st.SearchStrategy[int | Decimal]:
    """What an ordinal attribute can hold."""
    return st.integers(-MAX_NUMBER, MAX_NUMBER) | st.integers(0, 99) | decimals()


def values() -> st.SearchStrategy[Value]:
    """What any attribute can hold."""
    return numbers() | texts()


@st.composite
def boards(draw: st.DrawFn, min_cells: int = 2, max_side: int = 5) -> Board:
    """A board of `min_cells` cells or more, its goal row at any row."""
    rows = draw(st.integers(1, max_side))
    columns = draw(st.integers(max(1, -(-min_cells // rows)), max(max_side, min_cells)))
    return Board(rows, columns, Row(draw(st.integers(1, rows))))


def cells(board: Board) -> st.SearchStrategy[Cell]:
    """A cell of `board`."""
    return st.builds(
        Cell,
        st.builds(Row, st.integers(1, board.rows)),
        st.builds(Column, st.integers(1, board.columns)),
    )


@st.composite
def decks(draw: st.DrawFn, max_tokens: int = MAX_TOKENS) -> Deck:
    """A deck with any kinds of attributes, orders, cycles, relations, a lexicon."""
    ids = draw(st.lists(token_ids(), min_size=1, max_size=max_tokens, unique=True))
    kinds = draw(
        st.dictionaries(
            st.sampled_from([NAME, "letter", "colour"]) | names(), _kinds(), max_size=3
        )
    )
    tokens = tuple(
        Token(token, tuple(draw(st.fixed_dictionaries({}, optional=kinds)).items()))
        for token in ids
    )
    ordered, cyclic = _declared(draw, tokens), _declared(draw, tokens)
    pairs = st.frozensets(st.tuples(names(), names()), max_size=3)
    return Deck(
        tokens,
        ordered,
        {name: listed for name, listed in cyclic.items() if name not in ordered},
        draw(st.dictionaries(names(), pairs, max_size=2)),
        tuple(draw(st.lists(names(), max_size=2))),
    )


@st.composite
def states(draw: st.DrawFn, deck: Deck, board: Board) -> State:
    """Each token of `deck` on a cell of its own."""
    places = draw(st.permutations(board.cells))
    return State(board, {token.id: cell for token, cell in zip(deck.tokens, places, strict=False)})


@st.composite
def demonstrations(
    draw: st.DrawFn, max_moves: int = 6, board: Board | None = None
) -> Demonstration:
    """Legal moves of any tokens to any empty cells; an optional field is there or not."""
    room = MAX_TOKENS if board is None else min(MAX_TOKENS, board.rows * board.columns - 1)
    deck = draw(decks(max_tokens=room))
    start = draw(states(deck, board or draw(boards(min_cells=len(deck.tokens) + 1))))
    moves: list[Move] = []
    state = start
    for _ in range(draw(st.integers(0, max_moves))):
        token = draw(st.sampled_from(deck.tokens)).id
        empty = [cell for cell in start.board.cells if cell not in state.tokens]
        moves.append(Move(token, state.cells[token], draw(st.sampled_from(empty))))
        state = state.after(moves[-1])
    times = st.lists(st.integers(0, 10**6), min_size=len(moves), max_size=len(moves))
    return Demonstration(
        deck,
        start,
        tuple(moves),
        draw(st.none() | texts()),
        draw(st.none() | times.map(lambda one: tuple(sorted(one)))),
        draw(st.none() | st.sampled_from(sources())),
    )


def sources() -> tuple[Source, ...]:
    """All places where a demonstration can be played."""
    return get_args(Source)


def _kinds() -> st.SearchStrategy[st.SearchStrategy[Value]]:
    """Numbers on all tokens, or strings on all."""
    return st.sampled_from([numbers(), texts(), st.sampled_from("abcñ")])


def _declared(draw: st.DrawFn, tokens: tuple[Token, ...]) -> Mapping[str, tuple[str, ...]]:
    """Some attributes of non-empty strings, each with all of its values in some order."""
    shown: dict[str, set[Value]] = {}
    for token in tokens:
        for name, value in token.attributes:
            shown.setdefault(name, set()).add(value)
    listable = {
        name: sorted(str(value) for value in listed)
        for name, listed in shown.items()
        if all(isinstance(value, str) and value for value in listed)
    }
    some = draw(st.sets(st.sampled_from(sorted(listable)))) if listable else set[str]()
    return {name: tuple(draw(st.permutations(listable[name]))) for name in sorted(some)}
