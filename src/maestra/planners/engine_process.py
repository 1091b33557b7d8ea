"""Running a planner's program so that nothing of it outlives the call.

The program gets a session of its own, so that all of its processes die by one signal; address
space and processor time limited by the shell that starts it, so that the limits are in force
before its first instruction and hold even if we are killed; and a folder of its own, which is
removed however the call ends.
"""

from __future__ import annotations

import contextlib
import math
import os
import resource
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, Final, TypeAlias

from maestra.learning.planning import NoEngine, OutOfMemory, OutOfTime, Solved
from maestra.learning.plans import ReachesGoal, validate

if TYPE_CHECKING:
    from maestra.learning.planning import (
        Limits,
        OperatorName,
        Outcome,
        PlanningProblem,
        Unsolved,
    )

_SHELL: Final = "/bin/sh"
# ulimit counts address space in KiB and processor time in seconds. exec: no shell is left.
_LIMITED: Final = 'ulimit -v "$1" && ulimit -t "$2" && shift 2 && exec "$@"'
_CPU_PER_WALL: Final = 2
"""Processor time allowed for each second of the time limit: only a net for when we are killed
ourselves, so wide enough for an engine with two threads."""
_NO_ROOM_TO_LOAD: Final = ("failed to map segment", "cannot allocate memory", "bad_alloc")
"""What the loader, libc and C++ say when the memory limit refuses them."""


@dataclass(frozen=True, slots=True)
class Ended:
    """The program ended by itself."""

    code: int
    """Its exit code; negative: the signal that ended it."""
    output: str
    """What it wrote on standard output and standard error."""
    seconds: float


@dataclass(frozen=True, slots=True)
class Overran:
    """The time limit passed, and every process of the program was killed."""

    seconds: float


@dataclass(frozen=True, slots=True)
class Starved:
    """The memory limit ended it."""

    seconds: float


@dataclass(frozen=True, slots=True)
class NotStarted:
    """It could not be started."""

    why: str


Run: TypeAlias = Ended | Overran | Starved | NotStarted


@contextlib.contextmanager
def engine_folder() -> Generator[Path]:
    """A folder for one call's files, removed on the way out."""
    with tempfile.TemporaryDirectory(prefix="maestra-planner-") as folder:
        yield Path(folder)


def run(command: Sequence[str], folder: Path, limits: Limits, *, given: str = "") -> Run:
    """Run `command` in `folder` within `limits`; no process of it is left afterwards.

    Args:
        command: the program's path and its arguments.
        folder: where it runs, and where it may write.
        limits: what it may take.
        given: what it reads on standard input.
    """
    source = folder / "given"
    source.write_text(given, encoding="utf-8")
    with source.open("rb") as stdin:
        return _run(command, folder, limits, stdin)


def _run(command: Sequence[str], folder: Path, limits: Limits, stdin: BinaryIO) -> Run:
    began = time.perf_counter()
    engine = _Engine()
    try:
        try:
            process = engine.start([*_limiting_shell(limits), *command], folder, stdin)
        except OSError as error:
            return NotStarted(f"{_SHELL}: {error.strerror}")
        output, _ = process.communicate(timeout=limits.time_s)
    except subprocess.TimeoutExpired:
        return Overran(time.perf_counter() - began)
    finally:
        engine.end()
    seconds = time.perf_counter() - began
    return _judge_end(process.returncode, output.decode(errors="replace"), seconds)


class _Engine:
    """A program that is surely dead after `end`, wherever an interrupt strikes.

    Ctrl-C may be raised in the main thread at any instruction, also inside Popen, after the
    program began and before anybody knows its process id. So Popen is called in a thread of its
    own, where nothing is raised.
    """

    def __init__(self) -> None:
        self._started: list[subprocess.Popen[bytes]] = []
        self._failed: list[OSError] = []
        self._wanted = True
        self._lock = threading.Lock()
        self._starter: threading.Thread | None = None

    def start(
        self, command: Sequence[str], folder: Path, stdin: BinaryIO
    ) -> subprocess.Popen[bytes]:
        """Start `command` in `folder`.

        Raises:
            OSError: it cannot be started.
        """
        self._starter = threading.Thread(target=self._start, args=(command, folder, stdin))
        self._starter.start()
        self._starter.join()
        if self._failed:
            raise self._failed[0]
        return self._started[0]

    def _start(self, command: Sequence[str], folder: Path, stdin: BinaryIO) -> None:
        with self._lock:
            if not self._wanted:
                return
            try:
                process = subprocess.Popen(
                    command,
                    cwd=folder,
                    stdin=stdin,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                )
            except OSError as error:
                self._failed.append(error)
            else:
                self._started.append(process)

    def end(self) -> None:
        """Kill what is left of the program: after a normal end, its children."""
        with self._lock:  # waits for a start that is under way
            self._wanted = False
        for process in self._started:
            with process, contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        if self._starter is not None and self._starter.is_alive():
            self._starter.join()


def _limiting_shell(limits: Limits) -> list[str]:
    memory = limits.memory_mb * 2**20
    _, ours = resource.getrlimit(resource.RLIMIT_AS)
    if ours != resource.RLIM_INFINITY:
        memory = min(memory, ours)  # a limit can only be lowered
    cpu_s = _CPU_PER_WALL * math.ceil(limits.time_s)
    return [_SHELL, "-c", _LIMITED, _SHELL, str(memory // 1024), str(cpu_s)]


def _judge_end(code: int, output: str, seconds: float) -> Run:
    # Nobody but the kernel, short of memory, kills it without our asking.
    killed_for_memory = code == -signal.SIGKILL
    refused_memory = code != 0 and any(text in output.lower() for text in _NO_ROOM_TO_LOAD)
    if killed_for_memory or refused_memory:
        return Starved(seconds)
    if code == -signal.SIGXCPU:
        return Overran(seconds)
    return Ended(code, output, seconds)


def checked(
    problem: PlanningProblem, plan: Sequence[OperatorName], engine: str, seconds: float
) -> Outcome:
    """The outcome of an engine that says `plan` is one: it is replayed before it is believed."""
    verdict = validate(problem, plan)
    if isinstance(verdict, ReachesGoal):
        return Solved(tuple(plan), engine, seconds)
    return NoEngine(engine, f"its plan is not one: {verdict}")


def without_answer(ran: Overran | Starved | NotStarted, engine: str) -> Unsolved:
    """The outcome of a run in which the engine did not come to an end of its own."""
    match ran:
        case Overran(seconds):
            return OutOfTime(engine, seconds)
        case Starved(seconds):
            return OutOfMemory(engine, seconds)
        case NotStarted(why):
            return NoEngine(engine, why)


def last_line(output: str) -> str:
    """What a program said last: usually why it failed."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return lines[-1] if lines else "it said nothing"
