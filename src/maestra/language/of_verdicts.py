"""What is said of a refused move: short, and without blame.

Each reason is given in several ways, the most telling first; the first that is short enough for
a patient is said.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, assert_never

from maestra.core.board import Cell
from maestra.core.tokens import Deck
from maestra.language.keys import Key
from maestra.language.of_pairs import Two
from maestra.language.of_rules import Rules, relation_of
from maestra.language.of_summary import either
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import (
    Does,
    InRow,
    Named,
    Nth,
    Numeral,
    Place,
    Say,
    Several,
    opposite,
    say,
)
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import FillOrder
from maestra.rules.judging import (
    AfterTheEnd,
    BrokenPrecondition,
    DeadEnd,
    JudgedMove,
    NotShown,
    Refused,
)
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_ROW, Play, Setting
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows
from maestra.rules.summaries.blame import broken_rules
from maestra.rules.summaries.summary import Check, Summary, Unseen
from maestra.rules.token_tests import Has

MAX_WORDS: Final = 12
"""In a sentence for patients."""

_CELLS: Final = MappingProxyType({"destination": Key.WRONG_PLACE, "origin": Key.WRONG_ORIGIN})
_COLUMNS: Final = MappingProxyType(
    {"destination-column": Key.WRONG_COLUMN, "origin-column": Key.WRONG_ORIGIN_COLUMN}
)
_FIRST: Final = ("to-goal-row", "from-storage", "destination", "destination-column")
"""What is wrong with the move's cells is said before what lies on others; origins come last."""


