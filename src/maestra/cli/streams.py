"""Files, standard input and output, and progress: how commands read and write."""

import contextlib
import errno
import io
import json
import os
import stat
import sys
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from pathlib import Path
from typing import IO, Final, TypeAlias, cast

from maestra.cli.terms import STANDARD_INPUT, STANDARD_OUTPUT, ReaderGoneError

STANDARD: Final = "-"
"""The name of standard input or output on the command line."""
CHUNK_BYTES: Final = 2**16
"""Read at a time: what a pipe holds on Linux."""
MAX_EXERCISE_BYTES: Final = 2**28
"""An exercise is read whole; those of the largest boards take some ten megabytes."""
PATIENCE_S: Final = 1.0
"""Before progress is shown: what is done sooner needs none."""

Advance: TypeAlias = Callable[[int], None]
"""So much more is done."""


def named(path: str) -> str:
    """What messages call the file at `path`."""
    return STANDARD_INPUT if path == STANDARD else path


def read_chunks(path: str, advance: Advance | None = None) -> Iterator[bytes]:
    """The bytes of a file or of standard input, as soon as they come.

    Raises:
        OSError: it cannot be read; with its name.
    """
    with _opened(path) as file:
        while chunk := _read(file, path):
            if advance is not None:
                advance(len(chunk))
            yield chunk


def read_whole(path: str) -> bytes:
    """The bytes of an exercise's file or of standard input.

    Raises:
        OSError: it cannot be read; with its name.
        FormatError: it is too long to be an exercise.
    """
    from maestra.core.faults import Fault
    from maestra.core.json_lines import FormatError

    read = bytearray()
    for chunk in read_chunks(path):
        read += chunk
        if len(read) > MAX_EXERCISE_BYTES:
            fault = Fault("", f"more than {MAX_EXERCISE_BYTES // 2**20} MB", "an exercise")
            raise FormatError(named(path), 1, (fault,))
    return bytes(read)


def size_of(path: str) -> int | None:
    """How many bytes there are to read; None when nobody knows."""
    if path != STANDARD:
        with contextlib.suppress(OSError):
            status = Path(path).stat()
            if stat.S_ISREG(status.st_mode):
                return status.st_size
    return None


def write_file(path: str, text: str) -> None:
    """Put `text` into a file, whole or not at all; `-` and devices are written as they are.

    A file that exists keeps its permissions, and a link still points where it did.

    Raises:
        OSError: it cannot be written; with its name, and the old file untouched.
    """
    if path == STANDARD:
        sys.stdout.write(text)
        return
    target = Path(path).resolve()
    try:
        mode = _mode_of(target)
        if mode is None:
            target.write_text(text, encoding="utf-8")
            return
        with _scratch_beside(target) as scratch:
            scratch.write(text.encode())
            scratch.flush()
            os.fchmod(scratch.fileno(), mode)
            os.fsync(scratch.fileno())
            Path(scratch.name).replace(target)
    except OSError as error:
        is_folder_missing = isinstance(error, FileNotFoundError)
        error.filename = str(target.parent) if is_folder_missing else path
        error.filename2 = None
        raise


def print_json(value: object) -> None:
    """`value` as one line of JSON on standard output, where a reader finds it at once."""
    readable = sys.stdout.encoding.lower().replace("-", "") == "utf8"
    print_lines([json.dumps(value, ensure_ascii=not readable)])


def print_lines(lines: Iterable[str]) -> None:
    """Lines on standard output, where a reader finds them at once.

    Raises:
        ReaderGoneError: nobody reads them.
        OSError: they cannot be written; with the name of standard output.
    """
    try:
        sys.stdout.writelines(f"{line}\n" for line in lines)
        sys.stdout.flush()
    except BrokenPipeError:
        raise ReaderGoneError from None
    except OSError as error:
        error.filename = STANDARD_OUTPUT
        raise


@contextlib.contextmanager
def progress(what: str, total: int | None, *, wanted: bool = True) -> Generator[Advance]:
    """Show how far a long task is, on standard error if that is a terminal.

    Args:
        what: the task.
        total: how much there is to do; None when nobody knows.
        wanted: False shows nothing.
    """
    if not (wanted and sys.stderr.isatty()):
        yield _ignore
        return
    bar = _Bar(what, total)
    try:
        yield bar.advance
    finally:
        bar.close()


@contextlib.contextmanager
def waiting(what: str) -> Generator[None]:
    """Show that something is going on whose progress nobody knows, as `progress` does."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(what):
        yield


class _Bar:
    """A progress bar that appears only once its task has taken a while."""

    def __init__(self, what: str, total: int | None) -> None:
        self._what, self._total, self._done = what, total, 0
        self._due = time.monotonic() + PATIENCE_S
        self._shown: Callable[[int], None] | None = None
        self._resources = contextlib.ExitStack()

    def advance(self, more: int) -> None:
        """So much more is done."""
        self._done += more
        if self._shown is None and time.monotonic() >= self._due:
            self._shown = self._appear()
        if self._shown is not None:
            self._shown(self._done)

    def close(self) -> None:
        """Take the bar off the screen."""
        self._resources.close()

    def _appear(self) -> Callable[[int], None]:
        from rich.console import Console
        from rich.progress import Progress

        bar = self._resources.enter_context(Progress(console=Console(stderr=True), transient=True))
        task = bar.add_task(self._what, total=self._total)
        return lambda done: bar.update(task, completed=done)


def _ignore(_more: int) -> None:
    pass


def _opened(path: str) -> contextlib.AbstractContextManager[io.BufferedReader]:
    if path == STANDARD:
        # It stays open: whoever gave it to us closes it.
        return contextlib.nullcontext(cast("io.BufferedReader", sys.stdin.buffer))
    return Path(path).open("rb")


def _read(file: io.BufferedReader, path: str) -> bytes:
    try:
        return file.read1(CHUNK_BYTES)
    except OSError as error:
        error.filename = named(path)
        raise


@contextlib.contextmanager
def _scratch_beside(target: Path) -> Generator[IO[bytes]]:
    """A new file in the same folder, so that renaming it is one step; gone if that fails."""
    import tempfile

    with tempfile.NamedTemporaryFile(dir=target.parent, prefix=".maestra-", delete=False) as file:
        try:
            yield file
        except BaseException:
            Path(file.name).unlink(missing_ok=True)
            raise


def _mode_of(target: Path) -> int | None:
    """The permissions to write `target` with; None for a device or a pipe, which is no file."""
    try:
        status = target.stat()
    except FileNotFoundError:
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    return stat.S_IMODE(status.st_mode) if stat.S_ISREG(status.st_mode) else None
