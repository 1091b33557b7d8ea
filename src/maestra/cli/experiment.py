"""`maestra experiment`: the paper's experiments repeated, and what is ours measured."""

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


class PartName(Enum):
    """The parts of the few-shot experiment."""

    LANGUAGE = "language"
    ROWS_AND_MOVES = "rows-and-moves"
    WRONG_ANSWERS = "wrong-answers"
    OUTSIDE = "outside"
    SLIP = "slip"
    NO_SLIP = "no-slip"
    PAPER = "paper"
    PAPER_ONE_START = "paper-one-start"


class GrowthName(Enum):
    """What a lesson may have more of."""

    TOKENS = "tokens"
    CELLS = "cells"
    DEMONSTRATIONS = "demonstrations"


class LevelName(Enum):
    """What preconditions may speak of."""

    A = "A"
    B = "B"
    C = "C"


Json = Annotated[bool, typer.Option("--json", help="Print JSON and nothing else.")]
CsvFile = Annotated[
    str | None, typer.Option("--csv", metavar="FILE", help="Also write the numbers as CSV.")
]
PageFile = Annotated[
    str | None,
    typer.Option("--page", metavar="FILE", help="Also write the tables into this page of docs."),
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
    part: Annotated[
        list[PartName] | None,
        typer.Option(help="Only this part; may be given again.  [default: all]"),
    ] = None,
    exercises: Annotated[int, typer.Option(min=1, help="How many, drawn at random.")] = 20,
    draws: Annotated[
        int, typer.Option(min=1, help="How often each of the paper's exercises is shown anew.")
    ] = 10,
    seed: Annotated[int, typer.Option(min=0, help="The first of the exercises' seeds.")] = 1000,
    demonstrations: Annotated[
        list[int] | None,
        typer.Option(min=1, help="Show just so many; may be given again.  [default: 1, 2, 3]"),
    ] = None,
    results: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Keep each finished run here, as JSON Lines; begun again, go on from there.",
        ),
    ] = None,
    csv: CsvFile = None,
    page: PageFile = None,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one on each core.")] = -1,
    as_json: Json = False,
) -> None:
    """Measure how often one to three demonstrations and a few questions are enough."""
    from pathlib import Path

    from maestra.cli.experiment_output import print_tables, write_page
    from maestra.cli.streams import print_json, progress, write_file
    from maestra.experiments.fewshot_findings import findings, findings_csv
    from maestra.experiments.fewshot_runs import Part, fewshot_runs, header, wanted_runs
    from maestra.experiments.fewshot_tables import tables
    from maestra.experiments.pages import table_json

    if jobs == 0:
        raise typer.BadParameter("0 processes do nothing", param_hint="--jobs")
    parts = list(Part) if part is None else [Part(one.value) for one in part]
    wanted = wanted_runs(parts, exercises, draws, seed, demonstrations or ())
    kept = None if results is None else Path(results)
    with progress("runs", len(wanted)) as advance:
        found = list(findings(fewshot_runs(wanted, jobs, kept, advance)))
    made = tables(found)
    if csv is not None:
        write_file(csv, findings_csv(found))
    if page is not None:
        write_page(page, made)
    if as_json:
        fields = {"seed": seed, "exercises": exercises, "draws": draws}
        print_json({**header(), **fields, "tables": [table_json(one) for one in made]})
    else:
        print_tables(made)


