"""Simulated patients: they see what the coach commands and play through the same events.

The model has four traits, after the persona that Andriella, Torras and Alenyà describe by four
dimensions to simulate a patient before real ones are met [1]; what the traits do is ours:

* *memory*: how likely the rule is in mind at an attempt. If it is, the patient sees every right
  move and takes one; if not, any token that catches the eye, to the first free cell of the goal
  row as a rule. It also decides whether a token that was refused a moment ago is avoided.
* *attention*: how likely the patient is at it at all, and takes a hint in. A lapse is silence
  until the next prompt.
* *reactivity*: how long an action takes on average; each time between half and one and a half of
  it.
* *motor slips*: how likely a token lands on a neighbour of the cell that was meant.

A hint that is taken in does what it says: a rule comes to mind more often (`REMINDS`), a row or a
few tokens are all that is looked at, a shown move is made. Errors and unanswered prompts wear on
the patient, right moves restore; one who has had enough, or has sat longer than the stamina, is
seen to by the caregiver, who ends the session.

All numbers are assumptions, not measurements of people; each patient's own differ from the
profile's by up to `SPREAD`. They serve to compare policies with one another, not to foretell how
anybody will do.

[1] Andriella, Torras, Alenyà, Learning Robot Policies Using a High-Level Abstraction
Persona-Behaviour Simulator (abstract and introduction).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final

from maestra.coaching.chance import Chance
from maestra.coaching.commands import Command, LookAt, PointAt, Say
from maestra.coaching.referee import Referee
from maestra.coaching.settings import Mental, Physical, Profile
from maestra.core.board import Cell, Column
from maestra.core.state import Move
from maestra.core.tokens import TokenId
from maestra.language.coach_keys import CoachKey
from maestra.rules.position import Position

SPREAD: Final = 0.2
"""By how much of itself a patient's trait may differ from the profile's."""
REMINDS: Final = 0.4
"""How much of what memory lacks a rule that is heard and taken in makes good."""
HABIT: Final = 0.8
"""How likely a token goes to the first free cell when no rule is in mind."""
RELIEF: Final = 1.0
"""What a right move takes off a patient's weariness."""
WEAR_OF_ERROR: Final = 1.0
WEAR_OF_SILENCE: Final = 0.5


@dataclass(frozen=True, slots=True)
class Patient:
    """One simulated person."""

    memory: float
    attention: float
    reaction_ms: int
    slip: float
    tolerance: float
    """How much weariness is borne."""
    stamina_ms: int


_BY_MENTAL: Final = MappingProxyType(
    {
        Mental.NONE: Patient(0.95, 0.97, 4_000, 0.01, 8, 1_200_000),
        Mental.VERY_MILD: Patient(0.85, 0.93, 5_000, 0.02, 7, 1_200_000),
        Mental.MILD: Patient(0.70, 0.88, 7_000, 0.03, 6, 1_000_000),
        Mental.MODERATE: Patient(0.45, 0.78, 10_000, 0.05, 5, 900_000),
        Mental.SEVERE: Patient(0.25, 0.65, 14_000, 0.08, 4, 900_000),
    }
)
_BY_PHYSICAL: Final = MappingProxyType(
    {Physical.NONE: (0.0, 1.0), Physical.SLIGHT: (0.03, 1.4), Physical.MARKED: (0.08, 2.0)}
)
"""What a physical impairment adds to slips, and by how much it slows."""


def patient_of(profile: Profile, chance: Chance) -> Patient:
    """A person of this profile."""
    usual = _BY_MENTAL[profile.mental]
    slips, slower = _BY_PHYSICAL[profile.physical]
    draws: list[float] = []
    for _ in range(4):
        share, chance = chance.share()
        draws.append(1 + SPREAD * (2 * share - 1))
    memory, attention, reaction, slip = draws
    return Patient(
        min(usual.memory * memory, 1.0),
        min(usual.attention * attention, 1.0),
        round(usual.reaction_ms * slower * reaction),
        (usual.slip + slips) * slip,
        usual.tolerance,
        usual.stamina_ms,
    )


@dataclass(frozen=True, slots=True)
class Heard:
    """The last hint, as far as the patient is concerned."""

    key: CoachKey | None = None
    cells: tuple[Cell, ...] = ()


@dataclass(frozen=True, slots=True)
class Mind:
    """What the patient has in mind."""

    heard: Heard = Heard()
    refused: tuple[Move, ...] = ()
    """At this step."""
    weariness: float = 0.0


@dataclass(frozen=True, slots=True)
class Deed:
    """What the patient does next; nothing, if there is no move."""

    move: Move | None
    after_ms: int


_HINTS: Final = frozenset(
    {
        CoachKey.REMIND,
        CoachKey.LOOK_AT_ROW,
        CoachKey.ONE_OF_THESE,
        CoachKey.THIS_ONE,
        CoachKey.TOGETHER,
    }
)
_PRAISE: Final = frozenset(
    {CoachKey.PRAISE, CoachKey.PRAISE_OWN_CORRECTION, CoachKey.LET_US_GO_ON, CoachKey.ACCEPTED}
)