@dataclass(frozen=True, slots=True)
class Reasons:
    """Says why one move was refused."""

    judged: JudgedMove
    verdict: Refused
    summary: Summary
    deck: Deck

    def all(self) -> Iterator[Say]:
        """The reasons, the most telling first; the last one is always short."""
        match self.verdict:
            case DeadEnd():
                yield say(Key.DEAD_END)
            case AfterTheEnd():
                yield say(Key.AFTER_THE_END)
            case NotShown(action):
                broken = list(self._of_rules())
                yield from broken or self._of_unknown(action)
            case BrokenPrecondition(_, literals):
                yield from self._of_rules()
                yield from self._of_literals(literals)
            case _:
                assert_never(self.verdict)
        yield say(Key.NOT_NOW)

    @property
    def _tokens(self) -> Tokens:
        return Tokens(self.summary.board, self.summary.deck)

    @property
    def _moved(self) -> Named:
        return Named(self.verdict.action.shown)

    @property
    def _destination(self) -> Cell:
        return self.judged.move.destination

    def _of_rules(self) -> Iterator[Say]:
        """A reason for each broken rule; where the token goes is said first."""
        before, move = self.judged.before, self.judged.move
        if self.summary.places:
            yield from self._of_frame()
        for rule in broken_rules(self.summary, before, self.deck, move):
            yield from self._of_rule(rule)

    def _of_rule(self, rule: Rule) -> Iterator[Say]:
        match rule:
            case FillOrder():
                yield self._of_order(rule)
            case EveryToken(Has(feature)) if feature.attribute == ORIGIN_ROW:
                yield Rules(self._tokens).says(rule)
            case StraightUp(mirrored=False):
                yield say(Key.OTHER_COLUMN, token=self._moved)
            case EveryToken(test):
                yield _not_so(Rules(self._tokens).does(test, self._moved))
            case Ordered() | EachPair():
                yield from self._of_neighbours(rule)
            case Pattern():
                yield from self._of_pattern(rule)
            case _:
                yield Rules(self._tokens).says(rule)

    def _of_order(self, rule: FillOrder) -> Say:
        play = Play.begin(Setting(self.deck, self.judged.before))
        cell = self.summary.board.goal_cells[rule.next_cells(play)[0]]
        return say(Key.NEXT_PLACE, place=Place(cell))

    def _of_neighbours(self, rule: Ordered | EachPair) -> Iterator[Say]:
        """Of the wrong pairs with the moved token in them the closest, seen from its right one."""
        before, move = self.judged.before, self.judged.move
        play = Play.begin(Setting(self.deck, before))
        cell = move.destination.column - 1
        after = play.after(play.setting.number_of[move.token], cell)
        wrong = [
            (right - left, one, two)
            for left, right, masks in rule.links(after.setting)
            if cell in {left, right}
            and (one := after.row[left]) is not None
            and (two := after.row[right]) is not None
            and not masks[one] >> two & 1
        ]
        _, one, two = min(wrong)
        shown = [Named(self.deck.tokens[token].attributes) for token in (one, two)]
        relation = relation_of(rule)
        other = say(Key.TOKEN_ON_ITS_LEFT, token=shown[0])
        yield _not_so(Two(self._tokens, shown[1], other).stands(relation))
        for shorter in (other, say(Key.THE_ONE_ON_ITS_LEFT)):
            yield _not_so(Two(self._tokens, say(Key.IT), shorter).stands(relation))

    def _of_pattern(self, rule: Pattern) -> Iterator[Say]:
        """What belongs where the token was put, if that is one thing."""
        place = (self._destination.column - 1) % len(rule.tests)
        value = self._tokens.value_of(rule.tests[place])
        if value is not None:
            yield say(Key.WRONG_PLACE, token=value, place=Place(self._destination))
        yield Rules(self._tokens).says(rule)

    def _of_unknown(self, action: Action) -> Iterator[Say]:
        """Nothing is broken: was the token not shown yet, or can no right row begin so?"""
        summary = self.summary
        shown = any(
            isinstance(gap, Unseen) and gap.step == action.step and action.shown in gap.missing
            for gap in summary.gaps
        )
        told = any(step.shown for step in summary.steps)
        if not shown and not told and summary.check is not Check.NOT_COMPARED:
            yield say(Key.DEAD_END)
        yield say(Key.NOT_SHOWN, tokens=either((action.shown,)), nth=Nth(action.step))

    def _of_frame(self) -> Iterator[Say]:
        """A move that does not take a token from storage to the goal row."""
        goal = self.summary.board.goal_row
        if self.judged.move.origin.row == goal:
            yield say(Key.NOT_FROM_STORAGE, token=self._moved, row=InRow(goal))
        if self._destination.row != goal:
            yield say(Key.NOT_TO_GOAL_ROW, row=InRow(goal))

    def _of_literals(self, literals: tuple[Literal, ...]) -> Iterator[Say]:
        for literal in sorted(literals, key=self._rank):
            yield from self._of_literal(literal)

    def _rank(self, literal: Literal) -> tuple[int, int]:
        """Cells of the move first, then what lies close by, then the origin."""
        if isinstance(literal, Placed):
            name = literal.feature.name
            return (0, _FIRST.index(name)) if name in _FIRST else (2, 0)
        return 1, abs(literal.cell.column - self._destination.column)

    def _of_literal(self, literal: Literal) -> Iterator[Say]:
        match literal:
            case Placed():
                yield self._of_cells(literal)
            case Contains(cell, shown):
                yield say(Key.BELONGS_THERE, token=Named(shown), place=Place(cell))
            case Related() | Shows():
                yield from self._of_content(literal)
            case _:
                assert_never(literal)

    def _of_content(self, literal: Related | Shows) -> list[Say]:
        """What lies on a cell is not as it should be, or nothing lies there."""
        lying = self.judged.before.tokens.get(literal.cell)
        if lying is None:
            return [say(Key.NOTHING_THERE, place=Place(literal.cell))]
        there = self._beside(literal.cell, Named(self.deck.by_id[lying].attributes))
        if isinstance(literal, Shows):
            return [_not_so(self._tokens.has(literal.feature, there))]
        both = [Two(self._tokens, subject, there) for subject in (self._moved, say(Key.IT))]
        return [_not_so(two.has(literal.feature, converse=literal.converse)) for two in both]

    def _beside(self, cell: Cell, there: Named) -> Say:
        """A token on `cell`, seen from where the moved one goes."""
        if cell.row == self._destination.row:
            if cell.column == self._destination.column - 1:
                return say(Key.TOKEN_ON_ITS_LEFT, token=there)
            if cell.column == self._destination.column + 1:
                return say(Key.TOKEN_ON_ITS_RIGHT, token=there)
        if cell.row == self.summary.board.goal_row:
            return say(Key.TOKEN_IN_COLUMN, token=there, column=Numeral(int(cell.column)))
        return say(Key.TOKEN_IN_PLACE, token=there, place=Place(cell))

    def _of_cells(self, literal: Placed) -> Say:
        name, value = literal.feature.name, literal.value
        if isinstance(value, Cell):
            return say(_CELLS[name], token=self._moved, place=Place(value))
        if name in _COLUMNS:
            return say(_COLUMNS[name], token=self._moved, column=Numeral(int(value)))
        if name == "origin-row":
            return say(Key.WRONG_ORIGIN_ROW, row=InRow(int(value)))
        goal = InRow(self.summary.board.goal_row)
        if name == "from-storage":
            return say(Key.NOT_FROM_STORAGE, token=self._moved, row=goal)
        if name == "to-goal-row":
            return say(Key.NOT_TO_GOAL_ROW, row=goal)
        return say(Key.OTHER_COLUMN, token=self._moved)


def _not_so(said: Does | Several) -> Say:
    return say(Key.NOT_SO, does=opposite(said))
