"""How little assistance could be enough, if the coach knew the simulated patient inside out.

The simulated patient of `coaching.patients`, playing the paper's ascending exercise by the
coach's own rules (errorless mode off, human-centred robot, no robot arm), is a Markov decision
process. Backward induction finds for each price of help the best level in each state; the
highest price at which no less is completed than with level 5 throughout gives the assistance
that suffices. A policy that has to learn who sits there cannot be expected to do better.

A state is: moves made; the rank of the last token placed, which says how many tokens may follow;
weariness; attempt; last outcome; silences; the highest help so far; the help in mind; refused
tokens, of which some would have been right elsewhere. Every outcome but a right one adds
weariness, so no state comes back and plain recursion ends.

Left out: the limit on time, which makes completing a little likelier in all figures; where
tokens lie, so levels 2 and 3 count with their mean over arrangements, drawn from a fixed seed.
A test holds level 4 throughout against the sessions that `experiment coaching` plays.

Cost: some 100,000 states for a patient and price, a few seconds.
"""

from __future__ import annotations

import random
from bisect import bisect_left
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from statistics import fmean
from typing import Final, NamedTuple

from maestra.coaching.chance import Chance
from maestra.coaching.patients import (
    HABIT,
    RELIEF,
    REMINDS,
    WEAR_OF_ERROR,
    WEAR_OF_SILENCE,
    Patient,
    patient_of,
)
from maestra.coaching.settings import Mental, Profile, settings_for
from maestra.coaching.situation import Outcome

LENGTH: Final = 5
TOKENS: Final = 10
ROWS: Final = 3
"""Of storage, of `LENGTH` cells each."""
MOST_HELP: Final = 5
SHOWN: Final = 4
PRICES: Final = tuple(2.0 ** (-half / 2) for half in range(10, 25))
"""Of a level of help, in completed sessions."""
PROFILES: Final = (Mental.MODERATE, Mental.SEVERE)
"""The other ones complete nearly always, whatever the help."""
_ARRANGEMENTS: Final = 300
_HALVES: Final = 2
"""Weariness is counted in halves."""


class State(NamedTuple):
    """Before help is chosen."""

    made: int = 0
    rank: int = 0
    """Of the last token placed, 1 to `TOKENS`; 0 before."""
    weariness: int = 0
    attempt: int = 1
    last: Outcome = Outcome.RIGHT
    silences: int = 0
    """0, 1, or 2 for more."""
    most: int = 0
    mind: int = 0
    wrong: int = 0
    """Tokens refused that are not right now."""
    misplaced: int = 0
    """Tokens refused that are right, elsewhere."""

    @property
    def fitting(self) -> int:
        """How many tokens are right now."""
        return TOKENS - LENGTH + 1 + self.made - self.rank

    @property
    def stored(self) -> int:
        """How many lie in storage."""
        return TOKENS - self.made


class Worth(NamedTuple):
    """What is to be expected of a state."""

    value: float
    """Completing, less the price of the help."""
    complete: float
    levels: float
    """Assistance: the sum of the levels."""


_ENDED: Final = Worth(0.0, 0.0, 0.0)


