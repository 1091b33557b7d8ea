"""The way to the record, and its tables."""

from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import select

from maestra.core.faults import InvalidError
from maestra.storage import migrations, postgres, schema, sqlite
from maestra.storage.opening import DATA_VARIABLE, KEYS_VARIABLE, Place, place
from maestra.storage.postgres import PostgresDatabase
from maestra.storage.store import SqlStore
from maestra.storage.tables import METADATA, SESSIONS
from tests.storage.samples import PATIENT, entry, session


def test_the_tables_after_all_migrations_are_those_that_the_code_expects(store: SqlStore) -> None:
    with store.database.reading() as connection:
        context = MigrationContext.configure(connection)
        assert compare_metadata(context, METADATA) == []


def test_the_newest_migration_is_the_version_that_is_read() -> None:
    (folder,) = migrations.__path__
    newest = max(path.name for path in (Path(folder) / "versions").glob("v*.py"))
    assert newest.startswith(f"v{schema.VERSION}_")


def test_the_usual_folders_are_apart_and_follow_xdg(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for variable in (DATA_VARIABLE, KEYS_VARIABLE, "XDG_DATA_HOME", "XDG_CONFIG_HOME"):
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    usual = Place(f"{tmp_path}/.local/share/maestra", tmp_path / ".config/maestra/keys")
    assert place() == usual
    monkeypatch.setenv("XDG_DATA_HOME", "relative/paths/are/ignored")
    assert place() == usual
    monkeypatch.setenv("XDG_DATA_HOME", "/srv/data")
    monkeypatch.setenv("XDG_CONFIG_HOME", "/srv/config")
    assert place() == Place("/srv/data/maestra", Path("/srv/config/maestra/keys"))
    monkeypatch.setenv(DATA_VARIABLE, "postgresql://a@b/c")
    monkeypatch.setenv(KEYS_VARIABLE, "/keys")
    assert place() == Place("postgresql://a@b/c", Path("/keys"))
    assert place("here", "there") == Place("here", Path("there"))


def test_a_password_is_never_shown() -> None:
    assert PostgresDatabase("postgresql://me:secret@host/base").name == (
        "postgresql://me:***@host/base"
    )


def test_a_missing_driver_of_postgresql_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(_: str) -> None:
        return None

    monkeypatch.setattr(postgres, "find_spec", nothing)
    with pytest.raises(InvalidError, match=r"pip install 'maestra\[postgresql\]'"):
        PostgresDatabase("postgresql://host/base")


@pytest.mark.parametrize("data", ["postgresql://nobody@127.0.0.1:1/base"])
def test_a_server_that_is_away_is_said_to_be(data: str) -> None:
    database = PostgresDatabase(data)
    with pytest.raises(OSError, match=r"refused|could not|failed"):
        database.writing()
    with pytest.raises(OSError, match=r"refused|could not|failed"), database.reading():
        pass


def test_a_folder_that_cannot_be_used_is_said_to_be(sqlite_place: Place) -> None:
    Path(sqlite_place.data).mkdir()
    (Path(sqlite_place.data) / sqlite.FILE_NAME).mkdir()
    with pytest.raises(OSError, match="unable to open"):
        sqlite_place.database.writing()


def test_a_file_that_is_no_database_is_said_to_be(sqlite_place: Place) -> None:
    Path(sqlite_place.data).mkdir()
    (Path(sqlite_place.data) / sqlite.FILE_NAME).write_bytes(b"not a database" * 100)
    with pytest.raises(OSError, match="not a database"):
        sqlite_place.database.writing()


def test_erasing_waits_for_readers_and_says_so_when_they_stay(
    store: SqlStore, place: Place, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sqlite, "BUSY_S", 0.1)
    monkeypatch.setattr(postgres, "BUSY_MS", 100)
    store.save_session(session())
    store.events.append([entry(1)])
    reader = place.database
    with reader.reading() as connection:
        connection.execute(select(SESSIONS)).all()
        with pytest.raises(OSError, match=r"somebody is reading it|lock timeout"):
            store.erase(PATIENT)
    # Nobody can read anything of the patient any more all the same.
    assert store.patients() == ()
    assert list(store.events.entries(session().session)) == []
