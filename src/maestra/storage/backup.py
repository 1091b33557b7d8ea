"""Backups: all rows as they lie in the database, sealed as they are, for either engine.

A backup is a gzip file of JSON Lines: a header, one line for each row, and a last line with the
SHA-256 of all lines before it. It holds no keys: whoever finds it can read nobody's data, and
who is erased stays erased in every backup. The keys have a file of their own, to be kept
elsewhere.
"""

import gzip
import json
import os
from base64 import b64decode, b64encode
from collections.abc import Generator, Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from hashlib import sha256
from itertools import groupby
from pathlib import Path
from typing import IO, Any, Final, cast

from sqlalchemy import Connection, insert, select

from maestra.core.faults import Fault, InvalidError
from maestra.storage import schema
from maestra.storage.chain import Tampered, verify
from maestra.storage.formats import BACKUP_FORMAT, BackupJson
from maestra.storage.opening import Place, make_folders
from maestra.storage.record import Signer, links
from maestra.storage.store import SqlStore
from maestra.storage.tables import METADATA, OF_A_PATIENT, PASSING, STORE
from maestra.storage.vault import StoreId, SubjectId, Vault, flush_folder

_TOGETHER: Final = 500
"""Rows that are put back with one statement."""


@dataclass(frozen=True, slots=True)
class Restored:
    """What a restored backup held."""

    events: int
    left_out: int
    """Rows of patients whose key is no more."""


def back_up(store: SqlStore, path: Path) -> int:
    """Write a backup of one moment of `store`, while it may be written to; returns its rows.

    Raises:
        OSError: it cannot be written; then no file is there.
    """
    rows = 0
    digest = sha256()
    with _whole_or_not(path) as raw, gzip.GzipFile(fileobj=raw, mode="wb", mtime=0) as file:

        def put(value: object) -> None:
            line = json.dumps(value).encode() + b"\n"
            digest.update(line)
            file.write(line)

        put({"format": BACKUP_FORMAT, "store": store.vault.store, "tables": schema.VERSION})
        with store.database.reading() as connection:
            for table in (one for one in METADATA.sorted_tables if one not in PASSING):
                for row in connection.execute(select(table)):
                    put([table.name, [_encoded(value) for value in row]])
                    rows += 1
        file.write(json.dumps({"sha256": digest.hexdigest()}).encode() + b"\n")
    return rows


def back_up_keys(store: SqlStore, path: Path) -> None:
    """Write all keys and heads of `store` in a file that only its owner may read."""
    with _whole_or_not(path) as file:
        file.write(store.vault.packed().encode())


def restore(path: Path, where: Place, keys: Path | None = None) -> Restored:
    """Make a backup a record again, at a place where there is none.

    The keys that are there count; only where there are none, those of the file `keys`.

    Raises:
        InvalidError: the file is no whole backup, or not what was written, or there is a record
            already, or the keys are missing.
        OSError: something cannot be read or written.
    """
    name = str(path)
    header = _header(path, name)
    make_folders(where)
    store = StoreId(header.store)
    if keys is not None and not (where.keys / store).exists():
        Vault.unpack(where.keys, keys.read_text(encoding="utf-8"), str(keys))
    vault = Vault(where.keys, store)
    database = where.database
    try:
        with database.writing() as connection:
            with connection.begin():
                schema.upgrade(connection, database.name)
                if connection.scalar(select(STORE.c.id)) is not None:
                    raise InvalidError([Fault(database.name, "a record", "a place without one")])
                left_out = _fill(connection, _rows(path, name), vault)
                signer = Signer(vault)
                head = signer.restored(connection)
                with closing(links(connection)) as found:
                    outcome = verify(
                        found, [*vault.heads(), head.line()], vault.store, vault.check
                    )
                if isinstance(outcome, Tampered):
                    raise _refused(name, outcome.finding.value, "what was backed up")
            vault.add(head)
    finally:
        database.close()
    return Restored(outcome.events, left_out)


def _fill(connection: Connection, rows: Iterable[tuple[str, list[object]]], vault: Vault) -> int:
    left_out = 0
    private = {table.name for table in OF_A_PATIENT}
    for name, group in groupby(rows, key=lambda row: row[0]):
        table = METADATA.tables[name]
        columns = [column.name for column in table.columns]
        waiting: list[dict[str, object]] = []
        for _, values in group:
            row = dict(zip(columns, values, strict=True))
            subject = row.get("subject")
            if name in private and subject is not None and not vault.has(SubjectId(str(subject))):
                left_out += 1
                continue
            waiting.append(row)
            if len(waiting) == _TOGETHER:
                connection.execute(insert(table), waiting)
                waiting = []
        if waiting:
            connection.execute(insert(table), waiting)
    return left_out


def _lines(path: Path, name: str) -> Iterator[bytes]:
    try:
        with gzip.open(path, "rb") as file:
            yield from file
    except (EOFError, gzip.BadGzipFile) as error:
        raise _refused(name, str(error) or "a file that is cut off", "a whole backup") from error


def _header(path: Path, name: str) -> BackupJson:
    """The first line, after the whole file was found to be what was written."""
    digest, last, first = sha256(), b"", b""
    for line in _lines(path, name):
        digest.update(last)
        first = first or line
        last = line
    no_backup = _refused(name, "something else, or a part", f"a whole {BACKUP_FORMAT}")
    try:
        header = BackupJson.model_validate_json(first)
        is_whole = json.loads(last) == {"sha256": digest.hexdigest()}
    except ValueError:
        raise no_backup from None
    if not is_whole:
        raise no_backup
    if header.tables != schema.VERSION:
        found = f"tables of version {header.tables}"
        raise _refused(name, found, f"version {schema.VERSION}, of this Maestra")
    return header


def _rows(path: Path, name: str) -> Iterator[tuple[str, list[object]]]:
    for line in _lines(path, name):
        row = cast("list[Any] | dict[str, str]", json.loads(line))
        if isinstance(row, list):  # else the header, or the digest at the end
            table: str = row[0]
            values: list[object] = row[1]
            yield table, [_decoded(value) for value in values]


def _encoded(value: object) -> object:
    return {"base64": b64encode(value).decode()} if isinstance(value, bytes) else value


def _decoded(value: Any) -> object:  # noqa: ANN401 - a column's, whatever it is
    return value if isinstance(value, str | int | None) else b64decode(value["base64"])


def _refused(name: str, found: str, expected: str) -> InvalidError:
    return InvalidError([Fault(name, found, expected)])


@contextmanager
def _whole_or_not(path: Path) -> Generator[IO[bytes]]:
    """A file that has its name only once it is whole and on the disk."""
    scratch = path.with_name(f"{path.name}.part")
    number = os.open(scratch, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    try:
        with os.fdopen(number, "wb") as file:
            yield file
            file.flush()
            os.fsync(number)
        scratch.replace(path)
        flush_folder(path.parent)
    except BaseException:
        scratch.unlink(missing_ok=True)
        raise
