"""What a person reads about a file that is no file of demonstrations: golden lines.

Each says the file, the line, the field, what is there and what was expected.
"""

import json
import tracemalloc
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import deepcopy
from typing import Any

import pytest

from maestra.core.demonstration import MAX_MOVES
from maestra.core.formats import DEMONSTRATION_FORMAT, read_demonstrations
from maestra.core.json_lines import MAX_LINE_BYTES, FormatError

Path = tuple[str | int, ...]

GOOD: Mapping[str, object] = {
    "format": DEMONSTRATION_FORMAT,
    "board": {"rows": 4, "columns": 5, "goal_row": 1},
    "tokens": {"04A3B2": {"value": 19}, "04A3B3": {"value": 23, "colour": "red"}},
    "start": {"04A3B2": [2, 1], "04A3B3": [3, 4]},
    "moves": [
        {"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]},
        {"token": "04A3B3", "origin": [3, 4], "destination": [1, 2]},
    ],
}
LINE = json.dumps(GOOD).encode()


def changed(*changes: tuple[Path, object]) -> bytes:
    """The good line with some fields changed."""
    fields: Any = deepcopy(dict(GOOD))
    for path, value in changes:
        within = fields
        for step in path[:-1]:
            within = within[step]
        within[path[-1]] = value
    return json.dumps(fields).encode()


def without(name: str) -> bytes:
    return json.dumps({key: value for key, value in GOOD.items() if key != name}).encode()


def refusal(*chunks: bytes) -> str:
    return refusal_of(chunks)


def refusal_of(chunks: Iterable[bytes]) -> str:
    with pytest.raises(FormatError) as caught:
        for _ in read_demonstrations(chunks, "demos.jsonl"):
            pass
    said = str(caught.value)
    assert said.isprintable()
    return said


@pytest.mark.parametrize("content", [b"", b"\n", b" \r\n\r\n", b"\xef\xbb\xbf", b"\xef\xbb\xbf\n"])
def test_an_empty_file_is_refused(content: bytes) -> None:
    assert refusal(content) == (
        "demos.jsonl, line 1: an empty file, expected at least one demonstration, one a line"
    )


def test_a_file_that_is_not_json_is_refused() -> None:
    assert refusal(LINE + b"\ntoken;from;to\n") == (
        "demos.jsonl, line 2: not JSON (Expecting value at character 1), "
        "expected one JSON object a line"
    )


def test_json_over_several_lines_is_refused() -> None:
    assert refusal(json.dumps(GOOD, indent=2).encode()) == (
        "demos.jsonl, line 1: not JSON (Expecting property name enclosed in double quotes "
        "at character 2), expected one JSON object a line"
    )


def test_a_list_of_demonstrations_is_refused() -> None:
    assert refusal(b"[" + LINE + b"]") == (
        'demos.jsonl, line 1: [{"format": "maestra.demonstration/1", "board": {"rows": ..., '
        "expected a JSON object"
    )


def test_binary_noise_is_refused() -> None:
    assert refusal(bytes(range(128, 256)) * 100) == (
        "demos.jsonl, line 1: bytes that are not UTF-8 text (0x80 at byte 1), "
        "expected JSON Lines in UTF-8"
    )


def test_a_file_of_utf_16_is_refused() -> None:
    assert refusal(LINE.decode().encode("utf-16")) == (
        "demos.jsonl, line 1: UTF-16 text, expected JSON Lines in UTF-8"
    )


def test_another_format_is_refused() -> None:
    assert refusal(changed((("format",), "maestra.exercise/1"))) == (
        'demos.jsonl, line 1: format: "maestra.exercise/1", expected "maestra.demonstration/1"'
    )


def test_a_newer_version_is_refused() -> None:
    newer = changed((("format",), "maestra.demonstration/2"), (("sound",), True))
    assert refusal(LINE, b"\n", newer) == (
        'demos.jsonl, line 2: format: "maestra.demonstration/2", which needs a newer Maestra, '
        'expected "maestra.demonstration/1" or older'
    )


def test_mixed_boards_are_refused() -> None:
    other = changed((("board", "rows"), 3), (("board", "goal_row"), 2))
    assert refusal(b"\n" + LINE + b"\n\n" + other) == (
        "demos.jsonl, line 4: board: 3 x 5 with goal row 2, "
        "expected 4 x 5 with goal row 1 as on line 2"
    )


FIELDS: Sequence[tuple[str, bytes, str]] = [
    (
        "two tokens on a cell",
        changed((("start", "04A3B3"), [2, 1])),
        "start.04A3B3: [2, 1] is taken, expected a cell of its own (04A3B2 lies there)",
    ),
    (
        "a token moved from where it is not",
        changed((("moves", 0, "origin"), [2, 2])),
        "moves[0].origin: 04A3B2 is not on [2, 2], expected [2, 1], where it lies",
    ),
    (
        "a move to an occupied cell",
        changed((("moves", 1, "destination"), [1, 1])),
        "moves[1].destination: [1, 1] is taken by 04A3B2, expected an empty cell",
    ),
    (
        "a move off the board",
        changed((("moves", 1, "destination"), [1, 6])),
        "moves[1].destination: [1, 6] is off the board, expected row 1 to 4 and column 1 to 5",
    ),
    (
        "a start off the board",
        changed((("start", "04A3B3"), [0, -4])),
        "start.04A3B3: [0, -4] is off the board, expected row 1 to 4 and column 1 to 5",
    ),
    (
        "an unknown token is moved",
        changed((("moves", 0, "token"), "04A3B9")),
        "moves[0].token: unknown token 04A3B9, expected a token of the deck",
    ),
    (
        "an unknown token lies on the board",
        changed((("start", "04A3B9"), [4, 4])),
        "start.04A3B9: unknown token, expected a token of the deck",
    ),
    (
        "a token lies nowhere",
        changed((("start",), {"04A3B2": [2, 1]}), (("moves",), [])),
        "start.04A3B3: missing, expected a cell for each token",
    ),
    (
        "an unknown field",
        changed((("colour",), "red")),
        (
            "colour: unknown field, expected one of board, cycles, format, label, lexicon, moves, "
            "orders, relations, source, start, times_ms, tokens"
        ),
    ),
    (
        "an unknown field of the board",
        changed((("board", "cols"), 5)),
        "board.cols: unknown field, expected one of columns, goal_row, rows",
    ),
    (
        "an unknown field of a move",
        changed((("moves", 1, "orgin"), [3, 4])),
        "moves[1].orgin: unknown field, expected one of destination, origin, token",
    ),
    ("no board", without("board"), "board: missing, expected a field of this name"),
    ("no tokens", without("tokens"), "tokens: missing, expected a field of this name"),
    (
        "a move without destination",
        changed((("moves", 1), {"token": "04A3B3", "origin": [3, 4]})),
        "moves[1].destination: missing, expected a field of this name",
    ),
    ("the board a number", changed((("board",), 20)), "board: 20, expected a JSON object"),
    ("tokens a list", changed((("tokens",), [19])), "tokens: [19], expected a JSON object"),
    (
        "a token a number",
        changed((("tokens", "04A3B2"), 19)),
        "tokens.04A3B2: 19, expected a JSON object",
    ),
    ("moves an object", changed((("moves",), {})), "moves: {}, expected a list"),
    ("a move a list", changed((("moves", 0), [1])), "moves[0]: [1], expected a JSON object"),
    (
        "no rows",
        changed((("board", "rows"), 0)),
        "board.rows: 0, expected a whole number from 1 to 100",
    ),
    (
        "rows in words",
        changed((("board", "rows"), "4")),
        'board.rows: "4", expected a whole number from 1 to 100',
    ),
    (
        "a goal row below the board",
        changed((("board", "goal_row"), 5)),
        "board.goal_row: 5, expected a row of the board, 1 to 4",
    ),
    (
        "a cell by name",
        changed((("start", "04A3B2"), "l21")),
        'start.04A3B2: "l21", expected a cell, [row, column]',
    ),
    (
        "half a cell",
        changed((("moves", 0, "origin"), [2])),
        "moves[0].origin: [2], expected a cell, [row, column]",
    ),
    (
        "a cell and a half",
        changed((("start", "04A3B2"), [2.5, 1])),
        "start.04A3B2: [2.5, 1], expected a cell, [row, column]",
    ),
    (
        "an empty id",
        changed((("tokens", ""), {})),
        'tokens.: "", expected text of 1 to 1000 characters without control characters',
    ),
    (
        "an id that would move the cursor",
        changed((("moves", 0, "token"), "\x1b[2J")),
        (
            r'moves[0].token: "\u001b[2J", '
            "expected text of 1 to 1000 characters without control characters"
        ),
    ),
    ("no tokens in tokens", changed((("tokens",), {})), "tokens: no token, expected at least one"),
    (
        "a value that is a list",
        changed((("tokens", "04A3B2", "value"), [19])),
        "tokens.04A3B2.value: [19], expected a number or a string",
    ),
    (
        "a value that is true",
        changed((("tokens", "04A3B2", "value"), True)),
        "tokens.04A3B2.value: true, expected a number or a string",
    ),
    (
        "a value beyond 64 bits",
        changed((("tokens", "04A3B2", "value"), 10**15 + 1)),
        "tokens.04A3B2.value: 1000000000000001, expected a number from -10^15 to 10^15",
    ),
    (
        "numbers and strings under one name",
        changed((("tokens", "04A3B3", "value"), "C")),
        'tokens.04A3B3.value: "C", expected a number as on the other tokens',
    ),
    (
        "an order without a token's value",
        changed((("orders",), {"colour": ["blue", "green"]})),
        'tokens.04A3B3.colour: "red", expected a value of orders.colour',
    ),
    (
        "an order of numbers",
        changed((("cycles",), {"value": [19, 23]})),
        (
            "cycles.value[0]: 19, expected text of 1 to 1000 characters "
            "without control characters; "
            "cycles.value[1]: 23, expected text of 1 to 1000 characters without control characters"
        ),
    ),
    (
        "a relation of three",
        changed((("relations",), {"partner": [["cup", "saucer", "spoon"]]})),
        'relations.partner[0]: ["cup", "saucer", "spoon"], expected a pair of names',
    ),
    (
        "a lexicon in one string",
        changed((("lexicon",), "CURIE")),
        'lexicon: "CURIE", expected a list',
    ),
    (
        "a label that is a number",
        changed((("label",), 1)),
        "label: 1, expected text of at most 1000 characters without control characters",
    ),
    (
        "a time too few",
        changed((("times_ms",), [0])),
        "times_ms: length 1, expected 2, one for each move",
    ),
    (
        "a time before the start",
        changed((("times_ms",), [-1, 0])),
        "times_ms[0]: -1, expected a whole number of milliseconds from 0",
    ),
    (
        "times that fall",
        changed((("times_ms",), [5, 4])),
        (
            "times_ms: times that run backwards or too far, "
            "expected times that rise from 0, up to 10^15"
        ),
    ),
    ("only bad tokens", changed((("tokens",), {"T": 1})), "tokens.T: 1, expected a JSON object"),
    (
        "an order of nothing",
        changed((("orders",), {"size": []})),
        "orders.size: no value, expected the values in their order",
    ),
    (
        "a source of another kind",
        changed((("source",), "dream")),
        'source: "dream", expected one of board, file, simulated',
    ),
]


@pytest.mark.parametrize(
    ("line", "said"), [case[1:] for case in FIELDS], ids=[case[0] for case in FIELDS]
)
def test_each_bad_field_has_its_line(line: bytes, said: str) -> None:
    assert refusal(LINE + b"\n" + line + b"\n") == f"demos.jsonl, line 2: {said}"


def test_every_fault_of_shape_is_said_at_once() -> None:
    line = changed(
        (("board", "rows"), "four"), (("start", "04A3B2"), 1), (("moves", 1, "token"), None)
    )
    said = refusal(line)
    assert [
        part.split(":")[0] for part in said.removeprefix("demos.jsonl, line 1: ").split("; ")
    ] == [
        "board.rows",
        "start.04A3B2",
        "moves[1].token",
    ]


def test_every_fault_of_board_deck_and_start_is_said_at_once() -> None:
    line = changed((("tokens", "04A3B3", "value"), "C"), (("start", "04A3B3"), [2, 1]))
    assert refusal(line) == (
        'demos.jsonl, line 1: tokens.04A3B3.value: "C", expected a number as on the other tokens; '
        "start.04A3B3: [2, 1] is taken, expected a cell of its own (04A3B2 lies there)"
    )
    line = changed((("tokens", "04A3B3", "value"), "C"), (("board", "goal_row"), 5))
    assert refusal(line) == (
        "demos.jsonl, line 1: board.goal_row: 5, expected a row of the board, 1 to 4; "
        'tokens.04A3B3.value: "C", expected a number as on the other tokens'
    )


def test_a_file_wrong_throughout_gives_a_short_line() -> None:
    said = refusal(changed((("moves",), [1] * 5_000)))
    assert said.endswith("moves[9]: 1, expected a JSON object; and 4990 more")


def test_more_moves_than_a_working_day_has_are_refused() -> None:
    moves = [{"token": "04A3B2", "origin": [2, 1], "destination": [1, 1]}] * (MAX_MOVES + 1)
    assert refusal(changed((("moves",), moves))) == (
        "demos.jsonl, line 1: moves: more than 10000, expected at most 10000"
    )


def test_a_name_with_a_line_end_cannot_break_the_line() -> None:
    said = refusal(changed((("a\nb\u2028c",), 1)))
    assert said.startswith(r"demos.jsonl, line 1: a\nb\u2028c: unknown field, expected one of ")


def test_a_line_of_a_gigabyte_is_refused_without_being_read() -> None:
    read = 0

    def gigabyte() -> Iterator[bytes]:
        nonlocal read
        yield LINE + b"\n"
        for _ in range(2**30 // 2**16):
            read += 2**16
            yield b"x" * 2**16

    tracemalloc.start()
    try:
        said = refusal_of(gigabyte())
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert said == (
        "demos.jsonl, line 2: a line longer than 4 MB, expected one JSON object a line"
    )
    assert read <= MAX_LINE_BYTES + 2**16
    assert peak < 3 * MAX_LINE_BYTES
