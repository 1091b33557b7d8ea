"""Maestra as a process of its own: what cannot be seen from inside."""

import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from maestra import __version__
from tests.cli.running import EXAMPLES, learned

MAESTRA = (sys.executable, "-m", "maestra")
COLOUR = re.compile("\x1b\\[(?:\\d+;)*[349]\\d")
PLAYS = EXAMPLES / "plays" / "ascending.jsonl"
WAITS_S = 60.0


@pytest.fixture(name="exercise", scope="module")
def an_exercise(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return learned(tmp_path_factory.mktemp("exercise"), "ascending")


def test_the_package_runs_as_the_program_does() -> None:
    done = subprocess.run([*MAESTRA, "--version"], capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == (f"maestra {__version__}\n", "")


def test_bad_input_ends_with_2_and_one_line() -> None:
    done = subprocess.run(
        [*MAESTRA, "explain", "/gone"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "maestra: /gone: no such file or folder, expected one that exists\n"


def test_each_play_is_answered_before_the_next_is_read(exercise: Path) -> None:
    with subprocess.Popen(
        [*MAESTRA, "judge", str(exercise), "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        for line in PLAYS.read_bytes().splitlines(keepends=True)[:2]:
            process.stdin.write(line)
            process.stdin.flush()
            assert process.stdout.readline().startswith(b'{"moves": ')
        process.stdin.close()
    assert process.returncode == 1


def test_a_reader_that_goes_away_ends_it_quietly(exercise: Path) -> None:
    with subprocess.Popen(
        [*MAESTRA, "judge", str(exercise), "-"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.close()
        _, said = process.communicate(PLAYS.read_bytes() * 20)
    assert (process.returncode, said) == (141, b"")


@pytest.mark.parametrize("arguments", [["judge"], ["explain"], []])
def test_a_full_disk_is_said_in_one_line(exercise: Path, arguments: list[str]) -> None:
    files = {"judge": [str(exercise), str(PLAYS)], "explain": [str(exercise)]}
    more = files[arguments[0]] if arguments else []
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [*MAESTRA, *arguments, *more], stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert done.returncode == 2
    assert done.stderr == b"maestra: standard output: no space left, expected room on the disk\n"


def test_control_c_ends_it_quietly(exercise: Path) -> None:
    with subprocess.Popen(
        [*MAESTRA, "judge", str(exercise), "-"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(PLAYS.read_bytes().splitlines(keepends=True)[0])
        process.stdin.flush()
        process.stdout.readline()
        # While it waits for the next line: elsewhere Python may raise the interrupt in a callback
        # of its own, which swallows it. And no end of the input may come before the interrupt.
        wait_until_it_waits(process.pid)
        process.send_signal(signal.SIGINT)
        process.wait(WAITS_S)
        _, said = process.communicate()
    assert (process.returncode, said) == (130, b"")


def wait_until_it_waits(process: int) -> None:
    """Return once the process has slept for a while, as Linux sees it."""
    asleep, until = 0, time.monotonic() + WAITS_S
    while asleep < 5:  # looks, one after another
        assert time.monotonic() < until
        state = (
            Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
        )
        asleep = asleep + 1 if state == "S" else 0
        time.sleep(0.02)


def test_the_session_has_colours_on_a_terminal_unless_they_are_not_wanted() -> None:
    assert COLOUR.search(on_terminal({}))
    assert not COLOUR.search(on_terminal({"NO_COLOR": "1"}))


def test_a_patient_is_accompanied_on_a_terminal() -> None:
    seen = on_terminal({}, b"accompany 5", b"c", b"u", b"r", b"i", b"e", b"menu", b"quit")
    assert "I do not keep this session" in seen
    assert seen.count("Which exercise shall it be?") == 3


def on_terminal(variables: dict[str, str], *typed: bytes) -> str:
    """What a person sees who types this line by line, or asks for an exercise and leaves."""
    ours, theirs = pty.openpty()
    environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
    with subprocess.Popen(
        [*MAESTRA, "demo", "--lang", "en"],
        stdin=theirs,
        stdout=theirs,
        stderr=theirs,
        env=environment | {"TERM": "xterm-256color"} | variables,
    ) as process:
        os.close(theirs)
        seen = b""
        deadline = time.monotonic() + 60
        for prompt, line in enumerate(typed or (b"7", b"quit"), start=1):
            while seen.count(b"> ") < prompt and time.monotonic() < deadline:
                seen += os.read(ours, 4096)
            os.write(ours, line + b"\n")
        while b"Goodbye." not in seen and time.monotonic() < deadline:
            seen += os.read(ours, 4096)
    os.close(ours)
    assert process.returncode == 0
    return seen.decode()
