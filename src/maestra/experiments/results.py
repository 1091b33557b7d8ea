"""Results kept as they come: a file of JSON Lines that a stopped experiment goes on with.

The first line says what is measured; each further one is a finished run, on the disk before the
next is begun to be written. A last line that was cut off is dropped. Two processes cannot write
to one file at a time.
"""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Generator, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Final, TypeAlias, cast

from maestra.core.faults import Fault, shorten
from maestra.core.json_lines import FormatError

RESULTS_FORMAT: Final = "maestra.experiment/1"

Record: TypeAlias = Mapping[str, object]


class ResultsFile:
    """The finished runs of one experiment, and a place for further ones."""

    def __init__(self, file: IO[bytes], records: list[Record]) -> None:
        self._file = file
        self.records = records
        """Those that were there, and those added."""

    def add(self, record: Record) -> None:
        """Keep one finished run: when this returns it is on the disk."""
        self._file.write(_line(record))
        self._file.flush()
        os.fsync(self._file.fileno())
        self.records.append(record)


@contextmanager
def open_results(path: Path, header: Record) -> Generator[ResultsFile]:
    """Open or begin the results of the experiment that `header` describes.

    Raises:
        FormatError: the file holds something else, or the results of other settings or another
            version, or another process is writing to it.
        OSError: it cannot be read or written.
    """
    wanted: Record = {"format": RESULTS_FORMAT, **header}
    with path.open("a+b") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            found, expected = "in use by another experiment", "a file of its own for each"
            raise FormatError(str(path), 1, (Fault("", found, expected),)) from None
        file.seek(0)
        lines = file.read().splitlines(keepends=True)
        if lines and not lines[-1].endswith(b"\n"):
            file.truncate(sum(map(len, lines[:-1])))
            del lines[-1]
        records = [_decode(line, path, number) for number, line in enumerate(lines, start=1)]
        results = ResultsFile(file, records[1:])
        if not records:
            file.write(_line(wanted))
        elif records[0] != wanted:
            raise FormatError(str(path), 1, tuple(_differences(records[0], wanted)))
        yield results


def _line(record: Record) -> bytes:
    return json.dumps(record, ensure_ascii=False).encode() + b"\n"


def _decode(line: bytes, path: Path, number: int) -> Record:
    try:
        record: object = json.loads(line)
    except ValueError:
        record = None
    if not isinstance(record, dict):
        raise FormatError(str(path), number, (Fault("", "no JSON object", "a result"),))
    return cast("Record", record)


def _differences(found: Record, wanted: Record) -> Iterator[Fault]:
    for name in dict.fromkeys((*wanted, *found)):
        if found.get(name) != wanted.get(name):
            missing = "missing" if name not in found else shorten(found[name])
            other = shorten(wanted[name]) if name in wanted else "no such field"
            yield Fault(name, missing, f"{other} as in this experiment")
