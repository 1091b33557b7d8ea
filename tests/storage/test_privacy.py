"""Nobody's data is readable without the keys, and nothing is of somebody who was erased."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from maestra.coaching.ports import SessionId
from maestra.core.faults import InvalidError
from maestra.storage.backup import back_up, back_up_keys, restore
from maestra.storage.chain import Sound
from maestra.storage.opening import Place, open_store, open_to_read
from maestra.storage.postgres import PostgresDatabase
from maestra.storage.store import ERASED, SqlStore
from maestra.storage.vault import SubjectId
from tests.storage.samples import OTHER, PATIENT, SESSION, entry, session
from tests.storage.servers import PostgresServer

NAME = "Montserrat Casademunt"
WORD = "unmistakable-word"
NEEDLES = tuple(
    word.encode() for word in (PATIENT, NAME, WORD, SESSION, "leisurely", "four-legged-first")
)
Opening = Callable[[Place], SqlStore]


def fill(store: SqlStore) -> None:
    store.save_exercise("ascending", "{}")
    store.save_settings(PATIENT, '{"pace": "leisurely"}')
    store.save_name(PATIENT, NAME)
    store.save_plan(PATIENT, '{"exercises": ["four-legged-first"]}')
    store.save_session(session())
    store.events.append([entry(number, word=WORD) for number in range(20)])
    store.save_session(session(SessionId("other session"), OTHER))
    store.events.append([entry(1, SessionId("other session"))])


def found_in(folder: Path, *words: bytes) -> set[tuple[str, bytes]]:
    """Which of these words, or of those that tell of the patient, stand in which file."""
    return {
        (path.name, needle)
        for path in folder.rglob("*")
        if path.is_file()
        for needle in words or NEEDLES
        if needle in path.read_bytes()
    }


def folders(place: Place, request: pytest.FixtureRequest) -> list[Path]:
    """Where the engine keeps everything, and the keys."""
    if isinstance(place.database, PostgresDatabase):
        server: PostgresServer = request.getfixturevalue("server")
        server.sql("CHECKPOINT")
        return [server.folder, place.keys]
    return [Path(place.data), place.keys]


def test_without_the_keys_nothing_tells_of_a_patient_even_before_erasing(
    store: SqlStore, place: Place, request: pytest.FixtureRequest
) -> None:
    fill(store)
    assert [found_in(folder) for folder in folders(place, request)] == [set(), set()]


def test_the_search_for_words_finds_them_where_they_stand(
    store: SqlStore, place: Place, request: pytest.FixtureRequest
) -> None:
    store.save_exercise("ascending", "not-a-secret")
    found = found_in(folders(place, request)[0], b"not-a-secret")
    assert {word for _, word in found} == {b"not-a-secret"}


def test_an_erased_patient_is_nowhere_and_the_chain_still_holds(
    store: SqlStore, place: Place, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    fill(store)
    store.erase(PATIENT)
    assert store.patients() == (OTHER,)
    assert [one.patient for one in store.sessions()] == [OTHER]
    assert [one.kind for one in store.events.entries()] == ["event", ERASED]
    for lookup in (store.settings, store.name, store.plan, store.everything, store.erase):
        with pytest.raises(KeyError):
            lookup(PATIENT)
    assert store.verify() == Sound(22, 22, 0, 4)
    back_up(store, tmp_path / "backup")
    back_up_keys(store, tmp_path / "all.keys")
    store.close()
    read = Place(str(tmp_path / "restored"), tmp_path / "restored-keys")
    restore(tmp_path / "backup", read, tmp_path / "all.keys")
    again = open_to_read(read)
    assert json.dumps(again.everything(OTHER), sort_keys=True)
    assert again.patients() == (OTHER,)
    assert again.verify() == Sound(22, 22, 0, 5)
    again.close()
    for folder in (*folders(place, request), tmp_path):
        assert found_in(folder) == set()


def test_who_is_erased_stays_erased_in_older_backups(
    store: SqlStore, place: Place, opened: Opening, tmp_path: Path
) -> None:
    fill(store)
    back_up(store, tmp_path / "backup")
    store.erase(PATIENT)
    store.close()
    elsewhere = Place(str(tmp_path / "restored"), place.keys)
    restored = restore(tmp_path / "backup", elsewhere)
    assert restored.left_out == 5
    again = opened(elsewhere)
    assert again.patients() == (OTHER,)
    assert again.verify() == Sound(21, 21, 0, 4)


def test_erasing_that_was_broken_off_can_be_done_again(store: SqlStore) -> None:
    fill(store)
    for key in list(store.vault.folder.glob("subjects/*.key")):
        store.vault.destroy(SubjectId(key.stem))  # as far as it came
    assert store.patients() == ()
    store.erase(PATIENT)
    with pytest.raises(KeyError):
        store.erase(PATIENT)
    assert isinstance(store.verify(), Sound)


def test_a_patient_who_comes_back_after_erasing_begins_anew(store: SqlStore) -> None:
    fill(store)
    store.erase(PATIENT)
    store.save_session(session())
    store.events.append([entry(1)])
    assert [one.key for one in store.events.entries(SESSION)] == ["key 1"]
    assert store.verify() == Sound(23, 23, 0, 5)


def test_a_patient_may_have_everything_that_is_kept(store: SqlStore) -> None:
    fill(store)
    text = json.dumps(store.everything(PATIENT))
    assert all(word.decode() in text for word in NEEDLES)
    assert OTHER not in text
    (played,) = json.loads(text)["sessions"]
    assert len(played["events"]) == 20


# ---------------------------------------------------------------- the drill


def contents(store: SqlStore) -> object:
    return (
        store.exercises(),
        store.patients(),
        store.sessions(),
        tuple(store.events.entries()),
        store.name(PATIENT),
        store.settings(PATIENT),
    )


def test_drill_a_backup_restored_on_another_machine_is_the_same_record(
    store: SqlStore, opened: Opening, tmp_path: Path
) -> None:
    fill(store)
    rows = back_up(store, tmp_path / "backup")
    back_up_keys(store, tmp_path / "all.keys")
    before = contents(store)
    store.close()
    other_machine = Place(str(tmp_path / "new" / "data"), tmp_path / "new" / "keys")
    restored = restore(tmp_path / "backup", other_machine, tmp_path / "all.keys")
    assert (rows, restored.events, restored.left_out) == (30, 21, 0)
    again = opened(other_machine)
    assert contents(again) == before
    assert again.verify() == Sound(21, 21, 0, 4)
    again.events.append([entry(20)])
    assert again.verify() == Sound(22, 22, 0, 5)


def test_drill_a_backup_of_sqlite_is_restored_in_postgresql(
    sqlite_place: Place, server: PostgresServer, opened: Opening, tmp_path: Path
) -> None:
    store = opened(sqlite_place)
    fill(store)
    before = contents(store)
    back_up(store, tmp_path / "backup")
    store.close()
    moved = Place(server.new_database(), sqlite_place.keys)
    restore(tmp_path / "backup", moved)
    again = opened(moved)
    assert contents(again) == before
    assert again.verify() == Sound(21, 21, 0, 4)


def test_events_written_after_a_backup_are_gone_and_new_ones_take_their_place(
    store: SqlStore, place: Place, opened: Opening, tmp_path: Path
) -> None:
    fill(store)
    back_up(store, tmp_path / "backup")
    store.events.append([entry(number) for number in range(30, 40)])
    store.close()
    elsewhere = Place(str(tmp_path / "restored"), place.keys)
    restore(tmp_path / "backup", elsewhere)
    again = opened(elsewhere)
    again.events.append([entry(50)])
    assert again.verify() == Sound(22, 22, 0, 5)


def test_a_backup_is_not_restored_over_a_record(
    store: SqlStore, place: Place, tmp_path: Path
) -> None:
    fill(store)
    back_up(store, tmp_path / "backup")
    store.close()
    with pytest.raises(InvalidError, match="a record, expected a place without one"):
        restore(tmp_path / "backup", place)


def test_a_backup_needs_its_keys(sqlite_place: Place, opened: Opening, tmp_path: Path) -> None:
    store = opened(sqlite_place)
    fill(store)
    back_up(store, tmp_path / "backup")
    back_up_keys(store, tmp_path / "all.keys")
    elsewhere = Place(str(tmp_path / "data2"), tmp_path / "keys2")
    with pytest.raises(InvalidError, match="no keys"):
        restore(tmp_path / "backup", elsewhere)
    (tmp_path / "wrong.keys").write_text("{}")
    with pytest.raises(InvalidError, match="expected keys"):
        restore(tmp_path / "backup", elsewhere, tmp_path / "wrong.keys")
    text = (tmp_path / "all.keys").read_text()
    (tmp_path / "wrong.keys").write_text(text.replace("maestra.keys/1", "maestra.keys/2"))
    with pytest.raises(InvalidError, match="expected keys"):
        restore(tmp_path / "backup", elsewhere, tmp_path / "wrong.keys")
    (tmp_path / "wrong.keys").write_text(text.replace(store.vault.store, "../../../elsewhere"))
    with pytest.raises(InvalidError, match="expected keys"):
        restore(tmp_path / "backup", elsewhere, tmp_path / "wrong.keys")


@pytest.mark.parametrize("cut", [0, 1, 200, -1])
def test_a_file_that_is_no_whole_backup_is_refused(
    sqlite_place: Place, opened: Opening, tmp_path: Path, cut: int
) -> None:
    store = opened(sqlite_place)
    fill(store)
    back_up(store, tmp_path / "backup")
    whole = (tmp_path / "backup").read_bytes()
    (tmp_path / "cut").write_bytes(whole[:cut] if cut >= 0 else b"not at all")
    with pytest.raises(InvalidError, match="a whole"):
        restore(tmp_path / "cut", Place(str(tmp_path / "data2"), sqlite_place.keys))


def test_a_store_that_was_being_begun_when_the_power_went_is_begun_again(
    sqlite_place: Place, tmp_path: Path
) -> None:
    Path(sqlite_place.data).mkdir()
    (Path(sqlite_place.data) / "maestra.db").touch()
    store = open_store(sqlite_place)
    assert store.verify() == Sound(0, 0, 0, 1)
    store.close()
    assert tmp_path.exists()
