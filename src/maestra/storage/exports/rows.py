"""The record as one table: a row for everything that happened and everything that was done."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, TypeAlias

from maestra.coaching.ports import Entry, PatientId, Store, StoredSession

_Json: TypeAlias = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Row:
    """One event or command; what does not apply is None."""

    sequence: int
    """The entry's place in the whole record."""
    part: int
    """From 1; an entry of several commands has several rows."""
    patient: str
    session: str
    exercise: str
    version: int
    """Of the exercise."""
    seed: int | None
    maestra: str | None
    """The program's version."""
    at_ms: int
    """Since the session began, on a clock that never runs backwards."""
    utc: str
    source: str
    """start, event or commands."""
    type: str
    """What happened or was done; of a note, the note's kind."""
    token: str | None
    row: int | None
    column: int | None
    step: int | None
    attempt: int | None
    level: int | None
    """Of assistance, 0 to 5."""
    by: str | None
    text: str | None
    """What was said."""
    detail: str
    """All of it, as JSON."""


def rows(store: Store, patient: PatientId | None = None) -> Iterator[Row]:
    """The rows of one patient or of all, in the order of the record within each session."""
    for session in store.sessions(patient):
        start: _Json = {}
        for entry in store.events.entries(session.session):
            parts = _parts(entry)
            if entry.kind == "start":
                start = parts[0]
            for number, part in enumerate(parts, 1):
                yield _row(entry, number, part, session, start)


def _parts(entry: Entry) -> list[_Json]:
    """The objects of a payload: one, or a list of them."""
    payload: _Json | list[_Json] = json.loads(entry.payload)
    return payload if isinstance(payload, list) else [payload]


def _row(entry: Entry, number: int, part: _Json, session: StoredSession, start: _Json) -> Row:
    happened: _Json = part.get("what", part)
    told: _Json = {**happened, **happened.get("fields", {})}
    row, column = _cell(told)
    return Row(
        sequence=entry.sequence,
        part=number,
        patient=session.patient,
        session=session.session,
        exercise=session.exercise,
        version=session.version,
        seed=_whole(start.get("seed")),
        maestra=_text(start.get("maestra")),
        at_ms=entry.at,
        utc=entry.utc,
        source=entry.kind,
        type=_type(told, entry.kind),
        token=_text(told.get("token")),
        row=row,
        column=column,
        step=_whole(told.get("step")),
        attempt=_whole(told.get("attempt")),
        level=_whole(told.get("level")),
        by=_text(told.get("by")),
        text=_text(told.get("text")),
        detail=json.dumps(part, ensure_ascii=False, sort_keys=True),
    )


def _type(told: _Json, kind: str) -> str:
    """What it is: a note's kind says more than that it is a note."""
    return str(told.get("note") or told.get("event") or told.get("command") or kind)


def _cell(told: _Json) -> tuple[int | None, int | None]:
    match told.get("cell") or told.get("destination"):
        case [int(row), int(column)]:
            return row, column
        case _:
            return _whole(told.get("row")), _whole(told.get("column"))


def _whole(value: object) -> int | None:
    return value if isinstance(value, int) else None


def _text(value: object) -> str | None:
    return value if isinstance(value, str) else None
