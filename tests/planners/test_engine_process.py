import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import pytest

from maestra.learning.planning import Limits, NoEngine
from maestra.planners.engine_process import (
    Ended,
    NotStarted,
    Overran,
    Starved,
    engine_folder,
    last_line,
    run,
    without_answer,
)
from tests.planners.conftest import make_program

AMPLE = Limits(60.0, 2_000)


def is_alive(pid: int) -> bool:
    """Whether the process still runs; one that ended and was not waited for does not."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text(errors="replace")
    except FileNotFoundError:
        return False
    return stat.rpartition(")")[2].split()[0] not in "ZX"


def wait_until(true: Callable[[], bool]) -> None:
    for _ in range(1_000):
        if true():
            return
        time.sleep(0.01)
    pytest.fail("waited ten seconds in vain")


def pids_in(notes: Path) -> list[int]:
    return [int(line) for line in notes.read_text().split()]


def forking_engine(folder: Path, notes: Path, then: str) -> Path:
    """An engine that starts a child, notes both process ids, and goes on as told."""
    return make_program(folder / "engine", f'sleep 60 & echo "$$ $!" > "{notes}"; {then}')


def test_a_program_gets_its_arguments_its_folder_and_its_input(tmp_path: Path) -> None:
    program = make_program(tmp_path / "engine", 'echo "$2 $1"; cat; pwd; echo oops >&2; exit 7')
    with engine_folder() as folder:
        ran = run([str(program), "a b", "c"], folder, AMPLE, given="é\n")
        where = folder
    assert isinstance(ran, Ended)
    assert (ran.code, ran.output) == (7, f"c a b\né\n{where}\noops\n")
    assert ran.seconds > 0


def test_a_program_that_ends_leaves_no_child_behind(tmp_path: Path) -> None:
    notes = tmp_path / "pids"
    # The child holds no output of the engine's, or its end would be the engine's.
    engine = make_program(tmp_path / "engine", f'sleep 60 >&- 2>&- & echo "$$ $!" > "{notes}"')
    with engine_folder() as folder:
        assert isinstance(run([str(engine)], folder, AMPLE), Ended)
    wait_until(lambda: not any(map(is_alive, pids_in(notes))))


def test_a_program_over_its_time_is_killed_with_its_children(tmp_path: Path) -> None:
    notes = tmp_path / "pids"
    engine = forking_engine(tmp_path, notes, "trap '' TERM INT HUP; sleep 60")
    with engine_folder() as folder:
        ran = run([str(engine)], folder, Limits(0.3, 2_000))
    assert isinstance(ran, Overran)
    assert 0.3 <= ran.seconds < 5
    assert len(pids_in(notes)) == 2
    wait_until(lambda: not any(map(is_alive, pids_in(notes))))


@contextlib.contextmanager
def interrupts() -> Generator[Callable[[], None]]:
    """A function to be called in any thread, which interrupts the main one as Ctrl-C does."""

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGUSR1, interrupt)
    try:
        yield lambda: os.kill(os.getpid(), signal.SIGUSR1)
    finally:
        signal.signal(signal.SIGUSR1, before)


def run_in_a_folder(engine: Path) -> None:
    with engine_folder() as folder:
        run([str(engine)], folder, AMPLE)


def test_an_interrupted_call_kills_the_program_and_its_children(tmp_path: Path) -> None:
    notes = tmp_path / "pids"
    engine = forking_engine(tmp_path, notes, "sleep 60")
    with interrupts() as interrupt:

        def once_it_runs() -> None:
            wait_until(lambda: notes.exists() and len(pids_in(notes)) == 2)
            interrupt()

        interrupter = threading.Thread(target=once_it_runs)
        interrupter.start()
        with pytest.raises(KeyboardInterrupt):
            run_in_a_folder(engine)
        interrupter.join()
    wait_until(lambda: not any(map(is_alive, pids_in(notes))))


def test_an_interrupt_while_the_program_starts_kills_it_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    notes = tmp_path / "pids"
    engine = forking_engine(tmp_path, notes, "sleep 60")
    start = subprocess.Popen.__init__
    with interrupts() as interrupt:

        def start_slowly(
            process: subprocess.Popen[bytes],
            *arguments: Any,  # noqa: ANN401 - whatever Popen takes
            **options: Any,  # noqa: ANN401
        ) -> None:
            start(process, *arguments, **options)
            wait_until(lambda: notes.exists() and len(pids_in(notes)) == 2)
            interrupt()
            time.sleep(0.1)  # the program runs, and nobody knows of it yet

        monkeypatch.setattr(subprocess.Popen, "__init__", start_slowly)
        with pytest.raises(KeyboardInterrupt):
            run_in_a_folder(engine)
    wait_until(lambda: not any(map(is_alive, pids_in(notes))))


def test_an_interrupt_before_the_program_starts_keeps_it_from_starting(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[object] = []
    late: list[threading.Thread] = []
    start = threading.Thread.start

    def interrupted(thread: threading.Thread) -> None:
        late.append(thread)
        raise KeyboardInterrupt

    monkeypatch.setattr(threading.Thread, "start", interrupted)
    monkeypatch.setattr(subprocess, "Popen", started.append)
    with pytest.raises(KeyboardInterrupt):
        run_in_a_folder(tmp_path / "engine")
    (thread,) = late
    start(thread)  # as if the interrupt had struck between its making and its first instruction
    thread.join()
    assert started == []


def test_an_engine_outlives_us_only_to_its_processor_time(tmp_path: Path) -> None:
    notes = tmp_path / "pids"
    engine = make_program(tmp_path / "engine", f'echo $$ > "{notes}"; while :; do :; done')
    program = f"""
