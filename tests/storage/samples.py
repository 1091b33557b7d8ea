"""Things to keep."""

import json
from collections.abc import Generator
from contextlib import contextmanager
from typing import Final

from sqlalchemy import Connection

from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import NewEntry, PatientId, SessionId, StoredSession
from maestra.storage.opening import Place

PATIENT: Final = PatientId("heron")
OTHER: Final = PatientId("plover")
SESSION: Final = SessionId("session-1")


def session(
    name: SessionId = SESSION, patient: PatientId = PATIENT, ended: str | None = None
) -> StoredSession:
    begun = "2026-05-01T09:00:00+00:00"
    return StoredSession(name, patient, "ascending", 1, '{"level": 2}', begun, ended)


def entry(number: int, name: SessionId = SESSION, word: str = "lifted") -> NewEntry:
    payload = json.dumps({"at": 10 * number, "what": {"event": word, "token": f"T{number}"}})
    utc = f"2026-05-01T09:00:{number % 60:02}+00:00"
    return NewEntry(name, f"key {number}", Milliseconds(10 * number), utc, "event", payload)


@contextmanager
def behind(place: Place) -> Generator[Connection]:
    """A connection that bypasses the store; what is done on it is committed."""
    database = place.database
    try:
        with database.writing() as connection, connection.begin():
            yield connection
    finally:
        database.close()


def untie(connection: Connection) -> None:
    """Take away the triggers that keep events from being changed."""
    if connection.dialect.name == "sqlite":
        connection.exec_driver_sql("DROP TRIGGER IF EXISTS events_no_update")
        connection.exec_driver_sql("DROP TRIGGER IF EXISTS events_no_delete")
    else:
        connection.exec_driver_sql("DROP TRIGGER IF EXISTS events_no_change ON events")
