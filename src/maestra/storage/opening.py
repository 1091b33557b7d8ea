"""The way to the record: a folder or an address, and the folder of its keys."""

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from sqlalchemy import insert, select
from sqlalchemy.exc import DBAPIError

from maestra.core.faults import Fault, refuse
from maestra.storage import schema
from maestra.storage.database import Database, as_os_error
from maestra.storage.postgres import SCHEMES, PostgresDatabase
from maestra.storage.record import Signer
from maestra.storage.sqlite import SqliteDatabase
from maestra.storage.store import SqlStore
from maestra.storage.tables import STORE
from maestra.storage.vault import StoreId, Vault, new_store_id

DATA_VARIABLE: Final = "MAESTRA_DATA"
KEYS_VARIABLE: Final = "MAESTRA_KEYS"


@dataclass(frozen=True, slots=True)
class Place:
    """Where a record is, and where its keys are."""

    data: str
    """A folder, or a PostgreSQL URL."""
    keys: Path

    @property
    def database(self) -> SqliteDatabase | PostgresDatabase:
        """The engine there."""
        if self.data.startswith(SCHEMES):
            return PostgresDatabase(self.data)
        return SqliteDatabase(Path(self.data))


def place(data: str | None = None, keys: str | None = None) -> Place:
    """Where the user wants it: as named, else by the environment, else the usual folders.

    The usual ones are those of the XDG base directory specification: the record among the user's
    data, the keys among the settings, so that a copy of the one is not a copy of the other.
    """
    data = data or os.environ.get(DATA_VARIABLE) or str(_home("XDG_DATA_HOME", ".local/share"))
    keys = (
        keys or os.environ.get(KEYS_VARIABLE) or str(_home("XDG_CONFIG_HOME", ".config") / "keys")
    )
    return Place(data, Path(keys))


def open_store(where: Place) -> SqlStore:
    """Open the record to read and write; begin one where there is none.

    Raises:
        InvalidError: somebody else is writing, or its keys are not there, or a newer Maestra
            wrote it.
        OSError: it cannot be reached.
    """
    make_folders(where)
    database = where.database
    try:
        vault = _prepare(database, where.keys)
        return SqlStore(database, vault, writes=True)
    except BaseException:
        database.close()
        raise


def open_to_read(where: Place) -> SqlStore:
    """Open the record to read it, also while somebody writes.

    Raises:
        InvalidError: there is none, or its keys are not there, or another Maestra wrote it.
        OSError: it cannot be reached.
    """
    database = where.database
    try:
        if not database.exists():
            refuse([Fault(database.name, "no record", "one that Maestra has begun")])
        with database.reading() as connection:
            schema.demand_version(connection, database.name)
            store = StoreId(connection.execute(select(STORE.c.id)).scalar_one())
        return SqlStore(database, Vault(where.keys, store), writes=False)
    except BaseException:
        database.close()
        raise


def _prepare(database: Database, keys: Path) -> Vault:
    """The tables as they should be, and the keys that belong to them."""
    connection = database.writing()
    try:
        with connection.begin():
            schema.upgrade(connection, database.name)
            store = connection.scalar(select(STORE.c.id))
            if store is not None:
                vault = Vault(keys, StoreId(store))
                vault.drop_torn_head()
                return vault
            # Keys first: a record without keys would be lost, keys without a record do no harm.
            store = new_store_id()
            vault = Vault.create(keys, store)
            Signer(vault).begin()
            connection.execute(insert(STORE).values(id=store))
            return vault
    except DBAPIError as error:
        raise as_os_error(error, database.name) from error
    finally:
        connection.close()


def make_folders(where: Place) -> None:
    """The folders of a record and of keys, which only their owner may look into."""
    if not where.data.startswith(SCHEMES):
        Path(where.data).mkdir(parents=True, exist_ok=True, mode=0o700)
    where.keys.mkdir(parents=True, exist_ok=True, mode=0o700)


def _home(variable: str, usual: str) -> Path:
    named = os.environ.get(variable, "")
    # The specification has relative paths ignored.
    base = Path(named) if Path(named).is_absolute() else Path.home() / usual
    return base / "maestra"
