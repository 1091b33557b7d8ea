"""What every engine promises to coaching's Store port."""

import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from sqlalchemy.exc import DBAPIError

from maestra.coaching.ports import Entry, NewEntry, PatientId, SessionId, Store, StoredExercise
from maestra.core.faults import InvalidError
from maestra.storage.chain import Sound
from maestra.storage.opening import Place, open_store, open_to_read
from maestra.storage.store import NOBODY, SqlStore
from tests.storage.samples import OTHER, PATIENT, SESSION, behind, entry, session

Opening = Callable[[Place], SqlStore]


def as_kept(new: NewEntry, sequence: int) -> Entry:
    return Entry(new.session, new.key, new.at, new.utc, new.kind, new.payload, sequence)


def test_the_store_is_coachings(store: SqlStore) -> None:
    port: Store = store
    assert port.patients() == ()


# ---------------------------------------------------------------- the record


def test_events_come_back_as_they_were_appended(store: SqlStore) -> None:
    store.save_session(session())
    kept = store.events.append([entry(1), entry(2)])
    assert kept == (as_kept(entry(1), 1), as_kept(entry(2), 2))
    assert tuple(store.events.entries()) == kept


def test_events_of_one_session_are_told_apart(store: SqlStore) -> None:
    other = SessionId("session-2")
    store.save_session(session())
    store.save_session(session(other, OTHER))
    store.events.append([entry(1), entry(1, other), entry(2)])
    assert [one.sequence for one in store.events.entries(SESSION)] == [1, 3]
    assert [one.sequence for one in store.events.entries(other)] == [2]
    assert list(store.events.entries(SessionId("session-3"))) == []


def test_an_event_appended_again_under_its_key_is_kept_once(store: SqlStore) -> None:
    store.save_session(session())
    first = store.events.append([entry(1), entry(2)])
    again = store.events.append([entry(2), entry(3)])
    assert again == (first[1], as_kept(entry(3), 3))
    assert len(list(store.events.entries())) == 3


def test_a_key_that_was_used_for_something_else_is_refused_and_nothing_is_kept(
    store: SqlStore,
) -> None:
    store.save_session(session())
    store.events.append([entry(1)])
    with pytest.raises(InvalidError, match="key 1, used for something else before"):
        store.events.append([entry(2), entry(1, word="placed")])
    assert [one.key for one in store.events.entries()] == ["key 1"]


def test_events_of_a_session_that_nobody_saved_are_refused(store: SqlStore) -> None:
    with pytest.raises(KeyError, match="session-1"):
        store.events.append([entry(1)])
    assert store.verify() == Sound(0, 0, 0, 1)


def test_sessions_of_nobody_are_kept_too(store: SqlStore) -> None:
    # They are not sealed, and test_privacy.py searches the same server's log for a patient's.
    nobodys = session(SessionId("nobody's"), NOBODY)
    store.save_session(nobodys)
    store.events.append([entry(1, nobodys.session)])
    assert store.sessions() == (nobodys,)
    assert [one.key for one in store.events.entries(nobodys.session)] == ["key 1"]
    assert store.patients() == ()


