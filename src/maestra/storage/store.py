"""Everything that is kept, on either engine: coaching's `Store`, names, and erasing."""

import json
from collections.abc import Callable, Mapping
from dataclasses import asdict
from typing import Final, TypeVar

from sqlalchemy import Connection, Table, delete, func, insert, select, update

from maestra.coaching.ports import (
    Entry,
    PatientId,
    StoredExercise,
    StoredSession,
)
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.text import faults_of_name
from maestra.storage.access import AccessStore
from maestra.storage.chain import Verification
from maestra.storage.custody import CustodyStore
from maestra.storage.database import Database
from maestra.storage.formats import PATIENT_FORMAT
from maestra.storage.record import Record, Signer, demand_writer, session_tag
from maestra.storage.tables import (
    EXERCISES,
    NAMES,
    OF_A_PATIENT,
    PATIENTS,
    PLANS,
    SESSIONS,
    SETTINGS,
    SHELF,
)
from maestra.storage.vault import KeyDestroyedError, SubjectId, Vault
from maestra.storage.writer import Writer

NOBODY: Final = PatientId("")
"""Whose sessions are nobody's, as when an exercise is taught; what is kept of them is not sealed.
"""
ERASED: Final = "patient-erased"
"""The kind of the event that says that somebody was erased; names nobody."""


_Made = TypeVar("_Made")


