import io
import os
import stat
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from maestra.cli import streams
from maestra.cli.streams import (
    print_json,
    print_lines,
    progress,
    read_chunks,
    read_whole,
    size_of,
    waiting,
    write_file,
)
from maestra.cli.terms import ReaderGoneError
from maestra.core.json_lines import FormatError


class Terminal(io.StringIO):
    """What says of itself that it is a terminal."""

    def isatty(self) -> bool:
        return True


def permissions(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


def test_a_file_is_written_whole_and_nothing_else_is_left(tmp_path: Path) -> None:
    write_file(str(tmp_path / "x.json"), "é\n")
    assert (tmp_path / "x.json").read_bytes() == "é\n".encode()
    assert [path.name for path in tmp_path.iterdir()] == ["x.json"]


def test_a_new_file_has_the_permissions_that_the_user_wants(tmp_path: Path) -> None:
    mask = os.umask(0o027)
    try:
        write_file(str(tmp_path / "x.json"), "")
    finally:
        os.umask(mask)
    assert permissions(tmp_path / "x.json") == 0o640


def test_a_file_that_exists_keeps_its_permissions(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.touch()
    path.chmod(0o604)
    write_file(str(path), "new")
    assert (permissions(path), path.read_text()) == (0o604, "new")


def test_a_link_still_points_where_it_did(tmp_path: Path) -> None:
    (tmp_path / "real.json").write_text("old")
    (tmp_path / "link.json").symlink_to("real.json")
    write_file(str(tmp_path / "link.json"), "new")
    assert (tmp_path / "link.json").is_symlink()
    assert (tmp_path / "real.json").read_text() == "new"


def test_a_file_that_cannot_be_finished_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "x.json"
    path.write_text("old")

    def full(_descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left") as caught:
        write_file(str(path), "new")
    assert caught.value.filename == str(path)
    assert path.read_text() == "old"
    assert [one.name for one in tmp_path.iterdir()] == ["x.json"]


def test_a_folder_is_not_written_over(tmp_path: Path) -> None:
    with pytest.raises(IsADirectoryError):
        write_file(str(tmp_path), "")


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as caught:
        write_file(str(tmp_path / "gone" / "x.json"), "")
    assert caught.value.filename == str(tmp_path / "gone")


def test_a_device_is_written_as_it_is() -> None:
    write_file("/dev/null", "lost")
    assert Path("/dev/null").is_char_device()


def test_a_dash_is_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    write_file("-", "text")
    assert capsys.readouterr().out == "text"


def test_the_size_of_what_is_no_file_is_not_known(tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"123")
    assert size_of(str(tmp_path / "x")) == 3
    assert size_of("-") is None
    assert size_of(str(tmp_path)) is None
    assert size_of(str(tmp_path / "gone")) is None


def test_reading_tells_how_much_was_read(tmp_path: Path) -> None:
    (tmp_path / "x").write_bytes(b"1" * 100_000)
    told: list[int] = []
    assert b"".join(read_chunks(str(tmp_path / "x"), told.append)) == b"1" * 100_000
    assert sum(told) == 100_000


def test_an_error_while_reading_names_the_file(monkeypatch: pytest.MonkeyPatch) -> None:
    class Broken(io.BytesIO):
        def read1(self, size: int | None = -1) -> bytes:
            assert size
            raise OSError(5, "Input/output error")

    stdin = io.TextIOWrapper(Broken())
    monkeypatch.setattr(sys, "stdin", stdin)
    with pytest.raises(OSError, match="Input/output error") as caught:
        list(read_chunks("-"))
    assert caught.value.filename == "standard input"


def test_a_file_too_long_for_an_exercise_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(streams, "MAX_EXERCISE_BYTES", 2**20)
    (tmp_path / "x").write_bytes(b" " * (2**20 + 1))
    with pytest.raises(FormatError, match="x, line 1: more than 1 MB, expected an exercise"):
        read_whole(str(tmp_path / "x"))


@pytest.mark.parametrize(
    ("encoding", "line"),
    [("utf-8", '{"a": "é"}\n'.encode()), ("latin-1", b'{"a": "\\u00e9"}\n')],
)
def test_json_can_be_read_whatever_the_encoding(
    monkeypatch: pytest.MonkeyPatch, encoding: str, line: bytes
) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding))
    print_json({"a": "é"})
    assert written.getvalue() == line


def test_standard_output_without_room_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    class Full(io.StringIO):
        def flush(self) -> None:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(sys, "stdout", Full())
    with pytest.raises(OSError, match="No space left") as caught:
        print_lines(["x"])
    assert caught.value.filename == "standard output"


def test_a_reader_that_is_gone_is_told_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    class Closed(io.StringIO):
        def flush(self) -> None:
            raise BrokenPipeError

    monkeypatch.setattr(sys, "stdout", Closed())
    with pytest.raises(ReaderGoneError):
        print_lines(["x"])


def shown_while(monkeypatch: pytest.MonkeyPatch, work: Callable[[streams.Advance], None]) -> str:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with progress("Reading", 10) as advance:
        work(advance)
    return terminal.getvalue()


def test_a_task_that_takes_long_shows_its_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(streams, "PATIENCE_S", 0.0)

    def work(advance: streams.Advance) -> None:
        advance(4)
        time.sleep(0.01)
        advance(5)

    assert "Reading" in shown_while(monkeypatch, work)


def test_a_task_that_is_soon_done_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(streams, "PATIENCE_S", 3_600.0)
    assert shown_while(monkeypatch, lambda advance: advance(4)) == ""


def test_progress_is_shown_on_a_terminal_only(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(streams, "PATIENCE_S", 0.0)
    with progress("Reading", None) as advance:
        advance(1)
    assert capsys.readouterr().err == ""


def test_progress_that_is_not_wanted_is_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(streams, "PATIENCE_S", 0.0)
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with progress("Reading", None, wanted=False) as advance:
        advance(1)
    assert terminal.getvalue() == ""


def test_a_wait_of_unknown_length_is_shown_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with waiting("Planning"):
        time.sleep(0.01)
    assert "Planning" in terminal.getvalue()


def test_a_wait_is_not_shown_where_nobody_looks(capsys: pytest.CaptureFixture[str]) -> None:
    with waiting("Planning"):
        pass
    assert capsys.readouterr() == ("", "")
