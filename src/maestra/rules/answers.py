"""What a caregiver is asked about an exercise, and what is answered."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

from maestra.core.faults import Fault, refuse
from maestra.rules.rule import Rule
from maestra.rules.setting import Index, Play


class Reply(Enum):
    """What a caregiver says to a question."""

    YES = "yes"
    NO = "no"
    UNSURE = "unsure"
    """It does not matter, or is not known."""


@dataclass(frozen=True, slots=True)
class RowQuestion:
    """Is this finished play right?"""

    play: Play


@dataclass(frozen=True, slots=True)
class MoveQuestion:
    """Is it right to place this token on this goal cell here?

    Raises:
        InvalidError: the token is not left, or the cell is not free.
    """

    position: Play
    token: Index
    cell: Index

    def __post_init__(self) -> None:
        """Refuse what no board could show, naming every fault."""
        faults: list[Fault] = []
        if not (self.token >= 0 and self.position.left >> self.token & 1):
            faults.append(Fault("token", str(self.token), "a token that lies in storage"))
        if self.cell not in self.position.free:
            faults.append(Fault("cell", str(self.cell), "an empty goal cell"))
        refuse(faults)


@dataclass(frozen=True, slots=True)
class RuleQuestion:
    """Is this rule meant?"""

    rule: Rule


Question: TypeAlias = RowQuestion | MoveQuestion | RuleQuestion


@dataclass(frozen=True, slots=True)
class Answer:
    """A question and what was said to it.

    Raises:
        InvalidError: something said to be wrong where no row was refused, or off the row.
    """

    question: Question
    reply: Reply
    wrong: Index | None = None
    """After a "no" to a row: the goal cell that the caregiver says is wrong."""

    def __post_init__(self) -> None:
        """Refuse a wrong cell that means nothing."""
        match self:
            case Answer(wrong=None):
                return
            case Answer(RowQuestion(play), Reply.NO, int(wrong)):
                length = play.setting.length
                if not 0 <= wrong < length:
                    refuse([Fault("wrong", str(wrong), f"a goal cell, 0 to {length - 1}")])
            case _:
                refuse([Fault("wrong", str(self.wrong), 'nothing: only after "no" to a row')])
