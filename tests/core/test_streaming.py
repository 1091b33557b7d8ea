"""A file of any length is read in the same memory; `make million` reads a long one."""

import sys
from collections.abc import Iterator
from itertools import islice

from maestra.core.formats import read_demonstrations
from tests.core.bad_lines import changed

CHUNK_BYTES = 2**16
ROOM_BLOCKS = 200
"""What else may be allocated by the way; a kept demonstration takes thirty blocks or more."""


def file_of(demonstrations: int) -> Iterator[bytes]:
    """Chunks of a file in which the deck, the start and the moves differ from line to line."""
    lines = [
        changed(
            (("tokens", "04A3B2", "value"), number % 7),
            (("start", "04A3B3"), [4, 1 + number % 5]),
            (("moves", 1, "origin"), [4, 1 + number % 5]),
        )
        + b"\n"
        for number in range(35)
    ]
    rest = b""
    for number in range(demonstrations):
        rest += lines[number % len(lines)]
        while len(rest) >= CHUNK_BYTES:
            yield rest[:CHUNK_BYTES]
            rest = rest[CHUNK_BYTES:]
    yield rest


def most_blocks(reader: Iterator[object], demonstrations: int) -> int:
    """The most memory blocks allocated at once while so many are read."""
    return max(sys.getallocatedblocks() for _ in islice(reader, demonstrations))


def test_memory_does_not_grow_with_the_length_of_a_file() -> None:
    reader = read_demonstrations(file_of(20_000), "demos.jsonl")
    most_blocks(reader, 1_000)  # whatever is loaded or cached at first
    early = most_blocks(reader, 1_000)
    late = most_blocks(reader, 18_000)
    assert next(reader, None) is None
    assert late <= early + ROOM_BLOCKS
