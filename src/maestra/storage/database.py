"""What the store needs of a database engine, and how its errors are said."""

import errno
from contextlib import AbstractContextManager
from typing import Final, Protocol

from sqlalchemy import Connection
from sqlalchemy.exc import DBAPIError

from maestra.core.faults import Fault, InvalidError

_NO_SPACE: Final = ("full", "no space left", "disk full")


class Database(Protocol):
    """An engine: SQLite in a file, PostgreSQL on a server."""

    @property
    def name(self) -> str:
        """What messages call it; holds no password."""
        ...

    def writing(self) -> Connection:
        """The one connection that writes; nobody else has one until it is closed.

        Raises:
            InvalidError: somebody else is writing.
            OSError: the database cannot be reached.
        """
        ...

    def reading(self) -> AbstractContextManager[Connection]:
        """A connection that sees one moment of the database, and changes nothing."""
        ...

    def scrub(self, writing: Connection) -> None:
        """Overwrite what has been deleted, in the database and in its logs.

        Raises:
            OSError: it cannot be done now.
        """
        ...

    def close(self) -> None:
        """Let go of it."""
        ...


def in_use(name: str) -> InvalidError:
    """Said when another program is writing the same record."""
    return InvalidError([Fault(name, "in use by another Maestra", "a record that nobody writes")])


def as_os_error(error: DBAPIError, name: str) -> OSError:
    """What went wrong in the engine, as what a caller can act on."""
    said = str(error.orig or error).strip().splitlines()
    text = said[0] if said else type(error.orig).__name__
    is_full = any(words in text.lower() for words in _NO_SPACE)
    return OSError(errno.ENOSPC if is_full else errno.EIO, text, name)
