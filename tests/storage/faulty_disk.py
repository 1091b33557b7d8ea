"""A disk below SQLite that fails when it is told to, and that remembers what it was asked.

apsw lets file systems be written in Python, for the SQLite that it brings along. `driver` makes
a DBAPI of it, so that the whole store runs on such a disk.
"""

import itertools
import random
import sqlite3
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any, Final

import apsw

SECTOR: Final = 512
"""Bytes that a disk writes all or none of."""
_number = itertools.count()


@dataclass(frozen=True, slots=True)
class Write:
    """Bytes asked to be written; in the disk's memory only, until a sync."""

    file: str
    offset: int
    content: bytes


@dataclass(frozen=True, slots=True)
class Truncate:
    """A file asked to be cut off."""

    file: str
    size: int


@dataclass(frozen=True, slots=True)
class Sync:
    """Everything before, in this file, is on the disk."""

    file: str


@dataclass(frozen=True, slots=True)
class Delete:
    """A file was removed."""

    file: str


Operation = Write | Truncate | Sync | Delete


class Disk(apsw.VFS):
    """The disk: `operations` is what it was asked; `failing` says which of them fail."""

    def __init__(self) -> None:
        """Register it with apsw."""
        self.vfs = f"faulty-{next(_number)}"
        self.operations: list[Operation] = []
        self.failing: Callable[[int], type[apsw.Error] | None] = lambda _: None
        self.noticed: Callable[[], None] = lambda: None
        super().__init__(self.vfs, "")

    def xOpen(self, name: str | apsw.URIFilename | None, flags: list[int]) -> apsw.VFSFile:  # noqa: N802 - apsw's name
        return _File(self, name, flags)

    def xDelete(self, filename: str, syncdir: bool) -> None:  # noqa: FBT001, N802 - apsw's
        self.ask(Delete(Path(filename).name))
        super().xDelete(filename, syncdir)

    def ask(self, operation: Operation) -> None:
        """Note an operation, or fail."""
        error = self.failing(len(self.operations))
        self.operations.append(operation)
        self.noticed()
        if error is not None:
            raise error("the disk was told to fail")


class _File(apsw.VFSFile):
    def __init__(self, disk: Disk, name: str | apsw.URIFilename | None, flags: list[int]) -> None:
        super().__init__("", name, flags)
        path = name.filename() if isinstance(name, apsw.URIFilename) else name
        self._name = Path(path or "unnamed").name
        self._disk = disk

    def xWrite(self, data: bytes, offset: int) -> None:  # noqa: N802 - apsw's name
        self._disk.ask(Write(self._name, offset, bytes(data)))
        super().xWrite(data, offset)  # pyright: ignore[reportUnknownMemberType] - apsw's stub

    def xTruncate(self, newsize: int) -> None:  # noqa: N802 - apsw's name
        self._disk.ask(Truncate(self._name, newsize))
        super().xTruncate(newsize)

    def xSync(self, flags: int) -> None:  # noqa: N802 - apsw's name
        _ = flags  # what is remembered counts; the real disk need not be waited for
        self._disk.ask(Sync(self._name))


def after_power_cut(operations: Sequence[Operation], chance: random.Random) -> dict[str, bytes]:
    """What may be left on a disk when the power goes after these operations.

    Up to its last sync a file is as it was asked to be. Of what came later each sector may be
    there or not, in any order.
    """
    files: dict[str, bytearray] = {}
    last = {one.file: k for k, one in enumerate(operations) if isinstance(one, Sync)}
    for k, one in enumerate(operations):
        is_safe = k < last.get(one.file, -1)
        match one:
            case Write(name, offset, content):
                file = files.setdefault(name, bytearray())
                for start, piece in _sectors(offset, content):
                    if is_safe or chance.random() < 0.5:
                        _put(file, start, piece)
            case Truncate(name, size) if is_safe or chance.random() < 0.5:
                file = files.setdefault(name, bytearray())
                del file[size:]
            case Delete(name) if chance.random() < 0.5:
                files.pop(name, None)
            case _:
                pass
    return {name: bytes(file) for name, file in files.items()}


