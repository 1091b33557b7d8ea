"""`maestra report`: how a patient gets on."""

import contextlib
import sys
from dataclasses import asdict
from pathlib import Path

from rich.console import Console
from rich.table import Table

from maestra.cli.recording import unknown
from maestra.cli.streams import print_json, print_lines, write_file
from maestra.coaching.ports import PatientId
from maestra.coaching.progress import ExerciseProgress, progress
from maestra.coaching.report import Report, ReportTable, draw
from maestra.language import Language
from maestra.storage.opening import open_to_read, place


def report(
    patient: str,
    html: str | None,
    svg: str | None,
    where: tuple[str | None, str | None],
    lang: str,
    *,
    as_json: bool,
) -> None:
    """Print the tables; write the page and the pictures that are asked for."""
    whose = PatientId(patient)
    with contextlib.closing(open_to_read(place(*where))) as store:
        if whose not in store.patients():
            raise unknown(patient)
        found = progress(store, whose)
    made = Report(whose, found, Language(lang))
    if html is not None:
        write_file(html, made.page())
    if svg is not None:
        _write_pictures(made, Path(svg))
    if as_json:
        print_json({"patient": patient, "exercises": [_json(one) for one in found]})
    elif not found:
        print_lines([made.title, "", made.nothing_yet])
    else:
        _print(made)


def _print(made: Report) -> None:
    console = Console(file=sys.stdout, highlight=False)
    console.print(_table(made.summary(), made.title))
    for exercise in made.exercises:
        console.print(_table(made.sessions(exercise), exercise.exercise))
    console.print(made.how_to_read, markup=False)


def _table(table: ReportTable, title: str) -> Table:
    drawn = Table(title=title, title_justify="left")
    for number, head in enumerate(table.heads):
        drawn.add_column(head, no_wrap=number == 0)
    for row in table.rows:
        drawn.add_row(*row)
    return drawn


def _write_pictures(made: Report, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for number, exercise in enumerate(made.exercises, 1):
        for chart, name in zip(
            made.charts(exercise), ("first-attempts", "reaction", "assistance"), strict=True
        ):
            write_file(str(folder / f"{number}-{name}.svg"), draw(chart, made.session_word))


def _json(exercise: ExerciseProgress) -> dict[str, object]:
    trends = exercise.trends
    return {
        "exercise": exercise.exercise,
        "completion": exercise.completion,
        "first_attempt_share": exercise.first_attempt_share,
        "reaction_ms": exercise.reaction,
        "assistance": exercise.assistance,
        "trends": {
            "first_attempts": trends.first_attempts.value,
            "reaction": trends.reaction.value,
            "assistance": trends.assistance.value,
        },
        "sessions": [asdict(one) for one in exercise.sessions],
    }
