"""Programs that play until they are killed: they tell each entry once the store acknowledged it.

    python playing_child.py DATA KEYS

For each line on standard input, the name of a round, a process is forked off that plays; so the
libraries are imported once. Printed are `pid N`, the entries, and `dead` once it was killed.

Two patients play at once, session after session, through the very code that plays real ones;
they move whatever token wherever, so that much is refused and put back.
"""

import itertools
import os
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final

from maestra.boards.simulated import SimulatedBoard
from maestra.coaching.chance import Chance
from maestra.coaching.events import Begun, EndOrdered
from maestra.coaching.fields import Milliseconds
from maestra.coaching.policies import policy_for
from maestra.coaching.ports import Entry, EventStore, NewEntry, PatientId, SessionId, StoredSession
from maestra.coaching.recording import Start
from maestra.coaching.running import Running
from maestra.coaching.settings import Settings
from maestra.core.board import Board
from maestra.core.state import State
from maestra.rules.exercise import LearnStatus, RuledExercise, meant_rules
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.paper import NUMBER_DECK
from maestra.rules.rule import Rule
from maestra.rules.setting import Line
from maestra.storage.opening import Place, open_store
from maestra.storage.store import SqlStore

PATIENTS: Final = 2
PAUSE_S: Final = 0.01
MOST_MOVES: Final = 30
"""In one session."""
BEGUN: Final = "2026-05-01T09:00:00+00:00"
BOARD: Final = Board()
RULES: Final[tuple[Rule, ...]] = (
    Ordered("value", Direction.RISING, strict=True, line=Line.ROW),
    FullRow(),
)
EXERCISE: Final = RuledExercise(
    BOARD, NUMBER_DECK, meant_rules(RULES, [1.0, 1.0]), 1.0, LearnStatus.TOLD, RULES
)


class Telling:
    """An event store that tells what it has kept, and tries again where it could not."""

    def __init__(self, store: EventStore) -> None:
        self._store = store

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        while True:
            try:
                kept = self._store.append(entries)
            except OSError:  # the server is away: again, under the same keys
                time.sleep(PAUSE_S)
            else:
                tell("".join(f"{entry.session}|{entry.key}\n" for entry in kept))
                return kept

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        return self._store.entries(session)


def main(data: str, keys: str) -> None:
    for line in sys.stdin:
        pid = os.fork()
        if pid == 0:
            os.close(sys.stdin.fileno())
            play_round(Place(data, Path(keys)), line.strip())
            return
        tell(f"pid {pid}\n")
        os.waitpid(pid, 0)
        tell("dead\n")


def tell(text: str) -> None:
    os.write(sys.stdout.fileno(), text.encode())


def play_round(place: Place, name: str) -> None:
    store = open_store(place)
    for number in range(PATIENTS):
        patient = PatientId(f"heron {number}")
        threading.Thread(target=play_for_ever, args=(store, patient, name)).start()


def play_for_ever(store: SqlStore, patient: PatientId, name: str) -> None:
    for number in itertools.count():
        play(store, patient, SessionId(f"{patient} {name} {number}"), number)


def play(store: SqlStore, patient: PatientId, session: SessionId, seed: int) -> None:
    while True:
        try:
            store.save_session(StoredSession(session, patient, "ascending", 1, "{}", BEGUN))
        except OSError:
            time.sleep(PAUSE_S)
        else:
            break
    settings, chance = Settings(), Chance(seed)
    tokens = [token.id for token in NUMBER_DECK.tokens]
    cells = dict(zip(tokens, BOARD.storage_cells, strict=False))
    state = State(BOARD, cells)
    board = SimulatedBoard(state)
    start = Start(EXERCISE, NUMBER_DECK, state, settings, seed, policy_for(settings), patient)
    running = Running(session, start, board, (), Telling(store.events), BEGUN)
    running.feed(Begun(), Milliseconds(0), BEGUN)
    for number in range(1, MOST_MOVES):
        token, chance = chance.pick(tokens)
        free = [cell for cell in BOARD.cells if cell not in board.cells.values()]
        cell, chance = chance.pick(free)
        board.move(token, cell)
        running.poll(Milliseconds(1_000 * number), BEGUN)
    if not running.has_ended:
        running.feed(EndOrdered(), Milliseconds(1_000 * MOST_MOVES), BEGUN)


if __name__ == "__main__":
    main(*sys.argv[1:])
