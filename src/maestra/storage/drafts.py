"""Exercises that are being taught, each an account's own, and the pictures on tokens."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from hashlib import sha256
from types import MappingProxyType
from typing import NewType

from sqlalchemy import Connection, delete, insert, select, update

from maestra.storage.store import SqlStore
from maestra.storage.tables import DRAFTS, PICTURES, SHOWN_PICTURES

DraftId = NewType("DraftId", str)
Digest = NewType("Digest", str)
"""The SHA-256 of a picture's bytes, in hexadecimal."""


@dataclass(frozen=True, slots=True)
class StoredDraft:
    """An exercise that is being taught, as it was left."""

    draft: DraftId
    account: str
    """Whose it is."""
    version: int
    """From 1; each change makes the next one."""
    changed_utc: str
    content: str


@dataclass(frozen=True, slots=True)
class StoredPicture:
    """A picture."""

    media_type: str
    content: bytes


class OutdatedError(Exception):
    """Somebody changed it meanwhile."""


class Drafts:
    """The drafts and pictures of a store."""

    def __init__(self, store: SqlStore) -> None:
        """Read and write in `store`."""
        self._store = store

    def add(self, new: StoredDraft) -> None:
        """Keep a draft that was not there."""
        self._store.write(lambda one: one.execute(insert(DRAFTS).values(asdict(new))))

    def change(self, changed: StoredDraft) -> None:
        """Keep a draft instead of the version before it.

        Raises:
            OutdatedError: another version is kept, or none any more.
        """

        def change(connection: Connection) -> None:
            before = (DRAFTS.c.draft == changed.draft) & (DRAFTS.c.version == changed.version - 1)
            done = connection.execute(update(DRAFTS).where(before).values(asdict(changed)))
            if done.rowcount != 1:
                raise OutdatedError(changed.draft)

        self._store.write(change)

    def draft(self, draft: DraftId) -> StoredDraft:
        """A draft.

        Raises:
            KeyError: there is none.
        """
        with self._store.database.reading() as connection:
            query = select(DRAFTS).where(DRAFTS.c.draft == draft)
            found = connection.execute(query).one_or_none()
        if found is None:
            raise KeyError(draft)
        return StoredDraft(*found)

    def of(self, account: str) -> tuple[StoredDraft, ...]:
        """The drafts of an account, the one that was changed last first."""
        query = select(DRAFTS).where(DRAFTS.c.account == account)
        with self._store.database.reading() as connection:
            found = [StoredDraft(*row) for row in connection.execute(query)]
        return tuple(sorted(found, key=lambda one: (one.changed_utc, one.draft), reverse=True))

    def delete(self, draft: DraftId) -> None:
        """Forget a draft."""
        query = delete(DRAFTS).where(DRAFTS.c.draft == draft)
        self._store.write(lambda one: one.execute(query))

    # ------------------------------------------------------------ pictures

    def keep_picture(self, picture: StoredPicture) -> Digest:
        """Keep a picture, once however often it is given; returns what it is found by."""
        digest = Digest(sha256(picture.content).hexdigest())

        def keep(connection: Connection) -> None:
            known = select(PICTURES.c.digest).where(PICTURES.c.digest == digest)
            if connection.scalar(known) is None:
                row = {"digest": digest, **asdict(picture)}
                connection.execute(insert(PICTURES).values(row))

        self._store.write(keep)
        return digest

    def picture(self, digest: Digest) -> StoredPicture:
        """A picture.

        Raises:
            KeyError: there is none.
        """
        query = select(PICTURES.c.media_type, PICTURES.c.content)
        with self._store.database.reading() as connection:
            found = connection.execute(query.where(PICTURES.c.digest == digest)).one_or_none()
        if found is None:
            raise KeyError(digest)
        return StoredPicture(*found)

    def save_shown(self, exercise: str, version: int, shown: Mapping[str, Digest]) -> None:
        """Keep which pictures the tokens of a version of an exercise show, instead of before."""

        def save(connection: Connection) -> None:
            own = (SHOWN_PICTURES.c.exercise == exercise) & (SHOWN_PICTURES.c.version == version)
            connection.execute(delete(SHOWN_PICTURES).where(own))
            for value, digest in shown.items():
                row = {"exercise": exercise, "version": version}
                row |= {"value": value, "digest": digest}
                connection.execute(insert(SHOWN_PICTURES).values(row))

        self._store.write(save)

    def shown(self, exercise: str, version: int) -> Mapping[str, Digest]:
        """What tokens of a version of an exercise show under `picture`, each with its picture."""
        query = select(SHOWN_PICTURES.c.value, SHOWN_PICTURES.c.digest).where(
            (SHOWN_PICTURES.c.exercise == exercise) & (SHOWN_PICTURES.c.version == version)
        )
        with self._store.database.reading() as connection:
            found = {row.value: Digest(row.digest) for row in connection.execute(query)}
        return MappingProxyType(found)
