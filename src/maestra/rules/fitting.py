"""Whether rules that were learned with one deck, on one board, can be asked of another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypeAlias, assert_never

from maestra.core.board import Board
from maestra.core.faults import Fault
from maestra.core.tokens import Deck, Scale
from maestra.rules.forms.base import Position, place_of
from maestra.rules.forms.conditions import At, IfThen
from maestra.rules.forms.context import Cue, ModelRow
from maestra.rules.forms.counting import Equation, Total
from maestra.rules.forms.length import UntilTotal
from maestra.rules.forms.order import (
    CyclicOrdered,
    EqualSteps,
    ExtremeAt,
    Ordered,
    RiseAndFall,
    Zigzag,
)
from maestra.rules.forms.patterns import Pattern, Template
from maestra.rules.forms.relations import EachPair, TwoPlaces
from maestra.rules.forms.sources import TakeExtreme
from maestra.rules.forms.words import Word
from maestra.rules.looks import sights_of
from maestra.rules.pairs import Compare, Named, Relation
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_COLUMN, ORIGIN_ROW, Line
from maestra.rules.token_tests import (
    Among,
    Anything,
    Both,
    Compared,
    Comparison,
    Either,
    Has,
    Not,
    TokenTest,
)

_ORIGINS = (ORIGIN_ROW, ORIGIN_COLUMN)
_UNORDERED = (Comparison.EQUAL, Comparison.DIFFERENT)

Need: TypeAlias = tuple[str, bool]
"""An attribute, and whether its values must have an order."""


def misfits(rules: Iterable[Rule], deck: Deck) -> tuple[Fault, ...]:
    """What `rules` ask for that `deck` does not have; none, if they can be played with it."""
    return tuple(dict.fromkeys(fault for rule in rules for fault in _misfits(rule, deck)))


def _misfits(rule: Rule, deck: Deck) -> Iterator[Fault]:
    for attribute, ordered in needs_of(rule):
        if attribute in _ORIGINS:
            continue
        if attribute not in deck.scales:
            yield Fault(attribute, "no token shows it", "a deck with this attribute")
        elif ordered and deck.scales[attribute] is Scale.NOMINAL:
            yield Fault(attribute, "values without an order", "a deck that declares their order")
    for name in _relations_of(rule):
        if name not in deck.relations:
            yield Fault(f"relations.{name}", "missing", "a deck that declares this relation")
    if isinstance(rule, Word) and not deck.lexicon:
        yield Fault("lexicon", "missing", "a deck with a list of words")


def misplaced(rules: Iterable[Rule], board: Board) -> tuple[Fault, ...]:
    """Where `rules` have no meaning on `board`: places and rows that it does not have.

    Everything else means the same on any board; a pattern that is not repeated must fit in.
    """
    return tuple(dict.fromkeys(fault for rule in rules for fault in _misplaced(rule, board)))


def _misplaced(rule: Rule, board: Board) -> Iterator[Fault]:
    length, rows = board.columns, board.rows - 1
    for position in _positions_of(rule):
        if place_of(position, length) is None:
            found = f"place {position} of {length}" if position else f"the middle of {length}"
            yield Fault("board", found, "a goal row that has this place")
    match rule:
        case Pattern(tests, repeat=False) if len(tests) > length:
            yield Fault("board", f"{length} goal cells", f"{len(tests)}, as long as the pattern")
        case Template(_, letters, repeat=False) if len(letters) > length:
            expected = f"{len(letters)}, as long as the pattern"
            yield Fault("board", f"{length} goal cells", expected)
        case ModelRow(row) | Cue(row) if row > rows:
            yield Fault("board", f"{rows} storage rows", f"{row}: the last is looked at")
        case Cue(_, column) if column > length:
            yield Fault("board", f"{length} columns", f"{column}: the last is looked at")
        case _:
            return


def _positions_of(rule: Rule) -> tuple[Position, ...]:
    match rule:
        case ExtremeAt(position=position) | At(position=position, line=Line.ROW):
            return (position,)
        case TwoPlaces(first, second):
            return (first, second)
        case Equation(_, left, right):
            return (*left, *right)
        case IfThen(condition, consequence):
            return (*_positions_of(condition), *_positions_of(consequence))
        case _:
            return ()


def needs_of(rule: Rule) -> Iterator[Need]:
    """The attributes that `rule` asks for."""
    for sight in sights_of(rule):
        if isinstance(sight, str):
            yield sight, _ranks(rule)
        else:
            yield from _needs_of_test(sight)


def _ranks(rule: Rule) -> bool:
    """Whether the rule compares its attribute by order."""
    match rule:
        case (
            Ordered()
            | CyclicOrdered()
            | RiseAndFall()
            | Zigzag()
            | EqualSteps()
            | ExtremeAt()
            | Total()
            | Equation()
            | UntilTotal()
            | TakeExtreme()
        ):
            return True
        case EachPair() | TwoPlaces() | ModelRow() | Cue():
            return _is_ordered(rule.relation)
        case _:
            return False


def _is_ordered(relation: Relation) -> bool:
    if isinstance(relation, Compare):
        return relation.comparison not in _UNORDERED
    return not isinstance(relation, Named)


def _needs_of_test(test: TokenTest) -> Iterator[Need]:
    match test:
        case Anything():
            return
        case Has(feature):
            yield feature.attribute, False
        case Compared(attribute) | Among(attribute):
            yield attribute, True
        case Not(of):
            yield from _needs_of_test(of)
        case Either(first, second) | Both(first, second):
            yield from _needs_of_test(first)
            yield from _needs_of_test(second)
        case _:
            assert_never(test)


def _relations_of(rule: Rule) -> Iterator[str]:
    match rule:
        case (
            EachPair(relation=Named(name))
            | TwoPlaces(relation=Named(name))
            | ModelRow(relation=Named(name))
            | Cue(relation=Named(name))
            | Word(relation=str(name))
        ):
            yield name
        case _:
            return
