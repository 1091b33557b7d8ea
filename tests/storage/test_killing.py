"""A program killed at any moment has lost nothing that was acknowledged, and doubled nothing.

MAESTRA_KILLS says how often on each engine; `make crashes` kills 120 times.
"""

import collections
import os
import random
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from maestra.storage.chain import Sound
from maestra.storage.opening import Place, open_to_read
from tests.storage.servers import PostgresServer

KILLS = int(os.environ.get("MAESTRA_KILLS", "5"))
CHILD = Path(__file__).with_name("playing_child.py")
MOST_S = 0.5
"""How long a child may play at most before it is killed."""
SERVER_EVERY = 5
"""Each so manieth kill on PostgreSQL kills the server too, while the program plays."""


class Child:
    """A program that plays, and what it has said is kept."""

    def __init__(self, place: Place, number: int) -> None:
        arguments = [sys.executable, str(CHILD), place.data, str(place.keys), str(number)]
        self.process = subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True)
        self.said: list[str] = []
        self.first = threading.Event()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            if line.endswith("\n"):
                self.said.append(line.strip())
                self.first.set()

    def kill(self) -> list[str]:
        """End it as the kernel would; what it had said is kept."""
        self.process.kill()
        self.process.wait()
        self.reader.join()
        assert self.process.stdout is not None
        self.process.stdout.close()
        return self.said


@pytest.mark.timeout(0 if KILLS > 10 else 300)
def test_every_acknowledged_event_is_there_once_after_every_kill(
    place: Place, request: pytest.FixtureRequest
) -> None:
    chance = random.Random(20260501)  # noqa: S311 - no secret, and the same in each run
    said: list[str] = []
    kept: collections.Counter[str] = collections.Counter()
    recovered = 0
    for number in range(KILLS):
        child = Child(place, number)
        assert child.first.wait(60), "the program did not start"
        pause = threading.Event()
        pause.wait(chance.uniform(0, MOST_S))
        if place.data.startswith("postgres") and number % SERVER_EVERY == SERVER_EVERY - 1:
            server: PostgresServer = request.getfixturevalue("server")
            server.crash()
            pause.wait(MOST_S)
        said += child.kill()
        store = open_to_read(place)
        kept = collections.Counter(
            f"{entry.session}|{entry.key}" for entry in store.events.entries()
        )
        verified = store.verify()
        store.close()
        assert isinstance(verified, Sound), verified
        recovered = verified.recovered
        assert [key for key in said if kept[key] != 1] == []
        assert max(kept.values()) == 1
    print(  # noqa: T201 - the figures of docs/reference/record.md
        f"{place.data.partition(':')[0][:10]}: {KILLS} kills, {len(said)} events acknowledged, "
        f"{sum(kept.values())} kept, 0 lost, 0 doubled, {recovered} signed after a crash"
    )
