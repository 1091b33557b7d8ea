"""`maestra replay`: a recorded session, event by event, with what was done then."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from maestra.app import record_to_read
from maestra.cli.streams import STANDARD, named, print_json, print_lines, read_chunks
from maestra.coaching.commands import AskCaregiver, Command, Say, encode_command, encode_commands
from maestra.coaching.events import encode_event
from maestra.coaching.ports import SessionId
from maestra.coaching.recording import read_session, replay
from maestra.core.faults import Fault, InvalidError


def show(session: str, data: str | None, keys: str | None, *, as_json: bool) -> None:
    """Print each event and the commands that it leads to.

    Raises:
        FormatError: the file is no session.
        InvalidError: there is no such session.
        OSError: it cannot be read.
    """
    is_file = session == STANDARD or Path(session).exists()
    chunks = read_chunks(session) if is_file else _kept(SessionId(session), data, keys)
    start, events = read_session(chunks, named(session))
    timed = list(events)
    for event, (_, commands) in zip(timed, replay(start.session(), timed), strict=True):
        written = encode_event(event)
        if as_json:
            print_json({**written, "commands": encode_commands(commands)})
        else:
            what = written["what"]
            name = what.pop("event")
            about = " ".join(f"{key}={value}" for key, value in what.items())
            print_lines([f"{event.at / 1000:9.3f} s  {name} {about}".rstrip()])
            print_lines(f"             {line}" for line in map(_line, commands))


def _line(command: Command) -> str:
    match command:
        case Say(text=text):
            return f'say "{text}"'
        case AskCaregiver(text=text):
            return f'ask-caregiver "{text}"'
        case _:
            fields = encode_command(command)
            name = fields.pop("command")
            about = " ".join(f"{key}={value}" for key, value in fields.items() if value != [])
            return f"{name} {about}".rstrip()


def _kept(session: SessionId, data: str | None, keys: str | None) -> Iterator[bytes]:
    """The lines of a session in the record, as its file would have them."""
    store = record_to_read(data, keys)
    try:
        kept = [one.payload for one in store.events.entries(session) if one.kind != "commands"]
    finally:
        store.close()
    if not kept:
        fault = Fault("session", session, "a session's file, or the name of one in the record")
        raise InvalidError([fault])
    return (f"{payload}\n".encode() for payload in kept)
