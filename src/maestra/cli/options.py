"""Arguments and options that several commands share; imports nothing but typer."""

from enum import Enum
from typing import Annotated

import typer


class LanguageName(Enum):
    """The languages that Maestra speaks."""

    ENGLISH = "en"
    SPANISH = "es"
    CATALAN = "ca"


ExerciseFile = Annotated[
    str, typer.Argument(metavar="EXERCISE.json", help="An exercise that `learn` wrote.")
]
Lang = Annotated[LanguageName, typer.Option("--lang", help="The language of sentences.")]
Json = Annotated[bool, typer.Option("--json", help="Print JSON and nothing else.")]
Words = Annotated[
    str | None,
    typer.Option("--words", metavar="FILE", help="Your own words for attributes and values."),
]
