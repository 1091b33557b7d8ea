"""Which account cares for which patient, and the audit: who did what, to whom, when.

No pseudonym stands in these tables: a patient is the random number that only the record's keys
turn into a pseudonym, and after erasing nothing does.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias, cast

from sqlalchemy import Connection, Row, delete, func, insert, select

from maestra.coaching.ports import PatientId
from maestra.core.faults import Fault, InvalidError
from maestra.storage.database import Database
from maestra.storage.tables import AUDIT, CAREGIVERS, PATIENTS
from maestra.storage.vault import KeyDestroyedError, SubjectId, Vault

Write: TypeAlias = Callable[[Callable[[Connection], Any]], Any]
"""Does something in a transaction; what it returns, once that is on the disk."""
SubjectOf: TypeAlias = Callable[[Connection, PatientId], SubjectId]
"""The number that stands for a pseudonym; may raise KeyError."""


@dataclass(frozen=True, slots=True)
class Noted:
    """One line of the audit."""

    number: int
    utc: str
    account: str | None
    """Who; None for whoever was not logged in."""
    act: str
    patient: PatientId | None
    detail: str
    """What else tells which thing it was; holds no secret and no pseudonym."""


class CustodyStore:
    """Who cares for whom, and the audit."""

    def __init__(
        self,
        database: Database,
        vault: Vault,
        write: Write,
        subject_of: SubjectOf,
        subject_or_new: SubjectOf,
    ) -> None:
        """Read from `database`; change it through `write`."""
        self._database = database
        self._vault = vault
        self._write = write
        self._subject_of = subject_of
        self._subject_or_new = subject_or_new

    # ------------------------------------------------------------ caregivers

    def own(self, patient: PatientId, account: str) -> None:
        """Give an account a new patient, or one of its own again.

        Raises:
            InvalidError: the pseudonym cannot be one, or somebody else has such a patient.
        """

        def give(connection: Connection) -> None:
            is_known = self._is_known(connection, patient)
            subject = self._subject_or_new(connection, patient)
            if self._cares(connection, subject, account):
                return
            if is_known:
                raise InvalidError([Fault("patient", "a pseudonym that is taken", "another one")])
            connection.execute(insert(CAREGIVERS).values(subject=subject, account=account))

        self._write(give)

    def entrust(self, patient: PatientId, account: str) -> None:
        """Let an account care for a patient too.

        Raises:
            KeyError: nobody has this pseudonym.
        """

        def give(connection: Connection) -> None:
            subject = self._subject_of(connection, patient)
            if not self._cares(connection, subject, account):
                connection.execute(insert(CAREGIVERS).values(subject=subject, account=account))

        self._write(give)

    def release(self, patient: PatientId, account: str) -> None:
        """Let an account care for a patient no more.

        Raises:
            KeyError: nobody has this pseudonym.
        """

        def take(connection: Connection) -> None:
            subject = self._subject_of(connection, patient)
            which = (CAREGIVERS.c.subject == subject) & (CAREGIVERS.c.account == account)
            connection.execute(delete(CAREGIVERS).where(which))

        self._write(take)

    def cares(self, account: str, patient: PatientId) -> bool:
        """Whether an account cares for a patient.

        Raises:
            KeyError: nobody has this pseudonym.
        """
        with self._database.reading() as connection:
            return self._cares(connection, self._subject_of(connection, patient), account)

    def patients_of(self, account: str) -> tuple[PatientId, ...]:
        """For whom an account cares, in order."""
        query = select(CAREGIVERS.c.subject).where(CAREGIVERS.c.account == account)
        with self._database.reading() as connection:
            found = [
                pseudonym(connection, self._vault, subject)
                for subject in connection.scalars(query).all()
            ]
        return tuple(sorted(one for one in found if one is not None))

    # ------------------------------------------------------------ the audit

    def note(
        self, utc: str, account: str | None, act: str, patient: PatientId | None, detail: str
    ) -> None:
        """Keep a line; of a patient nobody knows, only that it was one."""

        def keep(connection: Connection) -> None:
            subject = None
            if patient is not None:
                try:
                    subject = self._subject_of(connection, patient)
                except KeyError:
                    subject = None
            number = 1 + (connection.scalar(select(func.max(AUDIT.c.number))) or 0)
            row = (number, utc, account, act, subject, detail)
            connection.execute(insert(AUDIT).values(row))

        self._write(keep)

    def audit(self, before: int | None = None, most: int = 100) -> tuple[Noted, ...]:
        """The newest lines, or the newest of those before a number."""
        query = select(AUDIT).order_by(AUDIT.c.number.desc()).limit(most)
        if before is not None:
            query = query.where(AUDIT.c.number < before)
        with self._database.reading() as connection:
            rows = connection.execute(query).all()
            return tuple(self._as_noted(connection, row) for row in rows)

    # ------------------------------------------------------------ within

    def _is_known(self, connection: Connection, patient: PatientId) -> bool:
        try:
            self._subject_of(connection, patient)
        except KeyError:
            return False
        return True

    def _cares(self, connection: Connection, subject: str, account: str) -> bool:
        which = (CAREGIVERS.c.subject == subject) & (CAREGIVERS.c.account == account)
        return connection.execute(select(CAREGIVERS.c.account).where(which)).first() is not None

    def _as_noted(self, connection: Connection, row: Row[Any]) -> Noted:
        patient = None if row.subject is None else pseudonym(connection, self._vault, row.subject)
        return Noted(row.number, row.utc, row.account, row.act, patient, row.detail)


def pseudonym(connection: Connection, vault: Vault, subject: str) -> PatientId | None:
    """Whom a number stands for; None after erasing."""
    query = select(PATIENTS.c.sealed).where(PATIENTS.c.subject == subject)
    sealed = cast("bytes | None", connection.scalar(query))
    if sealed is None:
        return None
    try:
        return PatientId(vault.unseal(SubjectId(subject), sealed, PATIENTS.name).decode())
    except KeyDestroyedError:
        return None
