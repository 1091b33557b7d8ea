"""`maestra --help` answers at once because nothing heavy is imported for it."""

import json
import subprocess
import sys

import pytest

HEAVY = {
    "clingo",
    "cryptography",
    "fastapi",
    "joblib",
    "numpy",
    "pddl",
    "rich",
    "sqlalchemy",
    "uvicorn",
    "maestra.core",
    "maestra.rules",
}
PROBE = """
import json, sys
from maestra.cli.program import run
run({arguments})
print()
print(json.dumps(sorted(sys.modules)))
"""


def imported(*arguments: str) -> set[str]:
    done = subprocess.run(
        [sys.executable, "-c", PROBE.format(arguments=list(arguments))],
        capture_output=True,
        text=True,
        check=True,
    )
    return set(json.loads(done.stdout.splitlines()[-1]))


def test_help_imports_nothing_heavy() -> None:
    assert imported("--help") & (HEAVY | {"pydantic"}) == set()


# typer itself asks pydantic to read a command's arguments.
@pytest.mark.parametrize("arguments", [("learn", "--help"), ("--version",), ("nope",)])
def test_nothing_heavy_is_imported_before_a_command_runs(arguments: tuple[str, ...]) -> None:
    assert imported(*arguments) & HEAVY == set()
