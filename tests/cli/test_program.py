import errno
import re
import runpy
import sys

import pytest
import typer

from maestra import __version__
from maestra.cli import main, program
from maestra.cli.terms import ReaderGoneError
from tests.cli.running import maestra

COMMANDS = ("learn", "explain", "moves", "judge", "export", "features", "demo", "experiment")


def raising(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    def app(**_: object) -> None:
        raise error

    monkeypatch.setattr(program, "app", app)


def test_the_version_is_printed() -> None:
    ran = maestra("--version")
    assert (ran.code, ran.out, ran.err) == (0, f"maestra {__version__}\n", "")


@pytest.mark.parametrize("arguments", [(), ("--help",), ("-h",)])
def test_help_lists_every_command_with_a_whole_sentence(arguments: tuple[str, ...]) -> None:
    ran = maestra(*arguments)
    assert (ran.code, ran.err) == (0, "")
    for command in COMMANDS:
        assert re.search(rf"^  {command} +[A-Z].*\.$", ran.out, re.MULTILINE), ran.out
    assert "..." not in ran.out.partition("Commands:")[2]


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_has_help(command: str) -> None:
    ran = maestra(command, "--help")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(f"Usage: maestra {command}")


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("lern",), "maestra: No such command 'lern'. Did you mean 'learn'?\n"),
        (("judge",), "maestra: Missing argument 'EXERCISE.json'.\n"),
        (("explain", "x", "--nope"), "maestra: No such option: --nope\n"),
        (
            ("judge", "-", "-"),
            "maestra: Invalid value: only one file can be standard input\n",
        ),
        (
            ("learn", "x", "-o", "-", "--json"),
            "maestra: Invalid value: --json and --output - both want standard output\n",
        ),
        (
            ("learn", "x", "-o", "y", "--engine", "clingo"),
            "maestra: Invalid value: --engine needs --learner compiled\n",
        ),
        (
            ("learn", "x", "-o", "y", "--compiled-pddl", "z"),
            "maestra: Invalid value: --compiled-pddl needs --learner compiled\n",
        ),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(arguments: tuple[str, ...], line: str) -> None:
    ran = maestra(*arguments)
    assert (ran.code, ran.out, ran.err) == (2, "", line)


@pytest.mark.parametrize(
    ("error", "line"),
    [
        (
            FileNotFoundError(errno.ENOENT, "", "a\nb.jsonl"),
            r"maestra: a\nb.jsonl: no such file or folder, expected one that exists",
        ),
        (
            PermissionError(errno.EACCES, "", b"x.json"),
            "maestra: x.json: permission denied, expected a file you may use",
        ),
        (
            OSError(errno.ENOSPC, "No space left on device"),
            "maestra: no space left, expected room on the disk",
        ),
        (
            OSError(errno.EIO, "Input/output error", "x"),
            "maestra: x: Input/output error",
        ),
        (OSError("odd"), "maestra: odd"),
    ],
)
def test_what_is_wrong_with_a_file_is_said_in_one_line(
    monkeypatch: pytest.MonkeyPatch, error: OSError, line: str
) -> None:
    raising(monkeypatch, error)
    ran = maestra("learn")
    assert (ran.code, ran.out, ran.err) == (2, "", f"{line}\n")


@pytest.mark.parametrize("error", [KeyError("gone"), ValueError("a\nb"), MemoryError()])
def test_a_fault_of_ours_is_told_apart_and_shows_no_traceback(
    monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    raising(monkeypatch, error)
    monkeypatch.delenv("MAESTRA_TRACEBACK", raising=False)
    ran = maestra("learn")
    assert ran.code == 70
    assert ran.err.count("\n") == 1
    assert ran.err.startswith("maestra: a fault of Maestra itself, please report it (")


def test_a_fault_of_ours_can_show_where_it_happened(monkeypatch: pytest.MonkeyPatch) -> None:
    raising(monkeypatch, KeyError("gone"))
    monkeypatch.setenv("MAESTRA_TRACEBACK", "1")
    with pytest.raises(KeyError, match="gone"):
        maestra("learn")


@pytest.mark.parametrize(
    ("error", "code"),
    [(KeyboardInterrupt(), 130), (typer.Abort(), 130), (ReaderGoneError(), 141)],
)
def test_an_end_from_outside_is_quiet(
    monkeypatch: pytest.MonkeyPatch, error: BaseException, code: int
) -> None:
    raising(monkeypatch, error)
    ran = maestra("learn")
    assert (ran.code, ran.out, ran.err) == (code, "", "")


@pytest.mark.parametrize("module", ["maestra", "maestra.__main__"])
def test_the_package_runs_as_a_module(
    module: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["maestra", "--version"])
    monkeypatch.delitem(sys.modules, "maestra.__main__", raising=False)
    with pytest.raises(SystemExit) as ended:
        runpy.run_module(module, run_name="__main__")
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"maestra {__version__}\n"


def test_importing_the_entry_runs_nothing() -> None:
    assert runpy.run_module("maestra.__main__", run_name="imported")["main"] is main
