"""One thread that writes: it takes all that waits, does it in one transaction, then answers all.

So the disk is asked to flush once for a group, not once for each event, and nobody is told that
something is kept before it is.
"""

import contextlib
import queue
import threading
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Final, Generic, TypeVar

from sqlalchemy import Connection
from sqlalchemy.exc import DBAPIError, InvalidRequestError

from maestra.storage.database import Database, as_os_error

MOST_TOGETHER: Final = 256
"""Jobs in one transaction, so that the first of a flood does not wait for the last."""

_Made = TypeVar("_Made")


@dataclass(frozen=True, slots=True)
class _Job(Generic[_Made]):
    do: Callable[[Connection], _Made]
    answer: "Future[_Made]"
    alone: bool

    def run(self, connection: Connection) -> Callable[[], None]:
        """Do it, undoing it alone if it refuses; what there is to answer once all is kept."""
        try:
            with connection.begin_nested():
                made = self.do(connection)
        except DBAPIError:
            raise
        except Exception as error:  # noqa: BLE001 - it is the caller's, who gets it
            refusal = error
            return lambda: self.answer.set_exception(refusal)
        return lambda: self.answer.set_result(made)


class Writer:
    """The one that writes to a database."""

    def __init__(
        self, database: Database, closing: Callable[[Connection], Callable[[], None]]
    ) -> None:
        """Start it.

        `closing` runs at the end of each transaction; what it returns, after the commit and
        before anybody is answered.

        Raises:
            InvalidError: another program is writing.
            OSError: the database cannot be reached.
        """
        self._database = database
        self._closing = closing
        self._waiting: queue.SimpleQueue[_Job[Any] | None] = queue.SimpleQueue()
        self._held: list[_Job[Any] | None] = []
        """Taken from the line, and to be done by itself next."""
        self._connection: Connection | None = database.writing()
        self._thread = threading.Thread(target=self._serve, name="maestra-writer", daemon=True)
        self._door = threading.Lock()
        """Nothing comes into the line after the end of it."""
        self._is_closed = False
        self._thread.start()

    def run(self, job: Callable[[Connection], _Made], *, alone: bool = False) -> _Made:
        """Do `job` in a transaction and wait until it is on the disk.

        With `alone`, in no transaction and with nothing beside it.

        Raises:
            OSError: it could not be kept, or nobody knows whether it was; nothing of it is
                acknowledged.
            Exception: whatever `job` raised, with nothing of it kept.
        """
        answer: Future[_Made] = Future()
        with self._door:
            if self._is_closed:
                raise OSError(None, "the record is closed", self._database.name)
            self._waiting.put(_Job(job, answer, alone))
        return answer.result()

    def close(self) -> None:
        """Do what waits, then stop."""
        with self._door:
            if self._is_closed:
                return
            self._is_closed = True
            self._waiting.put(None)
        self._thread.join()

    def _serve(self) -> None:
        while (group := self._next_group()) is not None:
            try:
                answers = self._do(group)
            except Exception as error:  # noqa: BLE001 - each of the group must hear of it
                self._forget_connection()
                for job in group:
                    job.answer.set_exception(self._said(error))
            else:
                for answer in answers:
                    answer()
        self._forget_connection()

    def _next_group(self) -> list[_Job[Any]] | None:
        """Whatever waits, at least one; None when it is time to stop."""
        first = self._held.pop() if self._held else self._waiting.get()
        if first is None:
            return None
        group = [first]
        while not first.alone and len(group) < MOST_TOGETHER:
            try:
                job = self._waiting.get_nowait()
            except queue.Empty:
                break
            if job is None or job.alone:
                self._held.append(job)
                break
            group.append(job)
        return group

    def _do(self, group: list[_Job[Any]]) -> list[Callable[[], None]]:
        connection = self._connected()
        if group[0].alone:
            made = group[0].do(connection)
            return [lambda: group[0].answer.set_result(made)]
        with connection.begin():
            answers = [job.run(connection) for job in group]
            after = self._closing(connection)
        after()
        return answers

    def _connected(self) -> Connection:
        if self._connection is None:
            self._connection = self._database.writing()
        return self._connection

    def _forget_connection(self) -> None:
        """After a failure nobody knows what the connection remembers: begin with a new one."""
        connection, self._connection = self._connection, None
        if connection is not None:
            with contextlib.suppress(DBAPIError, InvalidRequestError, OSError):
                connection.invalidate()
            with contextlib.suppress(DBAPIError, InvalidRequestError, OSError):
                connection.close()

    def _said(self, error: Exception) -> Exception:
        return as_os_error(error, self._database.name) if isinstance(error, DBAPIError) else error
