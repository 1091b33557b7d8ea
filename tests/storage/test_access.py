"""Accounts, logins, devices, caregivers and the audit, on every engine."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from maestra.core.faults import InvalidError
from maestra.storage.access import Account, Device, Login
from maestra.storage.backup import back_up, restore
from maestra.storage.opening import Place
from maestra.storage.postgres import PostgresDatabase
from maestra.storage.store import SqlStore
from maestra.storage.vault import SubjectId
from tests.storage.samples import OTHER, PATIENT
from tests.storage.servers import PostgresServer

Opening = Callable[[Place], SqlStore]

NAME = "Aurora Casademunt"
SECRET = "KRSXG5CTMVRXEZLU"
ADA = Account("", NAME, "caregiver", "ca", "$argon2id$hash-of-it", secret=SECRET)
BOARD = Device("d1", "digest-1", "board", "the table", "room-1", None, None, "a1", 5)


def add_patients(store: SqlStore) -> None:
    store.save_settings(PATIENT, "{}")
    store.save_settings(OTHER, "{}")


# ---------------------------------------------------------------- accounts


def test_an_account_comes_back_as_it_was_kept(store: SqlStore) -> None:
    assert not store.access.has_accounts()
    kept = store.access.add_account(ADA)
    assert kept == replace(ADA, account=kept.account)
    assert kept.account
    assert store.access.account(kept.account) == kept
    assert store.access.account_named(f" {NAME.upper()}") == kept
    assert store.access.account_named("somebody") is None
    assert store.access.has_accounts()
    eva = store.access.add_account(replace(ADA, name="eva"))
    bea = store.access.add_account(replace(ADA, name="Bea"))
    assert store.access.accounts() == (kept, bea, eva)


def test_an_account_that_is_not_there_is_not_found(store: SqlStore) -> None:
    with pytest.raises(KeyError, match="nobody"):
        store.access.account("nobody")
    with pytest.raises(KeyError, match="nobody"):
        store.access.change_account("nobody", lambda one: replace(one, name="somebody"))


def test_a_name_is_one_accounts_however_it_is_written(store: SqlStore) -> None:
    ada = store.access.add_account(ADA)
    eva = store.access.add_account(replace(ADA, name="Eva"))
    with pytest.raises(InvalidError, match="name: taken"):
        store.access.add_account(replace(ADA, name=NAME.lower()))
    with pytest.raises(InvalidError, match="name: taken"):
        store.access.change_account(eva.account, lambda one: replace(one, name=NAME.upper()))
    with pytest.raises(InvalidError, match="an empty name"):
        store.access.change_account(eva.account, lambda one: replace(one, name=""))
    with pytest.raises(InvalidError, match="control"):
        store.access.add_account(replace(ADA, name="\x07"))
    changed = store.access.change_account(ada.account, lambda one: replace(one, name="ADA"))
    assert store.access.account_named("ada") == changed
    assert store.access.account_named(NAME) is None


def test_changes_of_one_account_are_made_one_after_the_other(store: SqlStore) -> None:
    ada = store.access.add_account(ADA)

    def step() -> None:
        for _ in range(5):
            store.access.change_account(
                ada.account, lambda one: replace(one, last_step=one.last_step + 1)
            )

    threads = [threading.Thread(target=step) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert store.access.account(ada.account).last_step == 20


# ---------------------------------------------------------------- logins


def test_a_login_lasts_until_it_is_ended(store: SqlStore) -> None:
    logins = [Login(f"digest-{k}", "account", "ada", 10 * k, 10 * k) for k in range(4)]
    for one in logins:
        store.access.add_login(one)
    store.access.add_login(Login("other", "account", "eva", 5, 5))
    assert store.access.login("digest-1") == logins[1]
    assert store.access.login("digest-9") is None
    assert store.access.logins("ada") == tuple(reversed(logins))
    store.access.use_login("digest-1", 99)
    assert store.access.login("digest-1") == replace(logins[1], used_ms=99)
    store.access.end_login("digest-1")
    store.access.use_login("digest-1", 100)
    assert store.access.login("digest-1") is None
    store.access.end_logins("ada", but="digest-2")
    assert store.access.logins("ada") == (logins[2],)
    store.access.end_logins("ada")
    assert store.access.logins("ada") == ()
    assert len(store.access.logins("eva")) == 1


def test_old_and_unused_logins_of_a_kind_are_forgotten(store: SqlStore) -> None:
    for digest, kind, begun, used in (
        ("old", "account", 9, 50),
        ("unused", "account", 10, 19),
        ("fresh", "account", 10, 20),
        ("other", "screen", 1, 1),
    ):
        store.access.add_login(Login(digest, kind, "ada", begun, used))
    store.access.forget_logins(["account"], 10, 20)
    assert {one.digest for one in store.access.logins("ada")} == {"fresh", "other"}


# ---------------------------------------------------------------- devices


def test_a_device_is_known_by_the_digest_of_its_token_until_it_is_removed(
    store: SqlStore,
) -> None:
    add_patients(store)
    screen = Device("d2", "digest-2", "screen", "tablet", None, PATIENT, "hash", "a1", 6)
    store.access.add_device(BOARD)
    store.access.add_device(screen)
    store.access.add_login(Login("open", "screen", "d2", 1, 1))
    assert store.access.device_with("digest-1") == BOARD
    assert store.access.device_with("digest-3") is None
    assert store.access.device("d2") == screen
    assert store.access.devices() == (screen, BOARD)
    store.access.remove_device("d2")
    assert store.access.device_with("digest-2") is None
    assert store.access.login("open") is None
    assert store.access.devices() == (BOARD,)


def test_a_device_needs_names_that_can_be_printed_and_a_patient_that_is_there(
    store: SqlStore,
) -> None:
    for wrong in (replace(BOARD, label=""), replace(BOARD, room="\x07")):
        with pytest.raises(InvalidError):
            store.access.add_device(wrong)
    with pytest.raises(KeyError):
        store.access.add_device(replace(BOARD, patient=PATIENT))
    assert store.access.devices() == ()


# ---------------------------------------------------------------- caregivers


def test_a_new_patient_is_its_makers_and_nobody_elses(store: SqlStore) -> None:
    store.custody.own(PATIENT, "ada")
    store.custody.own(PATIENT, "ada")
    assert store.patients() == (PATIENT,)
    assert store.custody.cares("ada", PATIENT)
    assert not store.custody.cares("eva", PATIENT)
    with pytest.raises(InvalidError, match="taken"):
        store.custody.own(PATIENT, "eva")
    assert store.custody.cares("ada", PATIENT)
    assert not store.custody.cares("eva", PATIENT)


def test_a_pseudonym_that_cannot_be_one_is_nobodys(store: SqlStore) -> None:
    with pytest.raises(InvalidError):
        store.custody.own(type(PATIENT)(""), "ada")
    assert store.patients() == ()


def test_patients_are_entrusted_and_taken_back(store: SqlStore) -> None:
    add_patients(store)
    for _ in range(2):
        store.custody.entrust(OTHER, "ada")
    store.custody.entrust(PATIENT, "ada")
    store.custody.entrust(PATIENT, "eva")
    assert store.custody.patients_of("ada") == (PATIENT, OTHER)
    assert store.custody.patients_of("eva") == (PATIENT,)
    store.custody.release(PATIENT, "ada")
    store.custody.release(PATIENT, "ada")
    assert store.custody.patients_of("ada") == (OTHER,)
    assert store.custody.patients_of("eva") == (PATIENT,)


def test_nobody_cares_for_a_patient_who_is_not_there(store: SqlStore) -> None:
    for ask in (
        lambda: store.custody.cares("ada", PATIENT),
        lambda: store.custody.entrust(PATIENT, "ada"),
        lambda: store.custody.release(PATIENT, "ada"),
    ):
        with pytest.raises(KeyError, match=PATIENT):
            ask()


# ---------------------------------------------------------------- the audit


def test_the_audit_is_read_from_the_newest_page_by_page(store: SqlStore) -> None:
    add_patients(store)
    for k in range(5):
        store.custody.note(f"2026-05-0{k + 1}", "ada", "read", PATIENT, f"line {k}")
    store.custody.note("2026-05-06", None, "denied", type(PATIENT)("nobody"), "")
    lines = store.custody.audit(most=3)
    assert [one.detail for one in lines] == ["", "line 4", "line 3"]
    assert (lines[0].account, lines[0].patient) == (None, None)
    assert (lines[1].account, lines[1].patient, lines[1].act) == ("ada", PATIENT, "read")
    older = store.custody.audit(lines[-1].number, 3)
    assert [one.detail for one in older] == ["line 2", "line 1", "line 0"]
    assert store.custody.audit(older[-1].number) == ()


# ---------------------------------------------------------------- what is left


def test_an_erased_patient_is_in_no_table_of_access(store: SqlStore) -> None:
    store.custody.own(PATIENT, "ada")
    store.access.add_device(replace(BOARD, room=None, patient=PATIENT))
    store.custody.note("2026-05-01", "ada", "read", PATIENT, "")
    store.erase(PATIENT)
    assert store.custody.patients_of("ada") == ()
    assert store.access.devices() == ()
    (line,) = store.custody.audit()
    assert (line.act, line.patient) == ("read", None)
    store.custody.own(PATIENT, "eva")
    assert store.custody.audit()[0].patient is None


def test_a_patient_whose_key_is_lost_is_named_nowhere(store: SqlStore) -> None:
    store.custody.own(PATIENT, "ada")
    for key in store.vault.folder.glob("subjects/*.key"):
        store.vault.destroy(SubjectId(key.stem))
    assert store.custody.patients_of("ada") == ()


def fill(store: SqlStore) -> None:
    store.access.add_account(ADA)
    store.custody.own(PATIENT, "ada")
    store.access.add_login(Login("digest-of-a-login", "account", "ada", 1, 1))
    store.access.add_device(replace(BOARD, patient=PATIENT))
    store.custody.note("2026-05-01", "ada", "read", PATIENT, "")


def test_no_name_secret_or_pseudonym_lies_in_the_clear(
    store: SqlStore, place: Place, request: pytest.FixtureRequest
) -> None:
    fill(store)
    folder = Path(place.data)
    if isinstance(place.database, PostgresDatabase):
        server: PostgresServer = request.getfixturevalue("server")
        server.sql("CHECKPOINT")
        folder = server.folder
    files = [path.read_bytes() for path in folder.rglob("*") if path.is_file()]
    for word in (NAME, SECRET, PATIENT, ADA.password):
        assert not any(word.encode() in one for one in files)
    assert any(b"the table" in one for one in files)


def test_a_backup_brings_everything_back_but_nobody_logged_in(
    store: SqlStore, place: Place, opened: Opening, tmp_path: Path
) -> None:
    fill(store)
    accounts, devices, lines = (
        store.access.accounts(),
        store.access.devices(),
        store.custody.audit(),
    )
    back_up(store, tmp_path / "backup")
    store.close()
    elsewhere = Place(str(tmp_path / "restored"), place.keys)
    restore(tmp_path / "backup", elsewhere)
    again = opened(elsewhere)
    assert again.access.accounts() == accounts
    assert again.access.devices() == devices
    assert again.custody.audit() == lines
    assert again.custody.patients_of("ada") == (PATIENT,)
    assert again.access.login("digest-of-a-login") is None
    again.custody.note("2026-05-02", None, "read", None, "")
    assert len(again.custody.audit()) == 2