def test_many_threads_append_without_losing_or_doubling_anything(store: SqlStore) -> None:
    store.save_session(session())

    def append_ten(first: int) -> None:
        for number in range(first, first + 10):
            store.events.append([entry(number)])

    threads = [threading.Thread(target=append_ten, args=(10 * k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    kept = list(store.events.entries())
    assert [one.sequence for one in kept] == list(range(1, 81))
    assert {one.key for one in kept} == {f"key {number}" for number in range(80)}
    verified = store.verify()
    assert isinstance(verified, Sound)
    assert verified.signed == 80
    assert verified.heads <= 81


def test_the_database_itself_refuses_to_change_or_remove_an_event(
    store: SqlStore, place: Place
) -> None:
    store.save_session(session())
    store.events.append([entry(1)])
    store.close()
    with behind(place) as connection:
        for statement in ("UPDATE events SET utc = 'never'", "DELETE FROM events"):
            with pytest.raises(DBAPIError, match="append-only"), connection.begin_nested():
                connection.exec_driver_sql(statement)


# ---------------------------------------------------------------- exercises


def test_exercises_have_versions_and_what_equals_the_latest_makes_none(store: SqlStore) -> None:
    assert store.save_exercise("ascending", "{}", "one") == 1
    assert store.save_exercise("ascending", "{}", "one") == 1
    assert store.save_exercise("ascending", "{}", "two") == 2
    assert store.save_exercise("ascending", "{}", "one") == 3
    assert store.save_exercise("odd", "[]") == 1
    assert store.exercise("ascending") == StoredExercise("ascending", 3, "{}", "one")
    assert store.exercise("ascending", 2).demonstrations == "two"
    assert [(one.name, one.version) for one in store.exercises()] == [("ascending", 3), ("odd", 1)]


@pytest.mark.parametrize(("name", "version"), [("even", None), ("odd", 2)])
def test_an_exercise_that_is_not_there_is_not_found(
    store: SqlStore, name: str, version: int | None
) -> None:
    store.save_exercise("odd", "[]")
    with pytest.raises(KeyError, match=name):
        store.exercise(name, version)


def test_an_exercise_needs_a_name_that_can_be_printed(store: SqlStore) -> None:
    with pytest.raises(InvalidError, match="name"):
        store.save_exercise("\x07", "{}")


# ---------------------------------------------------------------- patients and sessions


def test_settings_are_kept_and_replaced(store: SqlStore) -> None:
    with pytest.raises(KeyError):
        store.settings(PATIENT)
    store.save_settings(PATIENT, '{"level": 1}')
    store.save_settings(PATIENT, '{"level": 2}')
    store.save_settings(OTHER, "{}")
    assert store.settings(PATIENT) == '{"level": 2}'
    assert store.patients() == (PATIENT, OTHER)


def test_names_are_kept_apart(store: SqlStore) -> None:
    store.save_settings(PATIENT, "{}")
    with pytest.raises(KeyError):
        store.name(PATIENT)
    store.save_name(PATIENT, "Anna Puig")
    assert store.name(PATIENT) == "Anna Puig"
    store.save_name(OTHER, "Jordi")
    assert store.patients() == (PATIENT, OTHER)


def test_a_pseudonym_that_cannot_be_printed_is_refused(store: SqlStore) -> None:
    with pytest.raises(InvalidError, match="patient"):
        store.save_settings(PatientId("a\nb"), "{}")


def test_a_session_is_replaced_when_it_has_ended(store: SqlStore) -> None:
    ended = session(ended="2026-05-01T09:10:00+00:00")
    store.save_session(session())
    store.save_session(ended)
    store.save_session(session(SessionId("session-0"), OTHER))
    assert store.sessions(PATIENT) == (ended,)
    assert [one.session for one in store.sessions()] == ["session-0", "session-1"]


def test_a_session_does_not_become_another_patients(store: SqlStore) -> None:
    store.save_session(session())
    with pytest.raises(InvalidError, match="another patient's"):
        store.save_session(session(patient=OTHER))
    assert store.patients() == (PATIENT,)


# ---------------------------------------------------------------- opening


def test_what_was_kept_is_there_after_closing(place: Place, opened: Opening) -> None:
    first = opened(place)
    first.save_session(session())
    first.events.append([entry(1)])
    first.close()
    second = opened(place)
    assert second.sessions(PATIENT) == (session(),)
    assert second.events.append([entry(1), entry(2)])[1].sequence == 2
    assert second.verify() == Sound(2, 2, 0, 3)


def test_only_one_program_writes_at_a_time(place: Place, opened: Opening) -> None:
    first = opened(place)
    with pytest.raises(InvalidError, match="in use by another Maestra"):
        open_store(place)
    first.save_exercise("odd", "[]")
    first.close()
    assert opened(place).exercise("odd").version == 1


def test_others_may_read_while_one_writes(place: Place, opened: Opening) -> None:
    writing = opened(place)
    writing.save_session(session())
    reading = open_to_read(place)
    writing.events.append([entry(1)])
    assert [one.key for one in reading.events.entries()] == ["key 1"]
    with pytest.raises(OSError, match="opened to be read only"):
        reading.events.append([entry(2)])
    reading.close()


def test_a_record_that_nobody_began_cannot_be_read(place: Place) -> None:
    with pytest.raises(InvalidError, match="no record"):
        open_to_read(place)


def test_a_record_of_a_newer_maestra_is_refused(place: Place, opened: Opening) -> None:
    opened(place).close()
    with behind(place) as connection:
        connection.exec_driver_sql("UPDATE alembic_version SET version_num = '9999'")
    for opening in (open_store, open_to_read):
        with pytest.raises(InvalidError, match="version 9999, expected version"):
            opening(place)


def test_a_record_without_its_keys_is_not_opened(
    place: Place, opened: Opening, tmp_path: Path
) -> None:
    opened(place).close()
    elsewhere = Place(place.data, tmp_path / "elsewhere")
    for opening in (open_store, open_to_read):
        with pytest.raises(InvalidError, match="no keys"):
            opening(elsewhere)


def test_nothing_is_written_after_closing(store: SqlStore) -> None:
    store.close()
    store.close()
    with pytest.raises(OSError, match="the record is closed"):
        store.save_exercise("odd", "[]")
