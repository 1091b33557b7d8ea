"""What is said of a rule that a move breaks: of the tokens at hand, or else the rule itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.language.keys import Key
from maestra.language.of_pairs import Two
from maestra.language.of_rules import Rules, relation_of
from maestra.language.of_tokens import Tokens
from maestra.language.phrases import Does, InRow, Named, Place, Say, Several, opposite, say
from maestra.rules.forms.base import EachSlot
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import Pattern
from maestra.rules.forms.relations import EachPair
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp
from maestra.rules.forms.timing import FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import ORIGIN_ROW, Line, Play, Setting
from maestra.rules.token_tests import Has, TokenTest


@dataclass(frozen=True, slots=True)
class Against:
    """Says what is wrong with one move; each reason is given in several ways, the best first."""

    before: State
    """What was on the board before it."""
    move: Move
    deck: Deck
    """The tokens of the play."""
    tokens: Tokens
    """As they are spoken of."""

    def of_rule(self, rule: Rule) -> Iterator[Say]:
        """Why the move breaks `rule`; of what the tokens at hand show, if it is their fault."""
        match rule:
            case FillOrder():
                yield self._of_order(rule)
            case Ordered(line=Line.ROW) | EachPair(line=Line.ROW):
                yield from self._of_pairs(rule)
            case StraightUp(mirrored=False) if self._is_out_of_place(rule):
                yield say(Key.OTHER_COLUMN, token=self.moved)
            case EveryToken(test) if not _is_of_origin(test) and self._is_out_of_place(rule):
                yield not_so(Rules(self.tokens).does(test, self.moved))
            case Pattern(line=Line.ROW) if self._is_out_of_place(rule):
                yield from self._of_pattern(rule)
            case _:
                pass
        yield Rules(self.tokens).says(rule)

    def _is_out_of_place(self, rule: EachSlot) -> bool:
        """Whether it is the moved token that may not lie there, not one that lay there before."""
        setting = Setting(self.deck, self.before)
        fitting = rule.allowed(setting)[self.move.destination.column - 1]
        return not fitting >> setting.number_of[self.move.token] & 1

    def _of_order(self, rule: FillOrder) -> Say:
        play = Play.begin(Setting(self.deck, self.before))
        cell = self.before.board.goal_cells[rule.next_cells(play)[0]]
        return say(Key.NEXT_PLACE, place=Place(cell))

    def _of_pairs(self, rule: Ordered | EachPair) -> Iterator[Say]:
        """Of the wrong pairs with the moved token in them the closest, seen from its right one."""
        before, move = self.before, self.move
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
        if not wrong:
            return
        _, one, two = min(wrong)
        shown = [Named(self.deck.tokens[token].attributes) for token in (one, two)]
        relation = relation_of(rule)
        other = say(Key.TOKEN_ON_ITS_LEFT, token=shown[0])
        yield not_so(Two(self.tokens, shown[1], other).stands(relation))
        for shorter in (other, say(Key.THE_ONE_ON_ITS_LEFT)):
            yield not_so(Two(self.tokens, say(Key.IT), shorter).stands(relation))

    def _of_pattern(self, rule: Pattern) -> Iterator[Say]:
        """What belongs where the token was put, if that is one thing."""
        place = (self.move.destination.column - 1) % len(rule.tests)
        value = self.tokens.value_of(rule.tests[place])
        if value is not None:
            yield say(Key.WRONG_PLACE, token=value, place=Place(self.move.destination))

    def of_frame(self) -> Iterator[Say]:
        """A move that does not take a token from storage to the goal row."""
        goal = self.before.board.goal_row
        if self.move.origin.row == goal:
            yield say(Key.NOT_FROM_STORAGE, token=self.moved, row=InRow(goal))
        if self.move.destination.row != goal:
            yield say(Key.NOT_TO_GOAL_ROW, row=InRow(goal))

    @property
    def moved(self) -> Named:
        """The moved token."""
        return Named(self.deck.by_id[self.move.token].attributes)


def _is_of_origin(test: TokenTest) -> bool:
    """Whether the test is about where the token came from, which the rule says best."""
    return isinstance(test, Has) and test.feature.attribute == ORIGIN_ROW


def not_so(said: Does | Several) -> Say:
    """That it is not so."""
    return say(Key.NOT_SO, does=opposite(said))
