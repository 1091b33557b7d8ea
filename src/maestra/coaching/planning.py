"""Help where it is worth its price.

The rest of a session is taken for a Markov decision process with a finite horizon: so many moves
to go, so much strain, the help that stands. An attempt is right, wrong, or does not come
(`Odds`). A right one brings the next move and relieves; the others strain, and who is strained
too much gives up. Backward induction [1] finds what is best where a session that is completed is
worth 1 and each level of help costs a *price*. One price throughout is the Lagrangian way to save
as much help as possible for the sessions that are lost by it [2]; which price it is says how many
those may be.

What the coach does anyway is part of the process: a human-centred robot no more than encourages
after a first silence. After a silence level 0 lets stand what was said before; a token that was
shown is still the one to take. Nobody knows how much strain a patient bears: any amount from
`LEAST_BORNE` to `MOST_BORNE` is as likely to be too much.

Simplified: who has borne much strain before runs the same risk again; that the coach shows the
token after so many attempts, and helps no less after an error, is left out. Two other ways were
measured on simulated patients and left, for they saved less at the same loss: choosing the price
anew before each attempt so that the plan completes as often as the most help, and learning from
what a patient has borne.

Cost: a plan has `MOST_AHEAD` x `MOST_BORNE` x 12 states and is made for each choice, in about a
millisecond.

[1] Mansour, Reinforcement Learning, lecture 4: finite horizon, constructing an optimal policy.
[2] Altman, Constrained Markov Decision Processes, INRIA 1995: the Lagrangian approach.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from maestra.coaching.fields import MAX_LEVEL
from maestra.coaching.situation import STRAIN, Limits, Outcome, Situation

LEAST_BORNE: Final = 4
"""Strain below which nobody gives up: two errors."""
MOST_BORNE: Final = 16
"""Strain at which everybody gives up: eight errors."""
MOST_AHEAD: Final = 8
"""Moves that are planned; a longer exercise is planned as if it had no more to go."""

_RELIEF: Final = -STRAIN[Outcome.RIGHT]
_WEAR: Final = STRAIN[Outcome.WRONG]
_LEVELS: Final = range(MAX_LEVEL + 1)
_BORNE: Final = tuple(
    min(1.0, max(0.0, (MOST_BORNE - strain) / (MOST_BORNE - LEAST_BORNE + 1)))
    for strain in range(MOST_BORNE + _WEAR)
)
"""By strain: the share of patients who bear it."""


@dataclass(frozen=True, slots=True)
class Odds:
    """What is believed of the next attempt."""

    right: tuple[float, ...]
    """How likely it is right if there is one, by the level of the help that stands."""
    silent: float
    """How likely there is none."""


Worth: TypeAlias = float
"""Of a state: how likely completing is, less the price of the help to come."""
_COMPLETE: Final = 1.0
_GIVEN_UP: Final = 0.0


@dataclass(frozen=True, slots=True)
class _Menu:
    """The levels that may be chosen."""

    usual: range
    after_silence: range
    """After a first one at a move."""


@dataclass(frozen=True, slots=True)
class _Layer:
    """The states with the same moves to go, by strain."""

    fresh: tuple[Worth, ...]
    """Before the first help at a move."""
    helped: tuple[tuple[Worth, ...], ...]
    """No silence yet at this move: by the help that stands; its price is paid."""
    helped_again: tuple[tuple[Worth, ...], ...]
    """After a silence."""


_END: Final = _Layer((_COMPLETE,) * MOST_BORNE, (), ())


def best_help(odds: Odds, situation: Situation, strain: int, limits: Limits, price: float) -> int:
    """The level to help with now; nobody who is more strained is helped less.

    A price alone would: a session that is likely to be given up anyway is not worth much help.

    Args:
        odds: what is believed of the patient.
        situation: where the session is.
        strain: in halves of an error.
        limits: the levels that may be chosen.
        price: of one level of help, in completed sessions.
    """
    menu = _Menu(limits.levels, limits.after_silence)
    layer = _END
    for _ in range(min(situation.left, MOST_AHEAD)):
        layer = _layer(odds, layer, menu, price)
    levels, standing = menu.usual, 0
    if situation.last is Outcome.SILENCE:
        levels = menu.after_silence if situation.silences == 1 else menu.usual
        standing = situation.standing
    by_strain = layer.helped_again if situation.silences else layer.helped
    return max(
        max(levels, key=lambda level: (helped[level or standing] - price * level, -level))
        for helped in by_strain[: min(strain, MOST_BORNE - 1) + 1]
    )


def _layer(odds: Odds, after: _Layer, menu: _Menu, price: float) -> _Layer:
    """The states with one move more to go than `after`, the most strained first."""
    nowhere = [_GIVEN_UP] * (MOST_BORNE + _WEAR)
    fresh, again = [*nowhere], [*nowhere]
    first = [(_GIVEN_UP,) * len(_LEVELS)] * (MOST_BORNE + _WEAR)
    later, helped, helped_again = [*first], [*first], [*first]
    for strain in range(MOST_BORNE - 1, -1, -1):
        right = after.fresh[max(0, strain - _RELIEF)]
        missed, silent = strain + _WEAR, strain + 1
        bears_missed = _BORNE[missed] / _BORNE[strain]
        bears_silent = odds.silent * _BORNE[silent] / _BORNE[strain]
        row = _attempted(odds, right, again[missed], bears_missed, later[silent], bears_silent)
        priced = _priced(row, price)
        helped_again[strain] = row
        again[strain] = max(_of(priced, menu.usual))
        first[strain] = _after_silence(row, priced, menu.after_silence)
        later[strain] = _after_silence(row, priced, menu.usual)
        row = _attempted(odds, right, fresh[missed], bears_missed, first[silent], bears_silent)
        helped[strain] = row
        fresh[strain] = max(_of(_priced(row, price), menu.usual))
    return _Layer(tuple(fresh), tuple(helped), tuple(helped_again))


def _attempted(
    odds: Odds,
    right: Worth,
    wrong: Worth,
    bears_wrong: float,
    silent: Sequence[Worth],
    silence: float,
) -> tuple[Worth, ...]:
    """With the help of each level standing: what the next attempt is worth."""
    answered = 1 - odds.silent
    return tuple(
        [
            answered * (share * right + (1 - share) * bears_wrong * wrong) + silence * kept
            for share, kept in zip(odds.right, silent, strict=True)
        ]
    )


def _priced(helped: Sequence[Worth], price: float) -> list[Worth]:
    """By level: before it is said."""
    return [worth - price * level for level, worth in enumerate(helped)]


def _of(priced: list[Worth], levels: range) -> list[Worth]:
    return priced[levels.start : levels.stop]


def _after_silence(
    helped: tuple[Worth, ...], priced: list[Worth], levels: range
) -> tuple[Worth, ...]:
    """By the help that stands: it may be left so, if level 0 is allowed, or more be said."""
    if 0 not in levels:
        return (max(_of(priced, levels)),) * len(helped)
    if len(levels) == 1:
        return helped
    said = max(_of(priced, levels[1:]))
    return tuple([max(said, kept) for kept in helped])
