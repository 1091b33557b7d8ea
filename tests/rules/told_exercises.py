"""Exercises made of rules, for tests of what is done with them."""

from __future__ import annotations

from collections.abc import Sequence

from maestra.core.board import Board
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.exercise import Alternative, LearnStatus, RuledExercise, meant_rules
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.paper import BOARD, NUMBER_DECK
from maestra.rules.rule import Rule
from maestra.rules.token_tests import has

RISING = Ordered("value", Direction.RISING)
ODD = EveryToken(has("odd", "value"))
VOWELS = EveryToken(has("vowel", "letter"))
FULL = FullRow()


def told(
    *rules: Rule,
    deck: Deck = NUMBER_DECK,
    board: Board = BOARD,
    status: LearnStatus = LearnStatus.TOLD,
    safe: Sequence[Rule] | None = None,
    others: Sequence[Sequence[Rule]] = (),
) -> RuledExercise:
    """An exercise of these rules."""
    weights = [0.05] * len(others)
    return RuledExercise(
        board,
        deck,
        meant_rules(rules, [0.9] * len(rules)),
        0.9,
        status,
        tuple(rules if safe is None else safe),
        tuple(Alternative(tuple(one), w) for one, w in zip(others, weights, strict=True)),
    )


def deck_of(attribute: str, values: Sequence[Value]) -> Deck:
    """A token for each value, called by it."""
    return Deck(tuple(Token(TokenId(str(value)), ((attribute, value),)) for value in values))


def in_storage(deck: Deck, board: Board) -> State:
    """The tokens in the deck's order, from the first storage cell on."""
    ids = [token.id for token in deck.tokens]
    return State(board, dict(zip(ids, board.storage_cells, strict=False)))
