"""The commands that ask: `teach` and `exam`; what they do is imported when they run."""

from enum import Enum
from typing import Annotated

import typer

from maestra.cli.options import ExerciseFile, Lang, LanguageName, Words


class Protocol(Enum):
    """How a program answers in place of a person."""

    JSONL = "jsonl"


class Talk(Enum):
    """What the program that answers understands."""

    QUESTIONS = "questions"
    FULL = "full"


_PROTOCOL = typer.Option(
    help="A program answers: a line of JSON for each question, and one for its answer."
)
_SEED = typer.Option(metavar="NUMBER", help="What is drawn by chance is drawn by it.")


def teach(
    demonstrations: Annotated[
        str | None,
        typer.Argument(metavar="[DEMOS.jsonl]", help="What was shown, one a line."),
    ] = None,
    *,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="EXERCISE.json", help="Where to write it.")
    ],
    goes_on: Annotated[
        str | None,
        typer.Option(
            "--continue", metavar="EXERCISE.json", help="Go on with what was taught before."
        ),
    ] = None,
    questions: Annotated[
        int, typer.Option(metavar="NUMBER", min=0, max=5, help="At most so many.")
    ] = 3,
    kinds: Annotated[
        str, typer.Option(metavar="KIND,KIND", help="What may be asked about.")
    ] = "move,row,rule",
    protocol: Annotated[Protocol | None, _PROTOCOL] = None,
    dialogue: Annotated[
        Talk,
        typer.Option(
            help="What the program understands: questions alone, or also lines about mistakes "
            "and contradictions."
        ),
    ] = Talk.QUESTIONS,
    seed: Annotated[int, _SEED] = 0,
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
) -> None:
    """Learn from demonstrations, then ask what is unclear."""
    if demonstrations is None and goes_on is None:
        raise typer.BadParameter("DEMOS.jsonl or --continue is needed")
    if "-" in {demonstrations, goes_on}:
        raise typer.BadParameter("answers come from standard input, so no file can")
    if output == "-":
        raise typer.BadParameter("questions go to standard output, so the exercise cannot")
    if protocol is None and dialogue is not Talk.QUESTIONS:
        raise typer.BadParameter("--dialogue needs --protocol jsonl")
    chosen = tuple(kinds.split(","))
    unknown = [one for one in chosen if one not in {"move", "row", "rule"}]
    if unknown:
        raise typer.BadParameter(f"--kinds {unknown[0]}: expected some of move, row, rule")
    from maestra.cli import teaching

    request = teaching.Request(
        demonstrations,
        output,
        goes_on,
        questions,
        chosen,
        seed,
        by_lines=protocol is not None,
        follow_ups=protocol is None or dialogue is Talk.FULL,
    )
    teaching.teach(request, lang.value, words)


def exam(
    exercise: ExerciseFile,
    *,
    plays: Annotated[
        int,
        typer.Option(
            metavar="NUMBER", min=1, max=100, help="So many right plays, and as many near misses."
        ),
    ] = 10,
    output: Annotated[
        str | None,
        typer.Option(
            "--output", "-o", metavar="EXERCISE.json", help="Where to write it, if not back."
        ),
    ] = None,
    protocol: Annotated[Protocol | None, _PROTOCOL] = None,
    seed: Annotated[int, _SEED] = 0,
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
) -> None:
    """Judge what Maestra plays by the rules of an exercise."""
    if exercise == "-":
        raise typer.BadParameter("answers come from standard input, so the exercise cannot")
    if output == "-":
        raise typer.BadParameter("questions go to standard output, so the exercise cannot")
    from maestra.cli import examining

    request = examining.Request(exercise, output or exercise, plays, seed, protocol is not None)
    examining.exam(request, lang.value, words)
