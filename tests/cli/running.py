"""Runs the program in this process, as a shell would in another."""

import io
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import pytest

from maestra.cli.program import run

EXAMPLES: Final = Path(__file__).parents[2] / "examples"
GROUNDED: Final = ("--learner", "grounded")
"""What makes `learn` write actions, as in the paper, instead of rules."""


@dataclass(frozen=True)
class Ran:
    """What a run left behind."""

    code: int
    out: str
    err: str


def maestra(*arguments: str | Path, typed: bytes = b"") -> Ran:
    """Run `maestra` with `arguments` and `typed` as its standard input."""
    streams = [io.TextIOWrapper(io.BytesIO(typed if k == 0 else b""), "utf-8") for k in range(3)]
    with pytest.MonkeyPatch.context() as patch:
        for name, stream in zip(("stdin", "stdout", "stderr"), streams, strict=True):
            patch.setattr(sys, name, stream)
        code = run([str(argument) for argument in arguments])
        for stream in streams[1:]:
            stream.flush()
    out, err = (stream.buffer for stream in streams[1:])
    assert isinstance(out, io.BytesIO)
    assert isinstance(err, io.BytesIO)
    return Ran(code, out.getvalue().decode(), err.getvalue().decode())


def learned(folder: Path, name: str, *options: str) -> Path:
    """The exercise that the example of this name teaches, in a file in `folder`."""
    path = folder / f"{name}.json"
    ran = maestra("learn", EXAMPLES / f"{name}.jsonl", "-o", path, *options)
    assert ran.code == 0, ran
    return path
