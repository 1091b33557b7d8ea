"""The record as files for other programs: pseudonyms only, and only of whom the visitor sees.

A record may be larger than the memory, so files are written to the disk first and sent from there.
"""

from __future__ import annotations

import io
import tempfile
import zipfile
from collections.abc import Iterator, Sequence
from enum import Enum
from pathlib import Path
from typing import IO, Final, assert_never, cast

from maestra.coaching.ports import PatientId, Store
from maestra.storage.exports.bids import write_bids
from maestra.storage.exports.rows import Row, rows
from maestra.storage.exports.tables import write_csv, write_json_lines
from maestra.storage.exports.xes import write_xes

IN_MEMORY: Final = 1_000_000
"""Bytes of a file that stay in memory."""
A_PIECE: Final = 64 * 1024
"""Bytes that are sent at a time."""


class Form(Enum):
    """What the record can be written as."""

    CSV = "csv"
    JSONL = "jsonl"
    BIDS = "bids"
    XES = "xes"

    @property
    def file_name(self) -> str:
        """What the file is called that is sent."""
        return "maestra-bids.zip" if self is Form.BIDS else f"maestra.{self.value}"

    @property
    def media_type(self) -> str:
        """What kind of file it is."""
        return _MEDIA_TYPES[self]


_MEDIA_TYPES: Final = {
    Form.CSV: "text/csv; charset=utf-8",
    Form.JSONL: "application/jsonl",
    Form.BIDS: "application/zip",
    Form.XES: "application/xml",
}


def exported(store: Store, patients: Sequence[PatientId], form: Form) -> IO[bytes]:
    """The file, at its beginning; who takes it closes it."""
    found = (row for patient in patients for row in rows(store, patient))
    # Closed by whoever sends it.
    file = cast("IO[bytes]", tempfile.SpooledTemporaryFile(IN_MEMORY))  # noqa: SIM115
    try:
        _write(found, form, file)
    except BaseException:
        file.close()
        raise
    file.seek(0)
    return file


def pieces(file: IO[bytes]) -> Iterator[bytes]:
    """The file piece by piece; it is closed at the end."""
    with file:
        while piece := file.read(A_PIECE):
            yield piece


def _write(found: Iterator[Row], form: Form, file: IO[bytes]) -> None:
    match form:
        case Form.BIDS:
            with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(file, "w") as packed:
                write_bids(found, Path(folder))
                for path in sorted(Path(folder).rglob("*")):
                    packed.write(path, path.relative_to(folder))
        case Form.CSV | Form.JSONL | Form.XES:
            text = io.TextIOWrapper(file, "utf-8", newline="")
            match form:
                case Form.CSV:
                    write_csv(found, text)
                case Form.JSONL:
                    write_json_lines(found, text)
                case Form.XES:
                    write_xes(found, text)
                case _:
                    assert_never(form)
            text.detach()
        case _:
            assert_never(form)
