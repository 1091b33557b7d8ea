"""All parts of the few-shot experiment: what each shows and asks, run in parallel and kept.

A run is one sample with one number of demonstrations; it gives an outcome for each number of
questions. Each finished run is on the disk before the next one counts, see `results`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from enum import Enum
from math import ceil
from pathlib import Path
from types import MappingProxyType
from typing import Final, NamedTuple, TypeAlias, cast

from joblib import Parallel, delayed
from pydantic import TypeAdapter, ValidationError

from maestra import __version__
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.experiments.fewshot import USUAL, Circumstances, Outcome, trials
from maestra.experiments.fewshot_paper import RULES, paper_trials
from maestra.experiments.results import Record, ResultsFile, open_results
from maestra.learning.fewshot.questions import QuestionKind

WRONG_ANSWERS: Final = 0.03
"""How often the caregiver of that part answers wrongly."""


class Part(Enum):
    """What is measured."""

    LANGUAGE = "language"
    """Random exercises of the whole language, any person, any question."""
    ROWS_AND_MOVES = "rows-and-moves"
    """The same, but never asked about rules."""
    WRONG_ANSWERS = "wrong-answers"
    """The same as the first, by somebody who answers wrongly now and then."""
    OUTSIDE = "outside"
    """Exercises about something that the learner is not shown."""
    SLIP = "slip"
    """Just one mistake in three demonstrations."""
    NO_SLIP = "no-slip"
    """No mistake in three demonstrations."""
    PAPER = "paper"
    """The paper's six exercises, the tokens elsewhere at the start of each demonstration."""
    PAPER_ONE_START = "paper-one-start"
    """The same, each demonstration from the same start."""


@dataclass(frozen=True, slots=True)
class Design:
    """How often a part shows and asks, and what is out of the usual."""

    demonstrations: tuple[int, ...]
    questions: tuple[int, ...]
    circumstances: Circumstances = USUAL
    share: float = 1.0
    """Of the exercises, the first ones: fewer are enough to compare with the same of another
    part."""


DESIGNS: Final[Mapping[Part, Design]] = MappingProxyType(
    {
        Part.LANGUAGE: Design((1, 2, 3), (0, 3, 5)),
        Part.ROWS_AND_MOVES: Design(
            (1, 2, 3),
            (3, 5),
            Circumstances(kinds=frozenset({QuestionKind.ROW, QuestionKind.MOVE})),
            share=0.4,
        ),
        Part.WRONG_ANSWERS: Design(
            (1, 2, 3), (3, 5), Circumstances(wrong=WRONG_ANSWERS), share=0.4
        ),
        Part.OUTSIDE: Design((1, 2, 3), (0, 3), Circumstances(outside=True), share=0.6),
        Part.SLIP: Design((3,), (0,), Circumstances(slip=True)),
        Part.NO_SLIP: Design((3,), (0,), Circumstances(slip=False)),
        Part.PAPER: Design((2,), (0, 3)),
        Part.PAPER_ONE_START: Design((2,), (0, 3)),
    }
)
PAPERS: Final = frozenset({Part.PAPER, Part.PAPER_ONE_START})


class Run(NamedTuple):
    """One sample, shown so often."""

    part: Part
    seed: int
    """Of the sample; for the paper's exercises they take turns with it."""
    demonstrations: int


Runs: TypeAlias = Mapping[Run, tuple[Outcome, ...]]
"""What came of each: an outcome for each number of questions of its part."""


def wanted_runs(
    parts: Sequence[Part],
    exercises: int,
    draws: int,
    seed: int,
    demonstrations: Collection[int] = (),
) -> list[Run]:
    """Every run of these parts, a sample after the other.

    Args:
        parts: what is measured.
        exercises: how many random ones.
        draws: how often each of the paper's exercises is shown anew.
        seed: of the first sample; the others follow it.
        demonstrations: only runs with so many; without any with all that the part has.
    """
    return [
        Run(part, number, count)
        for part in parts
        for number in _numbers(part, exercises, draws, seed)
        for count in DESIGNS[part].demonstrations
        if not demonstrations or count in demonstrations
    ]


