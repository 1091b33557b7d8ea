"""The example programs against a real server: a board and a robot join with their tokens."""

import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from maestra.coaching.commands import View
from maestra.coaching.settings import Helper, Settings
from maestra.web.access.devices import DeviceKind, make_program
from maestra.web.access.visitor import Role
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from maestra.web.rooms.stage import RoomName
from tests.browser.serving import Served, serving
from tests.web.people import add_account
from tests.web.rooms.exercises import HERON, prepare, right_move, wrong_move

PROGRAMS = Path(__file__).parents[3] / "examples" / "programs"
ONE = RoomName("1")
PATIENCE_S = 30.0


@pytest.fixture
def served(tmp_path: Path) -> Iterator[Served]:
    with serving(tmp_path) as one:
        settings = Settings(robot_moves=True, put_back=Helper.ROBOT)
        prepare(one.context.store, settings)
        yield one


class Program:
    """One under way; what it has printed so far."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self.process = process
        self.lines: list[str] = []
        threading.Thread(target=self._read, daemon=True).start()

    def type(self, line: str) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{line}\n")
        self.process.stdin.flush()

    def has_said(self, words: str) -> bool:
        return any(words in line for line in self.lines)

    def _read(self) -> None:
        assert self.process.stdout is not None
        self.lines.extend(self.process.stdout)


@contextmanager
def program(served: Served, kind: DeviceKind) -> Generator[Program]:
    name = f"for the {kind.value} at {time.monotonic_ns()}"
    visitor = add_account(served.context, name, Role.ADMINISTRATOR)
    token = make_program(served.context, visitor, kind, "example", ONE)
    command = [sys.executable, str(PROGRAMS / f"{kind.value}.py"), served.url, ONE, token]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        one = Program(process)
        try:
            yield one
        finally:
            process.terminate()


def wait_until(is_so: Callable[[], bool]) -> None:
    until = time.monotonic() + PATIENCE_S
    while not is_so():
        assert time.monotonic() < until
        time.sleep(0.05)


def begin(served: Served) -> Room:
    rooms = served.app.state.rooms
    assert isinstance(rooms, Rooms)
    return rooms.begin(HERON, "ascending", room=ONE)


def label(room: Room, token: str) -> str:
    return next(view.label for one, view in (room.state.tokens or {}).items() if one == token)


def test_a_board_and_a_robot_join_and_play(served: Served) -> None:
    with (
        program(served, DeviceKind.BOARD) as board,
        program(served, DeviceKind.ROBOT) as robot,
    ):
        rooms = served.app.state.rooms
        wait_until(lambda: rooms.place(ONE).state.has_board)
        room = begin(served)
        wait_until(lambda: board.has_said("ready:"))
        move = right_move(room)
        board.type(f"{label(room, move.token)} {move.destination.row},{move.destination.column}")
        wait_until(lambda: room.state.moves == 1)
        said = room.state.said
        assert said is not None
        wait_until(lambda: robot.has_said("says:"))
        move = wrong_move(room)
        board.type(f"{label(room, move.token)} {move.destination.row},{move.destination.column}")
        # The robot has no hand, so the patient is asked.
        wait_until(lambda: room.state.shown is not None and room.state.shown.view is View.PUT_BACK)
        assert room.state.awaiting == ()
        board.type(f"{label(room, move.token)} {move.origin.row},{move.origin.column}")
        wait_until(lambda: room.session.table.cells.get(move.token) == move.origin)
        board.type("nonsense")
        wait_until(lambda: board.has_said("a line is a token and a cell"))


def test_a_board_that_is_gone_is_missed_and_welcomed_back(
    served: Served, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("maestra.web.rooms.room.BOARD_RETURNS_MS", 300)
    room = begin(served)
    with program(served, DeviceKind.BOARD) as board:
        wait_until(lambda: board.has_said("ready:"))
        move = right_move(room)
        board.type(f"{label(room, move.token)} {move.destination.row},{move.destination.column}")
        wait_until(lambda: room.state.moves == 1)
    wait_until(lambda: not room.state.connected)
    with program(served, DeviceKind.BOARD) as board:
        wait_until(lambda: board.has_said("ready:"))
        wait_until(lambda: room.state.connected)
    assert room.state.moves == 1


@pytest.mark.parametrize("kind", [DeviceKind.BOARD, DeviceKind.ROBOT])
def test_a_program_without_a_token_of_its_room_stays_outside(
    served: Served, kind: DeviceKind
) -> None:
    begin(served)
    command = [sys.executable, str(PROGRAMS / f"{kind.value}.py"), served.url, ONE, "guessed"]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.wait(PATIENCE_S) != 0
