"""The rows as CSV (RFC 4180) and as JSON Lines."""

import csv
import json
from collections.abc import Iterable
from dataclasses import astuple, fields
from typing import IO, Final

from maestra.storage.exports.rows import Row

COLUMNS: Final = tuple(one.name for one in fields(Row))


def write_csv(rows: Iterable[Row], file: IO[str]) -> int:
    """Write a header and the rows; returns how many. What does not apply is empty."""
    writer = csv.writer(file)
    writer.writerow(COLUMNS)
    count = 0
    for row in rows:
        writer.writerow(astuple(row))
        count += 1
    return count


def write_json_lines(rows: Iterable[Row], file: IO[str]) -> int:
    """Write one object a line; returns how many. `detail` is JSON within, no longer text."""
    count = 0
    for row in rows:
        value = dict(zip(COLUMNS, astuple(row), strict=True))
        value["detail"] = json.loads(row.detail)
        file.write(json.dumps(value, ensure_ascii=False) + "\n")
        count += 1
    return count