from pathlib import Path
from maestra.learning.planning import Limits
from maestra.planners.engine_process import run
run([{str(engine)!r}], Path({str(tmp_path)!r}), Limits(0.9, 2_000))
"""
    with subprocess.Popen([sys.executable, "-c", program]) as ours:
        wait_until(lambda: notes.exists() and len(pids_in(notes)) == 1)
        ours.kill()
    (pid,) = pids_in(notes)
    assert is_alive(pid)
    wait_until(lambda: not is_alive(pid))


def test_memory_is_limited_before_the_program_begins(tmp_path: Path) -> None:
    program = make_program(tmp_path / "engine", "ulimit -v; ulimit -Hv")
    with engine_folder() as folder:
        ran = run([str(program)], folder, Limits(1.0, 123))
    assert isinstance(ran, Ended)
    assert ran.output.split() == [str(123 * 1024)] * 2


def test_a_memory_limit_is_never_above_our_own(tmp_path: Path) -> None:
    program = f"""
import resource
from pathlib import Path
from maestra.learning.planning import Limits
from maestra.planners.engine_process import run
resource.setrlimit(resource.RLIMIT_AS, (2**31, 2**31))
print(run(["/bin/sh", "-c", "ulimit -v"], Path({str(tmp_path)!r}), Limits(9.0, 2**30)).output)
"""
    said = subprocess.run(
        [sys.executable, "-c", program], check=True, capture_output=True, text=True, timeout=60
    )
    assert said.stdout.split() == [str(2**21)]


@pytest.mark.parametrize(
    "does",
    [
        "kill -KILL $$",  # as the kernel does when memory runs short
        "echo 'libc.so.6: failed to map segment from shared object'; exit 127",
        "echo 'terminate called after throwing std::bad_alloc' >&2; kill -ABRT $$",
        "echo 'fork: Cannot allocate memory'; exit 1",
    ],
)
def test_an_end_for_want_of_memory_is_recognised(tmp_path: Path, does: str) -> None:
    program = make_program(tmp_path / "engine", does)
    with engine_folder() as folder:
        assert isinstance(run([str(program)], folder, AMPLE), Starved)


def test_success_is_not_want_of_memory_whatever_it_says(tmp_path: Path) -> None:
    program = make_program(tmp_path / "engine", "echo 'no bad_alloc today'")
    with engine_folder() as folder:
        assert isinstance(run([str(program)], folder, AMPLE), Ended)


def test_an_end_for_want_of_processor_time_is_an_overrun(tmp_path: Path) -> None:
    program = make_program(tmp_path / "engine", "kill -XCPU $$")
    with engine_folder() as folder:
        assert isinstance(run([str(program)], folder, AMPLE), Overran)


def test_another_signal_is_the_programs_own_end(tmp_path: Path) -> None:
    program = make_program(tmp_path / "engine", "kill -SEGV $$")
    with engine_folder() as folder:
        ran = run([str(program)], folder, AMPLE)
    assert isinstance(ran, Ended)
    assert ran.code == -signal.SIGSEGV


def test_a_program_that_is_not_there_ends_with_the_shells_words(tmp_path: Path) -> None:
    with engine_folder() as folder:
        ran = run([str(tmp_path / "nowhere")], folder, AMPLE)
    assert isinstance(ran, Ended)
    assert ran.code == 127
    assert "nowhere" in ran.output


def test_without_a_shell_nothing_is_started(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("maestra.planners.engine_process._SHELL", "/no/such/shell")
    with engine_folder() as folder:
        ran = run(["anything"], folder, AMPLE)
    assert isinstance(ran, NotStarted)
    assert without_answer(ran, "engine") == NoEngine("engine", ran.why)
    assert "/no/such/shell" in ran.why


def test_the_folder_is_removed_even_when_the_call_fails() -> None:
    places: list[Path] = []

    def fail() -> None:
        with engine_folder() as folder:
            places.append(folder)
            (folder / "plan").write_text("half a plan")
            raise InterruptedError

    with pytest.raises(InterruptedError):
        fail()
    assert not places[0].exists()


@pytest.mark.parametrize(
    ("output", "last"), [("a\n b \n\n", "b"), ("", "it said nothing"), (" \n", "it said nothing")]
)
def test_what_a_program_said_last(output: str, last: str) -> None:
    assert last_line(output) == last
