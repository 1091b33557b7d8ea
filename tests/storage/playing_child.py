"""A program that plays until it is killed: it tells each event once the store has acknowledged it.

python playing_child.py DATA KEYS ROUND
"""

import itertools
import os
import sys
import threading
import time
from pathlib import Path

from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import NewEntry, PatientId, SessionId, StoredSession
from maestra.storage.opening import Place, open_store
from maestra.storage.store import SqlStore

THREADS = 3
PAUSE_S = 0.01


def main(data: str, keys: str, name: str) -> None:
    store = open_store(Place(data, Path(keys)))
    session = SessionId(f"session {name}")
    begun = "2026-05-01T09:00:00+00:00"
    store.save_session(StoredSession(session, PatientId("heron"), "odd", 1, "{}", begun))
    threads = [
        threading.Thread(target=play, args=(store, session, number)) for number in range(THREADS)
    ]
    for thread in threads:
        thread.start()


def play(store: SqlStore, session: SessionId, thread: int) -> None:
    for number in itertools.count():
        entry = NewEntry(
            session, f"{thread} {number}", Milliseconds(number), "now", "event", '{"a": 1}'
        )
        while True:
            try:
                store.events.append([entry])
            except OSError:  # the server is away: again, under the same key
                time.sleep(PAUSE_S)
            else:
                os.write(sys.stdout.fileno(), f"{session}|{entry.key}\n".encode())
                break


if __name__ == "__main__":
    main(*sys.argv[1:])
