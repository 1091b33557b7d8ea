"""The record of events: appended, sealed, chained, signed."""

import contextlib
import json
from collections.abc import Callable, Generator, Iterator, Sequence
from datetime import UTC, datetime
from typing import Final, TypeAlias

from sqlalchemy import Connection, Row, bindparam, func, insert, select

from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import Entry, NewEntry, SessionId
from maestra.core.faults import Fault, InvalidError
from maestra.storage.chain import (
    GENESIS,
    Head,
    HeadKind,
    Link,
    SignedHead,
    Verification,
    digest_after,
    read_head,
    verify,
)
from maestra.storage.database import Database
from maestra.storage.tables import EVENTS, SESSIONS
from maestra.storage.vault import KeyDestroyedError, SubjectId, Vault
from maestra.storage.writer import Writer

_AT_ONCE: Final = 1_000
"""Rows that are read at a time."""

_End: TypeAlias = tuple[int, bytes]
"""Where the record ends: sequence and digest of the last event."""

# Put together once: that takes longer than what they ask of the database.
_KNOWN: Final = select(EVENTS).where(EVENTS.c.key_tag == bindparam("key"))
_WHOSE: Final = select(SESSIONS.c.subject).where(SESSIONS.c.tag == bindparam("session"))
_LAST: Final = select(EVENTS.c.sequence, EVENTS.c.digest).where(
    EVENTS.c.sequence == select(func.max(EVENTS.c.sequence)).scalar_subquery()
)
_KEEP: Final = insert(EVENTS)


class Signer:
    """Signs how far the record goes, after each transaction that made it longer."""

    def __init__(self, vault: Vault) -> None:
        """Go on where the last head is."""
        self._vault = vault
        self._signed = 0
        # A spoilt file of heads keeps nobody from playing; `verify` tells of it.
        with contextlib.suppress(IndexError, ValueError):
            self._signed = read_head(vault.heads()[-1]).head.sequence
        self._kind = HeadKind.RECOVERED

    def closing(self, connection: Connection) -> Callable[[], None]:
        """What to do after the commit of the transaction that ends here."""
        sequence, digest = tail(connection)
        return lambda: self._sign(sequence, digest)

    def begin(self) -> None:
        """Say that the store is begun, with nothing in it."""
        self._vault.add(self._vault.sign(self._head(HeadKind.BEGUN, 0, GENESIS)))

    def started(self) -> None:
        """From now on what is signed has been written by this program."""
        self._kind = HeadKind.WRITTEN

    def restored(self, connection: Connection) -> SignedHead:
        """A head that says that the record ends here because a backup was restored."""
        return self._vault.sign(self._head(HeadKind.RESTORED, *tail(connection)))

    def _sign(self, sequence: int, digest: bytes) -> None:
        if sequence > self._signed:
            self._vault.add(self._vault.sign(self._head(self._kind, sequence, digest)))
            self._signed = sequence

    def _head(self, kind: HeadKind, sequence: int, digest: bytes) -> Head:
        return Head(self._vault.store, kind, sequence, digest, datetime.now(UTC).isoformat())


