"""A file of demonstrations that may be too long to keep, and is read again then."""

import contextlib
import tempfile
from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass
from typing import IO, Final

from maestra.cli.faults_at import at_line
from maestra.cli.streams import STANDARD, named, progress, read_chunks, size_of
from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.formats import read_numbered
from maestra.core.tokens import Deck
from maestra.rules.decks import merge_decks

MAX_KEPT: Final = 20_000
"""Demonstrations kept while the file is read: some tens of megabytes."""


@dataclass(frozen=True, slots=True)
class Shown:
    """The demonstrations of a file."""

    name: str
    """The file's, for messages."""
    count: int
    deck: Deck
    """Of all of them together."""
    kept: tuple[Demonstration, ...]
    """The first ones; all, unless there are more than `MAX_KEPT`."""
    lines: tuple[int, ...]
    """For each that is kept, its line."""
    path: str
    """Where all of them can be read again."""

    @property
    def is_whole(self) -> bool:
        """Whether all are kept."""
        return self.count == len(self.kept)

    @property
    def board(self) -> Board:
        """The board, the same for all."""
        return self.kept[0].board

    def numbered(self) -> Iterator[tuple[int, Demonstration]]:
        """All of them with their lines, read once more if they were not kept."""
        if self.is_whole:
            yield from zip(self.lines, self.kept, strict=True)
            return
        with progress("Learning", size_of(self.path)) as advance:
            yield from read_numbered(read_chunks(self.path, advance), self.name, Demonstration)


@contextlib.contextmanager
def shown_in(path: str) -> Generator[Shown]:
    """The demonstrations of a file or of standard input, for as long as they are needed.

    Raises:
        OSError: the file cannot be read.
        FormatError: it holds something else, or decks that do not fit together.
    """
    name = named(path)
    with contextlib.ExitStack() as stack:
        advance = stack.enter_context(progress("Reading", size_of(path)))
        chunks = read_chunks(path, advance)
        if path == STANDARD:
            copy = stack.enter_context(tempfile.NamedTemporaryFile(prefix="maestra-"))
            chunks, path = _copied(chunks, copy), copy.name
        yield _survey(chunks, name, path)


def _copied(chunks: Iterator[bytes], copy: IO[bytes]) -> Iterator[bytes]:
    for chunk in chunks:
        copy.write(chunk)
        yield chunk
    copy.flush()


def _survey(chunks: Iterator[bytes], name: str, path: str) -> Shown:
    kept: list[Demonstration] = []
    lines: list[int] = []
    decks: dict[Deck, int] = {}
    latest: Deck | None = None
    count = 0
    for number, shown in read_numbered(chunks, name, Demonstration):
        count += 1
        if count <= MAX_KEPT:
            kept.append(shown)
            lines.append(number)
        if shown.deck is not latest:
            latest = shown.deck
            decks.setdefault(latest, number)
    return Shown(name, count, _merged(decks, name), tuple(kept), tuple(lines), path)


def _merged(decks: Mapping[Deck, int], name: str) -> Deck:
    """One deck out of the decks of a file, each with the line it was on first.

    Raises:
        FormatError: one does not fit to those before it.
    """
    try:
        return merge_decks(list(decks))
    except InvalidError:
        merged: list[Deck] = []
        for deck, number in decks.items():
            merged.append(deck)
            with at_line(name, number):
                merge_decks(merged)
        raise
