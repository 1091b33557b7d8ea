"""Who may use Maestra: accounts, who is logged in, and devices with their tokens.

Of passwords, cookies and tokens only digests are kept; names and second factors are sealed with a
key of the account's own. What may be done with them is decided in `web/access`.
"""

import json
import unicodedata
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, replace
from typing import Any, Final

from sqlalchemy import Connection, Row, delete, insert, select, update

from maestra.coaching.ports import PatientId
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.text import faults_of_name
from maestra.storage.custody import SubjectOf, Write, pseudonym
from maestra.storage.database import Database
from maestra.storage.tables import ACCOUNTS, DEVICES, LOGINS
from maestra.storage.vault import SubjectId, Vault

_ABOUT: Final = "account"


@dataclass(frozen=True, slots=True)
class Account:
    """Somebody who may log in."""

    account: str
    """Random; empty until it is kept."""
    name: str
    role: str
    language: str
    password: str
    """Its Argon2id hash, parameters and salt included."""
    temporary_until_ms: int | None = None
    """Set while the password is one that somebody else made, to be changed before this."""
    secret: str | None = None
    """The second factor's (base32), if there is one."""
    offered_secret: str | None = None
    """One that was shown, and is not yet confirmed by a code."""
    last_step: int = 0
    """The step of the newest code that was used: no code counts twice."""
    is_disabled: bool = False


@dataclass(frozen=True, slots=True)
class Login:
    """Somebody, or a patient's screen, that is logged in."""

    digest: str
    """SHA-256 of what the browser holds."""
    kind: str
    holder: str
    """An account's or a device's id."""
    begun_ms: int
    used_ms: int


@dataclass(frozen=True, slots=True)
class Device:
    """A program or a screen with a token of its own."""

    device: str
    digest: str
    """SHA-256 of its token."""
    kind: str
    label: str
    room: str | None
    """The one room that a board or a robot may join."""
    patient: PatientId | None
    """The one patient whom a screen shows."""
    pin: str | None
    """The hash of the PIN that opens a patient's screen."""
    account: str
    """Who made it."""
    made_ms: int


