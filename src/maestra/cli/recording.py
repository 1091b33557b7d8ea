"""`maestra store` and `maestra patients`: the record looked after."""

import contextlib
import io
import json
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from typing import IO, Final, assert_never

import typer

from maestra.cli.streams import print_json, print_lines, write_file
from maestra.coaching.ports import PatientId
from maestra.core.faults import Fault, InvalidError
from maestra.language import Language
from maestra.language.record_keys import RecordKey as Key
from maestra.language.records import record_sentence
from maestra.storage import backup as backups
from maestra.storage.chain import Sound, Tampered
from maestra.storage.exports.bids import write_bids
from maestra.storage.exports.rows import Row, rows
from maestra.storage.exports.tables import write_csv, write_json_lines
from maestra.storage.exports.xes import write_xes
from maestra.storage.opening import open_store, open_to_read, place
from maestra.storage.store import SqlStore

_FILES: Final = {"csv": write_csv, "jsonl": write_json_lines, "xes": write_xes}


def verify(data: str | None, keys: str | None, language: Language, *, as_json: bool) -> None:
    """Say whether the record is sound; exit code 1 if not."""
    with _reading(data, keys) as store:
        found = store.verify()
    match found:
        case Sound(events, signed, recovered, heads):
            fields: dict[str, object] = {
                "sound": True,
                "events": events,
                "signed": signed,
                "recovered": recovered,
                "heads": heads,
            }
            line = record_sentence(Key.SOUND, language, signed=signed, events=events)
            if recovered:
                line += record_sentence(Key.RECOVERED, language, recovered=recovered)
        case Tampered(finding, sequence):
            fields = {"sound": False, "finding": finding.value, "at": sequence}
            what = record_sentence(Key[finding.name], language)
            line = record_sentence(Key.NOT_SOUND, language, finding=what, sequence=sequence)
        case _:
            assert_never(found)
    if as_json:
        print_json(fields)
    else:
        print_lines([line])
    if isinstance(found, Tampered):
        raise typer.Exit(1)


def backup(
    file: str, keys_file: str | None, data: str | None, keys: str | None, language: Language
) -> None:
    """Write a backup, and the keys if a file for them is named."""
    with _reading(data, keys) as store:
        count = backups.back_up(store, Path(file))
        if keys_file is not None:
            backups.back_up_keys(store, Path(keys_file))
    print_lines([record_sentence(Key.BACKED_UP, language, file=file, count=count)])


def restore(
    file: str, keys_file: str | None, data: str | None, keys: str | None, language: Language
) -> None:
    """Restore a backup."""
    where = place(data, keys)
    restored = backups.restore(Path(file), where, None if keys_file is None else Path(keys_file))
    line = record_sentence(Key.RESTORED, language, events=restored.events)
    if restored.left_out:
        line += record_sentence(Key.LEFT_OUT, language, count=restored.left_out)
    print_lines([line])


def export(
    form: str, output: str, patient: str | None, data: str | None, keys: str | None
) -> None:
    """Write the record for another program."""
    with _reading(data, keys) as store:
        whose = None if patient is None else _known(store, patient)
        found = rows(store, whose)
        if form == "bids":
            write_bids(found, Path(output))
            return
        file = io.StringIO(newline="")
        write: Callable[[Iterator[Row], IO[str]], int] = _FILES[form]
        write(found, file)
    write_file(output, file.getvalue())


def list_patients(data: str | None, keys: str | None, *, names: bool, as_json: bool) -> None:
    """List pseudonyms, and who they are."""
    with _reading(data, keys) as store:
        found = {one: _name(store, one) if names else None for one in store.patients()}
    if as_json:
        print_json([{"patient": one, **({"name": found[one]} if names else {})} for one in found])
    else:
        print_lines(one if name is None else f"{one}\t{name}" for one, name in found.items())


def name(patient: str, data: str | None, keys: str | None, language: Language) -> None:
    """Ask who a pseudonym is, and keep it."""
    given: str = typer.prompt(record_sentence(Key.ASK_NAME, language), err=True)
    with contextlib.closing(open_store(place(data, keys))) as store:
        store.save_name(PatientId(patient), given)


def everything(patient: str, output: str, data: str | None, keys: str | None) -> None:
    """Write all that is kept of a patient."""
    with _reading(data, keys) as store:
        text = json.dumps(store.everything(_known(store, patient)), ensure_ascii=False, indent=1)
    write_file(output, f"{text}\n")


def erase(
    patient: str, data: str | None, keys: str | None, language: Language, *, asks: bool
) -> None:
    """Erase a patient, once it is confirmed."""
    if asks:
        question = record_sentence(Key.ASK_ERASE, language, patient=patient)
        answer: str = typer.prompt(question, default="", show_default=False, err=True)
        if answer.strip().casefold() not in record_sentence(Key.YES, language).split():
            raise typer.Abort
    with contextlib.closing(open_store(place(data, keys))) as store:
        try:
            store.erase(PatientId(patient))
        except KeyError:
            raise unknown(patient) from None
    print_lines([record_sentence(Key.ERASED, language)])


def unknown(patient: str) -> InvalidError:
    """Said of a pseudonym that nobody has."""
    return InvalidError([Fault("patient", patient, "a pseudonym that `patients list` shows")])


def _known(store: SqlStore, patient: str) -> PatientId:
    whose = PatientId(patient)
    if whose not in store.patients():
        raise unknown(patient)
    return whose


def _name(store: SqlStore, patient: PatientId) -> str | None:
    try:
        return store.name(patient)
    except KeyError:
        return None


@contextlib.contextmanager
def _reading(data: str | None, keys: str | None) -> Generator[SqlStore]:
    with contextlib.closing(open_to_read(place(data, keys))) as store:
        yield store