class Oracle:
    """Knows one patient, and what help is best for them at one price."""

    def __init__(
        self, patient: Patient, attempts: int, price: float, fixed: int | None = None
    ) -> None:
        """Prepare.

        Args:
            patient: who plays.
            attempts: after which the token is shown.
            price: of one level, in completed sessions.
            fixed: the level to help with always; None for the best one.
        """
        self._patient, self._attempts, self._price = patient, attempts, price
        self._levels = range(MOST_HELP + 1) if fixed is None else range(fixed, fixed + 1)
        self._borne = _halves(patient.tolerance)
        self._worths: dict[State, Worth] = {}

    def worth(self, state: State | None = None) -> Worth:
        """What is to be expected from a state on, by default from the beginning."""
        state = state or State()
        if state.attempt > self._attempts + 1:  # all later ones are alike
            state = state._replace(attempt=self._attempts + 1)
        if state not in self._worths:
            levels = {self._given(state, level) for level in self._levels}
            self._worths[state] = max(self._with(state, level) for level in sorted(levels))
        return self._worths[state]

    def _given(self, state: State, level: int) -> int:
        """What the coach makes of a policy's choice."""
        if state.last is Outcome.WRONG:
            level = max(level, state.most)
        if state.last is Outcome.SILENCE and state.silences == 1:
            level = min(level, 1)
        if state.attempt > self._attempts:
            level = max(level, SHOWN)
        return 2 if level == SHOWN - 1 and state.fitting == state.stored else level

    def _with(self, state: State, level: int) -> Worth:
        """The worth when help of this level is given."""
        mind = state.mind
        if level > 1 or (level and state.made):  # before the first move level 1 only encourages
            mind = min(level, SHOWN)
        after = self._attempt(state._replace(most=max(state.most, level), mind=mind))
        paid = after.value - self._price * level
        return Worth(paid, after.complete, after.levels + level)

    def _attempt(self, state: State) -> Worth:
        if state.weariness > self._borne:
            return _ENDED
        attends = self._patient.attention
        right, wrong, misplaced = _odds(self._patient, state)
        parts = [(1 - attends, self.worth(_silent(state)))]
        then = self._on(state)
        parts += [(attends * right / len(then), one) for one in then]
        for share, refused in (
            (wrong, state._replace(wrong=min(state.wrong + 1, state.stored - state.fitting))),
            (misplaced, state._replace(misplaced=min(state.misplaced + 1, state.fitting))),
        ):
            if share:
                parts += [(attends * share * odds, one) for odds, one in self._refused(refused)]
        return Worth(*(sum(share * one[each] for share, one in parts) for each in range(3)))

    def _on(self, state: State) -> list[Worth]:
        """After a right move: each token that was right is as likely."""
        made = state.made + 1
        if made == LENGTH:
            return [Worth(1.0, 1.0, 0.0)]
        weariness = max(0, state.weariness - _halves(RELIEF))
        ranks = range(state.rank + 1, state.rank + state.fitting + 1)
        return [self.worth(State(made, rank, weariness)) for rank in ranks]

    def _refused(self, state: State) -> list[tuple[float, Worth]]:
        """After a wrong one: it is put back by the patient, or late by the caregiver."""
        weariness = state.weariness + _halves(WEAR_OF_ERROR)
        if weariness > self._borne:
            return []
        again = state._replace(attempt=state.attempt + 1, last=Outcome.WRONG)
        late = weariness + _halves(WEAR_OF_SILENCE)
        attends = self._patient.attention
        return [
            (attends, self.worth(again._replace(weariness=weariness))),
            (1 - attends, self.worth(again._replace(weariness=late))),
        ]


@dataclass(frozen=True, slots=True)
class BoundRow:
    """A profile: level 5 throughout, and what would be enough."""

    profile: str
    patients: int
    complete_with_most: float
    levels_with_most: float
    complete: float
    levels: float

    @property
    def saved(self) -> float:
        """The share of assistance that could be saved."""
        return 1 - self.levels / self.levels_with_most


def bound_rows(patients: int, seed: int, profiles: Iterable[Mental] = PROFILES) -> list[BoundRow]:
    """For each profile the least assistance with which as many sessions are completed.

    Args:
        patients: of each profile, the same as the first of `experiment coaching`.
        seed: decides who they are.
        profiles: which.
    """
    return [_row(mental, patients, seed) for mental in profiles]


def _row(mental: Mental, count: int, seed: int) -> BoundRow:
    profile = Profile(mental)
    attempts = settings_for(profile).attempts
    people = [patient_of(profile, Chance(seed).split(number)) for number in range(1, count + 1)]

    def mean(price: float, fixed: int | None = None) -> Worth:
        each = [Oracle(one, attempts, price, fixed).worth() for one in people]
        return Worth(*(fmean(one[part] for one in each) for part in range(3)))

    most = mean(0.0, MOST_HELP)
    means = cache(mean)
    index = bisect_left(
        PRICES,
        x=True,
        hi=len(PRICES) - 1,
        key=lambda price: means(price).complete >= most.complete,
    )
    least = means(PRICES[index])
    return BoundRow(mental.value, count, most.complete, most.levels, least.complete, least.levels)