class AccessStore:
    """Accounts, logins and devices in a database."""

    def __init__(
        self,
        database: Database,
        vault: Vault,
        write: Write,
        subject_of: SubjectOf,
    ) -> None:
        """Read from `database`; change it through `write`."""
        self._database = database
        self._vault = vault
        self._write = write
        self._subject_of = subject_of

    # ------------------------------------------------------------ accounts

    def add_account(self, account: Account, *, only_if_first: bool = False) -> Account:
        """Keep a new account; returns it with its id.

        Raises:
            InvalidError: the name cannot be one, or is taken, or there are accounts already.
        """
        refuse(faults_of_name("name", account.name))

        def add(connection: Connection) -> Account:
            if only_if_first and connection.execute(select(ACCOUNTS.c.account)).first():
                raise InvalidError([Fault("account", "not the first one", "none before it")])
            if self._by_name(connection, account.name) is not None:
                raise InvalidError([Fault("name", "taken", "another name")])
            kept = replace(account, account=self._vault.new_subject())
            row = {
                "account": kept.account,
                "tag": self._tag(kept.name),
                "sealed": self._seal(kept),
            }
            connection.execute(insert(ACCOUNTS).values(row))
            return kept

        made: Account = self._write(add)
        return made

    def change_account(self, account: str, change: Callable[[Account], Account]) -> Account:
        """Keep what `change` makes of an account, with nobody changing it in between.

        Raises:
            KeyError: there is no such account.
            InvalidError: the new name cannot be one, or is taken.
        """

        def keep(connection: Connection) -> Account:
            changed = change(self._account(connection, account))
            refuse(faults_of_name("name", changed.name))
            other = self._by_name(connection, changed.name)
            if other is not None and other.account != account:
                raise InvalidError([Fault("name", "taken", "another name")])
            row = {"tag": self._tag(changed.name), "sealed": self._seal(changed)}
            connection.execute(update(ACCOUNTS).where(ACCOUNTS.c.account == account).values(row))
            return changed

        kept: Account = self._write(keep)
        return kept

    def account(self, account: str) -> Account:
        """An account by its id.

        Raises:
            KeyError: there is none.
        """
        with self._database.reading() as connection:
            return self._account(connection, account)

    def account_named(self, name: str) -> Account | None:
        """An account by its name, however its letters are written."""
        with self._database.reading() as connection:
            return self._by_name(connection, name)

    def accounts(self) -> tuple[Account, ...]:
        """All of them, by name."""
        with self._database.reading() as connection:
            rows = connection.execute(select(ACCOUNTS)).all()
        found = [self._unsealed(row) for row in rows]
        return tuple(sorted(found, key=lambda one: one.name.casefold()))

    def has_accounts(self) -> bool:
        """Whether anybody can log in at all."""
        with self._database.reading() as connection:
            return connection.execute(select(ACCOUNTS.c.account)).first() is not None

    # ------------------------------------------------------------ logins

    def add_login(self, login: Login) -> None:
        """Let whoever holds what was digested be logged in."""
        self._execute(insert(LOGINS).values(asdict(login)))

    def login(self, digest: str) -> Login | None:
        """Whose this is; how long it counts is for the caller to say."""
        with self._database.reading() as connection:
            query = select(LOGINS).where(LOGINS.c.digest == digest)
            row = connection.execute(query).one_or_none()
        return None if row is None else Login(*row)

    def logins(self, holder: str) -> tuple[Login, ...]:
        """All of one holder, the newest first."""
        query = select(LOGINS).where(LOGINS.c.holder == holder)
        with self._database.reading() as connection:
            rows = connection.execute(query.order_by(LOGINS.c.begun_ms.desc())).all()
        return tuple(Login(*row) for row in rows)

    def use_login(self, digest: str, now_ms: int) -> None:
        """Remember that it was used; one that has ended stays so."""
        self._execute(update(LOGINS).where(LOGINS.c.digest == digest).values(used_ms=now_ms))

    def end_login(self, digest: str) -> None:
        """End it now."""
        self._execute(delete(LOGINS).where(LOGINS.c.digest == digest))

    def end_logins(self, holder: str, *, but: str = "") -> None:
        """End all of one holder's, but for one."""
        ended = (LOGINS.c.holder == holder) & (LOGINS.c.digest != but)
        self._execute(delete(LOGINS).where(ended))

    def forget_logins(
        self, kinds: Iterable[str], begun_before_ms: int, used_before_ms: int
    ) -> None:
        """Remove those of some kinds that are too old or too long unused to count any more."""
        is_over = (LOGINS.c.begun_ms < begun_before_ms) | (LOGINS.c.used_ms < used_before_ms)
        self._execute(delete(LOGINS).where(LOGINS.c.kind.in_(tuple(kinds)) & is_over))

    # ------------------------------------------------------------ devices

    def add_device(self, device: Device) -> None:
        """Let whoever holds its token in.

        Raises:
            KeyError: nobody has the patient's pseudonym.
            InvalidError: its label or room cannot be printed.
        """
        refuse(faults_of_name("label", device.label))
        if device.room is not None:
            refuse(faults_of_name("room", device.room))

        def add(connection: Connection) -> None:
            row = asdict(device)
            patient = row.pop("patient")
            row["subject"] = None if patient is None else self._subject_of(connection, patient)
            connection.execute(insert(DEVICES).values(row))

        self._write(add)

    def device_with(self, digest: str) -> Device | None:
        """Whose token this is the digest of."""
        return self._one_device(DEVICES.c.digest == digest)

    def device(self, device: str) -> Device | None:
        """A device by its id."""
        return self._one_device(DEVICES.c.device == device)

    def devices(self) -> tuple[Device, ...]:
        """All of them, the newest first."""
        with self._database.reading() as connection:
            rows = connection.execute(select(DEVICES).order_by(DEVICES.c.made_ms.desc())).all()
            return tuple(self._as_device(connection, row) for row in rows)

    def remove_device(self, device: str) -> None:
        """Refuse its token from now on, and end what it has open."""

        def remove(connection: Connection) -> None:
            connection.execute(delete(DEVICES).where(DEVICES.c.device == device))
            connection.execute(delete(LOGINS).where(LOGINS.c.holder == device))

        self._write(remove)

    # ------------------------------------------------------------ within

    def _execute(self, statement: Any) -> None:  # noqa: ANN401 - an insert, update or delete
        def execute(connection: Connection) -> None:
            connection.execute(statement)

        self._write(execute)

    def _tag(self, name: str) -> str:
        return self._vault.tag("account", unicodedata.normalize("NFKC", name).strip().casefold())

    def _seal(self, account: Account) -> bytes:
        contents = json.dumps(asdict(account)).encode()
        return self._vault.seal(SubjectId(account.account), contents, _ABOUT)

    def _unsealed(self, row: Row[Any]) -> Account:
        contents = self._vault.unseal(SubjectId(row.account), row.sealed, _ABOUT)
        return Account(**json.loads(contents))

    def _account(self, connection: Connection, account: str) -> Account:
        query = select(ACCOUNTS).where(ACCOUNTS.c.account == account)
        row = connection.execute(query).one_or_none()
        if row is None:
            raise KeyError(account)
        return self._unsealed(row)

    def _by_name(self, connection: Connection, name: str) -> Account | None:
        query = select(ACCOUNTS).where(ACCOUNTS.c.tag == self._tag(name))
        row = connection.execute(query).one_or_none()
        return None if row is None else self._unsealed(row)

    def _one_device(self, which: Any) -> Device | None:  # noqa: ANN401 - a condition
        with self._database.reading() as connection:
            row = connection.execute(select(DEVICES).where(which)).one_or_none()
            return None if row is None else self._as_device(connection, row)

    def _as_device(self, connection: Connection, row: Row[Any]) -> Device:
        patient = None if row.subject is None else pseudonym(connection, self._vault, row.subject)
        return Device(
            row.device,
            row.digest,
            row.kind,
            row.label,
            row.room,
            patient,
            row.pin,
            row.account,
            row.made_ms,
        )