def _numbers(part: Part, exercises: int, draws: int, seed: int) -> range:
    if part in PAPERS:
        return range(len(RULES) * draws)
    return range(seed, seed + ceil(DESIGNS[part].share * exercises))


def fewshot_runs(
    wanted: Sequence[Run],
    jobs: int = 1,
    results: Path | None = None,
    advance: Callable[[int], None] = lambda _more: None,
) -> Runs:
    """The runs that are `wanted`, those that are in the file `results` not again.

    Args:
        wanted: which.
        jobs: processes; -1 for one on each core.
        results: where each finished run is kept; None keeps none.
        advance: called with the number of runs that are done since the last call.

    Raises:
        FormatError: the file holds something else, or results of another version.
        OSError: it cannot be read or written.
    """
    with ExitStack() as stack:
        kept = None if results is None else stack.enter_context(open_results(results, header()))
        done = _kept(kept, results)
        advance(sum(run in done for run in wanted))
        missing = [run for run in wanted if run not in done]
        for run, outcomes in _in_parallel(missing, jobs):
            done[run] = outcomes
            if kept is not None:
                kept.add(_record(run, outcomes))
            advance(1)
    return {run: done[run] for run in wanted}


def run_one(run: Run) -> tuple[Outcome, ...]:
    """What comes of one run."""
    design = DESIGNS[run.part]
    if run.part not in PAPERS:
        return trials(run.seed, run.demonstrations, design.questions, design.circumstances)
    number, which = divmod(run.seed, len(RULES))
    return paper_trials(
        list(RULES)[which],
        number,
        run.demonstrations,
        design.questions,
        moves_tokens=run.part is Part.PAPER,
    )


def header() -> Record:
    """What the results were measured with; each of them names its own seed."""
    return {
        "experiment": "fewshot",
        "version": __version__,
        "command": "maestra experiment fewshot",
    }


def _in_parallel(runs: Sequence[Run], jobs: int) -> Iterator[tuple[Run, tuple[Outcome, ...]]]:
    if runs:
        parallel = Parallel(n_jobs=jobs, return_as="generator_unordered")
        work = (delayed(_with_run)(run) for run in runs)
        yield from cast("Iterator[tuple[Run, tuple[Outcome, ...]]]", parallel(work))


def _with_run(run: Run) -> tuple[Run, tuple[Outcome, ...]]:
    return run, run_one(run)


def _record(run: Run, outcomes: Sequence[Outcome]) -> Record:
    return {
        "part": run.part.value,
        "seed": run.seed,
        "demonstrations": run.demonstrations,
        "outcomes": [asdict(one) for one in outcomes],
    }


@dataclass(frozen=True, slots=True)
class _Kept:
    """A finished run as a line of the file."""

    part: Part
    seed: int
    demonstrations: int
    outcomes: tuple[Outcome, ...]


_KEPT: Final = TypeAdapter(_Kept)


def _kept(kept: ResultsFile | None, path: Path | None) -> dict[Run, tuple[Outcome, ...]]:
    """The runs of a file; a record that is none is refused with its line."""
    done: dict[Run, tuple[Outcome, ...]] = {}
    for line, record in enumerate(kept.records if kept else [], start=2):
        one = _kept_run(record)
        if one is None or tuple(o.questions for o in one.outcomes) != DESIGNS[one.part].questions:
            raise FormatError(str(path), line, (Fault("", "no run", "a finished run"),))
        done[Run(one.part, one.seed, one.demonstrations)] = one.outcomes
    return done


def _kept_run(record: Record) -> _Kept | None:
    try:
        return _KEPT.validate_python(dict(record))
    except ValidationError:
        return None
