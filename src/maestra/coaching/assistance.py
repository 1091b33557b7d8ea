"""Hints, worked out from the rules and the present state: for every exercise, and always true.

Each level says no more than it may:

| Level | Says |
|---|---|
| 0 | whose turn it is |
| 1 | encouragement, or a sentence of the rules |
| 2 | a row in which some token lies that may be moved now |
| 3 | up to three tokens, just one of which may be moved now |
| 4 | a token that may be moved now, and where to |
| 5 | the same, offered or done |

Where the tokens that may not be moved now are too few to hide the right one, which is when every
token fits, level 3 would say as much as level 4; then it says what level 2 does. Where no rule
is short enough to be heard, level 1 encourages. Where nothing may be moved there is no hint.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from maestra.coaching.chance import Chance
from maestra.coaching.fields import MAX_LEVEL
from maestra.coaching.referee import Referee
from maestra.coaching.settings import Hand, Profile, Reach
from maestra.core.board import Board, Cell, Row
from maestra.core.state import Move
from maestra.core.tokens import TokenId
from maestra.rules.position import Position

SHOWN_TOKENS: Final = 3
"""At level 3."""
MOST_WORDS: Final = 12
"""Of a sentence for patients."""


@dataclass(frozen=True, slots=True)
class YourTurn:
    """Level 0."""


@dataclass(frozen=True, slots=True)
class Encouragement:
    """Level 1, without a rule."""


@dataclass(frozen=True, slots=True)
class Reminder:
    """Level 1, with one of these."""

    rules: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class InThisRow:
    """Level 2."""

    row: Row
    cells: tuple[Cell, ...]


@dataclass(frozen=True, slots=True)
class OneOfThese:
    """Level 3."""

    tokens: tuple[TokenId, ...]
    """By where they lie."""


@dataclass(frozen=True, slots=True)
class ThisMove:
    """Level 4, or with `offered` level 5."""

    move: Move
    offered: bool


Hint: TypeAlias = YourTurn | Encouragement | Reminder | InThisRow | OneOfThese | ThisMove


def hint(
    referee: Referee,
    position: Position,
    level: int,
    profile: Profile,
    chance: Chance,
    vetoed: frozenset[Move] = frozenset(),
) -> Hint | None:
    """What to say at `level`; None if nothing may be moved.

    Args:
        referee: what is right.
        position: the play so far, every refused token put back.
        level: 0 to 5.
        profile: tokens within the patient's reach and on the side of the hand come first.
        chance: draws which of equally good things is said; the same one gives hints at all
            levels about the same move.
        vetoed: moves that the caregiver has judged wrong here.
    """
    right = [move for move in referee.right_moves(position) if move not in vetoed]
    if not right:
        return None
    move, chance = _best(position.now.board, right, profile, chance)
    match level:
        case 0:
            return YourTurn()
        case 1:
            short = tuple(rule for rule in referee.rules if is_short(rule))
            return Reminder(short) if short and position.moves else Encouragement()
        case 2:
            return _row(position, move)
        case 3:
            return _few(position, right, move, chance)
        case _:
            return ThisMove(move, offered=level == MAX_LEVEL)


def is_short(sentence: str) -> bool:
    """Whether a patient can take the sentence in."""
    return len(sentence.split()) <= MOST_WORDS


def _row(position: Position, move: Move) -> Hint:
    row = move.origin.row
    cells = position.now.board.cells
    return InThisRow(row, tuple(cell for cell in cells if cell.row == row))


def _few(position: Position, right: Sequence[Move], move: Move, chance: Chance) -> Hint:
    goal_row = position.now.board.goal_row
    movable = {each.token for each in right}
    decoys = [
        token
        for token, cell in position.now.cells.items()
        if token not in movable and cell.row != goal_row
    ]
    if not decoys:
        return _row(position, move)
    others, _ = chance.shuffled(decoys)
    cells: Mapping[TokenId, Cell] = position.now.cells
    tokens = sorted((move.token, *others[: SHOWN_TOKENS - 1]), key=cells.__getitem__)
    return OneOfThese(tuple(tokens))


def _best(
    board: Board, right: Sequence[Move], profile: Profile, chance: Chance
) -> tuple[Move, Chance]:
    """One of the moves that are easiest for the patient's hand."""
    efforts = [_effort(board, move, profile) for move in right]
    least = min(efforts)
    easy = [move for move, effort in zip(right, efforts, strict=True) if effort == least]
    return chance.pick(easy)


def _effort(board: Board, move: Move, profile: Profile) -> tuple[int, int]:
    """How far the token lies from the goal row, where the patient sits, and from the hand."""
    if profile.reach is Reach.WHOLE_BOARD:
        return (0, 0)
    column = move.origin.column
    aside = column - 1 if profile.hand is Hand.LEFT else board.columns - column
    return (abs(move.origin.row - board.goal_row), aside)
