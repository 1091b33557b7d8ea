"""How many actions are learned exactly after so many demonstrations: the paper's Fig. 6a [1].

An action is learned exactly when its precondition equals the one that all right plays together
leave; the percentage is of the actions that occur in right plays. Chosen demonstrations are a
smallest teaching set in a drawn order, random ones are drawn uniformly from all right plays.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import cache
from random import Random
from typing import Final, assert_never

from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError
from maestra.learning.grounded import GroundedLearner
from maestra.learning.teaching_sets import teaching_set
from maestra.rules.ground_truth import ground_truth
from maestra.rules.paper import PAPER_EXERCISES, PaperExercise
from maestra.rules.strips.actions import Action
from maestra.rules.strips.vocabulary import Level

LOW: Final = 0.1
HIGH: Final = 0.9
"""The spread is between these quantiles of the runs."""


class Choice(Enum):
    """Who chooses the demonstrations."""

    CHOSEN = "chosen"
    """A teacher who knows what the learner needs: a smallest teaching set, in a drawn order."""
    RANDOM = "random"
    """Nobody: drawn uniformly from the right plays."""


@dataclass(frozen=True, slots=True)
class CurveSettings:
    """What is measured; with the same settings every run comes out the same."""

    exercise: str
    """A key of `PAPER_EXERCISES`."""
    level: Level
    demonstrations: int
    """How many are shown at most; of chosen ones there are only as many as teach everything."""
    seed: int

    def __post_init__(self) -> None:
        """Refuse an exercise that there is not, or no demonstration at all."""
        faults: list[Fault] = []
        if self.exercise not in PAPER_EXERCISES:
            known = ", ".join(PAPER_EXERCISES)
            faults.append(Fault("exercise", self.exercise, f"one of {known}"))
        if self.demonstrations < 1:
            faults.append(Fault("demonstrations", str(self.demonstrations), "at least 1"))
        if faults:
            raise InvalidError(faults)

    @property
    def paper_exercise(self) -> PaperExercise:
        """The exercise itself."""
        return PAPER_EXERCISES[self.exercise]


@dataclass(frozen=True, slots=True)
class CurveRun:
    """One learner's way from nothing to what it has learned."""

    choice: Choice
    number: int
    """Of the run, from 1; with the seed it decides what is shown."""
    exact: tuple[int, ...]
    """After 1, 2, ... demonstrations, how many actions are learned exactly."""


@dataclass(frozen=True, slots=True)
class CurvePoint:
    """All runs after so many demonstrations, in percent of the actions that occur."""

    choice: Choice
    demonstrations: int
    runs: int
    mean: float
    deviation: float
    """The standard deviation between runs; 0 of a single one."""
    low: float
    """What a tenth of the runs do not exceed."""
    high: float
    """What nine tenths of the runs do not exceed."""


def run_curve(settings: CurveSettings, choice: Choice, number: int) -> CurveRun:
    """Show one learner demonstrations and compare with the truth after each."""
    truth = _truth(settings.exercise, settings.level)
    learner = GroundedLearner(settings.paper_exercise.vocabulary(settings.level))
    exact: list[int] = []
    for demonstration in _shown(settings, choice, number):
        learner.show(demonstration)
        learned = learner.exercise().model.preconditions
        exact.append(sum(learned.get(action) == bits for action, bits in truth.items()))
    return CurveRun(choice, number, tuple(exact))


def actions_that_occur(settings: CurveSettings) -> int:
    """In how many actions the percentages are counted."""
    return len(_truth(settings.exercise, settings.level))


def curve_points(settings: CurveSettings, runs: Iterable[CurveRun]) -> tuple[CurvePoint, ...]:
    """The curves of these runs, one after the other."""
    occurring = actions_that_occur(settings)
    by_choice: dict[Choice, list[CurveRun]] = {}
    for run in runs:
        by_choice.setdefault(run.choice, []).append(run)
    return tuple(
        _point(choice, shown, [100 * count / occurring for count in counts])
        for choice in Choice
        for shown, counts in enumerate(
            zip(*(run.exact for run in by_choice.get(choice, [])), strict=True), start=1
        )
    )


def _point(choice: Choice, shown: int, percents: Sequence[float]) -> CurvePoint:
    ordered = sorted(percents)
    return CurvePoint(
        choice,
        shown,
        len(ordered),
        statistics.fmean(ordered),
        statistics.stdev(ordered) if len(ordered) > 1 else 0.0,
        _quantile(ordered, LOW),
        _quantile(ordered, HIGH),
    )


def _quantile(ordered: Sequence[float], share: float) -> float:
    """The least value that this share of all does not exceed."""
    return ordered[math.ceil(share * len(ordered)) - 1]


def _shown(settings: CurveSettings, choice: Choice, number: int) -> Iterator[Demonstration]:
    seed = f"{settings.seed}/{choice.value}/{number}"
    rng = Random(seed)  # noqa: S311 - an experiment that can be repeated, no secret
    match choice:
        case Choice.CHOSEN:
            chosen = list(chosen_demonstrations(settings.exercise, settings.level))
            rng.shuffle(chosen)
            yield from chosen[: settings.demonstrations]
        case Choice.RANDOM:
            plays = settings.paper_exercise.plays()
            for _ in range(settings.demonstrations):
                yield plays.play(rng.randrange(plays.count))
        case _:
            assert_never(choice)


@cache
def chosen_demonstrations(exercise: str, level: Level) -> tuple[Demonstration, ...]:
    """The teaching set of one of the paper's exercises."""
    known = PAPER_EXERCISES[exercise]
    return teaching_set(known.plays(), known.vocabulary(level)).demonstrations


@cache
def _truth(exercise: str, level: Level) -> Mapping[Action, int]:
    known = PAPER_EXERCISES[exercise]
    return ground_truth(known.plays(), known.vocabulary(level)).preconditions
