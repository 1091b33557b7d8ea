"""Many samples of the few-shot learner, and the shares of them that came out well."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from math import sqrt
from typing import Final, TypeAlias

from joblib import Parallel, delayed

from maestra.experiments.fewshot import Outcome, learned_wrongly, trial
from maestra.rules.exercise import LearnStatus

Z_95: Final = 1.959964
"""Standard deviations on either side that hold 95 % of a normal distribution."""
DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class Share:
    """How many of how many, with the 95 % interval of Wilson's score for the true share."""

    count: int
    of: int
    low: float
    high: float

    @classmethod
    def of_all(cls, hits: Iterable[bool]) -> Share:
        """The share of those that are true; without any, from 0 to 1."""
        seen = list(hits)
        count, of = sum(seen), len(seen)
        if not of:
            return cls(0, 0, 0.0, 1.0)
        share = count / of
        spread = Z_95 * sqrt(share * (1 - share) / of + Z_95**2 / (4 * of**2))
        middle, scale = share + Z_95**2 / (2 * of), 1 + Z_95**2 / of
        low, high = (max(0.0, middle - spread) / scale, min(1.0, (middle + spread) / scale))
        return cls(count, of, round(low, DIGITS), round(high, DIGITS))


@dataclass(frozen=True, slots=True)
class SweepRow:
    """What came of all samples with so many demonstrations and so many questions at most."""

    demonstrations: int
    questions: int
    exact: Share
    """On fresh starts."""
    exact_on_new_decks: Share
    learned: Share
    """How many were called learned."""
    exact_of_learned: Share
    wrongly_learned: Share
    """Called learned, and not exact."""


Advance: TypeAlias = Callable[[int], None]


def _nothing(_more: int) -> None:
    """Nobody waits."""


def sweep(
    seeds: Sequence[int],
    demonstrations: Sequence[int],
    questions: Sequence[int],
    jobs: int = 1,
    advance: Advance = _nothing,
) -> tuple[tuple[SweepRow, ...], tuple[Outcome, ...]]:
    """The samples of `seeds`, each shown and asked as often as said: the shares and each outcome.

    Args:
        seeds: which samples.
        demonstrations: how many are shown.
        questions: how many may be asked.
        jobs: processes; -1 for one on each core.
        advance: called with the number of samples that are done since the last call.
    """
    rows: list[SweepRow] = []
    everything: list[Outcome] = []
    for asked in questions:
        for count in demonstrations:
            tasks = [delayed(trial)(seed, count, asked=asked) for seed in seeds]
            outcomes: list[Outcome] = []
            for outcome in Parallel(n_jobs=jobs, return_as="generator")(tasks):
                outcomes.append(outcome)
                advance(1)
            rows.append(_row(count, asked, outcomes))
            everything += outcomes
    return tuple(rows), tuple(everything)


def _row(count: int, asked: int, outcomes: Sequence[Outcome]) -> SweepRow:
    learned = [one for one in outcomes if one.status == LearnStatus.LEARNED.value]
    return SweepRow(
        count,
        asked,
        Share.of_all(one.exact for one in outcomes),
        Share.of_all(one.exact_on_new_decks for one in outcomes),
        Share.of_all(one.status == LearnStatus.LEARNED.value for one in outcomes),
        Share.of_all(one.exact for one in learned),
        Share.of_all(learned_wrongly(one) for one in outcomes),
    )


def outcomes_csv(outcomes: Iterable[Outcome]) -> str:
    """Each outcome as a line of CSV."""
    text = io.StringIO()
    fields = [name for name in Outcome.__dataclass_fields__ if name != "slips"]
    writer = csv.DictWriter(text, fields, extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    writer.writerows(asdict(outcome) for outcome in outcomes)
    return text.getvalue()
