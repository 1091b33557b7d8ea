"""Is a move right, by the rules of an exercise, and how sure is that; which moves are.

What the rules allow is certain when the most specific hypothesis allows it too; what they refuse
is certain when every alternative refuses it too. Where no rule explains what was shown, the most
specific hypothesis judges alone, and what it does not allow is not known.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, assert_never

from maestra.core.faults import refuse
from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.rules.completability import (
    CAREFUL_CHOICES,
    Conjunction,
    MoveAllowed,
    MoveRefused,
    MoveUndecided,
    MoveVerdict,
)
from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.fitting import misfits, misplaced
from maestra.rules.position import Position
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play, Setting
from maestra.rules.verdicts import (
    NoPlacement,
    NotKnown,
    NoWayOn,
    RowDone,
    RuledVerdict,
    RulesBroken,
    RulesKept,
)

CHOICES_TO_BE_SURE: Final = 300
"""Before the search that only says how sure a verdict is gives up: it is then not sure."""


class RuledJudge:
    """Judges moves of one exercise with one deck; what it works out once serves every move.

    The rules are of any deck that has the attributes they ask for, and of any board on which
    they have a meaning.
    """

    def __init__(self, exercise: RuledExercise, deck: Deck) -> None:
        """Prepare for plays of `exercise` with just the tokens of `deck`.

        Raises:
            InvalidError: the rules ask for what the deck does not have.
        """
        self.exercise = exercise
        self.deck = deck
        self._outside = exercise.status is LearnStatus.OUTSIDE
        self._rules = exercise.safe if self._outside else exercise.conjunction
        refuse(misfits(self._rules, deck))
        self._safe = None if misfits(exercise.safe, deck) else exercise.safe
        others = (other.rules for other in exercise.alternatives)
        self._others = tuple(rules for rules in others if not misfits(rules, deck))
        self._latest: _Start | None = None

    def verdict(self, position: Position, move: Move) -> RuledVerdict:
        """Whether `move` is right here; if not, why.

        A move after which the search for a completion was given up is allowed, but not certain.

        Raises:
            IllegalMoveError: no board could make this move.
            InvalidError: the rules have no meaning on this board.
        """
        start = self._start(position.start)
        position.now.after(move)
        play = start.play_of(position)
        goal_row = position.now.board.goal_row
        if not play.room:
            return RowDone()
        if move.origin.row == goal_row or move.destination.row != goal_row:
            return NotKnown() if self._outside else NoPlacement()
        key = (play, start.setting.number_of[move.token], move.destination.column - 1)
        if key not in start.verdicts:
            start.verdicts[key] = self._work_out(start, *key)
        return start.verdicts[key]

    def allowed_moves(self, position: Position) -> Iterator[Move]:
        """Every right move, by cell and token; also those whose search was given up.

        Raises:
            InvalidError: the rules have no meaning on this board.
        """
        start = self._start(position.start)
        play = start.play_of(position)
        for token, cell in start.rules.allowed_moves(play, undecided=True):
            yield play.after(token, cell).moves()[-1]

    def may_end(self, position: Position) -> bool:
        """Whether the exercise may end here.

        Raises:
            InvalidError: the rules have no meaning on this board.
        """
        start = self._start(position.start)
        return start.rules.may_end(start.play_of(position))

    def check_board(self, state: State) -> None:
        """Refuse to judge where the rules have no meaning.

        Raises:
            InvalidError: on this board, which is not the one the exercise was taught on.
        """
        if state.board != self.exercise.board:
            refuse(misplaced(self._rules, state.board))

    def _start(self, state: State) -> _Start:
        """What is known of plays from `state`; kept until a play begins elsewhere."""
        if self._latest is None or self._latest.setting.start != state:
            self.check_board(state)
            setting = Setting(self.deck, state)
            others = () if self._outside else self._others
            self._latest = _Start(setting, self._rules, self._safe, others)
        return self._latest

    def _work_out(self, start: _Start, play: Play, token: Index, cell: Index) -> RuledVerdict:
        found = start.rules.judge(play, token, cell)
        match found:
            case MoveAllowed():
                return RulesKept(start.is_safe(play, token, cell))
            case MoveUndecided():
                return RulesKept(certain=False)
            case MoveRefused() if self._outside:
                return NotKnown()
            case MoveRefused(broken):
                certain = self._is_certain(start, play, token, cell)
                meant = tuple(one for one in self.exercise.rules if one.rule in broken)
                return RulesBroken(meant, certain) if meant else NoWayOn(certain)
            case _:
                assert_never(found)

    def _is_certain(self, start: _Start, play: Play, token: Index, cell: Index) -> bool:
        """Whether a refusal is: nothing that may be meant allows the move."""
        if self.exercise.status is LearnStatus.CONTRADICTORY:
            return False
        return all(isinstance(v, MoveRefused) for v in start.other_verdicts(play, token, cell))


@dataclass(frozen=True)
class _Start:
    """What is known of the plays from one start."""

    setting: Setting
    meant: tuple[Rule, ...]
    certain: tuple[Rule, ...] | None
    """The most specific hypothesis, if the deck can be asked for it."""
    others: tuple[tuple[Rule, ...], ...]
    verdicts: dict[tuple[Play, Index, Index], RuledVerdict] = field(
        default_factory=dict["tuple[Play, Index, Index]", RuledVerdict]
    )

    def play_of(self, position: Position) -> Play:
        """The play as the rules see it."""
        play = Play.begin(self.setting)
        for move in position.moves:
            play = play.after(self.setting.number_of[move.token], move.destination.column - 1)
        return play

    @cached_property
    def rules(self) -> Conjunction:
        """What the moves are judged by."""
        return Conjunction(self.meant, self.setting, CAREFUL_CHOICES)

    def is_safe(self, play: Play, token: Index, cell: Index) -> bool:
        """Whether the most specific hypothesis allows a move that the rules allow."""
        if self._safe is None or set(self._safe.rules) <= set(self.meant):
            return self._safe is not None
        return isinstance(self._safe.judge(play, token, cell), MoveAllowed)

    @cached_property
    def _safe(self) -> Conjunction | None:
        if self.certain is None:
            return None
        return Conjunction(self.certain, self.setting, CHOICES_TO_BE_SURE)

    def other_verdicts(self, play: Play, token: Index, cell: Index) -> Iterator[MoveVerdict]:
        """What each alternative says of a move."""
        for other in self._others:
            yield other.judge(play, token, cell)

    @cached_property
    def _others(self) -> tuple[Conjunction, ...]:
        return tuple(Conjunction(rules, self.setting, CHOICES_TO_BE_SURE) for rules in self.others)
