"""What is said of a literal: as a condition of an action, and when it is broken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Cell
from maestra.core.tokens import Attributes
from maestra.language.keys import Key
from maestra.language.of_pairs import Two
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import InRow, Joint, Listing, Named, Numeral, Phrase, Place, Say, say
from maestra.rules.features import PairFeature
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows

_CELLS: Final = MappingProxyType({"destination": Key.GOES_TO, "origin": Key.COMES_FROM})
_NUMBERS: Final = MappingProxyType(
    {
        "origin-column": Key.COMES_FROM_COLUMN,
        "destination-column": Key.GOES_TO_COLUMN,
    }
)
_YES: Final = MappingProxyType(
    {
        "same-column": Key.KEEPS_COLUMN,
        "from-storage": Key.COMES_FROM_STORAGE,
        "to-goal-row": Key.GOES_TO_GOAL_ROW,
    }
)


@dataclass(frozen=True, slots=True)
class Conditions:
    """Says what must hold before an action that moves a token showing `moved`."""

    tokens: Tokens
    moved: Attributes

    def listed(self, literals: Sequence[Literal]) -> Listing:
        """Several conditions, at least one."""
        said: list[Phrase] = []
        alike: dict[tuple[PairFeature, bool, int], list[Related]] = {}
        for literal in literals:
            if isinstance(literal, Related):
                key = (literal.feature, literal.converse, literal.cell.row)
                alike.setdefault(key, []).append(literal)
            else:
                said.append(self.of(literal))
        said += [
            self.of(group[0]) if len(group) == 1 else self._of_row(group)
            for group in alike.values()
        ]
        return Listing(tuple(said), Joint.AND)

    def _of_row(self, group: Sequence[Related]) -> Say:
        """The same condition of several cells of a row."""
        columns = tuple(Numeral(int(literal.cell.column)) for literal in group)
        other = say(
            Key.WHAT_LIES_IN_COLUMNS,
            row=InRow(int(group[0].cell.row)),
            columns=Listing(columns, Joint.AND),
        )
        first = group[0]
        two = Two(self.tokens, Named(self.moved), other)
        return say(Key.IT_DOES, does=two.has(first.feature, converse=first.converse))

    def of(self, literal: Literal) -> Say:
        """One condition, of "it"."""
        match literal:
            case Placed():
                return _of_cells(literal)
            case Related(cell, feature, converse):
                other = say(Key.WHAT_LIES_THERE, place=Place(cell))
                said = Two(self.tokens, Named(self.moved), other).has(feature, converse=converse)
                return say(Key.IT_DOES, does=said)
            case Shows(cell, feature):
                place = Place(cell)
                return say(Key.TOKEN_THERE_DOES, place=place, does=self.tokens.has(feature))
            case Contains(cell, shown):
                return say(Key.LIES_THERE, token=Named(shown), place=Place(cell))
            case _:
                assert_never(literal)


def _of_cells(literal: Placed) -> Say:
    name, value = literal.feature.name, literal.value
    if isinstance(value, Cell):
        return say(_CELLS[name], place=Place(value))
    if name in _YES:
        return say(_YES[name])
    if name == "origin-row":
        return say(Key.COMES_FROM_ROW, row=InRow(int(value)))
    return say(_NUMBERS[name], column=Numeral(int(value)))


def needed(literals: Sequence[Literal]) -> tuple[Literal, ...]:
    """The literals without those that every exercise has or that follow from another."""
    placed = {one.feature.name for one in literals if isinstance(one, Placed)}
    implied = {"from-storage"}
    if "destination" in placed:
        implied.add("to-goal-row")
    kept = (
        one for one in literals if not (isinstance(one, Placed) and one.feature.name in implied)
    )
    return tuple(sorted(kept, key=_rank))


def _rank(literal: Literal) -> int:
    """Where tokens go is said first, then where they come from, then what lies there."""
    if not isinstance(literal, Placed):
        return 2
    return 0 if literal.feature.name.startswith("destination") else 1
