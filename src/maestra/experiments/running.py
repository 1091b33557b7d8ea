"""Experiments run: many runs in parallel, kept as they finish, and put into words for files."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import asdict
from pathlib import Path
from typing import Final, cast

from joblib import Parallel, delayed

from maestra import __version__
from maestra.core.faults import Fault
from maestra.core.json_lines import FormatError
from maestra.experiments.curve import (
    HIGH,
    LOW,
    Choice,
    CurvePoint,
    CurveRun,
    CurveSettings,
    actions_that_occur,
    run_curve,
)
from maestra.experiments.results import Record, ResultsFile, open_results
from maestra.experiments.svg import Picture, Point, Series, draw
from maestra.experiments.table import TableRow

PERCENT_DIGITS: Final = 2
SECOND_DIGITS: Final = 4


def curve_runs(
    settings: CurveSettings,
    runs: int,
    jobs: int,
    results: Path | None = None,
    advance: Callable[[int], None] = lambda _more: None,
) -> list[CurveRun]:
    """Runs 1 to `runs` of each choice, those that are in the file `results` not again.

    Args:
        settings: what is measured.
        runs: how many of each choice.
        jobs: processes; -1 for one on each core.
        results: where each finished run is kept; None keeps none.
        advance: called with the number of runs that are done since the last call.

    Raises:
        FormatError: the file holds something else, or results of other settings.
        OSError: it cannot be read or written.
    """
    with ExitStack() as stack:
        kept = (
            None
            if results is None
            else stack.enter_context(open_results(results, _header(settings)))
        )
        done = _kept_runs(settings, kept, results)
        wanted = [(choice, number) for choice in Choice for number in range(1, runs + 1)]
        advance(sum(key in done for key in wanted))
        missing = [key for key in wanted if key not in done]
        for run in _in_parallel(settings, missing, jobs):
            done[run.choice, run.number] = run
            if kept is not None:
                kept.add(_record(run))
            advance(1)
    return [done[key] for key in wanted]


def curve_csv(points: Iterable[CurvePoint]) -> str:
    """The curves as CSV, percentages rounded to hundredths."""
    return rows_csv([_plain(asdict(point), PERCENT_DIGITS) for point in points])


def table_csv(rows: Iterable[TableRow]) -> str:
    """The table as CSV, times in seconds."""
    return rows_csv([_plain(asdict(row), SECOND_DIGITS) for row in rows])


def curve_json(settings: CurveSettings, runs: int, points: Iterable[CurvePoint]) -> Record:
    """The curves and what they were measured with, as a JSON object."""
    return {
        **_header(settings),
        "runs": runs,
        "actions": actions_that_occur(settings),
        "points": [_plain(asdict(point), PERCENT_DIGITS) for point in points],
    }


def table_json(rows: Iterable[TableRow]) -> Record:
    """The table as a JSON object."""
    return {
        "experiment": "table",
        "version": __version__,
        "rows": [_plain(asdict(row), SECOND_DIGITS) for row in rows],
    }


def curve_svg(settings: CurveSettings, points: Sequence[CurvePoint]) -> str:
    """The curves as a picture, with the spread between the runs."""
    series = tuple(
        Series(
            f"{choice.value}, mean of {mine[0].runs} runs",
            tuple(Point(one.demonstrations, one.mean, one.low, one.high) for one in mine),
        )
        for choice in Choice
        if (mine := [point for point in points if point.choice == choice])
    )
    ends = "; ".join(
        f"{one.label}: {one.points[-1].mean:.1f} % after {one.points[-1].x} demonstrations"
        for one in series
    )
    return draw(
        Picture(
            title=f"{settings.paper_exercise.title}, vocabulary {settings.level.value}",
            description=(
                "Percentage of actions learned exactly against the number of demonstrations; "
                f"bands from the {LOW:.0%} to the {HIGH:.0%} quantile of runs. {ends}."
            ),
            horizontal="demonstrations",
            vertical="actions learned exactly, %",
            series=series,
        )
    )


def _in_parallel(
    settings: CurveSettings, keys: Sequence[tuple[Choice, int]], jobs: int
) -> Iterator[CurveRun]:
    work = (delayed(run_curve)(settings, choice, number) for choice, number in keys)
    if keys:
        parallel = Parallel(n_jobs=jobs, return_as="generator_unordered")
        yield from cast("Iterator[CurveRun]", parallel(work))


def _header(settings: CurveSettings) -> Record:
    return {
        "experiment": "curve",
        "exercise": settings.exercise,
        "level": settings.level.value,
        "demonstrations": settings.demonstrations,
        "seed": settings.seed,
        "version": __version__,
        "command": (
            f"maestra experiment curve --exercise {settings.exercise} --level "
            f"{settings.level.value} --demonstrations {settings.demonstrations} "
            f"--seed {settings.seed}"
        ),
    }


def _record(run: CurveRun) -> Record:
    return {"choice": run.choice.value, "run": run.number, "exact": list(run.exact)}


def _kept_runs(
    settings: CurveSettings, kept: ResultsFile | None, path: Path | None
) -> dict[tuple[Choice, int], CurveRun]:
    """The runs of a file; a record that is none is refused with its line."""
    records = kept.records if kept else []
    done: dict[tuple[Choice, int], CurveRun] = {}
    for line, record in enumerate(records, start=2):
        run = _kept_run(record)
        if run is None or not 0 < len(run.exact) <= settings.demonstrations:
            raise FormatError(str(path), line, (Fault("", "no run", "a finished run"),))
        done[run.choice, run.number] = run
    return done


def _kept_run(record: Record) -> CurveRun | None:
    match record:
        case {"choice": "chosen" | "random" as choice, "run": int(number), "exact": list()}:
            exact = cast("list[object]", record["exact"])
            counts = tuple(one for one in exact if isinstance(one, int))
            return CurveRun(Choice(choice), number, counts) if len(counts) == len(exact) else None
        case _:
            return None


def _plain(fields: dict[str, object], digits: int) -> dict[str, object]:
    """Fields as a file holds them: rounded, and choices by their names."""
    plain: dict[str, object] = {}
    for name, value in fields.items():
        match value:
            case float():
                plain[name] = round(value, digits)
            case Choice():
                plain[name] = value.value
            case _:
                plain[name] = value
    return plain


def rows_csv(rows: Sequence[dict[str, object]]) -> str:
    """Rows of the same fields as CSV, with a first line that names them."""
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, list(rows[0]) if rows else [], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()
