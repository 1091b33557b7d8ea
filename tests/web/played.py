"""Sessions of simulated patients in a record, kept as rooms keep them."""

from collections.abc import Iterator, Sequence
from datetime import timedelta

from maestra.boards.replay import ReplayBoard
from maestra.coaching.chance import Chance
from maestra.coaching.fields import Milliseconds
from maestra.coaching.patients import patient_of
from maestra.coaching.ports import Entry, NewEntry, PatientId, SessionId
from maestra.coaching.running import Running
from maestra.coaching.simulation import Simulation
from maestra.coaching.sitting import Chosen, known_patient, rise, sit_down
from maestra.rules.exercise_format import decode_exercise
from maestra.storage.store import SqlStore
from tests.web.conftest import NOON


class Collecting:
    """An event store that keeps all for one commit at the end."""

    def __init__(self) -> None:
        self.collected: list[NewEntry] = []

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        self.collected += entries
        return ()

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        del session
        return iter(())


def play(
    store: SqlStore, patient: PatientId, exercise: str = "ascending", sessions: int = 1
) -> tuple[SessionId, ...]:
    """Let a simulated patient play on as many days; the store knows patient and exercise."""
    found = store.exercise(exercise)
    chosen = Chosen(found.name, found.version, decode_exercise(found.exercise.encode()))
    before = len(store.sessions(patient))
    return tuple(
        _play(store, patient, chosen, number) for number in range(before, before + sessions)
    )


def _play(store: SqlStore, patient: PatientId, chosen: Chosen, number: int) -> SessionId:
    known = known_patient(store, patient)
    identity = SessionId(f"{patient}-{chosen.name}-{number}")
    begun = NOON + timedelta(days=number)
    sitting = sit_down(
        identity, patient, chosen, known, seed=number, utc=begun.isoformat(timespec="seconds")
    )
    sitting.keep(store)
    somebody = patient_of(known.settings.profile, Chance(number))
    start = sitting.start
    simulated = Simulation(start.session().game, somebody, number, start.policy).play()
    kept = Collecting()
    running = Running(identity, start, ReplayBoard(()), (), kept, begun.isoformat())
    for event in simulated.events:
        utc = (begun + timedelta(milliseconds=event.at)).isoformat(timespec="milliseconds")
        running.feed(event.what, Milliseconds(event.at), utc)
    store.events.append(kept.collected)
    ended = begun + timedelta(milliseconds=running.session.now)
    rise(store, sitting.stored, running.session, ended.isoformat(timespec="seconds"))
    return identity