@app.command()
def compare(
    *,
    exercise: Annotated[
        ExerciseName | None, typer.Option(help="Only this exercise; without it all six.")
    ] = None,
    draws: Annotated[int, typer.Option(min=1, help="Draw random demonstrations so often.")] = 20,
    repeat: Annotated[int, typer.Option(min=1, help="Take each other time so often.")] = 3,
    page: PageFile = None,
    as_json: Json = False,
) -> None:
    """Compare the few-shot learner with the paper's on the six exercises."""
    import time

    from maestra.cli.experiment_output import print_tables, write_page
    from maestra.cli.streams import print_json, progress
    from maestra.experiments.compared import QUESTIONS, Needed, compared_table, needed
    from maestra.experiments.pages import table_json
    from maestra.experiments.table import LEARNERS, TableRow, measure
    from maestra.rules.paper import PAPER_EXERCISES

    keys = list(PAPER_EXERCISES) if exercise is None else [exercise.value]
    papers: list[TableRow] = []
    ours: list[Needed] = []
    with progress("learning", len(keys) * (len(LEARNERS) + len(QUESTIONS))) as advance:
        for key in keys:
            for learner in LEARNERS:
                papers.append(measure(key, learner, repeat, time.perf_counter))
                advance(1)
            for questions in QUESTIONS:
                ours.append(needed(key, questions, draws, time.process_time))
                advance(1)
    made = compared_table(papers, ours)
    if page is not None:
        write_page(page, [made])
    if as_json:
        print_json({"experiment": "compare", "draws": draws, **table_json(made)})
    else:
        print_tables([made])


@app.command()
def growth(
    *,
    repeat: Annotated[int, typer.Option(min=1, help="Learn so many lessons of each size.")] = 5,
    by: Annotated[
        list[GrowthName] | None,
        typer.Option(help="Only this curve; may be given again.  [default: all]"),
    ] = None,
    folder: Annotated[
        str | None,
        typer.Option(
            metavar="FOLDER", help="Write the curves here, as growth.csv and a picture of each."
        ),
    ] = None,
    page: PageFile = None,
    as_json: Json = False,
) -> None:
    """Measure how long the few-shot learner takes, and how that grows."""
    import resource
    import time
    from pathlib import Path

    from maestra.cli.experiment_output import print_tables, write_page
    from maestra.cli.streams import print_json, progress, write_file
    from maestra.experiments import growth as measuring
    from maestra.experiments.pages import table_json
    from maestra.experiments.running import rows_csv

    def memory_mb() -> float:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

    def speed(size: measuring.Size) -> measuring.Speed:
        found = measuring.speed_of(size, repeat, time.process_time, memory_mb)
        advance(1)
        return found

    curves = [one.value for one in by or GrowthName]
    sizes = sum(len(measuring.GROWTHS[what]) for what in curves)
    goals, estimated = measuring.GOALS, measuring.ESTIMATED
    with progress("sizes", len(goals) + sizes + len(estimated)) as advance:
        speeds = [(goal, speed(goal.size)) for goal in goals]
        grown = {what: [speed(size) for size in measuring.GROWTHS[what]] for what in curves}
        errors: list[measuring.Estimate] = []
        for size in estimated:
            errors += measuring.estimates(size, repeat)
            advance(1)
    made = (measuring.speed_table(speeds), measuring.estimates_table(errors))
    rows = [row for what in curves for row in measuring.growth_rows(what, grown[what])]
    if folder is not None:
        write_file(str(Path(folder) / "growth.csv"), rows_csv(rows))
        for what in curves:
            picture = measuring.growth_svg(what, grown[what])
            write_file(str(Path(folder) / f"growth-{what}.svg"), picture)
    if page is not None:
        write_page(page, made)
    if as_json:
        tables = [table_json(one) for one in made]
        print_json({"experiment": "growth", "repeat": repeat, "tables": tables, "rows": rows})
    else:
        print_tables(made)


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


@app.command()
def assistance_bound(
    *,
    patients: Annotated[int, typer.Option(min=1, help="Of each profile.")] = 10,
    seed: Annotated[int, typer.Option(min=0, help="Decides who they are.")] = 1,
    as_json: Json = False,
) -> None:
    """Work out how little assistance could be enough for simulated patients."""
    from dataclasses import asdict

    from maestra.cli.experiment_output import print_bound
    from maestra.cli.streams import print_json
    from maestra.experiments import assistance_bound as bound

    rows = bound.bound_rows(patients, seed)
    if as_json:
        experiment = {"experiment": "assistance-bound", "seed": seed}
        print_json({**experiment, "rows": [asdict(row) for row in rows]})
    else:
        print_bound(rows)
