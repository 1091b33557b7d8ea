"""What the few-shot experiment found, an outcome a line: as it is kept beside the docs."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, fields
from typing import Final

from pydantic import TypeAdapter

from maestra.experiments.fewshot import Outcome
from maestra.experiments.fewshot_runs import Part, Runs
from maestra.rules.exercise import LearnStatus

CONFIDENCE_DIGITS: Final = 4


@dataclass(frozen=True, slots=True)
class Finding:
    """What counts of an outcome."""

    part: Part
    seed: int
    family: str
    """Of one of the paper's exercises, its key."""
    person: str
    demonstrations: int
    questions: int
    asked: int
    status: LearnStatus
    confidence: float
    exact: bool
    exact_on_new_decks: bool
    slipped: bool
    """Whether there was a mistake."""
    found: bool
    """Whether its demonstration was pointed out."""
    located: bool
    """Whether its move was."""
    false_alarms: int
    """Demonstrations without a mistake that were said to have one."""

    @property
    def learned(self) -> bool:
        """Whether it was called learned."""
        return self.status is LearnStatus.LEARNED


def findings(runs: Runs) -> Iterator[Finding]:
    """A finding for each outcome, in the order of the runs."""
    for run, outcomes in runs.items():
        for one in outcomes:
            yield _finding(run.part, one)


def _finding(part: Part, one: Outcome) -> Finding:
    wrong = None if one.slipped is None else one.slipped.demonstration
    pointed_out = {demonstration for demonstration, _ in one.slips}
    return Finding(
        part,
        one.seed,
        one.family,
        one.person,
        one.demonstrations,
        one.questions,
        one.asked,
        LearnStatus(one.status),
        round(one.confidence, CONFIDENCE_DIGITS),
        one.exact,
        one.exact_on_new_decks,
        one.slipped is not None,
        wrong in pointed_out,
        one.located,
        len(pointed_out - {wrong}),
    )


def findings_csv(found: Iterable[Finding]) -> str:
    """The findings as CSV, yes and no as 1 and 0."""
    text = io.StringIO(newline="")
    names = [field.name for field in fields(Finding)]
    writer = csv.DictWriter(text, names, lineterminator="\n")
    writer.writeheader()
    for one in found:
        cells = asdict(one)
        cells |= {"part": one.part.value, "status": one.status.value}
        writer.writerow({k: int(v) if isinstance(v, bool) else v for k, v in cells.items()})
    return text.getvalue()


def findings_from_csv(text: str) -> list[Finding]:
    """What `findings_csv` wrote.

    Raises:
        pydantic.ValidationError: it did not write that.
    """
    return TypeAdapter(list[Finding]).validate_python(list(csv.DictReader(text.splitlines())))
