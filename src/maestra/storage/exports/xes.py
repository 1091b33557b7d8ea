"""The record as an event log for process mining: XES, IEEE 1849. A trace for each session."""

import json
from collections.abc import Iterable
from itertools import groupby
from typing import IO, Final
from xml.sax.saxutils import quoteattr

from maestra.storage.exports.rows import Row

_HEAD: Final = """<?xml version="1.0" encoding="UTF-8"?>
<log xes.version="1849.2016" xes.features="" xmlns="http://www.xes-standard.org/">
<extension name="Concept" prefix="concept" uri="http://www.xes-standard.org/concept.xesext"/>
<extension name="Time" prefix="time" uri="http://www.xes-standard.org/time.xesext"/>
<extension name="Organizational" prefix="org" uri="http://www.xes-standard.org/org.xesext"/>
<classifier name="Activity" keys="concept:name"/>
"""
_NUMBERS: Final = ("sequence", "part", "at_ms", "row", "column", "step", "attempt", "level")
_TEXTS: Final = ("source", "token", "text")


def write_xes(rows: Iterable[Row], file: IO[str]) -> int:
    """Write the log; returns the number of traces."""
    file.write(_HEAD)
    count = 0
    for session, group in groupby(rows, key=lambda row: row.session):
        played = list(group)
        first = played[0]
        file.write("<trace>\n")
        file.write(_string("concept:name", session))
        file.write(_string("patient", first.patient))
        file.write(_string("exercise", first.exercise))
        file.write(_number("version", first.version))
        if first.seed is not None:
            file.write(_number("seed", first.seed))
        for row in played:
            file.write(_event(row))
        file.write("</trace>\n")
        count += 1
    file.write("</log>\n")
    return count


def _event(row: Row) -> str:
    who = "robot" if row.source == "commands" else row.by or "patient"
    pieces = [
        _string("concept:name", row.type),
        f'<date key="time:timestamp" value={quoteattr(row.utc)}/>\n',
        _string("org:resource", who),
    ]
    for name in _NUMBERS:
        value: int | None = getattr(row, name)
        if value is not None:
            pieces.append(_number(name, value))
    for name in _TEXTS:
        text: str | None = getattr(row, name)
        if text is not None:
            pieces.append(_string(name, text))
    detail = json.dumps(json.loads(row.detail))  # ASCII: no sign that XML forbids
    return f"<event>\n{''.join(pieces)}{_string('detail', detail)}</event>\n"


def _string(key: str, value: str) -> str:
    plain = "".join(sign if sign.isprintable() else " " for sign in value)
    return f"<string key={quoteattr(key)} value={quoteattr(plain)}/>\n"


def _number(key: str, value: int) -> str:
    return f'<int key={quoteattr(key)} value="{value}"/>\n'
