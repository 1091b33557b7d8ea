"""PostgreSQL by URL: the same tables, one writer by an advisory lock."""

import contextlib
from collections.abc import Generator
from importlib.util import find_spec
from typing import Final

from sqlalchemy import Connection, create_engine, make_url, text
from sqlalchemy.exc import ArgumentError, DBAPIError
from sqlalchemy.pool import NullPool

from maestra.core.faults import Fault, InvalidError
from maestra.storage.database import as_os_error, in_use
from maestra.storage.tables import OF_A_PATIENT

SCHEMES: Final = ("postgresql://", "postgres://", "postgresql+psycopg://")
_LOCK: Final = 0x4D61_6573_7472_6121
"""One number for all of Maestra, in each database: its writers take turns."""
_TAKE_LOCK: Final = text(f"SELECT pg_try_advisory_lock({_LOCK})")
_CONNECT_S: Final = 10
BUSY_MS: Final = 5_000
"""How long to wait for others to finish reading before a table can be written anew."""


class PostgresDatabase:
    """The record on a server."""

    def __init__(self, url: str) -> None:
        """Use the database that `url` names.

        Raises:
            InvalidError: it names none.
        """
        _, _, rest = url.partition("://")
        try:
            named = make_url(f"postgresql+psycopg://{rest}")
        except (ArgumentError, ValueError):
            expected = "postgresql://USER@HOST/DATABASE"
            raise InvalidError([Fault("--data", "no address of a database", expected)]) from None
        if find_spec("psycopg") is None:
            expected = "psycopg: pip install 'maestra[postgresql]'"
            raise InvalidError([Fault("--data", "PostgreSQL without its driver", expected)])
        self._name: str = named.render_as_string(hide_password=True).replace("+psycopg", "")
        self._engine = create_engine(
            named,
            poolclass=NullPool,
            isolation_level="REPEATABLE READ",
            # What is acknowledged is on the server's disk, whatever the server's default is.
            connect_args={
                "connect_timeout": _CONNECT_S,
                "options": "-c synchronous_commit=on -c application_name=maestra",
            },
        )

    @property
    def name(self) -> str:
        """The address, without the password."""
        return self._name

    def exists(self) -> bool:
        """Whether there is anything to read: the server knows."""
        return True

    def writing(self) -> Connection:
        """The one connection that writes."""
        try:
            connection = self._engine.connect()
            is_ours = connection.scalar(_TAKE_LOCK)
            connection.rollback()
        except DBAPIError as error:
            raise as_os_error(error, self.name) from error
        if not is_ours:
            connection.close()
            raise in_use(self.name)
        return connection

    @contextlib.contextmanager
    def reading(self) -> Generator[Connection]:
        """A connection that sees one moment of the database."""
        try:
            with self._engine.connect() as connection:
                yield connection.execution_options(postgresql_readonly=True)
        except DBAPIError as error:
            raise as_os_error(error, self.name) from error

    def scrub(self, writing: Connection) -> None:
        """Write the tables anew without what was deleted."""
        _ = writing  # VACUUM runs in no transaction, and this one's is not to be disturbed
        try:
            with self._engine.connect().execution_options(
                isolation_level="AUTOCOMMIT"
            ) as connection:
                connection.exec_driver_sql(f"SET lock_timeout = {BUSY_MS}")
                for table in OF_A_PATIENT:
                    connection.exec_driver_sql(f"VACUUM FULL {table.name}")
        except DBAPIError as error:
            raise as_os_error(error, self.name) from error

    def close(self) -> None:
        """Let go of the server."""
        self._engine.dispose()
