"""Literals and preconditions by their definition: slow, with sets, sharing nothing with the code.

The oracle of the vocabulary's bit sets, of the learner and of the searches.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import assert_never

from maestra.core.board import Board, Cell
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.core.tokens import Attributes, Deck, TokenId, Value
from maestra.rules.features import CellFeature, PairFeature, TokenFeature
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows
from maestra.rules.strips.vocabulary import Level, Vocabulary

ALPHABET = "abcdefghijklmnñopqrstuvwxyz"
Preconditions = Mapping[Action, frozenset[Literal]]


def every_literal(vocabulary: Vocabulary) -> Iterator[Literal]:
    """All that can be said, some of it never true."""
    board, level = vocabulary.board, vocabulary.level
    goal = [cell for cell in board.cells if cell.row == board.goal_row]
    for cell in board.cells if level is Level.C else goal:
        if level is not Level.A:
            yield from (Contains(cell, token.attributes) for token in vocabulary.deck.tokens)
        for feature in vocabulary.features:
            if isinstance(feature, PairFeature):
                yield Related(cell, feature, converse=False)
                if feature.name not in {"same", "different"}:
                    yield Related(cell, feature, converse=True)
            elif isinstance(feature, TokenFeature) and level is not Level.A:
                yield Shows(cell, feature)
    for feature in vocabulary.features:
        if isinstance(feature, CellFeature):
            yield from (Placed(feature, value) for value in _values(feature.name, board))


def holds(literal: Literal, deck: Deck, state: State, move: Move) -> bool:
    """Whether `literal` holds before `move`; `deck` declares orders, cycles and relations."""
    moved = shown_by(deck)[move.token]
    match literal:
        case Placed(feature, value):
            found = _of_cells(feature.name, state.board, move.origin, move.destination)
            return found == value
        case Contains(cell, shown):
            return _lying(deck, state, cell) == shown
        case Shows(cell, feature):
            there = _lying(deck, state, cell)
            return there is not None and token_has(feature, there)
        case Related(cell, feature, converse):
            there = _lying(deck, state, cell)
            if there is None:
                return False
            return pair_has(feature, deck, *((moved, there) if converse else (there, moved)))
        case _:
            assert_never(literal)


def token_has(feature: TokenFeature, shown: Attributes) -> bool:
    """What the name of a feature of one token says."""
    value = dict(shown).get(feature.attribute)
    if value is None:
        return False
    whole = isinstance(value, int)
    name, _, k = feature.name.rpartition("-")
    tests: Mapping[str, Callable[[], bool]] = {
        "odd": lambda: whole and bool(value % 2),
        "even": lambda: whole and not value % 2,
        "prime": lambda: _is_prime(value),
        "vowel": lambda: _letter(value) in "aeiou",
        "consonant": lambda: _letter(value) not in "aeiou",
        "multiple-of": lambda: (Fraction(value) / int(k)).denominator == 1,
        "digits": lambda: whole and len(str(value).lstrip("-")) == int(k),
        "above": lambda: Fraction(value) > Fraction(k),
        "below": lambda: Fraction(value) < Fraction(k),
    }
    return tests[name or feature.name]()


def pair_has(feature: PairFeature, deck: Deck, first: Attributes, second: Attributes) -> bool:
    """What the name of a feature of two tokens says."""
    one, other = dict(first).get(feature.attribute), dict(second).get(feature.attribute)
    if one is None or other is None:
        return False
    listed = deck.orders.get(feature.attribute) or deck.cycles.get(feature.attribute)
    cyclic = feature.attribute in deck.cycles
    tests: Mapping[str, Callable[[], bool]] = {
        "same": lambda: one == other,
        "different": lambda: one != other,
        "less-than": lambda: Fraction(one) < Fraction(other),
        "twice": lambda: Fraction(one) == Fraction(other) / 2,
        "before": lambda: _place(one, listed) < _place(other, listed),
        "successor": lambda: (
            (one, other) in _round(listed)
            if cyclic and listed
            else _place(other, listed) - _place(one, listed) == 1
        ),
    }
    related = tests.get(feature.name, lambda: (one, other) in deck.relations[feature.name])
    return related()


def learn(vocabulary: Vocabulary, demonstrations: Sequence[Demonstration]) -> Preconditions:
    """For each action shown, the literals that held each time."""
    literals = frozenset(every_literal(vocabulary))
    left: dict[Action, frozenset[Literal]] = {}
    for demonstration in demonstrations:
        state = demonstration.start
        for step, move in enumerate(demonstration.moves, start=1):
            action = Action(shown_by(demonstration.deck)[move.token], step)
            held = frozenset(one for one in literals if holds(one, vocabulary.deck, state, move))
            left[action] = left.get(action, literals) & held
            state = state.after(move)
    return left


def applicable(
    preconditions: Preconditions, deck: Deck, state: State, made: int
) -> Iterator[Move]:
    """Every move that the board can make and whose precondition holds."""
    for token, origin in state.cells.items():
        for destination in state.board.cells:
            if destination in state.tokens:
                continue
            move = Move(token, origin, destination)
            wanted = preconditions.get(Action(shown_by(deck)[token], made + 1))
            if wanted is not None and all(holds(one, deck, state, move) for one in wanted):
                yield move


def can_end(
    preconditions: Preconditions, lengths: frozenset[int], deck: Deck, state: State, made: int
) -> bool:
    """Whether some moves lead to an end, by trying all."""
    return made in lengths or any(
        can_end(preconditions, lengths, deck, state.after(move), made + 1)
        for move in applicable(preconditions, deck, state, made)
    )


def shown_by(deck: Deck) -> Mapping[TokenId, Attributes]:
    """What each token shows."""
    return {token.id: token.attributes for token in deck.tokens}


def _lying(deck: Deck, state: State, cell: Cell) -> Attributes | None:
    return next((shown_by(deck)[one] for one, at in state.cells.items() if at == cell), None)


def _of_cells(name: str, board: Board, origin: Cell, destination: Cell) -> Cell | int | bool:
    values: Mapping[str, Cell | int | bool] = {
        "origin": origin,
        "destination": destination,
        "origin-row": int(origin.row),
        "origin-column": int(origin.column),
        "destination-column": int(destination.column),
        "same-column": origin.column == destination.column,
        "from-storage": origin.row != board.goal_row,
        "to-goal-row": destination.row == board.goal_row,
    }
    return values[name]


def _values(name: str, board: Board) -> set[Cell | int | bool]:
    found = {_of_cells(name, board, one, other) for one in board.cells for other in board.cells}
    return {True} if name in {"same-column", "from-storage", "to-goal-row"} else found


def _round(listed: Sequence[str]) -> list[tuple[str, str]]:
    return list(zip(listed, (*listed[1:], listed[0]), strict=True))


def _is_prime(value: Value) -> bool:
    return isinstance(value, int) and value > 1 and all(value % d for d in range(2, value))


def _letter(value: Value) -> str:
    """Without its accent; an ñ keeps its own."""
    small = str(value).lower()
    return small if small == "ñ" else unicodedata.normalize("NFD", small)[0]


def _place(value: Value, listed: Sequence[str] | None) -> Fraction:
    if isinstance(value, int | Decimal):
        return Fraction(value)
    return Fraction(listed.index(value) if listed else ALPHABET.index(_letter(value)))