class SqlStore:
    """Exercises, patients, settings, sessions and the record, in a database."""

    def __init__(self, database: Database, vault: Vault, *, writes: bool) -> None:
        """Open a database that `opening` has made ready.

        Raises:
            InvalidError: another program is writing.
            OSError: the database cannot be reached.
        """
        self._database = database
        self._vault = vault
        signer = Signer(vault)
        self._writer = Writer(database, signer.closing) if writes else None
        self._record = Record(database, vault, self._writer)
        self._access = AccessStore(database, vault, self._write, self._known)
        self._custody = CustodyStore(database, vault, self._write, self._known, self._known_or_new)
        if self._writer is not None:
            self._writer.run(lambda _: None)  # signs what a crash has left unsigned
            signer.started()

    @property
    def events(self) -> Record:
        """The record of events."""
        return self._record

    @property
    def access(self) -> AccessStore:
        """Accounts, logins and devices."""
        return self._access

    @property
    def custody(self) -> CustodyStore:
        """Who cares for whom, and the audit."""
        return self._custody

    @property
    def vault(self) -> Vault:
        """The keys."""
        return self._vault

    @property
    def database(self) -> Database:
        """Where it lies."""
        return self._database

    def close(self) -> None:
        """Finish writing and let go."""
        if self._writer is not None:
            self._writer.close()
        self._database.close()

    def verify(self) -> Verification:
        """Whether the record is what was written."""
        return self._record.verify()

    def write(self, job: Callable[[Connection], _Made]) -> _Made:
        """Do `job` in a transaction; what it wrote is on the disk when this returns.

        Raises:
            OSError: it could not be kept.
            Exception: whatever `job` raised, with nothing of it kept.
        """
        return self._write(job)

    # ------------------------------------------------------------ exercises

    def save_exercise(self, name: str, exercise: str, demonstrations: str = "") -> int:
        """Keep a new version; returns its number. What equals the latest makes no new one."""
        refuse(faults_of_name("name", name))
        return self._write(lambda one: keep_exercise(one, name, exercise, demonstrations))

    def exercise(self, name: str, version: int | None = None) -> StoredExercise:
        """A version of an exercise, the latest if none is named.

        Raises:
            KeyError: there is none.
        """
        with self._database.reading() as connection:
            return _exercise(connection, name, version)

    def exercises(self) -> tuple[StoredExercise, ...]:
        """The latest version of each in the library, by name."""
        removed = select(SHELF.c.name).where(SHELF.c.removed_utc.is_not(None))
        latest = (
            select(EXERCISES.c.name, func.max(EXERCISES.c.version).label("version"))
            .where(EXERCISES.c.name.not_in(removed))
            .group_by(EXERCISES.c.name)
            .subquery()
        )
        query = select(EXERCISES).join(
            latest,
            (EXERCISES.c.name == latest.c.name) & (EXERCISES.c.version == latest.c.version),
        )
        with self._database.reading() as connection:
            found = [StoredExercise(*row) for row in connection.execute(query)]
        return tuple(sorted(found, key=lambda one: one.name))

    # ------------------------------------------------------------ patients

    def save_settings(self, patient: PatientId, settings: str) -> None:
        """Keep a patient's settings (JSON); who is not known yet is then."""

        def save(connection: Connection) -> None:
            subject = self._known_or_new(connection, patient)
            self._put(connection, SETTINGS, subject, settings)

        self._write(save)

    def settings(self, patient: PatientId) -> str:
        """A patient's settings.

        Raises:
            KeyError: there are none.
        """
        return self._get(SETTINGS, patient)

    def patients(self) -> tuple[PatientId, ...]:
        """All pseudonyms, in order; of whom the key is lost, none is known."""
        with self._database.reading() as connection:
            rows = connection.execute(select(PATIENTS.c.subject, PATIENTS.c.sealed)).all()
        found = [self._readable(row.subject, row.sealed, PATIENTS) for row in rows]
        return tuple(sorted(PatientId(one) for one in found if one is not None))

    def save_name(self, patient: PatientId, name: str) -> None:
        """Keep who a pseudonym is, apart and sealed; who is not known yet is then."""
        refuse(faults_of_name("name", name))

        def save(connection: Connection) -> None:
            subject = self._known_or_new(connection, patient)
            self._put(connection, NAMES, subject, name)

        self._write(save)

    def name(self, patient: PatientId) -> str:
        """Who a pseudonym is.

        Raises:
            KeyError: nobody said.
        """
        return self._get(NAMES, patient)

    def save_plan(self, patient: PatientId, plan: str) -> None:
        """Keep what caregivers intend with a patient (JSON); who is not known yet is then."""

        def save(connection: Connection) -> None:
            subject = self._known_or_new(connection, patient)
            self._put(connection, PLANS, subject, plan)

        self._write(save)

    def plan(self, patient: PatientId) -> str:
        """What caregivers intend with a patient.

        Raises:
            KeyError: nothing yet.
        """
        return self._get(PLANS, patient)

    def erase(self, patient: PatientId) -> None:
        """Destroy a patient's key, forget who it was, and clean the database of what is left.

        The record keeps its events, which nobody can read any more, so its chain still holds.
        Broken off before the patient is forgotten, it can be done again.

        Raises:
            KeyError: nobody has this pseudonym.
            OSError: the patient is erased, but somebody is reading, so the files keep, sealed
                with the key that is no more, what was deleted; the next erasing cleans them.
        """
        writer = demand_writer(self._writer, self._database)
        subject = writer.run(lambda connection: self._known(connection, patient))
        # First, so that whatever goes wrong afterwards nothing can be read.
        self._vault.destroy(subject)

        def forget(connection: Connection) -> None:
            for table in OF_A_PATIENT:
                connection.execute(delete(table).where(table.c.subject == subject))
            self._record.note(connection, ERASED, json.dumps({"subject": subject}))

        writer.run(forget)
        writer.run(self._database.scrub, alone=True)

    def everything(self, patient: PatientId) -> dict[str, object]:
        """All that is kept of a patient, as JSON has it: what a patient may ask for.

        Raises:
            KeyError: nobody has this pseudonym.
        """
        with self._database.reading() as connection:
            self._known(connection, patient)
        sessions = self.sessions(patient)
        return {
            "format": PATIENT_FORMAT,
            "patient": patient,
            "name": self._perhaps(NAMES, patient),
            "settings": _parsed(self._perhaps(SETTINGS, patient)),
            "plan": _parsed(self._perhaps(PLANS, patient)),
            "sessions": [
                {**asdict(one), "settings": _parsed(one.settings), "events": self._told(one)}
                for one in sessions
            ],
        }

    # ------------------------------------------------------------ sessions

    def save_session(self, session: StoredSession) -> None:
        """Keep a session; one with its id is replaced, for it has ended.

        Raises:
            InvalidError: it would become another patient's.
        """
        tag = session_tag(self._vault, session.session)

        def save(connection: Connection) -> None:
            subject = (
                None
                if session.patient == NOBODY
                else self._known_or_new(connection, session.patient)
            )
            contents = json.dumps(asdict(session))
            sealed = self._vault.seal(subject, contents.encode(), f"session {tag}")
            known = connection.execute(
                select(SESSIONS.c.subject).where(SESSIONS.c.tag == tag)
            ).one_or_none()
            if known is None:
                row = {"tag": tag, "subject": subject, "sealed": sealed}
                connection.execute(insert(SESSIONS).values(row))
            elif known.subject != subject:
                raise InvalidError(
                    [Fault("session", "another patient's", "one of its own for each patient")]
                )
            else:
                connection.execute(
                    update(SESSIONS).where(SESSIONS.c.tag == tag).values(sealed=sealed)
                )

        self._write(save)

    def sessions(self, patient: PatientId | None = None) -> tuple[StoredSession, ...]:
        """The sessions of one patient or of all, the earliest first."""
        query = select(SESSIONS)
        with self._database.reading() as connection:
            if patient is not None and patient != NOBODY:
                try:
                    subject = self._known(connection, patient)
                except KeyError:
                    return ()
                query = query.where(SESSIONS.c.subject == subject)
            rows = connection.execute(query).all()
        found: list[StoredSession] = []
        for row in rows:
            try:
                contents = self._vault.unseal(row.subject, row.sealed, f"session {row.tag}")
            except KeyDestroyedError:
                continue
            session = StoredSession(**json.loads(contents))
            if patient is None or session.patient == patient:
                found.append(session)
        return tuple(sorted(found, key=lambda one: (one.begun_utc, one.session)))

    # ------------------------------------------------------------ within

    def _write(self, job: Callable[[Connection], _Made]) -> _Made:
        return demand_writer(self._writer, self._database).run(job)

    def _known(self, connection: Connection, patient: PatientId) -> SubjectId:
        tag = self._vault.tag("patient", patient)
        found = connection.scalar(select(PATIENTS.c.subject).where(PATIENTS.c.tag == tag))
        if found is None:
            raise KeyError(patient)
        return SubjectId(found)

    def _known_or_new(self, connection: Connection, patient: PatientId) -> SubjectId:
        try:
            return self._known(connection, patient)
        except KeyError:
            refuse(faults_of_name("patient", patient))
        subject = self._vault.new_subject()
        sealed = self._vault.seal(subject, patient.encode(), _about(PATIENTS))
        row = {
            "subject": subject,
            "tag": self._vault.tag("patient", patient),
            "sealed": sealed,
        }
        connection.execute(insert(PATIENTS).values(row))
        return subject

    def _put(self, connection: Connection, table: Table, subject: SubjectId, text: str) -> None:
        sealed = self._vault.seal(subject, text.encode(), _about(table))
        connection.execute(delete(table).where(table.c.subject == subject))
        connection.execute(insert(table).values(subject=subject, sealed=sealed))

    def _get(self, table: Table, patient: PatientId) -> str:
        with self._database.reading() as connection:
            subject = self._known(connection, patient)
            sealed = connection.scalar(select(table.c.sealed).where(table.c.subject == subject))
        if sealed is None:
            raise KeyError(patient)
        text = self._readable(subject, sealed, table)
        if text is None:
            raise KeyError(patient)
        return text

    def _perhaps(self, table: Table, patient: PatientId) -> str | None:
        try:
            return self._get(table, patient)
        except KeyError:
            return None

    def _readable(self, subject: SubjectId, sealed: bytes, table: Table) -> str | None:
        try:
            return self._vault.unseal(subject, sealed, _about(table)).decode()
        except KeyDestroyedError:
            return None

    def _told(self, session: StoredSession) -> list[Mapping[str, object]]:
        return [told(entry) for entry in self._record.entries(session.session)]


