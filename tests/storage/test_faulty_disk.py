"""The store on a disk that loses power, fills up, or fails at any operation.

MAESTRA_POWER_CUTS says how many cuts are tried for each mode; `make crashes` tries 2,000.
"""

import collections
import os
import random
import shutil
import sqlite3
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import apsw
import pytest

from maestra.core.faults import InvalidError
from maestra.storage import sqlite
from maestra.storage.chain import Sound
from maestra.storage.opening import Place, open_store
from maestra.storage.sqlite import FILE_NAME, SqliteDatabase
from maestra.storage.store import SqlStore
from maestra.storage.vault import StoreId, Vault
from tests.storage.faulty_disk import Disk, Sync, Write, after_power_cut, driver
from tests.storage.samples import SESSION, entry, session

CUTS = int(os.environ.get("MAESTRA_POWER_CUTS", "60"))
EVENTS = 30
"""In a session whose power is cut."""
FEW = 8 if CUTS > 100 else 4
"""In a session on a bad disk, which is played once for each operation."""
Failing = Callable[[int], type[apsw.Error] | None]


@dataclass
class Machine:
    """A store on a disk that can be told to fail."""

    folder: Path
    disk: Disk = field(default_factory=Disk)

    @property
    def place(self) -> Place:
        return Place(str(self.folder / "data"), self.folder / "keys")

    @property
    def heads(self) -> Path:
        (found,) = self.folder.glob("keys/*/heads.jsonl")
        return found

    def open(self) -> SqlStore:
        (keys,) = (self.folder / "keys").iterdir()
        database = SqliteDatabase(Path(self.place.data), driver(self.disk))
        try:
            return SqlStore(database, Vault(keys.parent, StoreId(keys.name)), writes=True)
        except BaseException:
            database.close()
            raise