def _sectors(offset: int, content: bytes) -> Iterator[tuple[int, bytes]]:
    """The parts of a write that a disk does one by one."""
    start = offset
    while start < offset + len(content):
        end = min((start // SECTOR + 1) * SECTOR, offset + len(content))
        yield start, content[start - offset : end - offset]
        start = end


def _put(file: bytearray, offset: int, piece: bytes) -> None:
    if len(file) < offset:
        file.extend(bytes(offset - len(file)))
    file[offset : offset + len(piece)] = piece


# ---------------------------------------------------------------- the DBAPI


def driver(disk: Disk) -> ModuleType:
    """A module like `sqlite3`, on this disk."""
    made = ModuleType("sqlite3_on_a_faulty_disk")
    for name in ("Error", "DatabaseError", "OperationalError", "IntegrityError", "Binary"):
        setattr(made, name, getattr(sqlite3, name))
    for name in ("InterfaceError", "ProgrammingError", "NotSupportedError", "InternalError"):
        setattr(made, name, getattr(sqlite3, name))
    version = tuple(int(part) for part in apsw.sqlite_lib_version().split("."))
    made.__dict__.update(paramstyle="qmark", sqlite_version_info=version)

    def connect(file: str, **_: object) -> "_Connection":
        return _Connection(file, disk.vfs)

    made.__dict__["connect"] = connect
    return made


def _translated(error: apsw.Error) -> sqlite3.Error:
    if isinstance(error, apsw.CorruptError | apsw.NotADBError):
        return sqlite3.DatabaseError(str(error))
    said = "database or disk is full" if isinstance(error, apsw.FullError) else str(error)
    return sqlite3.OperationalError(said)


@dataclass
class _Cursor:
    connection: "_Connection"
    description: tuple[tuple[object, ...], ...] | None = None
    rowcount: int = -1
    lastrowid: int = 0
    arraysize: int = 1
    _rows: list[tuple[Any, ...]] = field(default_factory=list[tuple[Any, ...]])

    def execute(self, statement: str, parameters: Sequence[Any] = ()) -> "_Cursor":
        raw = self.connection.raw.cursor()
        # apsw tells the columns only while there is a row; SQLAlchemy wants them always.
        columns: list[tuple[tuple[object, ...], ...]] = []

        def note(cursor: apsw.Cursor, *_: object) -> bool:
            names = (str(column[0]) for column in cursor.get_description())
            columns.append(tuple((name, *[None] * 6) for name in names))
            return True

        raw.exec_trace = note
        run: Callable[..., Iterable[tuple[Any, ...]]] = getattr(raw, "execute")  # noqa: B009 - apsw's stub leaves its arguments open
        try:
            self._rows = list(run(statement, tuple(parameters)))
        except apsw.Error as error:
            raise _translated(error) from error
        self.description = columns[0] if columns and columns[0] else None
        self.rowcount = self.connection.raw.changes()
        return self

    def executemany(self, statement: str, many: Iterable[Sequence[Any]]) -> "_Cursor":
        for parameters in many:
            self.execute(statement, parameters)
        return self

    def fetchone(self) -> tuple[Any, ...] | None:
        return self._rows.pop(0) if self._rows else None

    def fetchmany(self, size: int = 1) -> list[tuple[Any, ...]]:
        found, self._rows = self._rows[:size], self._rows[size:]
        return found

    def fetchall(self) -> list[tuple[Any, ...]]:
        found, self._rows = self._rows, []
        return found

    def close(self) -> None:
        self._rows = []


class _Connection:
    isolation_level = None

    def __init__(self, file: str, vfs: str) -> None:
        is_read_only = file.endswith("?mode=ro")
        flags = apsw.SQLITE_OPEN_URI | (
            apsw.SQLITE_OPEN_READONLY
            if is_read_only
            else apsw.SQLITE_OPEN_READWRITE | apsw.SQLITE_OPEN_CREATE
        )
        try:
            self.raw = apsw.Connection(file, flags=flags, vfs=vfs)
        except apsw.Error as error:
            raise _translated(error) from error

    def cursor(self, *_: object) -> _Cursor:
        return _Cursor(self)

    def execute(self, statement: str) -> _Cursor:
        return _Cursor(self).execute(statement)

    def create_function(self, *_: object, **__: object) -> None:
        """SQLAlchemy offers functions that the store does not use."""

    def commit(self) -> None:
        if self.raw.in_transaction:
            self.execute("COMMIT")

    def rollback(self) -> None:
        if self.raw.in_transaction:
            self.execute("ROLLBACK")

    def close(self) -> None:
        try:
            self.raw.close()
        except apsw.Error as error:
            raise _translated(error) from error