def _halves(weariness: float) -> int:
    return round(_HALVES * weariness)


def _silent(state: State) -> State:
    return state._replace(
        weariness=state.weariness + _halves(WEAR_OF_SILENCE),
        attempt=state.attempt + 1,
        last=Outcome.SILENCE,
        silences=min(state.silences + 1, 2),
    )


def _odds(patient: Patient, state: State) -> tuple[float, float, float]:
    """Of an attempt: right; a token that is not right; one that is, on another cell."""
    unheard = _by_memory(patient, state, patient.memory, _guess(patient, state))
    slip = patient.slip if state.made < LENGTH - 1 else 0.0
    match state.mind:
        case 0:
            return unheard
        case 1:
            reminded = patient.memory + (1 - patient.memory) * REMINDS
            heard = _by_memory(patient, state, reminded, _guess(patient, state))
        case 2:
            heard = _by_memory(patient, state, patient.memory, _in_row(state.made, state.rank))
        case 3:
            shown = min(3, 1 + state.stored - state.fitting)
            heard = _by_memory(patient, state, patient.memory, 1 / shown)
        case _:
            heard = (1 - slip, 0.0, slip)
    hears = patient.attention
    first, second, third = (
        hears * one + (1 - hears) * other for one, other in zip(heard, unheard, strict=True)
    )
    return first, second, third


def _by_memory(
    patient: Patient, state: State, knows: float, guess: float
) -> tuple[float, float, float]:
    """If the rule is in mind the token is right, else it is with the likelihood `guess`."""
    slip = patient.slip if state.made < LENGTH - 1 else 0.0
    lands = _lands(state.made, patient.slip)
    return (
        knows * (1 - slip) + (1 - knows) * guess * lands,
        (1 - knows) * (1 - guess),
        knows * slip + (1 - knows) * guess * (1 - lands),
    )


def _guess(patient: Patient, state: State) -> float:
    """How likely any token is right; refused ones are avoided if they are in mind."""
    anyhow = state.fitting / state.stored
    left = state.stored - state.wrong - state.misplaced
    avoiding = (state.fitting - state.misplaced) / left if left else anyhow
    return patient.memory * avoiding + (1 - patient.memory) * anyhow


def _lands(made: int, slip: float) -> float:
    """How likely a token that is put anywhere comes to lie on the first free cell."""
    free = range(made, LENGTH)
    total = 0.0
    for cell in free:
        meant = (HABIT if cell == made else 0.0) + (1 - HABIT) / len(free)
        beside = [one for one in (cell - 1, cell + 1) if one in free]
        if cell == made:
            total += meant * (1 - slip if beside else 1.0)
        elif made in beside:
            total += meant * slip / len(beside)
    return total


@cache
def _in_row(made: int, rank: int) -> float:
    """How likely a token of the row that level 2 names is right, on the average."""
    chance = random.Random(TOKENS * made + rank)  # noqa: S311 - no secret
    shares: list[float] = []
    for _ in range(_ARRANGEMENTS):
        placed = {rank, *chance.sample(range(1, rank), made - 1)} if made else set[int]()
        cells = chance.sample(range(ROWS * LENGTH), TOKENS)
        rows = {one: cells[one - 1] // LENGTH for one in range(1, TOKENS + 1) if one not in placed}
        fitting = range(rank + 1, TOKENS - LENGTH + 2 + made)
        named = rows[chance.choice(fitting)]
        beside = [one for one, row in rows.items() if row == named]
        shares.append(sum(one in fitting for one in beside) / len(beside))
    return fmean(shares)
