"""JSON Lines, line by line: bytes that somebody else read, cut anywhere, into JSON objects.

Pure; knows nothing of what the objects mean but their `format`.
"""

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from decimal import Decimal, InvalidOperation
from typing import Final, NoReturn, cast

from maestra.core.faults import Fault, InvalidError, one_line, shorten

MAX_LINE_BYTES: Final = 4 * 2**20
"""A full 100 x 100 board takes about 1 MB; a longer line is a wrong file, not a demonstration."""
MAX_VERSION_DIGITS: Final = 9
"""Digits of a format's version that are read as a number."""

_BOM: Final = b"\xef\xbb\xbf"
"""What Windows programs put before UTF-8; files put end to end have it on later lines too."""
_HALF: Final = re.compile(rb"\\u[dD][89a-fA-F]")
"""The escape of half a character, of which JSON needs two for one beyond the first 65,536."""
_SIGNATURES: Final = (
    (b"\xff\xfe", "UTF-16 text"),
    (b"\xfe\xff", "UTF-16 text"),
    (b"\x1f\x8b", "a file compressed by gzip"),
    (b"PK\x03\x04", "a zip archive"),
)
"""First bytes of what people hand over by mistake, each with its name."""


class FormatError(InvalidError):
    """Input that is no demonstration: the file, the line (from 1), and every fault in it."""

    def __init__(self, file: str, line: int, faults: tuple[Fault, ...]) -> None:
        """Keep where it was found."""
        super().__init__(faults)
        self.args: tuple[object, ...] = (file, line, faults)
        self.file: str = file
        self.line: int = line

    def __str__(self) -> str:
        """One line: file, line, and each fault with its field and what was expected."""
        return f"{one_line(self.file)}, line {self.line}: {super().__str__()}"


def split_lines(chunks: Iterable[bytes], file: str) -> Iterator[tuple[int, bytes]]:
    """The lines that are not blank, numbered from 1; chunks may be cut anywhere.

    Raises:
        FormatError: a line of more than `MAX_LINE_BYTES`; raised before it is read to its end.
    """
    rest, number = bytearray(), 1
    for chunk in chunks:
        *ends, start = chunk.split(b"\n")
        for end in ends:
            _demand_room(len(rest) + len(end), file, number)
            rest += end
            if not _is_blank(rest):
                yield number, bytes(rest)
            rest.clear()
            number += 1
        _demand_room(len(rest) + len(start), file, number)
        rest += start
    if not _is_blank(rest):
        yield number, bytes(rest)


def decode_object(line: bytes, file: str, number: int, wanted: str) -> dict[str, object]:
    """The JSON object on `line`, whose `format` must be `wanted`.

    Numbers with a fraction come as `Decimal`, so that nothing is lost on the way.

    Raises:
        FormatError: as `parse_object`, or another or newer format.
    """
    fields = parse_object(line, file, number)
    written = fields.get("format")
    if written != wanted:
        raise FormatError(file, number, (Fault("format", *_other_format(written, wanted)),))
    return fields


def parse_object(line: bytes, file: str, number: int) -> dict[str, object]:
    """The JSON object on `line`, of whatever format.

    Raises:
        FormatError: not UTF-8, not JSON, a name twice, not an object.
    """
    try:
        parsed = _parse(line)
    except InvalidError as error:
        raise FormatError(file, number, error.faults) from None
    if not isinstance(parsed, dict):
        raise FormatError(file, number, (Fault("", shorten(parsed), "a JSON object"),))
    return cast("dict[str, object]", parsed)


def _parse(line: bytes) -> object:
    """The JSON on `line`.

    Raises:
        InvalidError: there is none, or one that readers would not agree on.
    """
    try:
        parsed: object = _DECODER.decode(line.removeprefix(_BOM).decode())
        if _HALF.search(line) is not None:
            json.dumps(parsed, ensure_ascii=False, default=str).encode()
    except UnicodeDecodeError as error:
        refusal = Fault("", _name_bytes(line, error.start), "JSON Lines in UTF-8")
    except UnicodeEncodeError:
        refusal = Fault("", "half a character (\\ud800 to \\udfff alone)", "whole characters")
    except json.JSONDecodeError as error:
        found = f"not JSON ({error.msg.removesuffix(' at')} at character {error.pos + 1})"
        refusal = Fault("", found, "one JSON object a line")
    except InvalidError:
        raise
    except (RecursionError, ValueError):
        found = "brackets nested too deep, or a number with thousands of digits"
        refusal = Fault("", found, "a plain JSON object")
    else:
        return parsed
    raise InvalidError([refusal])


def _is_blank(line: bytearray) -> bool:
    return not line.removeprefix(_BOM).strip()


def _demand_room(length: int, file: str, number: int) -> None:
    if length > MAX_LINE_BYTES:
        found = f"a line longer than {MAX_LINE_BYTES // 2**20} MB"
        raise FormatError(file, number, (Fault("", found, "one JSON object a line"),))


def _name_bytes(line: bytes, wrong: int) -> str:
    """What bytes that are not UTF-8 seem to be; the first wrong one is at index `wrong`."""
    for signature, name in _SIGNATURES:
        if line.startswith(signature):
            return name
    return f"bytes that are not UTF-8 text (0x{line[wrong]:02x} at byte {wrong + 1})"


def _other_format(found: object, wanted: str) -> tuple[str, str]:
    """What to say of a format that is not the wanted one: found, expected."""
    kind, _, version = wanted.partition("/")
    name, _, other = (found if isinstance(found, str) else "").partition("/")
    if (
        name == kind
        and other.isdecimal()
        and len(other) <= MAX_VERSION_DIGITS
        and int(other) > int(version)
    ):
        found_words = f"{shorten(found)}, which needs a newer Maestra"
        return found_words, f"{shorten(wanted)} or older"
    return ("missing" if found is None else shorten(found)), shorten(wanted)


def _number(text: str) -> int | Decimal:
    """A JSON number with a point or exponent; what 64 bits cannot hold is refused, not rounded."""
    try:
        value = Decimal(text)
    except InvalidOperation:  # an exponent of twenty digits
        value = Decimal("NaN")
    if Decimal(repr(float(text))) != value:
        raise InvalidError([Fault("", f"the number {shorten(text)}", "at most 15 digits")])
    return int(value) if value == value.to_integral_value() else value


def _no_constant(text: str) -> NoReturn:
    raise InvalidError([Fault("", text, "a number")])


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    fields = dict(pairs)
    if len(fields) < len(pairs):
        times = Counter(name for name, _ in pairs)
        twice = [name for name in fields if times[name] > 1]
        raise InvalidError([Fault(shorten(name), "twice", "each name once") for name in twice])
    return fields


# Made once: json.loads would make one for each line.
_DECODER: Final = json.JSONDecoder(
    parse_float=_number, parse_constant=_no_constant, object_pairs_hook=_object
)
