"""A patient's figures, worked out once for each session that has ended.

A session that has ended never changes, and reading hundreds of them anew for every page would take
seconds. Nothing is kept on the disk; who is erased is forgotten here too.
"""

from __future__ import annotations

import threading
from typing import Final
from weakref import WeakKeyDictionary

from maestra.coaching.ports import PatientId, SessionId, StoredSession
from maestra.coaching.progress import ExerciseProgress, SessionProgress, of_session
from maestra.storage.store import SqlStore

_Figures = dict[PatientId, dict[SessionId, SessionProgress]]

_KNOWN: Final[WeakKeyDictionary[SqlStore, _Figures]] = WeakKeyDictionary()
_LOCK: Final = threading.Lock()


def figures(store: SqlStore, patient: PatientId) -> tuple[ExerciseProgress, ...]:
    """A patient's progress in each exercise, by name: the same as `coaching.progress.progress`."""
    played: dict[str, list[SessionProgress]] = {}
    for session in store.sessions(patient):
        played.setdefault(session.exercise, []).append(_figures_of(store, session))
    return tuple(ExerciseProgress(name, tuple(played[name])) for name in sorted(played))


def forget(store: SqlStore, patient: PatientId) -> None:
    """Let nothing be left of a patient who is erased."""
    with _LOCK:
        _KNOWN.get(store, {}).pop(patient, None)


def _figures_of(store: SqlStore, session: StoredSession) -> SessionProgress:
    with _LOCK:
        known = _KNOWN.get(store, {}).get(session.patient, {}).get(session.session)
    if known is not None:
        return known
    found = of_session(session, store.events.entries(session.session))
    if session.ended_utc is not None:
        with _LOCK:
            _KNOWN.setdefault(store, {}).setdefault(session.patient, {})[session.session] = found
    return found
