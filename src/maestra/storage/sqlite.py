"""SQLite in a folder: one connection that writes and checkpoints, others that only read.

SQLite 3.7.0 to 3.51.2 can lose committed transactions in WAL mode when a checkpoint of one
connection meets a commit of another (the WAL-reset bug, https://sqlite.org/wal.html). Here one
connection of one process writes and checkpoints, held by a lock on a file of its own; all others
are opened read-only, and a read-only connection can do neither. So any SQLite will do.
"""

import contextlib
import fcntl
import os
import sqlite3
import time
from collections.abc import Callable, Generator
from pathlib import Path
from types import ModuleType
from typing import Final, cast

from sqlalchemy import Connection, Engine, create_engine, event
from sqlalchemy.engine.interfaces import DBAPIConnection
from sqlalchemy.exc import DBAPIError
from sqlalchemy.pool import NullPool

from maestra.storage.database import as_os_error, in_use
from maestra.storage.vault import flush_folder

FILE_NAME: Final = "maestra.db"
BUSY_S: Final = 5.0
"""How long to wait for others to finish reading before a log can be cut off."""
PRAGMAS: Final = (
    "journal_mode = WAL",
    "synchronous = FULL",  # NORMAL loses acknowledged events in a power cut
    "secure_delete = ON",
    "temp_store = MEMORY",
    "trusted_schema = OFF",
    f"busy_timeout = {int(1000 * BUSY_S)}",
)


class SqliteDatabase:
    """The record in a file of a folder."""

    def __init__(self, folder: Path, driver: ModuleType = sqlite3) -> None:
        """Use the file in `folder`; `driver` is a DBAPI of SQLite."""
        self._path: Path = folder / FILE_NAME
        self._driver: ModuleType = driver
        self._lock: int | None = None
        self._writer = _engine(driver, self._connect)
        self._reader = _engine(driver, self._connect_to_read)

    @property
    def name(self) -> str:
        """The file's path."""
        return str(self._path)

    def exists(self) -> bool:
        """Whether there is anything to read."""
        return self._path.exists()

    def writing(self) -> Connection:
        """The one connection that writes."""
        self._take_lock()
        is_new = not self.exists()
        try:
            connection = self._writer.connect()
            if is_new:
                flush_folder(self._path.parent)
        except DBAPIError as error:
            self._drop_lock()
            raise as_os_error(error, self.name) from error
        return connection

    @contextlib.contextmanager
    def reading(self) -> Generator[Connection]:
        """A connection that sees one moment of the database."""
        try:
            with self._reader.connect() as connection:
                yield connection
        except DBAPIError as error:
            raise as_os_error(error, self.name) from error

    def scrub(self, writing: Connection) -> None:
        """Write the file anew without what was deleted, and cut the log off."""
        raw = cast("sqlite3.Connection", writing.connection.driver_connection)
        raw.execute("VACUUM")
        deadline = time.monotonic() + BUSY_S
        while raw.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()[0] != 0:
            if time.monotonic() > deadline:
                raise OSError(
                    None, "erased, but not cleaned up: somebody is reading it", self.name
                )
            time.sleep(0.05)

    def close(self) -> None:
        """Let go of the file and its lock."""
        self._writer.dispose()
        self._reader.dispose()
        self._drop_lock()

    def _connect(self) -> DBAPIConnection:
        return self._configured(str(self._path))

    def _connect_to_read(self) -> DBAPIConnection:
        return self._configured(f"{self._path.absolute().as_uri()}?mode=ro")

    def _configured(self, file: str) -> DBAPIConnection:
        connection = self._driver.connect(
            file, uri=file.startswith("file:"), isolation_level=None, check_same_thread=False
        )
        for pragma in PRAGMAS:
            connection.execute(f"PRAGMA {pragma}").fetchall()
        return cast("DBAPIConnection", connection)

    def _take_lock(self) -> None:
        if self._lock is not None:
            return
        path = self._path.with_suffix(".lock")
        number = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
        try:
            fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(number)
            raise in_use(self.name) from None
        self._lock = number

    def _drop_lock(self) -> None:
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None


def _engine(driver: ModuleType, connect: Callable[[], DBAPIConnection]) -> Engine:
    engine = create_engine("sqlite://", module=driver, creator=connect, poolclass=NullPool)

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        # The driver's own begin comes too late: it leaves out reading and table-making.
        connection.exec_driver_sql("BEGIN")

    return engine
