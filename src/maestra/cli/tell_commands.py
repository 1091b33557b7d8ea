"""The commands for rules in words: `tell` and `edit`; what they do is imported when they run."""

from typing import Annotated

import typer

from maestra.cli.options import ExerciseFile, Json, Lang, LanguageName, Words


def tell(
    sentence: Annotated[str, typer.Argument(help="One rule or several, in your own words.")],
    *,
    deck: Annotated[
        str,
        typer.Option(
            metavar="PLAYS.jsonl", help="The tokens and the board: those of its first play."
        ),
    ],
    output: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="EXERCISE.json", help="Where to write it."),
    ] = None,
    board: Annotated[
        str | None, typer.Option(metavar="ROWSxCOLUMNS", help="Another board, such as 4x5.")
    ] = None,
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
    json: Json = False,
) -> None:
    """Make an exercise of rules said in words."""
    if json and output == "-":
        raise typer.BadParameter("--json and --output - both want standard output")
    from maestra.cli import telling

    telling.tell(sentence, deck, output, board, (lang.value, words), as_json=json)


def edit(
    exercise: ExerciseFile,
    *,
    rule: Annotated[
        tuple[str, str] | None,
        typer.Option(metavar="ID SENTENCE", help="What it shall say; see `explain --json`."),
    ] = None,
    add: Annotated[str | None, typer.Option(metavar="SENTENCE", help="One more rule.")] = None,
    remove: Annotated[str | None, typer.Option(metavar="ID", help="The rule goes.")] = None,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="EXERCISE.json", help="Where to write it.")
    ],
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
    json: Json = False,
) -> None:
    """Change the rules of an exercise in words."""
    if rule is None and add is None and remove is None:
        raise typer.BadParameter("one of --rule, --add and --remove is needed")
    if json and output == "-":
        raise typer.BadParameter("--json and --output - both want standard output")
    from maestra.cli import telling

    change = telling.Change(rule, add, remove)
    telling.edit(exercise, change, output, (lang.value, words), as_json=json)
