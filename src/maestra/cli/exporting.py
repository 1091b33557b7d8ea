"""`maestra export`: an exercise as PDDL."""

from pathlib import Path

from maestra.cli.faults_at import at_line
from maestra.cli.loading import exercise_in
from maestra.cli.streams import named, print_json, print_lines, read_chunks, waiting, write_file
from maestra.core.demonstration import Demonstration
from maestra.core.formats import read_numbered
from maestra.learning.model_pddl import exercise_pddl
from maestra.rules.exercise import GroundedExercise
from maestra.rules.grounding import grounded_from


def export(exercise_file: str, folder: str, play_file: str | None, *, as_json: bool) -> None:
    """Write `domain.pddl` and `problem.pddl` into `folder`, which is made if need be."""
    exercise = _grounded_in(exercise_file)
    number, play = 1, None
    if play_file is not None:
        chunks = read_chunks(play_file)
        number, play = next(read_numbered(chunks, named(play_file), Demonstration))
    with at_line(named(play_file or exercise_file), number), waiting("Writing PDDL"):
        texts = exercise_pddl(exercise, play)
    written = write_pddl(folder, texts.domain, texts.problem)
    if as_json:
        print_json(written)
    else:
        print_lines(written.values())


def _grounded_in(file: str) -> GroundedExercise:
    """The exercise in a file, as actions.

    Raises:
        FormatError: it is made of rules that no preconditions can say.
    """
    exercise = exercise_in(file)
    if isinstance(exercise, GroundedExercise):
        return exercise
    with at_line(named(file), 1):
        return grounded_from(exercise)


def write_pddl(folder: str, domain: str, problem: str) -> dict[str, str]:
    """Write both texts into `folder`; which is which file."""
    place = Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    written = {"domain": str(place / "domain.pddl"), "problem": str(place / "problem.pddl")}
    write_file(written["domain"], domain)
    write_file(written["problem"], problem)
    return written
