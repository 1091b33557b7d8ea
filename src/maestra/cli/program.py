"""One run of the program: its arguments in, its exit code out, and never a traceback."""

import contextlib
import errno
import os
import sys
from collections.abc import Sequence
from typing import Final, NoReturn

import typer

from maestra.cli.commands import app
from maestra.cli.terms import (
    BAD_INPUT,
    FAULT_OF_OURS,
    INTERRUPTED,
    PIPE_CLOSED,
    STANDARD_OUTPUT,
    ReaderGoneError,
)

TRACEBACK_VARIABLE: Final = "MAESTRA_TRACEBACK"
"""Set to anything, a fault of Maestra itself shows where it happened."""

_REASONS: Final = {
    errno.ENOENT: ("no such file or folder", "one that exists"),
    errno.ENOTDIR: ("no such file or folder", "one that exists"),
    errno.EISDIR: ("a folder", "a file"),
    errno.EACCES: ("permission denied", "a file you may use"),
    errno.EPERM: ("permission denied", "a file you may use"),
    errno.EROFS: ("permission denied", "a file you may use"),
    errno.EEXIST: ("a file", "a folder"),
    errno.ENOSPC: ("no space left", "room on the disk"),
    errno.EDQUOT: ("no space left", "room on the disk"),
    errno.ENAMETOOLONG: ("a name that is too long", "one that exists"),
}
"""What went wrong with a file, and what was expected of it."""


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run Maestra with `arguments`, by default the process's, and end the process."""
    code = run(sys.argv[1:] if arguments is None else arguments)
    code = _flush(code)
    sys.exit(code)


def run(arguments: Sequence[str]) -> int:
    """Run Maestra with `arguments`; its exit code. What is wrong is said in one line."""
    try:
        answer: object = app(args=list(arguments), prog_name="maestra", standalone_mode=False)
    except typer.TyperException as error:
        return _refuse(_one_line(error.format_message()))
    except (KeyboardInterrupt, typer.Abort):
        return INTERRUPTED
    except ReaderGoneError:
        return PIPE_CLOSED
    except OSError as error:
        return _refuse(describe(error))
    except ValueError as error:
        # Core's faults are ValueErrors; asking for the class only now keeps `--help` quick.
        from maestra.core.faults import InvalidError

        if isinstance(error, InvalidError):
            return _refuse(str(error))
        return _confess(error)
    except Exception as error:  # noqa: BLE001 - whatever it is, a user must not see a traceback
        return _confess(error)
    return answer if isinstance(answer, int) else 0


def describe(error: OSError) -> str:
    """What is wrong with a file, in one line."""
    from maestra.core.faults import Fault, one_line

    name = error.filename
    where = one_line(os.fsdecode(name)) if isinstance(name, str | bytes) else ""
    known = _REASONS.get(error.errno or 0)
    if known is None:
        reason = one_line(error.strerror or str(error))
        return f"{where}: {reason}" if where else reason
    return str(Fault(where, *known))


def _refuse(line: str) -> int:
    _say(f"maestra: {line}")
    return BAD_INPUT


def _confess(error: Exception) -> int:
    if os.environ.get(TRACEBACK_VARIABLE):
        raise error
    detail = _one_line(f"{type(error).__name__}: {error}")
    _say(
        f"maestra: a fault of Maestra itself, please report it ({detail}); "
        f"with {TRACEBACK_VARIABLE}=1 it shows where"
    )
    return FAULT_OF_OURS


def _say(line: str) -> None:
    with contextlib.suppress(OSError):  # nobody is left to be told
        sys.stderr.write(f"{line}\n")


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _flush(code: int) -> int:
    """Write out what is still held back; the exit code, another if that fails."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        code = PIPE_CLOSED
    except OSError as error:
        error.filename = STANDARD_OUTPUT
        code = _refuse(describe(error))
    else:
        return code
    # Python would flush again while it ends, and complain with a traceback of its own.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code
