"""Sessions of simulated patients, kept as the program keeps real ones."""

import json
from datetime import UTC, datetime, timedelta
from typing import Final

from maestra import __version__
from maestra.coaching.chance import Chance
from maestra.coaching.commands import encode_commands
from maestra.coaching.events import encode_event
from maestra.coaching.fields import Milliseconds
from maestra.coaching.patients import patient_of
from maestra.coaching.playing import step
from maestra.coaching.ports import NewEntry, PatientId, SessionId, Store, StoredSession
from maestra.coaching.session import new_session
from maestra.coaching.settings import Mental, Profile, encode_settings, settings_for
from maestra.coaching.simulation import Simulation
from tests.coaching.plain_referee import game

BEGUN: Final = datetime(2026, 5, 1, 9, tzinfo=UTC)


def keep_session(
    store: Store, patient: PatientId, number: int = 0, mental: Mental = Mental.MILD
) -> SessionId:
    """Have a simulated patient play a session, and keep it; returns its id."""
    profile = Profile(mental)
    settings = settings_for(profile)
    playing = game(settings=settings, seed=number)
    played = Simulation(playing, patient_of(profile, Chance(number)), number).play()
    session = SessionId(f"{patient}-{number}")
    begun = BEGUN + timedelta(days=number)
    kept = StoredSession(
        session, patient, "ascending", 1, json.dumps(encode_settings(settings)), begun.isoformat()
    )
    store.save_session(kept)
    start = {"seed": number, "maestra": __version__}
    entries = [
        NewEntry(session, "start", Milliseconds(0), begun.isoformat(), "start", json.dumps(start))
    ]
    state = new_session(playing)
    for place, event in enumerate(played.events):
        state, commands = step(state, event.what, event.at)
        utc = (begun + timedelta(milliseconds=event.at)).isoformat()
        for kind, payload in (
            ("event", encode_event(event)),
            ("commands", encode_commands(commands)),
        ):
            text = json.dumps(payload)
            entries.append(NewEntry(session, f"{kind} {place}", event.at, utc, kind, text))
    store.events.append(entries)
    return session
