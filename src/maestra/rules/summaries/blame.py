"""Which rules of a summary a refused move breaks."""

from __future__ import annotations

from typing import assert_never

from maestra.core.board import Board
from maestra.core.state import Move, State
from maestra.core.tokens import Deck
from maestra.rules.forms.base import EachSlot, Pairwise
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.timing import FillOrder
from maestra.rules.rule import Rule
from maestra.rules.setting import Play, Setting
from maestra.rules.strips.actions import Action
from maestra.rules.summaries.summary import Summary, Unseen
from maestra.rules.verdicts import (
    AfterTheEnd,
    BrokenPrecondition,
    DeadEnd,
    GroundedRefusal,
    NotShown,
)


def broken_rules(summary: Summary, before: State, deck: Deck, move: Move) -> tuple[Rule, ...]:
    """The rules that `move` breaks by itself, after right moves that led to `before`.

    None, if it does not take a token from storage to the goal row: rules speak of no other.
    """
    if not _is_placing(move, before.board):
        return ()
    play = Play.begin(Setting(deck, before))
    token, cell = play.setting.number_of[move.token], move.destination.column - 1
    return tuple(rule for rule in summary.rules if _breaks(rule, play, token, cell))


def _is_placing(move: Move, board: Board) -> bool:
    """Whether it takes a token from storage to the goal row."""
    return move.origin.row != board.goal_row and move.destination.row == board.goal_row


def _breaks(rule: Rule, play: Play, token: int, cell: int) -> bool:
    """Whether it is this token on this cell that breaks the rule.

    What lies in the row already was right; its origins are not known any more, so only what is
    said about pairs is looked at as a whole.
    """
    match rule:
        case FullRow():
            return False
        case FillOrder():
            return cell not in rule.next_cells(play)
        case Pairwise():
            return not rule.holds(play.after(token, cell))
        case EachSlot():
            return not rule.allowed(play.setting)[cell] >> token & 1
        case _:
            return not rule.possible(play.after(token, cell))


def ids_against(
    verdict: GroundedRefusal, before: State, move: Move, summary: Summary, deck: Deck
) -> tuple[str, ...]:
    """The ids of the sentences that a refused move goes against: rules, else gaps.

    Args:
        verdict: why it was refused.
        before: what was on the board before it.
        move: the move.
        summary: of the exercise it was judged by.
        deck: the tokens it was played with.
    """
    match verdict:
        case AfterTheEnd() | DeadEnd():
            return (summary.placing_name,)
        case NotShown(action) | BrokenPrecondition(action):
            if summary.places and not _is_placing(move, summary.board):
                return (summary.placing_name,)
            rules = broken_rules(summary, before, deck, move)
            names = zip(summary.rules, summary.rule_names, strict=True)
            broken = tuple(name for rule, name in names if rule in rules)
            return broken or _gaps(summary, action) or (summary.placing_name,)
        case _:
            assert_never(verdict)


def _gaps(summary: Summary, action: Action) -> tuple[str, ...]:
    """The gaps, or else the steps, that speak of the action."""
    gaps = tuple(
        name
        for gap, name in zip(summary.gaps, summary.gap_names, strict=True)
        if gap.step == action.step
        and action.shown in (gap.missing if isinstance(gap, Unseen) else gap.shown)
    )
    steps = tuple(step.name for step in summary.steps if step.step == action.step)
    return gaps or steps
