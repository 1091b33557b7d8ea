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
from maestra.language.of_broken_rules import Against, not_so
from maestra.language.of_pairs import Two
from maestra.language.of_summary import either
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import (
    InRow,
    Named,
    Nth,
    Numeral,
    Place,
    Say,
    say,
)
from maestra.rules.account import Account
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows
from maestra.rules.summaries.blame import broken_rules
from maestra.rules.summaries.summary import Check, Summary, Unseen
from maestra.rules.verdicts import (
    AfterTheEnd,
    BrokenPrecondition,
    DeadEnd,
    GroundedRefusal,
    JudgedMove,
    NoPlacement,
    NotKnown,
    NotShown,
    NoWayOn,
    RowDone,
    RuledRefusal,
    RulesBroken,
)

MAX_WORDS: Final = 12
"""In a sentence for patients."""

_CELLS: Final = MappingProxyType({"destination": Key.WRONG_PLACE, "origin": Key.WRONG_ORIGIN})
_COLUMNS: Final = MappingProxyType(
    {"destination-column": Key.WRONG_COLUMN, "origin-column": Key.WRONG_ORIGIN_COLUMN}
)
_FIRST: Final = ("to-goal-row", "from-storage", "destination", "destination-column")
"""What is wrong with the move's cells is said before what lies on others; origins come last."""


def reasons(judged: JudgedMove, account: Account, deck: Deck) -> Iterator[Say]:
    """Why a move was refused, the most telling first; the last one is always short.

    None, if it was not.

    Args:
        judged: the move and its verdict.
        account: of the exercise it was judged by.
        deck: the tokens it was played with.
    """
    verdict = judged.verdict
    if isinstance(verdict, RuledRefusal):
        yield from _of_rules(verdict, judged, deck)
    elif isinstance(verdict, GroundedRefusal) and isinstance(account, Summary):
        yield from _OfActions(judged, verdict, account, deck).all()
    else:
        return
    yield say(Key.NOT_NOW)


def _of_rules(verdict: RuledRefusal, judged: JudgedMove, deck: Deck) -> Iterator[Say]:
    """Why the rules of an exercise refuse a move."""
    board = judged.before.board
    against = Against(judged.before, judged.move, deck, Tokens(board, deck))
    match verdict:
        case RulesBroken(rules):
            for one in rules:
                yield from against.of_rule(one.rule)
        case NoPlacement():
            yield from against.of_frame()
        case NoWayOn():
            yield say(Key.NO_WAY_ON)
        case RowDone():
            yield say(Key.AFTER_THE_END)
        case NotKnown():
            yield say(Key.ASK_CAREGIVER)
        case _:
            assert_never(verdict)


@dataclass(frozen=True, slots=True)
class _OfActions:
    """Says why one move was refused by the actions of an exercise."""

    judged: JudgedMove
    verdict: GroundedRefusal
    summary: Summary
    deck: Deck

    def all(self) -> Iterator[Say]:
        """The reasons, the most telling first."""
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
        against = Against(before, move, self.deck, self._tokens)
        if self.summary.places:
            yield from against.of_frame()
        for rule in broken_rules(self.summary, before, self.deck, move):
            yield from against.of_rule(rule)

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
            return [not_so(self._tokens.has(literal.feature, there))]
        both = [Two(self._tokens, subject, there) for subject in (self._moved, say(Key.IT))]
        return [not_so(two.has(literal.feature, converse=literal.converse)) for two in both]

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
