"""Read a million demonstrations and say how fast and in how much memory: `make million`.

    python benchmarks/million.py [HOW_MANY]

The lines are of the paper's size: ten tokens, five moves, 0.9 kB. They are made as they are read,
so that the process holds nothing of the file but the chunk under way.
"""

import json
import resource
import sys
import time
from collections.abc import Iterator
from random import Random
from typing import Final

from maestra.core.board import Board
from maestra.core.formats import DEMONSTRATION_FORMAT, read_demonstrations

HOW_MANY: Final = 1_000_000
DIFFERENT: Final = 1_000
"""Different lines, in turn: making each anew would take longer than reading it."""
WARM: Final = 10_000
"""Demonstrations after which nothing more is loaded or cached."""
CHUNK_LINES: Final = 64
MOST_GROWTH_KB: Final = 4_096
"""A tenth of a million kept demonstrations would be a hundred times as much."""


def main() -> int:
    """Read them; 1 if memory grew."""
    how_many = int(sys.argv[1]) if len(sys.argv) > 1 else HOW_MANY
    lines = [_line(number) for number in range(DIFFERENT)]
    begin, warm_kb, count = time.perf_counter(), 0, 0
    for count, _ in enumerate(read_demonstrations(_chunks(lines, how_many), "-"), start=1):
        if count == WARM:
            warm_kb = _peak_kb()
    seconds = time.perf_counter() - begin
    growth_kb = _peak_kb() - warm_kb
    size_mb = how_many * sum(map(len, lines)) / len(lines) / 1e6
    print(f"{count:,} demonstrations, {size_mb:,.0f} MB, in {seconds:.0f} s")
    print(f"{count / seconds:,.0f} a second, {size_mb / seconds:.1f} MB a second")
    print(f"memory at most {_peak_kb():,} kB, {growth_kb:,} kB more than after {WARM:,}")
    return int(growth_kb > MOST_GROWTH_KB or count != how_many)


def _chunks(lines: list[bytes], how_many: int) -> Iterator[bytes]:
    for start in range(0, how_many, CHUNK_LINES):
        numbers = range(start, min(start + CHUNK_LINES, how_many))
        yield b"".join(lines[number % len(lines)] for number in numbers)


def _line(number: int) -> bytes:
    chance, board = Random(number), Board()
    ids = [f"04A3B2{index:02X}" for index in range(10)]
    cells = chance.sample(board.storage_cells, len(ids))
    start = {token: [cell.row, cell.column] for token, cell in zip(ids, cells, strict=True)}
    moves = [
        {"token": ids[index], "origin": start[ids[index]], "destination": [1, column]}
        for column, index in enumerate(sorted(chance.sample(range(10), 5)), start=1)
    ]
    fields = {
        "format": DEMONSTRATION_FORMAT,
        "board": {"rows": board.rows, "columns": board.columns, "goal_row": board.goal_row},
        "tokens": {token: {"value": 10 + index} for index, token in enumerate(ids)},
        "start": start,
        "moves": moves,
    }
    return json.dumps(fields).encode() + b"\n"


def _peak_kb() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


if __name__ == "__main__":
    sys.exit(main())
