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
from maestra.storage import backup as backups
from maestra.storage.chain import Sound, Tampered
from maestra.storage.exports.bids import write_bids
from maestra.storage.exports.rows import Row, rows
from maestra.storage.exports.tables import write_csv, write_json_lines
from maestra.storage.exports.xes import write_xes
from maestra.storage.opening import open_store, open_to_read, place
from maestra.storage.store import SqlStore

_FILES: Final = {"csv": write_csv, "jsonl": write_json_lines, "xes": write_xes}


def verify(data: str | None, keys: str | None, *, as_json: bool) -> None:
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
            line = f"sound: {signed} of {events} events are signed"
            if recovered:
                line += f", {recovered} of them only after a crash"
        case Tampered(finding, sequence):
            fields = {"sound": False, "finding": finding.value, "at": sequence}
            line = f"not sound: {finding.value} (at {sequence})"
        case _:
            assert_never(found)
    if as_json:
        print_json(fields)
    else:
        print_lines([line])
    if isinstance(found, Tampered):
        raise typer.Exit(1)


def backup(file: str, keys_file: str | None, data: str | None, keys: str | None) -> None:
    """Write a backup, and the keys if a file for them is named."""
    with _reading(data, keys) as store:
        count = backups.back_up(store, Path(file))
        if keys_file is not None:
            backups.back_up_keys(store, Path(keys_file))
    print_lines([f"{file}: rows: {count}"])


def restore(file: str, keys_file: str | None, data: str | None, keys: str | None) -> None:
    """Restore a backup."""
    where = place(data, keys)
    restored = backups.restore(Path(file), where, None if keys_file is None else Path(keys_file))
    line = f"events: {restored.events}"
    if restored.left_out:
        line += f"; {restored.left_out} rows of erased patients left out"
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


def name(patient: str, given: str, data: str | None, keys: str | None) -> None:
    """Keep who a pseudonym is."""
    with contextlib.closing(open_store(place(data, keys))) as store:
        store.save_name(PatientId(patient), given)


def everything(patient: str, output: str, data: str | None, keys: str | None) -> None:
    """Write all that is kept of a patient."""
    with _reading(data, keys) as store:
        text = json.dumps(store.everything(_known(store, patient)), ensure_ascii=False, indent=1)
    write_file(output, f"{text}\n")


def erase(patient: str, data: str | None, keys: str | None) -> None:
    """Erase a patient."""
    with contextlib.closing(open_store(place(data, keys))) as store:
        try:
            store.erase(PatientId(patient))
        except KeyError:
            raise unknown(patient) from None
    print_lines(
        ["erased; delete yourself what you exported before, and files of keys written before"]
    )


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
