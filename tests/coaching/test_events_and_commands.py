"""Events and commands as JSON: nothing else is read."""

from __future__ import annotations

import json

import pytest

from maestra.coaching.commands import MoveToken, decode_command, encode_command
from maestra.coaching.events import TimedEvent, TokenPlaced, decode_event, encode_event
from maestra.coaching.fields import Milliseconds
from maestra.core.board import Cell, Column, Row
from maestra.core.faults import InvalidError
from maestra.core.tokens import TokenId

PLACED = TimedEvent(Milliseconds(5), TokenPlaced(TokenId("04A3B2"), Cell(Row(1), Column(2))))


def test_an_event_is_written_with_its_time_and_cells_as_pairs() -> None:
    written = json.loads(json.dumps(encode_event(PLACED)))
    assert written == {
        "at": 5,
        "what": {"event": "placed", "token": "04A3B2", "cell": [1, 2]},
    }
    assert decode_event(written) == PLACED


def test_a_command_is_read_as_it_was_written() -> None:
    here, there = Cell(Row(1), Column(2)), Cell(Row(2), Column(2))
    command = MoveToken(1, TokenId("a"), here, there)
    assert decode_command(encode_command(command)) == command


@pytest.mark.parametrize(
    ("written", "fault"),
    [
        ({"at": -1, "what": {"event": "begun"}}, "at: -1"),
        ({"at": 1, "what": {"event": "flown"}}, "what.event"),
        ({"at": 1, "what": {"event": "begun", "who": "anna"}}, "what.who: unknown field"),
        ({"at": 1, "what": {"event": "lifted", "token": ""}}, "what.token"),
        ({"at": 1, "what": {"event": "placed", "token": "a", "cell": [0, 1]}}, "what.cell"),
        ({"at": 1, "what": {"event": "placed", "token": "a", "cell": [True, 1]}}, "what.cell"),
        ({"at": 1, "what": {"event": "placed", "token": "a", "cell": "l11"}}, "what.cell"),
        ({"at": 1, "what": {"event": "hint-ordered", "level": 6}}, "what.level"),
        (3, "3"),
    ],
)
def test_what_is_no_event_is_refused_with_its_place(written: object, fault: str) -> None:
    with pytest.raises(InvalidError, match=fault.replace(".", r"\.")):
        decode_event(written)


def test_what_is_no_command_is_refused() -> None:
    with pytest.raises(InvalidError, match="command"):
        decode_command({"command": "fly"})
