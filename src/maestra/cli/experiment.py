"""`maestra experiment`: the paper's experiments repeated, and the few-shot learner measured."""

from enum import Enum
from typing import Annotated, Final

import typer

app = typer.Typer(
    help="Repeat the paper's experiments.", no_args_is_help=True, rich_markup_mode=None
)

SHOWN_AT: Final = (1, 2, 5, 10, 12, 20, 50, 100, 200, 400)
"""After how many demonstrations the printed curve is read; the files have every number."""


class ExerciseName(Enum):
    """The paper's exercises, (i) to (vi)."""

    ODD_ASCENDING = "odd-ascending"
    ASCENDING = "ascending"
    DESCENDING = "descending"
    FIRST_ROW = "first-row"
    CURIE = "curie"
    LETTERS = "letters"


class LevelName(Enum):
    """What preconditions may speak of."""

    A = "A"
    B = "B"
    C = "C"


Json = Annotated[bool, typer.Option("--json", help="Print JSON and nothing else.")]
CsvFile = Annotated[
    str | None, typer.Option("--csv", metavar="FILE", help="Also write the numbers as CSV.")
]


@app.command()
def table(
    exercise: Annotated[
        ExerciseName | None, typer.Option(help="Only this exercise; without it all six.")
    ] = None,
    repeat: Annotated[int, typer.Option(min=1, help="Take each time so often.")] = 3,
    csv: CsvFile = None,
    *,
    as_json: Json = False,
) -> None:
    """Teach the six exercises with the fewest demonstrations, to each learner."""
    import time

    from maestra.cli.experiment_output import print_table
    from maestra.cli.streams import print_json, progress, write_file
    from maestra.experiments.running import table_csv, table_json
    from maestra.experiments.table import LEARNERS, TableRow, measure
    from maestra.rules.paper import PAPER_EXERCISES

    keys = list(PAPER_EXERCISES) if exercise is None else [exercise.value]
    rows: list[TableRow] = []
    with progress("learning", len(keys) * len(LEARNERS)) as advance:
        for key in keys:
            for learner in LEARNERS:
                rows.append(measure(key, learner, repeat, time.perf_counter))
                advance(1)
    if csv is not None:
        write_file(csv, table_csv(rows))
    if as_json:
        print_json(table_json(rows))
    else:
        print_table(rows)


@app.command()
def curve(
    *,
    exercise: Annotated[ExerciseName, typer.Option(help="What is taught.")],
    runs: Annotated[int, typer.Option(min=1, help="Learners for each curve.")] = 20,
    seed: Annotated[int, typer.Option(help="Decides what is drawn.")] = 1,
    level: Annotated[
        LevelName, typer.Option(help="What preconditions may speak of.")
    ] = LevelName.A,
    demonstrations: Annotated[
        int, typer.Option(min=1, help="Show so many demonstrations at most.")
    ] = 100,
    results: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Keep each finished run here, as JSON Lines; begun again, go on from there.",
        ),
    ] = None,
    csv: CsvFile = None,
    svg: Annotated[
        str | None, typer.Option(metavar="FILE", help="Also draw the curves into a picture.")
    ] = None,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one on each core.")] = -1,
    as_json: Json = False,
) -> None:
    """Measure how many actions are learned exactly after how many demonstrations (Fig. 6a)."""
    from pathlib import Path

    from maestra.cli.experiment_output import print_curve
    from maestra.cli.streams import print_json, progress, write_file
    from maestra.experiments.curve import CurveSettings, curve_points
    from maestra.experiments.running import curve_csv, curve_json, curve_runs, curve_svg
    from maestra.rules.strips.vocabulary import Level

    if jobs == 0:
        raise typer.BadParameter("0 processes do nothing", param_hint="--jobs")
    settings = CurveSettings(exercise.value, Level(level.value), demonstrations, seed)
    kept = None if results is None else Path(results)
    with progress("runs", 2 * runs) as advance:
        finished = curve_runs(settings, runs, jobs, kept, advance)
    points = curve_points(settings, finished)
    if csv is not None:
        write_file(csv, curve_csv(points))
    if svg is not None:
        write_file(svg, curve_svg(settings, points))
    if as_json:
        print_json(curve_json(settings, runs, points))
    else:
        print_curve(settings, points, SHOWN_AT)


@app.command()
def fewshot(
    *,
    exercises: Annotated[int, typer.Option(min=1, help="How many, drawn at random.")] = 20,
    seed: Annotated[int, typer.Option(min=0, help="The first of their seeds.")] = 1000,
    demonstrations: Annotated[
        list[int] | None,
        typer.Option(min=1, help="Show so many; may be given again.  [default: 1, 2, 3]"),
    ] = None,
    questions: Annotated[
        list[int] | None,
        typer.Option(min=0, help="Ask so many at most; may be given again.  [default: 0]"),
    ] = None,
    csv: CsvFile = None,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one on each core.")] = -1,
    as_json: Json = False,
) -> None:
    """Measure how often few demonstrations are enough (the learner in development)."""
    from dataclasses import asdict

    from maestra.cli.experiment_output import print_sweep
    from maestra.cli.streams import print_json, progress, write_file
    from maestra.experiments.fewshot_sweep import outcomes_csv, sweep

    if jobs == 0:
        raise typer.BadParameter("0 processes do nothing", param_hint="--jobs")
    shown, asked = demonstrations or [1, 2, 3], questions or [0]
    seeds = range(seed, seed + exercises)
    with progress("exercises", exercises * len(shown) * len(asked)) as advance:
        rows, outcomes = sweep(seeds, shown, asked, jobs, advance)
    if csv is not None:
        write_file(csv, outcomes_csv(outcomes))
    if as_json:
        print_json({"seed": seed, "exercises": exercises, "rows": [asdict(row) for row in rows]})
    else:
        print_sweep(rows)


@app.command()
def coaching(
    *,
    patients: Annotated[
        int, typer.Option(min=1, help="Of each profile, with each policy; ten sessions each.")
    ] = 100,
    seed: Annotated[int, typer.Option(min=0, help="Decides who they are.")] = 1,
    results: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Keep each finished patient here, as JSON Lines; begun again, go on from there.",
        ),
    ] = None,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one on each core.")] = -1,
    as_json: Json = False,
) -> None:
    """Compare policies of assistance on simulated patients."""
    from pathlib import Path

    from maestra.cli.experiment_output import print_policies
    from maestra.cli.streams import print_json, progress
    from maestra.coaching.settings import Mental
    from maestra.experiments.coaching import (
        POLICIES,
        coaching_json,
        coaching_runs,
        comparisons,
        policy_rows,
    )

    if jobs == 0:
        raise typer.BadParameter("0 processes do nothing", param_hint="--jobs")
    kept = None if results is None else Path(results)
    with progress("patients", patients * len(POLICIES) * len(Mental)) as advance:
        runs = coaching_runs(patients, seed, jobs, kept, advance)
    if as_json:
        print_json(coaching_json(seed, patients, runs))
    else:
        print_policies(policy_rows(runs), comparisons(runs))
