"""What a person reads about a file that is no file of demonstrations: golden lines.

Each says the file, the line, the field, what is there and what was expected.
"""

import json
import tracemalloc
from collections.abc import Iterable, Iterator
from typing import cast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.demonstration import MAX_MOVES
from maestra.core.formats import read_demonstrations
from maestra.core.json_faults import MAX_FAULTS
from maestra.core.json_lines import MAX_LINE_BYTES, FormatError
from tests.core.bad_lines import GOOD, LINE, WRONG_PLAY, WRONG_SHAPE, Path, changed


def refusal(*chunks: bytes) -> str:
    return refusal_of(chunks)


def refusal_of(chunks: Iterable[bytes]) -> str:
    said = outcome(chunks)
    assert said
    assert said.isprintable()
    return said


def outcome(chunks: Iterable[bytes]) -> str:
    """What is said of a file; nothing if it is read to its end."""
    try:
        for _ in read_demonstrations(chunks, "demos.jsonl"):
            pass
    except FormatError as error:
        return str(error)
    return ""


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


@pytest.mark.parametrize(
    ("line", "said"),
    [case[1:] for case in (*WRONG_SHAPE, *WRONG_PLAY)],
    ids=[case[0] for case in (*WRONG_SHAPE, *WRONG_PLAY)],
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
        'demos.jsonl, line 1: moves: [{"token": "04A3B2", "origin": [2, 1], '
        '"destination": [1,..., '
        "expected at most 10000 entries"
    )


@pytest.mark.parametrize(
    ("field", "value", "faults"),
    [
        ("lexicon", [1] * 1_500_000, 1),
        ("lexicon", [1] * 900_000, 1),
        ("start", {str(index): 1 for index in range(100_000)}, 1),
        ("tokens", {str(index): 1 for index in range(100_000)}, 1),
        ("moves", [1] * 1_000_000, 1),
        ("times_ms", ["x"] * 100_000, 1),
        ("orders", {"a": [1] * 9_000, "b": [1] * 1_000_000}, 2),
        ("relations", {"a": [1] * 9_000, "b": [1] * 1_000_000}, 2),
        ("moves", [1] * 9_999, 9_999),
        ("orders", {str(index): 1 for index in range(100_000)}, MAX_FAULTS),
    ],
)
def test_a_million_wrong_entries_are_not_a_million_faults(
    field: str, value: object, faults: int
) -> None:
    with pytest.raises(FormatError) as caught:
        list(read_demonstrations([changed(((field,), value))], "demos.jsonl"))
    assert len(caught.value.faults) == faults


def test_a_name_with_a_line_end_cannot_break_the_line() -> None:
    said = refusal(changed((("a\nb\u2028c",), 1)))
    assert said.startswith(r"demos.jsonl, line 1: a\nb\u2028c: unknown field, expected one of ")


def paths(fields: object, at: Path = ()) -> Iterator[Path]:
    """The place of everything within a line."""
    steps: dict[str | int, object] = {}
    if isinstance(fields, dict):
        steps = cast("dict[str | int, object]", fields)
    elif isinstance(fields, list):
        steps = dict(enumerate(cast("list[object]", fields)))
    for step, value in steps.items():
        yield (*at, step)
        yield from paths(value, (*at, step))


ANY_JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(st.characters())
    | st.sampled_from(["04A3B2", "04A3B3", 2, 1, "colour", "value", [1, 1], [2, 1]]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=5,
)
FULL = json.loads(
    changed(
        (("orders",), {"colour": ["red", "blue"]}),
        (("cycles",), {}),
        (("relations",), {"partner": [["cup", "saucer"]]}),
        (("lexicon",), ["CURIE"]),
        (("label",), "a note"),
        (("times_ms",), [5, 9]),
        (("source",), "board"),
    )
)


@given(st.lists(st.tuples(st.sampled_from(list(paths(FULL))), ANY_JSON), min_size=1, max_size=3))
def test_whatever_stands_in_whatever_field_is_read_or_refused_in_one_line(
    changes: list[tuple[Path, object]],
) -> None:
    inner_first = sorted(changes, key=lambda change: -len(change[0]))
    assert outcome([changed(*inner_first, line=FULL)]).isprintable()


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
