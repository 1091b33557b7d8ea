"""The exercises that are there at first start: the paper's six, and six of other kinds.

Their tokens show numbers, letters and colours alone, which every language has words for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.exercise import RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.base import Position
from maestra.rules.forms.counting import Total
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Zigzag
from maestra.rules.forms.patterns import Template
from maestra.rules.forms.relations import EachPair, Pairs, TwoPlaces
from maestra.rules.pairs import AddUp, Compare, Step, same
from maestra.rules.paper import PAPER_EXERCISES
from maestra.rules.paper_rules import paper_exercise
from maestra.rules.rule import Rule
from maestra.rules.telling import told_exercise
from maestra.rules.token_tests import Comparison
from maestra.storage.shelf import Shelf, Source
from maestra.storage.store import SqlStore
from maestra.web.library.origin import Origin

_BOARD: Final = Board()
_NUMBER: Final = "value"
_COLOUR: Final = "colour"


@dataclass(frozen=True, slots=True)
class Included:
    """An exercise that comes with Maestra."""

    name: str
    """Its English title, which the catalogues translate."""
    exercise: RuledExercise
    origin: Origin


def _numbers(values: Sequence[int]) -> Deck:
    """A token for each number; equal ones are told apart by a letter in their ids."""
    seen: dict[int, int] = {}
    tokens: list[Token] = []
    for value in values:
        seen[value] = seen.get(value, 0) + 1
        mark = "" if seen[value] == 1 else chr(ord("a") + seen[value] - 1)
        tokens.append(Token(TokenId(f"{value}{mark}"), ((_NUMBER, value),)))
    return Deck(tuple(tokens))


def _colours(counts: Mapping[str, int]) -> Deck:
    shown: list[tuple[str, Value]] = [
        (f"{colour}-{number}", colour)
        for colour, count in counts.items()
        for number in range(1, count + 1)
    ]
    return Deck(tuple(Token(TokenId(name), ((_COLOUR, colour),)) for name, colour in shown))


def _told(name: str, deck: Deck, *rules: Rule) -> Included:
    return Included(name, told_exercise((FullRow(), *rules), _BOARD, deck), Origin.INCLUDED)


_FIRST_HIGH: Final = TwoPlaces(Position(1), Position(2), Compare(_NUMBER, Comparison.MORE))

INCLUDED: Final = (
    *(
        Included(paper.title, paper_exercise(paper.key), Origin.PAPER)
        for paper in PAPER_EXERCISES.values()
    ),
    _told("Count in twos", _numbers(range(1, 11)), EachPair(Pairs.NEIGHBOURS, Step(_NUMBER, 2))),
    _told(
        "Neighbours add up to 10",
        _numbers((3, 3, 3, 7, 7, 4, 6, 5, 8, 2)),
        EachPair(Pairs.NEIGHBOURS, AddUp(_NUMBER, 10)),
    ),
    _told(
        "Make exactly 100",
        _numbers((5, 10, 10, 15, 20, 20, 25, 30, 35, 40)),
        Total(_NUMBER, Comparison.EQUAL, 100),
    ),
    _told(
        "High, low, high, low",
        _numbers((12, 17, 24, 31, 38, 45, 52, 66, 73, 89)),
        Zigzag(_NUMBER),
        _FIRST_HIGH,
    ),
    _told(
        "Take turns with two colours",
        _colours({"red": 5, "blue": 5}),
        Template(_COLOUR, "AB", repeat=True),
    ),
    _told(
        "Mirror the colours",
        _colours({"red": 3, "blue": 3, "yellow": 3}),
        EachPair(Pairs.MIRRORED, same(_COLOUR)),
    ),
)
"""Each once, in the order in which they are meant to be found."""

INCLUDED_NAMES: Final = tuple(one.name for one in INCLUDED)


def first_start(store: SqlStore, utc: str) -> None:
    """Keep what comes with Maestra; whatever has such a name already stays as it is.

    What somebody removed is not brought back.
    """
    shelf = Shelf(store)
    there = shelf.names()
    for one in INCLUDED:
        if one.name not in there:
            source = Source(one.origin.value, None, utc)
            shelf.keep(one.name, encode_exercise(one.exercise), "", source)