@pytest.fixture(scope="module")
def begun(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An empty store with a session, made once and copied for each test."""
    folder = tmp_path_factory.mktemp("begun")
    store = open_store(Place(str(folder / "data"), folder / "keys"))
    store.save_session(session())
    store.close()
    return folder


@pytest.fixture
def machines(begun: Path, tmp_path: Path) -> Iterator[Callable[[], Machine]]:
    """New machines, each with a copy of the store."""
    made: list[Machine] = []

    def make() -> Machine:
        folder = tmp_path / str(len(made))
        shutil.copytree(begun, folder)
        made.append(Machine(folder))
        return made[-1]

    yield make
    for machine in made:
        machine.disk.unregister()


def kept_keys(store: SqlStore) -> collections.Counter[str]:
    return collections.Counter(one.key for one in store.events.entries(SESSION))


# ---------------------------------------------------------------- power cuts


@dataclass
class Played:
    """A session, and what had been asked and acknowledged at each moment."""

    machine: Machine
    before: dict[str, bytes]
    acknowledged: list[tuple[int, str]] = field(default_factory=list[tuple[int, str]])
    heads_bytes: list[int] = field(default_factory=list[int])


def play(machine: Machine) -> Played:
    before = {
        path.name: path.read_bytes()
        for path in Path(machine.place.data).iterdir()
        if path.suffix != ".lock" and not path.name.endswith("-shm")
    }
    played = Played(machine, before, heads_bytes=[machine.heads.stat().st_size])
    machine.disk.noticed = lambda: played.heads_bytes.append(machine.heads.stat().st_size)
    store = machine.open()
    for number in range(EVENTS):
        store.events.append([entry(number)])
        played.acknowledged.append((len(machine.disk.operations), f"key {number}"))
    machine.disk.noticed = lambda: None
    operations = len(machine.disk.operations)
    store.close()
    del machine.disk.operations[operations:]
    return played


@dataclass
class Outcome:
    """What power cuts did."""

    cuts: int = 0
    lost_in: int = 0
    corrupt_in: int = 0


def cut_power(played: Played, folder: Path, cuts: int) -> Outcome:
    """Cut the power `cuts` times, each time after another operation; what was left."""
    chance = random.Random(7)  # noqa: S311 - no secret, and the same in each run
    outcome = Outcome()
    for number in range(cuts):
        at = chance.randrange(len(played.heads_bytes))
        left = folder / str(number)
        _leave(played, at, left, chance)
        outcome.cuts += 1
        expected = {key for when, key in played.acknowledged if when <= at}
        try:
            _check(left, expected)
        except (OSError, InvalidError, sqlite3.Error):
            outcome.corrupt_in += 1
        except LookupError:
            outcome.lost_in += 1
        shutil.rmtree(left)
    return outcome


def _leave(played: Played, at: int, folder: Path, chance: random.Random) -> None:
    """Make a machine as it may be found after a power cut."""
    shutil.copytree(played.machine.folder / "keys", folder / "keys")
    (folder / "data").mkdir()
    begun = [
        operation
        for name, content in played.before.items()
        for operation in (_whole(name, content), Sync(name))
    ]
    files = after_power_cut([*begun, *played.machine.disk.operations[:at]], chance)
    for name, content in files.items():
        (folder / "data" / name).write_bytes(content)
    # Heads are synced before anything is acknowledged: what was there then is there now.
    with Machine(folder).heads.open("r+b") as file:
        file.truncate(played.heads_bytes[at])


def _whole(name: str, content: bytes) -> Write:
    return Write(name, 0, content)


def _check(folder: Path, expected: set[str]) -> None:
    """Open what was left with the SQLite of Python.

    Raises:
        LookupError: an acknowledged event is missing, or not as it was.
        sqlite3.Error, OSError, InvalidError: it cannot be read.
    """
    with sqlite3.connect(folder / "data" / FILE_NAME) as raw:
        (said,) = raw.execute("PRAGMA integrity_check").fetchone()
    raw.close()
    if said != "ok":
        raise sqlite3.DatabaseError(said)
    store = open_store(Place(str(folder / "data"), folder / "keys"))
    try:
        kept = kept_keys(store)
        verified = store.verify()
    finally:
        store.close()
    if any(kept[key] != 1 for key in expected) or not isinstance(verified, Sound):
        raise LookupError(verified)


def with_pragma(patch: pytest.MonkeyPatch, synchronous: str) -> None:
    """Have the store flush as this mode of SQLite says, and write its log back often."""
    pragmas = (*sqlite.PRAGMAS, f"synchronous = {synchronous}", "wal_autocheckpoint = 20")
    patch.setattr(sqlite, "PRAGMAS", pragmas)


@pytest.mark.timeout(0 if CUTS > 100 else 300)
@pytest.mark.parametrize(
    ("synchronous", "is_safe"), [("FULL", True), ("NORMAL", False), ("OFF", False)]
)
def test_only_what_waits_for_the_disk_survives_every_power_cut(
    machines: Callable[[], Machine],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    synchronous: str,
    *,
    is_safe: bool,
) -> None:
    with_pragma(monkeypatch, synchronous)
    played = play(machines())
    outcome = cut_power(played, tmp_path / "left", CUTS)
    print(f"synchronous={synchronous}: {outcome}")  # noqa: T201 - figures of docs/reference/record.md
    if is_safe:
        assert outcome == Outcome(CUTS, 0, 0)
    else:
        assert outcome.lost_in + outcome.corrupt_in > 0
    if synchronous == "OFF":
        assert outcome.corrupt_in > 0


# ---------------------------------------------------------------- full and failing disks


def failing_in(operations: range, error: type[apsw.Error]) -> Failing:
    return lambda number: error if number in operations else None


def count_operations(machine: Machine) -> int:
    store = machine.open()
    for number in range(FEW):
        store.events.append([entry(number)])
    store.close()
    return len(machine.disk.operations)


def append_until_kept(store: SqlStore, number: int) -> int:
    """Append as a session does: again under the same key until it is kept; how often it failed."""
    failures = 0
    while True:
        try:
            store.events.append([entry(number)])
        except OSError:
            failures += 1
            assert failures < 10
        else:
            return failures


def open_until_it_does(machine: Machine) -> tuple[SqlStore, int]:
    failures = 0
    while True:
        try:
            return machine.open(), failures
        except OSError:
            failures += 1
            assert failures < 10


@pytest.mark.parametrize("error", [apsw.FullError, apsw.IOError])
def test_a_disk_that_fails_once_at_any_operation_loses_and_doubles_nothing(
    machines: Callable[[], Machine], error: type[apsw.Error], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sqlite, "PRAGMAS", (*sqlite.PRAGMAS, "wal_autocheckpoint = 10"))
    total = count_operations(machines())
    failed = 0
    for at in range(total):
        machine = machines()
        machine.disk.failing = failing_in(range(at, at + 1), error)
        store, failures = open_until_it_does(machine)
        for number in range(FEW):
            failures += append_until_kept(store, number)
        store.close()
        machine.disk.failing = lambda _: None
        failed += failures > 0
        again = machine.open()
        assert kept_keys(again) == {f"key {number}": 1 for number in range(FEW)}, at
        assert isinstance(again.verify(), Sound), at
        again.close()
    print(f"{error.__name__} once: {total} operations, {failed} said")  # noqa: T201 - as above
    assert failed > total // 2


@pytest.mark.parametrize("error", [apsw.FullError, apsw.IOError])
def test_a_disk_that_fails_from_any_operation_on_loses_nothing_acknowledged(
    machines: Callable[[], Machine], error: type[apsw.Error]
) -> None:
    total = count_operations(machines())
    for at in range(total):
        machine = machines()
        machine.disk.failing = failing_in(range(at, sys.maxsize), error)
        acknowledged: set[str] = set()
        try:
            store = machine.open()
        except OSError:
            pass
        else:
            for number in range(FEW):
                try:
                    store.events.append([entry(number)])
                except OSError:
                    continue
                acknowledged.add(f"key {number}")
            store.close()
        machine.disk.failing = lambda _: None
        again = machine.open()
        kept = kept_keys(again)
        assert all(kept[key] == 1 for key in acknowledged), at
        assert isinstance(again.verify(), Sound), at
        again.close()
    print(f"{error.__name__} for ever: {total} operations")  # noqa: T201 - as above


def test_an_event_whose_head_could_not_be_written_is_not_acknowledged_until_it_is(
    machines: Callable[[], Machine], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = machines().open()
    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", _full)
        with pytest.raises(OSError, match="No space left"):
            store.events.append([entry(1)])
    store.events.append([entry(1)])
    assert kept_keys(store) == {"key 1": 1}
    assert store.verify() == Sound(1, 1, 0, 2)
    store.close()


def _full(_: int) -> None:
    raise OSError(28, "No space left on device")


def test_a_full_disk_is_named(machines: Callable[[], Machine]) -> None:
    machine = machines()
    store = machine.open()
    machine.disk.failing = lambda _: apsw.FullError
    with pytest.raises(OSError) as raised:  # noqa: PT011 - its number is what counts
        store.events.append([entry(1)])
    assert raised.value.errno == 28
    machine.disk.failing = lambda _: None
    store.close()
