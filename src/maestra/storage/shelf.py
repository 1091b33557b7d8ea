"""The library's own facts: an exercise's title, whether it is there, where versions come from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from sqlalchemy import Connection, delete, insert, select

from maestra.coaching.ports import StoredExercise
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.text import faults_of_name
from maestra.storage.store import SqlStore, keep_exercise
from maestra.storage.tables import EXERCISES, SHELF, SOURCES


@dataclass(frozen=True, slots=True)
class Source:
    """Where a version of an exercise comes from."""

    origin: str
    """How it came: the library's word for it."""
    account: str | None
    """Whose doing it was; None for what Maestra brought along."""
    utc: str


class Shelf:
    """Titles, removals and sources of a store's exercises."""

    def __init__(self, store: SqlStore) -> None:
        """Read and write in `store`."""
        self._store = store

    def keep(self, name: str, exercise: str, demonstrations: str, source: Source) -> int:
        """Keep a new version of an exercise with its source; returns its number.

        What equals the latest version makes no new one, and keeps its source.
        """
        refuse(faults_of_name("name", name))

        def keep(connection: Connection) -> int:
            version = keep_exercise(connection, name, exercise, demonstrations)
            here = (SOURCES.c.name == name) & (SOURCES.c.version == version)
            if connection.execute(select(SOURCES.c.name).where(here)).first() is None:
                row = {"name": name, "version": version, "origin": source.origin}
                row |= {"account": source.account, "utc": source.utc}
                connection.execute(insert(SOURCES).values(row))
            return version

        return self._store.write(keep)

    def versions(self, name: str) -> tuple[StoredExercise, ...]:
        """All versions of an exercise, the newest first, also of one that was removed.

        Raises:
            KeyError: there is none.
        """
        query = select(EXERCISES).where(EXERCISES.c.name == name)
        with self._store.database.reading() as connection:
            rows = connection.execute(query.order_by(EXERCISES.c.version.desc())).all()
        if not rows:
            raise KeyError(name)
        return tuple(StoredExercise(*row) for row in rows)

    def names(self) -> frozenset[str]:
        """The names of all exercises, also of those that were removed."""
        with self._store.database.reading() as connection:
            return frozenset(connection.scalars(select(EXERCISES.c.name).distinct()))

    def sources(self) -> Mapping[tuple[str, int], Source]:
        """The sources that are known, by name and version."""
        with self._store.database.reading() as connection:
            rows = connection.execute(select(SOURCES)).all()
        found = {(row.name, row.version): Source(row.origin, row.account, row.utc) for row in rows}
        return MappingProxyType(found)

    def titles(self) -> Mapping[str, str]:
        """The titles of those that have another one than their name."""
        query = select(SHELF.c.name, SHELF.c.title).where(SHELF.c.title.is_not(None))
        with self._store.database.reading() as connection:
            found = {row.name: row.title for row in connection.execute(query)}
        return MappingProxyType(found)

    def removed(self) -> Mapping[str, str]:
        """The names of those that were removed, each with when."""
        query = select(SHELF.c.name, SHELF.c.removed_utc)
        with self._store.database.reading() as connection:
            rows = connection.execute(query.where(SHELF.c.removed_utc.is_not(None))).all()
        return MappingProxyType({row.name: row.removed_utc for row in rows})

    def retitle(self, name: str, title: str) -> None:
        """Call an exercise so; its name stays, for sessions and patients know it by that.

        Raises:
            KeyError: there is none.
            InvalidError: the title cannot be one, or another exercise of the library has it.
        """
        refuse(faults_of_name("title", title))

        def change(connection: Connection) -> None:
            others = {
                row.title or row.name
                for row in connection.execute(_SHOWN)
                if row.name != name and row.removed_utc is None
            }
            if title in others:
                raise InvalidError([Fault("title", "taken", "another title")])
            self._mark(connection, name, title=title)

        self._store.write(change)

    def remove(self, name: str, utc: str) -> None:
        """Take an exercise from the library; its versions stay for the sessions played with it.

        Raises:
            KeyError: there is none.
        """
        self._store.write(lambda one: self._mark(one, name, removed_utc=utc))

    def restore(self, name: str) -> None:
        """Put an exercise back into the library.

        Raises:
            KeyError: there is none.
        """
        self._store.write(lambda one: self._mark(one, name, removed_utc=None))

    def _mark(self, connection: Connection, name: str, **changed: str | None) -> None:
        known = select(EXERCISES.c.name).where(EXERCISES.c.name == name)
        if connection.execute(known).first() is None:
            raise KeyError(name)
        here = SHELF.c.name == name
        before = connection.execute(select(SHELF).where(here)).one_or_none()
        row = {"name": name, "title": None, "removed_utc": None}
        if before is not None:
            row |= {"title": before.title, "removed_utc": before.removed_utc}
        connection.execute(delete(SHELF).where(here))
        connection.execute(insert(SHELF).values({**row, **changed}))


_SHOWN: Final = (
    select(EXERCISES.c.name, SHELF.c.title, SHELF.c.removed_utc)
    .outerjoin(SHELF, SHELF.c.name == EXERCISES.c.name)
    .distinct()
)
