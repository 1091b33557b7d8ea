"""A program killed at any moment has lost nothing that was acknowledged, and doubled nothing.

MAESTRA_KILLS says how often on each engine; `make crashes` kills 120 times.
"""

import collections
import json
import os
import queue
import random
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from maestra.coaching.commands import encode_commands
from maestra.coaching.events import decode_event
from maestra.coaching.playing import step
from maestra.coaching.ports import Entry
from maestra.coaching.recording import decode_start
from maestra.storage.chain import Sound
from maestra.storage.opening import Place, open_to_read
from maestra.storage.store import SqlStore
from tests.storage.servers import PostgresServer

KILLS = int(os.environ.get("MAESTRA_KILLS", "5"))
CHILD = Path(__file__).with_name("playing_child.py")
START_S = 60.0 if KILLS <= 10 else 600.0
MOST_S = 0.5
"""How long a child may play at most before it is killed."""
SERVER_EVERY = 5
"""Each so manieth kill on PostgreSQL kills the server too, while the program plays."""


class Programs:
    """Programs that play, one after another; what each has said is kept."""

    def __init__(self, place: Place) -> None:
        arguments = [sys.executable, str(CHILD), place.data, str(place.keys)]
        self._process = subprocess.Popen(
            arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._pid = 0
        threading.Thread(target=self._read, daemon=True).start()

    def start(self, name: str) -> str:
        """Have one play; returns the first that it says."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{name}\n")
        self._process.stdin.flush()
        pid = self._lines.get(timeout=START_S)
        self._pid = int(pid.removeprefix("pid "))
        return self._lines.get(timeout=START_S)

    def kill(self) -> list[str]:
        """End it as the kernel would; what it had said since."""
        os.kill(self._pid, signal.SIGKILL)
        said: list[str] = []
        while (line := self._lines.get(timeout=START_S)) != "dead":
            said.append(line)
        return said

    def stop(self) -> None:
        """Start none any more."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as lines:
            for line in lines:
                self._lines.put(line.strip())


@pytest.mark.timeout(0 if KILLS > 10 else 300)
def test_every_acknowledged_event_is_there_once_after_every_kill(
    place: Place, request: pytest.FixtureRequest
) -> None:
    chance = random.Random(20260501)  # noqa: S311 - no secret, and the same in each run
    said: list[str] = []
    kept: collections.Counter[str] = collections.Counter()
    recovered = sessions = 0
    programs = Programs(place)
    for number in range(KILLS):
        said.append(programs.start(str(number)))
        pause = threading.Event()
        pause.wait(chance.uniform(0, MOST_S))
        if place.data.startswith("postgres") and number % SERVER_EVERY == SERVER_EVERY - 1:
            server: PostgresServer = request.getfixturevalue("server")
            server.crash()
            pause.wait(MOST_S)
        said += programs.kill()
        store = open_to_read(place)
        kept = collections.Counter(
            f"{entry.session}|{entry.key}" for entry in store.events.entries()
        )
        verified = store.verify()
        sessions = replay_all(store)
        store.close()
        assert isinstance(verified, Sound), verified
        recovered = verified.recovered
        assert [key for key in said if kept[key] != 1] == []
        assert max(kept.values()) == 1
    programs.stop()
    print(  # noqa: T201 - the figures of docs/reference/record.md
        f"{type(place.database).__name__}: {KILLS} kills, {len(said)} events acknowledged, "
        f"{sum(kept.values())} kept in {sessions} sessions that replay, 0 lost, 0 doubled, "
        f"{recovered} signed after a crash"
    )


def replay_all(store: SqlStore) -> int:
    """Replay every session from what is kept of it: the same commands; returns how many."""
    entries: dict[str, list[Entry]] = {}
    for entry in store.events.entries():
        entries.setdefault(entry.session, []).append(entry)
    for name, (begun, *kept) in entries.items():
        session = decode_start(begun.payload.encode()).session()
        for event, commands in in_pairs(kept):
            timed = decode_event(json.loads(event.payload))
            session, done = step(session, timed.what, timed.at)
            assert encode_commands(done) == json.loads(commands.payload), (name, event.key)
    return len(entries)


def in_pairs(kept: list[Entry]) -> Iterator[tuple[Entry, Entry]]:
    """Each event with the commands it led to: both are kept, or neither."""
    assert [entry.kind for entry in kept] == ["event", "commands"] * (len(kept) // 2)
    return zip(kept[::2], kept[1::2], strict=True)
