"""What the planners' tests share: a Madagascar to ask, and that nothing is left of any engine."""

import contextlib
import os
import stat
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from maestra.planners.madagascar import BINARY_VARIABLE

DOUBLE = Path(__file__).parent / "madagascar_double.py"


def make_program(path: Path, text: str) -> Path:
    """An executable shell script."""
    path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.fixture(scope="session")
def madagascar(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A program that behaves as Madagascar's Mp."""
    folder = tmp_path_factory.mktemp("madagascar")
    return make_program(folder / "Mp", f'exec "{sys.executable}" -I -S "{DOUBLE}" "$@"')


@pytest.fixture(autouse=True)
def _madagascar_is_named(madagascar: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(BINARY_VARIABLE, str(madagascar))


@pytest.fixture(autouse=True)
def _nothing_is_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """No file, no process and no thread of an engine is left when a test ends."""
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))
    threads_before, children_before = threads(), children()
    yield
    assert list(temporary.iterdir()) == []
    assert children() <= children_before
    # The kernel shows a thread for a moment after it was joined.
    deadline = time.monotonic() + 5
    while not threads() <= threads_before and time.monotonic() < deadline:
        time.sleep(0.001)
    assert threads() <= threads_before


def threads() -> set[str]:
    return {task.name for task in Path("/proc/self/task").iterdir()}


def children() -> set[str]:
    """The processes whose parent this one is, also those that ended and were not waited for."""
    found: set[str] = set()
    for entry in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):  # it ended while we looked
            # After the name, which may hold anything, come the state and the parent.
            fields = entry.read_text(errors="replace").rpartition(")")[2].split()
            if fields[1] == str(os.getpid()):
                found.add(entry.parent.name)
    return found