def keep_exercise(connection: Connection, name: str, exercise: str, demonstrations: str) -> int:
    """Keep a new version within a transaction; what was taken from the library is back there.

    What equals the latest version makes no new one. Returns the version's number.
    """
    connection.execute(update(SHELF).where(SHELF.c.name == name).values(removed_utc=None))
    try:
        latest = _exercise(connection, name, None)
    except KeyError:
        version = 1
    else:
        if (latest.exercise, latest.demonstrations) == (exercise, demonstrations):
            return latest.version
        version = latest.version + 1
    new = StoredExercise(name, version, exercise, demonstrations)
    connection.execute(insert(EXERCISES).values(asdict(new)))
    return version


def told(entry: Entry) -> dict[str, object]:
    """An event as JSON has it for others to read."""
    return {**asdict(entry), "payload": _parsed(entry.payload)}


def _parsed(text: str | None) -> object:
    return None if text is None else json.loads(text)


def _about(table: Table) -> str:
    return table.name


def _exercise(connection: Connection, name: str, version: int | None) -> StoredExercise:
    query = select(EXERCISES).where(EXERCISES.c.name == name)
    if version is not None:
        query = query.where(EXERCISES.c.version == version)
    found = connection.execute(query.order_by(EXERCISES.c.version.desc()).limit(1)).one_or_none()
    if found is None:
        raise KeyError(name)
    return StoredExercise(*found)
