"""How long it takes until the command line answers: `make bench`."""

from __future__ import annotations

import subprocess
import sys

import pytest

from benchmarks.stopwatch import Stopwatch


@pytest.mark.benchmark(group="start")
def test_help(benchmark: Stopwatch) -> None:
    command = [sys.executable, "-m", "maestra", "--help"]

    def ask() -> bytes:
        return subprocess.run(command, capture_output=True, check=True).stdout  # noqa: S603 - our own program

    assert b"learn" in benchmark.pedantic(ask, rounds=9)