class Record:
    """The events of a store; coaching's `EventStore`."""

    def __init__(self, database: Database, vault: Vault, writer: Writer | None) -> None:
        """Read from `database`; append through `writer`, if there is one."""
        self._database = database
        self._vault = vault
        self._writer = writer

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        """Keep them, all or none; when this returns they are on the disk, and signed.

        Raises:
            OSError: they cannot be kept.
            KeyError: the session has not been saved, so that nobody knows whose it is.
            InvalidError: a key was used before for something else.
        """
        writer = demand_writer(self._writer, self._database)
        return writer.run(lambda connection: self._append_all(connection, entries))

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        """What has been kept, of one session or of all, in order.

        Those of erased patients are left out: nobody can read them.
        """
        with self._database.reading() as connection:
            query = select(EVENTS).order_by(EVENTS.c.sequence)
            if session is not None:
                query = query.where(EVENTS.c.session_tag == session_tag(self._vault, session))
            with connection.execute(query.execution_options(yield_per=_AT_ONCE)) as rows:
                for row in rows:
                    entry = self._entry(row)
                    if entry is not None:
                        yield entry

    def verify(self) -> Verification:
        """Whether the record is what was written, up to the last signed head."""
        with (
            self._database.reading() as connection,
            contextlib.closing(links(connection)) as found,
        ):
            return verify(found, self._vault.heads(), self._vault.store, self._vault.check)

    def note(self, connection: Connection, kind: str, payload: str) -> None:
        """Keep something that belongs to no session, within a transaction of the writer."""
        end = tail(connection)
        entry = NewEntry(
            SessionId(""),
            f"{kind} {end[0] + 1}",
            Milliseconds(0),
            datetime.now(UTC).isoformat(),
            kind,
            payload,
        )
        self._append(connection, entry, None, end)

    def _append_all(
        self, connection: Connection, entries: Sequence[NewEntry]
    ) -> tuple[Entry, ...]:
        subjects = {one.session: self._subject(connection, one.session) for one in entries}
        end, kept = tail(connection), list[Entry]()
        for one in entries:
            entry, end = self._append(connection, one, subjects[one.session], end)
            kept.append(entry)
        return tuple(kept)

    def _append(
        self, connection: Connection, entry: NewEntry, subject: SubjectId | None, end: _End
    ) -> tuple[Entry, _End]:
        """Keep it after `end`, unless it is there already; and where the record ends now."""
        key_tag = self._vault.tag("entry", subject or "", entry.session, entry.key)
        known = connection.execute(_KNOWN, {"key": key_tag}).one_or_none()
        if known is not None:
            return self._same(known, entry), end
        sequence, previous = end
        contents = json.dumps([entry.session, entry.key, entry.kind, entry.payload]).encode()
        link = Link(
            sequence + 1,
            session_tag(self._vault, entry.session),
            key_tag,
            subject,
            entry.at,
            entry.utc,
            self._vault.seal(subject, contents, f"event {key_tag}"),
            b"",
        )
        digest = digest_after(previous, link)
        row = {name: getattr(link, name) for name in Link.__slots__}
        connection.execute(_KEEP, {**row, "digest": digest})
        return _kept(entry, link.sequence), (link.sequence, digest)

    def _same(self, known: Row[tuple[object, ...]], entry: NewEntry) -> Entry:
        kept = self._entry(known)
        if kept is None or kept != _kept(entry, kept.sequence):
            raise InvalidError(
                [Fault("key", f"{entry.key}, used for something else before", "a new key")]
            )
        return kept

    def _subject(self, connection: Connection, session: SessionId) -> SubjectId | None:
        tag = session_tag(self._vault, session)
        found = connection.execute(_WHOSE, {"session": tag}).one_or_none()
        if found is None:
            raise KeyError(session)
        return None if found.subject is None else SubjectId(found.subject)

    def _entry(self, row: Row[tuple[object, ...]]) -> Entry | None:
        try:
            contents = self._vault.unseal(row.subject, row.sealed, f"event {row.key_tag}")
        except KeyDestroyedError:
            return None
        session, key, kind, payload = json.loads(contents)
        return Entry(session, key, Milliseconds(row.at_ms), row.utc, kind, payload, row.sequence)


def session_tag(vault: Vault, session: SessionId) -> str:
    """What stands for a session in the tables."""
    return vault.tag("session", session)


def tail(connection: Connection) -> _End:
    """Sequence and digest of the last event; 0 and `GENESIS` where there is none."""
    found = connection.execute(_LAST).one_or_none()
    return (0, GENESIS) if found is None else (found.sequence, found.digest)


def links(connection: Connection) -> Generator[Link]:
    """All events, as the chain sees them."""
    query = select(EVENTS).order_by(EVENTS.c.sequence)
    with connection.execute(query.execution_options(yield_per=_AT_ONCE)) as rows:
        for row in rows:
            yield Link(*row)  # its fields are the columns


def demand_writer(writer: Writer | None, database: Database) -> Writer:
    """The writer.

    Raises:
        OSError: the record was opened to be read only.
    """
    if writer is None:
        raise OSError(None, "opened to be read only", database.name)
    return writer


def _kept(entry: NewEntry, sequence: int) -> Entry:
    return Entry(
        entry.session, entry.key, entry.at, entry.utc, entry.kind, entry.payload, sequence
    )
