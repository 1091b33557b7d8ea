"""Engines for the tests of the record: each test has a database and keys of its own."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from maestra.storage.opening import Place, open_store
from maestra.storage.store import SqlStore
from tests.storage.servers import PostgresServer


@pytest.fixture(scope="session")
def server() -> Iterator[PostgresServer]:
    server = PostgresServer()
    yield server
    server.stop()


@pytest.fixture(params=["sqlite", "postgresql"])
def place(request: pytest.FixtureRequest, tmp_path: Path) -> Place:
    """Where a store can be begun, on each engine."""
    keys = tmp_path / "keys"
    if request.param == "sqlite":
        return Place(str(tmp_path / "data"), keys)
    server: PostgresServer = request.getfixturevalue("server")
    return Place(server.new_database(), keys)


@pytest.fixture
def sqlite_place(tmp_path: Path) -> Place:
    return Place(str(tmp_path / "data"), tmp_path / "keys")


@pytest.fixture
def opened() -> Iterator[Callable[[Place], SqlStore]]:
    """Opens stores and closes them in the end."""
    stores: list[SqlStore] = []

    def opening(where: Place) -> SqlStore:
        stores.append(open_store(where))
        return stores[-1]

    yield opening
    for store in stores:
        store.close()


@pytest.fixture
def store(place: Place, opened: Callable[[Place], SqlStore]) -> SqlStore:
    """An empty store, on each engine."""
    return opened(place)
