"""The commands on the record: `store`, `patients`, `report`; imported when they run."""

from enum import Enum
from typing import TYPE_CHECKING, Annotated

import typer

from maestra.cli.options import Json, Lang, LanguageName

if TYPE_CHECKING:
    from maestra.language import Language


class ExportFormat(Enum):
    """What the record can be written as."""

    CSV = "csv"
    JSONL = "jsonl"
    BIDS = "bids"
    XES = "xes"


Data = Annotated[
    str | None,
    typer.Option(
        "--data",
        metavar="DIR|URL",
        help="Where the record is: a folder, or postgresql://...  [default: $MAESTRA_DATA, or "
        "your data folder]",
    ),
]
Keys = Annotated[
    str | None,
    typer.Option(
        "--keys",
        metavar="DIR",
        help="Where its keys are.  [default: $MAESTRA_KEYS, or your settings' folder]",
    ),
]
OwnLang = Annotated[
    LanguageName | None, typer.Option("--lang", help="The language.  [default: yours]")
]
Patient = Annotated[str, typer.Argument(metavar="PATIENT", help="A pseudonym.")]


def chosen(lang: LanguageName | None) -> "Language":
    """The language that was asked for, else the user's own."""
    from maestra.cli.own_language import own_language
    from maestra.language import Language

    return own_language() if lang is None else Language(lang.value)


store = typer.Typer(help="Check, back up, restore and export the record.")
patients = typer.Typer(help="Who is kept, under which pseudonym; and erasing them.")


@store.command()
def verify(data: Data = None, keys: Keys = None, lang: OwnLang = None, json: Json = False) -> None:
    """Say whether the record is what was written, up to the last signed head."""
    from maestra.cli import recording

    recording.verify(data, keys, chosen(lang), as_json=json)


@store.command()
def backup(
    file: Annotated[str, typer.Argument(metavar="FILE", help="Where to write the backup.")],
    keys_file: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="Also write the keys, to be kept elsewhere."),
    ] = None,
    data: Data = None,
    keys: Keys = None,
    lang: OwnLang = None,
) -> None:
    """Write a backup, which nobody can read without the keys."""
    from maestra.cli import recording

    recording.backup(file, keys_file, data, keys, chosen(lang))


@store.command()
def restore(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A backup.")],
    keys_file: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="The keys, where this machine has none."),
    ] = None,
    data: Data = None,
    keys: Keys = None,
    lang: OwnLang = None,
) -> None:
    """Make a backup a record again, at a place where there is none."""
    from maestra.cli import recording

    recording.restore(file, keys_file, data, keys, chosen(lang))


@store.command()
def export(
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FILE|DIR", help="Where to write it.")
    ],
    form: Annotated[
        ExportFormat, typer.Option("--format", help="BIDS is a folder, the others are files.")
    ] = ExportFormat.CSV,
    patient: Annotated[
        str | None, typer.Option(metavar="PATIENT", help="Of one patient alone.")
    ] = None,
    data: Data = None,
    keys: Keys = None,
) -> None:
    """Write all that happened for another program; with pseudonyms only."""
    from maestra.cli import recording

    recording.export(form.value, output, patient, data, keys)


@patients.command("list")
def list_patients(
    names: Annotated[bool, typer.Option("--names", help="Also who they are.")] = False,
    data: Data = None,
    keys: Keys = None,
    json: Json = False,
) -> None:
    """List the pseudonyms."""
    from maestra.cli import recording

    recording.list_patients(data, keys, names=names, as_json=json)


@patients.command()
def name(patient: Patient, data: Data = None, keys: Keys = None, lang: OwnLang = None) -> None:
    """Keep who a pseudonym is; the name is asked for, so that no list of commands has it."""
    from maestra.cli import recording

    recording.name(patient, data, keys, chosen(lang))


@patients.command()
def everything(
    patient: Patient,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="FILE", help="Where to write it.")
    ],
    data: Data = None,
    keys: Keys = None,
) -> None:
    """Write all that is kept of a patient, name included, as JSON."""
    from maestra.cli import recording

    recording.everything(patient, output, data, keys)


@patients.command()
def erase(
    patient: Patient,
    yes: Annotated[bool, typer.Option("--yes", help="Do not ask.")] = False,
    data: Data = None,
    keys: Keys = None,
    lang: OwnLang = None,
) -> None:
    """Erase a patient for ever: their key is destroyed, so no backup brings them back."""
    from maestra.cli import recording

    recording.erase(patient, data, keys, chosen(lang), asks=not yes)


def report(
    patient: Patient,
    *,
    html: Annotated[
        str | None, typer.Option("--html", metavar="FILE", help="Write a page to print.")
    ] = None,
    svg: Annotated[
        str | None, typer.Option("--svg", metavar="DIR", help="Write each picture as a file.")
    ] = None,
    data: Data = None,
    keys: Keys = None,
    lang: Lang = LanguageName.ENGLISH,
    json: Json = False,
) -> None:
    """Say how a patient gets on, exercise by exercise."""
    from maestra.cli import reporting

    reporting.report(patient, html, svg, (data, keys), lang.value, as_json=json)