def perceive(mind: Mind, commands: Iterable[Command], tried: Move | None) -> Mind:
    """The mind after the coach did this; `tried` is the move that it answers, if any.

    Cells that are looked or pointed at belong to what was said just before: with a hint they are
    part of it, with a request to put back they are no hint.
    """
    said: CoachKey | None = None
    for command in commands:
        match command:
            case Say(key):
                said = CoachKey(key)
                mind = _hear(mind, said, tried)
            case LookAt(cells) | PointAt(cells) if cells and said in _HINTS:
                mind = replace(mind, heard=replace(mind.heard, cells=cells))
            case _:
                pass
    return mind


def unanswered(mind: Mind) -> Mind:
    """A prompt has gone by."""
    return replace(mind, weariness=mind.weariness + WEAR_OF_SILENCE)


def has_had_enough(patient: Patient, mind: Mind, sat_ms: int) -> bool:
    """Whether the patient will not go on."""
    return mind.weariness > patient.tolerance or sat_ms > patient.stamina_ms


def decide(
    patient: Patient, mind: Mind, referee: Referee, position: Position, chance: Chance
) -> tuple[Deed, Chance]:
    """What the patient does next when it is their turn."""
    pace, chance = chance.share()
    after = round(patient.reaction_ms * (0.5 + pace))
    attends, chance = _happens(patient.attention, chance)
    if not attends:
        return Deed(None, after), chance
    takes_in, chance = _happens(patient.attention, chance)
    heard = mind.heard if takes_in else Heard()
    meant, chance = _meant(patient, mind, heard, referee, position, chance)
    slips, chance = _happens(patient.slip, chance)
    if slips and meant is not None:
        meant, chance = _slipped(meant, position, chance)
    return Deed(meant, after), chance


def attends(patient: Patient, chance: Chance) -> tuple[bool, Chance]:
    """Whether the patient takes in what they are asked to put back."""
    return _happens(patient.attention, chance)


def _hear(mind: Mind, key: CoachKey, tried: Move | None) -> Mind:
    if key in _HINTS:
        return replace(mind, heard=Heard(key))
    if key in _PRAISE:
        return Mind(weariness=max(0.0, mind.weariness - RELIEF))
    if key in {CoachKey.REFUSED, CoachKey.REFUSED_BY_CAREGIVER} and tried is not None:
        refused = (*mind.refused, tried)
        return replace(mind, refused=refused, weariness=mind.weariness + WEAR_OF_ERROR)
    return mind


def _meant(
    patient: Patient,
    mind: Mind,
    heard: Heard,
    referee: Referee,
    position: Position,
    chance: Chance,
) -> tuple[Move | None, Chance]:
    now = position.now
    if heard.key in {CoachKey.THIS_ONE, CoachKey.TOGETHER}:
        origin, destination = heard.cells
        return Move(now.tokens[origin], origin, destination), chance
    looked_at = [
        token
        for token, cell in now.cells.items()
        if cell.row != now.board.goal_row and (not heard.cells or cell in heard.cells)
    ]
    reminded = REMINDS if heard.key is CoachKey.REMIND else 0.0
    knows, chance = _happens(patient.memory + (1 - patient.memory) * reminded, chance)
    if knows:
        right = [move for move in referee.right_moves(position) if move.token in looked_at]
        if right:
            return chance.pick(right)
    return _any_move(patient, mind, looked_at, position, chance)


def _any_move(
    patient: Patient,
    mind: Mind,
    looked_at: Sequence[TokenId],
    position: Position,
    chance: Chance,
) -> tuple[Move | None, Chance]:
    """A token that catches the eye, to the first free cell as a rule."""
    now = position.now
    free = [cell for cell in now.board.goal_cells if cell not in now.tokens]
    avoids, chance = _happens(patient.memory, chance)
    refused = {move.token for move in mind.refused} if avoids else set[TokenId]()
    tokens = [token for token in looked_at if token not in refused] or list(looked_at)
    if not tokens or not free:
        return None, chance
    token, chance = chance.pick(tokens)
    by_habit, chance = _happens(HABIT, chance)
    cell = free[0]
    if not by_habit:
        cell, chance = chance.pick(free)
    return Move(token, now.cells[token], cell), chance


def _slipped(move: Move, position: Position, chance: Chance) -> tuple[Move, Chance]:
    """The token lands on a free neighbour, if there is one."""
    row, column = move.destination.row, move.destination.column
    now = position.now
    beside = [Cell(row, Column(column + step)) for step in (-1, 1)]
    free = [cell for cell in beside if cell in now.board and cell not in now.tokens]
    if not free:
        return move, chance
    cell, chance = chance.pick(free)
    return replace(move, destination=cell), chance


def _happens(likelihood: float, chance: Chance) -> tuple[bool, Chance]:
    share, chance = chance.share()
    return share < likelihood, chance
