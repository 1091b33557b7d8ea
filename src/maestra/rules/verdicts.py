"""What can be said of a move, for exercises of either kind."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias, assert_never

from maestra.core.state import Move, State
from maestra.rules.exercise import MeantRule
from maestra.rules.strips.actions import Action
from maestra.rules.strips.literals import Literal

# ---------------------------------------------------------------- exercises made of actions


@dataclass(frozen=True, slots=True)
class Allowed:
    """The move keeps all rules, and the exercise can still be completed after it."""

    action: Action


@dataclass(frozen=True, slots=True)
class NotShown:
    """No demonstration showed such a token as this move of a play."""

    action: Action


@dataclass(frozen=True, slots=True)
class BrokenPrecondition:
    """The action's precondition does not hold here."""

    action: Action
    literals: tuple[Literal, ...]
    """Those of it that are false; at least one."""


@dataclass(frozen=True, slots=True)
class DeadEnd:
    """The move itself breaks no rule, but after it the exercise cannot be completed."""

    action: Action


@dataclass(frozen=True, slots=True)
class AfterTheEnd:
    """The play was already complete."""

    action: Action


GroundedRefusal: TypeAlias = NotShown | BrokenPrecondition | DeadEnd | AfterTheEnd
GroundedVerdict: TypeAlias = Allowed | GroundedRefusal

# ---------------------------------------------------------------- exercises made of rules


@dataclass(frozen=True, slots=True)
class RulesKept:
    """The move keeps all rules, and as far as was found out the play can be completed."""

    certain: bool
    """Whether the most specific hypothesis allows it too."""


@dataclass(frozen=True, slots=True)
class RulesBroken:
    """The move breaks rules, whatever comes after it."""

    rules: tuple[MeantRule, ...]
    """At least one."""
    certain: bool
    """Whether every alternative refuses it too."""


@dataclass(frozen=True, slots=True)
class NoWayOn:
    """The move breaks no rule for itself, but no way to go on keeps all of them."""

    certain: bool
    """Whether every alternative refuses it too."""


@dataclass(frozen=True, slots=True)
class NoPlacement:
    """The move does not take a token from storage to the goal row; rules speak of no other."""


@dataclass(frozen=True, slots=True)
class RowDone:
    """No goal cell is free, or no token is left: the play was over."""


@dataclass(frozen=True, slots=True)
class NotKnown:
    """No rule explains what was shown, and what is sure does not allow the move: ask."""


RuledRefusal: TypeAlias = RulesBroken | NoWayOn | NoPlacement | RowDone | NotKnown
RuledVerdict: TypeAlias = RulesKept | RuledRefusal

# ---------------------------------------------------------------- either

Refused: TypeAlias = GroundedRefusal | RuledRefusal
Verdict: TypeAlias = GroundedVerdict | RuledVerdict
"""What `Judge.verdict` says of a move."""


@dataclass(frozen=True, slots=True)
class PutBack:
    """No move of the play: a refused token is moved back to where it was taken from."""

    refused: Refused
    """Why."""


@dataclass(frozen=True, slots=True)
class JudgedMove:
    """A move of a play, and what is to be said of it."""

    before: State
    """What was on the board before it, all refused tokens put back."""
    move: Move
    """With the origin where the token lies in `before`; but of `PutBack` as it was written."""
    verdict: Verdict | PutBack

    @property
    def is_refused(self) -> bool:
        """Whether the move was wrong."""
        return not isinstance(self.verdict, Allowed | RulesKept | PutBack)

    @property
    def is_certain(self) -> bool:
        """How far the verdict is to be trusted.

        What the most specific preconditions allow is right, if the rule can be said at all. What
        they refuse may only not have been shown yet, but nothing comes after the end; and to put
        a refused token back is always right. Rules say of themselves how sure they are.
        """
        match self.verdict:
            case Allowed() | AfterTheEnd() | PutBack() | NoPlacement() | RowDone():
                return True
            case NotShown() | BrokenPrecondition() | DeadEnd() | NotKnown():
                return False
            case RulesKept() | RulesBroken() | NoWayOn():
                return self.verdict.certain
            case _:
                assert_never(self.verdict)
