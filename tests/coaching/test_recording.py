"""A session kept as a file and played again, and one under way with board, robot and record."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import pytest

from maestra.boards.replay import ReplayBoard
from maestra.boards.simulated import SimulatedBoard
from maestra.coaching.commands import Command, MoveToken
from maestra.coaching.events import (
    Begun,
    EndOrdered,
    Event,
    HelpAsked,
    RobotDone,
    TimedEvent,
    TimePassed,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.policies import policy_for
from maestra.coaching.ports import Entry, NewEntry, SessionId
from maestra.coaching.recording import (
    Start,
    decode_start,
    encode_line,
    encode_start,
    read_session,
    replay,
)
from maestra.coaching.running import Running
from maestra.coaching.settings import Settings
from maestra.core.board import Board
from maestra.core.json_lines import FormatError
from maestra.core.state import State
from maestra.core.tokens import TokenId
from maestra.robots.screen import ScreenRobot
from maestra.rules.exercise import LearnStatus, RuledExercise, meant_rules
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import NUMBER_DECK
from maestra.rules.rule import Rule
from maestra.rules.setting import Line

RULES: tuple[Rule, ...] = (
    Ordered("value", Direction.RISING, strict=True, line=Line.ROW),
    FullRow(),
    FillOrder(Filling.LEFT_TO_RIGHT),
)
EXERCISE = RuledExercise(
    Board(),
    NUMBER_DECK,
    meant_rules(RULES, [1.0, 1.0, 1.0]),
    1.0,
    LearnStatus.TOLD,
    RULES,
)
STATE = State(
    Board(),
    dict(zip([t.id for t in NUMBER_DECK.tokens], Board().storage_cells, strict=False)),
)
NOTHING_IN_IT = (
    b'{"format": "maestra.session/1", "maestra": "0", "seed": 1, "exercise": {}, "play": {}, '
    b'"settings": {}, "policy": {}}\n'
)
UTC = "2026-11-22T05:00:00.000+00:00"


def start(settings: Settings | None = None) -> Start:
    wanted = settings or Settings()
    return Start(EXERCISE, NUMBER_DECK, STATE, wanted, 7, policy_for(wanted), "anna")


@dataclass
class ListStore:
    """Entries in a list."""

    kept: list[Entry] = field(default_factory=list[Entry])
    is_full: bool = False

    def append(self, entries: Sequence[NewEntry]) -> tuple[Entry, ...]:
        if self.is_full:
            raise OSError("disk full")
        for one in entries:
            fields = (one.session, one.key, one.at, one.utc, one.kind, one.payload)
            self.kept.append(Entry(*fields, len(self.kept) + 1))
        return tuple(self.kept[-len(entries) :])

    def entries(self, session: SessionId | None = None) -> Iterator[Entry]:
        return (one for one in self.kept if session in {None, one.session})


def under_way(
    settings: Settings | None = None, store: ListStore | None = None
) -> tuple[Running, SimulatedBoard, ListStore, list[str]]:
    board, lines = SimulatedBoard(STATE), list[str]()
    kept = store or ListStore()
    robot = ScreenRobot(lines.append, board.move)
    running = Running(SessionId("s"), start(settings), board, [robot], kept, UTC)
    return running, board, kept, lines


def test_a_start_survives_its_line() -> None:
    begun = start()
    assert decode_start(encode_start(begun).encode()) == begun
    words = '{"format": "maestra.words/1", "attributes": {}}'
    spoken = replace(begun, words=words)
    assert decode_start(encode_start(spoken).encode()) == spoken
    assert spoken.session().game.referee.rules == begun.session().game.referee.rules


def test_words_that_are_none_are_refused() -> None:
    fields = {**json.loads(encode_start(start())), "words": {"format": "maestra.words/1", "a": 1}}
    with pytest.raises(FormatError, match="a: "):
        decode_start(json.dumps(fields).encode())


def test_a_session_plays_again_to_the_same_commands() -> None:
    running, board, kept, lines = under_way()
    done = list(running.feed(Begun(), Milliseconds(0), UTC))
    for number, value in enumerate((68, 19, 23, 32, 34, 36), start=1):
        board.move(TokenId(str(value)), Board().goal_cells[max(0, number - 2)])
        if number == 1:
            board.move(TokenId("68"), STATE.cells[TokenId("68")])
        done += running.poll(Milliseconds(1_000 * number), UTC)
    assert running.has_ended
    assert lines
    text = "".join(f"{one.payload}\n" for one in kept.kept if one.kind != "commands")
    begun, events = read_session([text.encode()], "s.jsonl")
    again = [command for _, each in replay(begun.session(), events) for command in each]
    assert again == done


def test_what_is_acknowledged_is_kept_before_anything_is_done() -> None:
    store = ListStore()
    running, _, _, lines = under_way(store=store)
    store.is_full = True
    with pytest.raises(OSError, match="disk full"):
        running.feed(Begun(), Milliseconds(0), UTC)
    assert lines == []
    store.is_full = False
    running.feed(Begun(), Milliseconds(0), UTC)
    assert [one.kind for one in store.kept] == ["start", "event", "commands"]


def test_the_robot_moves_tokens_on_the_board_and_the_board_tells() -> None:
    settings = Settings(robot_moves=True, level=5, least_level=5)
    running, board, _, _ = under_way(settings)
    for _ in range(5):
        if running.has_ended:
            break
        running.feed(Begun(), Milliseconds(0), UTC)
    assert running.has_ended
    assert len([c for c in board.cells.values() if c.row == 1]) == 5


def test_silence_is_due_and_polled_for() -> None:
    running, _, kept, _ = under_way()
    running.feed(Begun(), Milliseconds(0), UTC)
    assert running.poll(Milliseconds(1_000), UTC) == ()
    assert running.poll(Milliseconds(60_000), UTC)
    assert any('"time-passed"' in one.payload for one in kept.kept)
    running.feed(EndOrdered(), Milliseconds(61_000), UTC)
    assert running.feed(HelpAsked(), Milliseconds(62_000), UTC)
    assert kept.kept[-2].at == 62_000


@dataclass
class Echo:
    """A robot whose every outcome brings another move: it never stops talking."""

    def carry_out(self, command: Command) -> Sequence[Event]:
        return [HelpAsked()] if not isinstance(command, MoveToken) else []

    def outcomes(self) -> Sequence[Event]:
        return [RobotDone(1)]

    def close(self) -> None:
        """Nothing."""


def test_a_robot_that_never_stops_talking_is_cut_short() -> None:
    kept = ListStore()
    running = Running(SessionId("s"), start(), SimulatedBoard(STATE), [Echo()], kept, UTC)
    assert running.poll(Milliseconds(0), UTC)
    assert len(kept.kept) < 1_000


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"{}\n",
        b'{"format": "maestra.session/1"}\n',
        NOTHING_IN_IT,
    ],
)
def test_a_file_that_is_no_session_is_refused(text: bytes) -> None:
    with pytest.raises(FormatError):
        read_session([text], "s.jsonl")


@pytest.mark.parametrize("line", [b"nonsense\n", b'{"at": 1}\n'])
def test_a_line_that_is_no_event_is_refused_with_its_number(line: bytes) -> None:
    _, events = read_session([encode_start(start()).encode(), b"\n", line], "s.jsonl")
    with pytest.raises(FormatError, match="line 2"):
        list(events)


def test_a_replayed_board_tells_only_what_boards_tell() -> None:
    board = SimulatedBoard(STATE)
    board.move(TokenId("19"), Board().goal_cells[0])
    told = board.events()
    timed = [TimedEvent(Milliseconds(1), what) for what in (Begun(), *told, TimePassed())]
    replayed = ReplayBoard(timed)
    again: list[Event] = []
    while replayed.has_more:
        again += replayed.events()
    assert again == list(told)
    assert encode_line(timed[0]).startswith('{"at": 1')
