from collections.abc import Iterator, Sequence
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.json_lines import MAX_LINE_BYTES, FormatError, decode_object, split_lines

WANTED = "maestra.demonstration/1"


def lines_of(*chunks: bytes) -> list[tuple[int, bytes]]:
    return list(split_lines(chunks, "demos.jsonl"))


def decode(text: str | bytes) -> dict[str, object]:
    line = text if isinstance(text, bytes) else text.encode()
    return decode_object(line, "demos.jsonl", 3, WANTED)


def refusal(text: str | bytes) -> str:
    with pytest.raises(FormatError) as caught:
        decode(text)
    assert (caught.value.file, caught.value.line) == ("demos.jsonl", 3)
    return str(caught.value).removeprefix("demos.jsonl, line 3: ")


def object_with(value: str) -> str:
    return f'{{"format": "{WANTED}", "value": {value}}}'


# ---------------------------------------------------------------- lines


@pytest.mark.parametrize(
    ("content", "lines"),
    [
        (b"", []),
        (b"\n\r\n \t\n", []),
        (b"\xef\xbb\xbf", []),
        (b"\xef\xbb\xbf\r\n", []),
        (b"a", [(1, b"a")]),
        (b"a\nb\n", [(1, b"a"), (2, b"b")]),
        (b"a\r\n\r\nb\r\n", [(1, b"a\r"), (3, b"b\r")]),
        (b"\n\na", [(3, b"a")]),
    ],
)
def test_lines_are_numbered_and_blank_ones_passed_over(
    content: bytes, lines: list[tuple[int, bytes]]
) -> None:
    assert lines_of(content) == lines


@given(st.data())
def test_any_chunking_yields_the_same_lines(data: st.DataObject) -> None:
    content = data.draw(st.lists(st.sampled_from([b"a", b"\r", b"\n", b"\xef\xbb\xbf", b" "])))
    whole = b"".join(content)
    assert lines_of(*content) == lines_of(whole) == lines_of(*(bytes([one]) for one in whole))


def test_a_line_as_long_as_the_limit_is_read() -> None:
    line = b"x" * MAX_LINE_BYTES
    assert lines_of(line) == lines_of(line + b"\n") == lines_of(line[:5], line[5:]) == [(1, line)]


@pytest.mark.parametrize(
    "chunks",
    [
        [b"a\n" + b"x" * (MAX_LINE_BYTES + 1)],
        [b"a\n", b" " * MAX_LINE_BYTES, b" \n"],
        [b"a\n" + b"x" * MAX_LINE_BYTES + b"\r\n"],
    ],
)
def test_a_longer_line_is_refused_after_those_before_it(chunks: Sequence[bytes]) -> None:
    lines = split_lines(chunks, "demos.jsonl")
    assert next(lines) == (1, b"a")
    with pytest.raises(FormatError) as caught:
        next(lines)
    assert str(caught.value) == (
        "demos.jsonl, line 2: a line longer than 4 MB, expected one JSON object a line"
    )


def test_an_endless_line_is_not_read_beyond_the_limit() -> None:
    asked = 0

    def endless() -> Iterator[bytes]:
        nonlocal asked
        while True:
            asked += 2**16
            yield b"x" * 2**16

    with pytest.raises(FormatError):
        next(split_lines(endless(), "demos.jsonl"))
    assert asked <= MAX_LINE_BYTES + 2**16


# ---------------------------------------------------------------- objects


def test_a_byte_order_mark_and_a_windows_line_end_are_read() -> None:
    assert decode(b"\xef\xbb\xbf" + object_with("1").encode() + b"\r") == {
        "format": WANTED,
        "value": 1,
    }


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("19", 19),
        ("-0", 0),
        ("1.0", 1),
        ("1e2", 100),
        ("-0.0", 0),
        ("0.1", Decimal("0.1")),
        ("1.10", Decimal("1.1")),
        ("1E-7", Decimal("0.0000001")),
        ("5e-324", Decimal("5E-324")),
        ("999999999999999", 10**15 - 1),
        ("0.123456789012345", Decimal("0.123456789012345")),
    ],
)
def test_numbers_are_read_as_they_are_written(written: str, value: Decimal | int) -> None:
    read = decode(object_with(written))["value"]
    assert read == value
    assert type(read) is type(value)


@given(st.decimals(allow_nan=False, allow_infinity=False))
def test_a_decimal_number_is_read_exactly_or_refused(number: Decimal) -> None:
    written = object_with(f"{number:e}")
    if Decimal(repr(float(number))) == number:
        assert decode(written)["value"] == number
    else:
        assert "expected at most 15 digits" in refusal(written)


@pytest.mark.parametrize(
    "number",
    ["0.1234567890123456789", "1e400", "1e99999999999999999999", "1e-400", "1e-9" + "9" * 30],
)
def test_a_number_that_would_be_rounded_is_refused(number: str) -> None:
    assert refusal(object_with(number)) == f'the number "{number}", expected at most 15 digits'


@pytest.mark.parametrize("constant", ["NaN", "Infinity", "-Infinity"])
def test_what_is_no_number_in_json_is_refused(constant: str) -> None:
    assert refusal(object_with(constant)) == f"{constant}, expected a number"


def test_a_name_twice_is_refused_at_any_depth() -> None:
    assert refusal('{"format": 1, "format": 2}') == '"format": twice, expected each name once'
    assert refusal(object_with('[{"b": 1, "a": 1, "c": 0, "b": 2, "a": 3}]')) == (
        '"b": twice, expected each name once; "a": twice, expected each name once'
    )


def test_characters_written_as_escapes_are_read_and_halves_of_them_refused() -> None:
    assert decode(object_with(r'"\ud83d\uDE00"'))["value"] == "\U0001f600"
    said = r"half a character (\ud800 to \udfff alone), expected whole characters"
    assert refusal(object_with(r'"\ud800"')) == said
    assert refusal(object_with(r'[0.5, {"\uDFFF": 1}]')) == said


@pytest.mark.parametrize("parsed", ["[]", '"text"', "19", "null", "true"])
def test_what_is_no_object_is_refused(parsed: str) -> None:
    assert refusal(parsed) == f"{parsed}, expected a JSON object"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "not JSON (Expecting value at character 1)"),
        ("{", "not JSON (Expecting property name enclosed in double quotes at character 2)"),
        ("{}{}", "not JSON (Extra data at character 3)"),
        ("rows,columns", "not JSON (Expecting value at character 1)"),
        ('{"a": "b', "not JSON (Unterminated string starting at character 7)"),
        ('{"a": "\t"}', "not JSON (Invalid control character at character 8)"),
    ],
)
def test_what_is_not_json_is_refused_with_its_place(text: str, said: str) -> None:
    assert refusal(text) == f"{said}, expected one JSON object a line"


@pytest.mark.parametrize(
    "text", ["[" * 100_000, '{"a":' * 100_000, object_with("9" * 5_000), object_with("[" * 3_000)]
)
def test_endless_brackets_and_numbers_are_refused(text: str) -> None:
    assert refusal(text) == (
        "brackets nested too deep, or a number with thousands of digits, "
        "expected a plain JSON object"
    )


def test_brackets_nearly_too_deep_never_give_a_traceback() -> None:
    for depth in range(800, 1_000):
        said = refusal("[" * depth + r'"\ud83d\ude00"' + "]" * depth)
        assert said.endswith("JSON object")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b'{"a": "\x93"}', "bytes that are not UTF-8 text (0x93 at byte 8)"),
        ("{}".encode("utf-16"), "UTF-16 text"),
        (b"\xfe\xff\x00{\x00}", "UTF-16 text"),
        (b"\x1f\x8b\x08\x00\x00", "a file compressed by gzip"),
        (b"PK\x03\x04\x14\x00\xff", "a zip archive"),
        (bytes(range(128, 256)), "bytes that are not UTF-8 text (0x80 at byte 1)"),
    ],
)
def test_bytes_that_are_no_text_are_named(content: bytes, said: str) -> None:
    assert refusal(content) == f"{said}, expected JSON Lines in UTF-8"


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("null", "format: missing"),
        ("1", "format: 1"),
        ('["maestra.demonstration/2"]', 'format: ["maestra.demonstration/2"]'),
        ('"maestra.exercise/1"', 'format: "maestra.exercise/1"'),
        ('"maestra.demonstration"', 'format: "maestra.demonstration"'),
        ('"maestra.demonstration/0"', 'format: "maestra.demonstration/0"'),
        ('"maestra.demonstration/-2"', 'format: "maestra.demonstration/-2"'),
        ('"maestra.demonstration/9999999999"', 'format: "maestra.demonstration/9999999999"'),
    ],
)
def test_another_format_is_refused(written: str, said: str) -> None:
    assert refusal(f'{{"format": {written}}}') == f'{said}, expected "{WANTED}"'


def test_a_missing_format_is_refused() -> None:
    assert refusal("{}") == f'format: missing, expected "{WANTED}"'


def test_a_newer_version_is_refused_with_the_version_it_needs() -> None:
    assert refusal('{"format": "maestra.demonstration/12", "new": 1}') == (
        'format: "maestra.demonstration/12", which needs a newer Maestra, '
        f'expected "{WANTED}" or older'
    )
