"""JSON Lines, line by line: bytes that somebody else read, cut anywhere, into JSON objects.

Pure; knows nothing of what the objects mean but their `format`.
"""

from __future__ import annotations

import json
from collections import Counter
from decimal import Decimal
from typing import TYPE_CHECKING, Final, NoReturn, cast

from maestra.core.faults import Fault, InvalidError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

MAX_LINE_BYTES: Final = 16 * 2**20
"""A full 100 x 100 board takes about 1 MB; a longer line is a wrong file, not a demonstration."""
MAX_VERSION_DIGITS: Final = 9
"""Digits of a format's version that are read as a number."""


class FormatError(InvalidError):
    """Input that is no demonstration: the file, the line (from 1), and every fault in it."""

    def __init__(self, file: str, line: int, faults: tuple[Fault, ...]) -> None:
        """Keep where it was found."""
        super().__init__(faults)
        self.file: str = file
        self.line: int = line

    def __str__(self) -> str:
        """One line: file, line, and each fault with its field and what was expected."""
        return f"{self.file}, line {self.line}: {super().__str__()}"


def split_lines(chunks: Iterable[bytes], file: str) -> Iterator[tuple[int, bytes]]:
    """The lines that are not blank, numbered from 1; chunks may be cut anywhere.

    Raises:
        FormatError: a line of more than `MAX_LINE_BYTES`; raised before it is read to its end.
    """
    rest, number = b"", 0
    for chunk in chunks:
        *lines, rest = (rest + chunk).split(b"\n")
        for line in lines:
            number += 1
            if line.strip():
                yield number, _within_limit(line, file, number)
        _within_limit(rest, file, number + 1)
    if rest.strip():
        yield number + 1, rest


def decode_object(line: bytes, file: str, number: int, wanted: str) -> dict[str, object]:
    """The JSON object on `line`, whose `format` must be `wanted`.

    Numbers with a fraction come as `Decimal`, so that nothing is lost on the way.

    Raises:
        FormatError: not UTF-8, not JSON, a name twice, not an object, another or newer format.
    """
    try:
        parsed: object = json.loads(
            line.decode("utf-8-sig"),
            parse_float=_number,
            parse_constant=_no_constant,
            object_pairs_hook=_object,
        )
    except UnicodeDecodeError:
        raise FormatError(file, number, (Fault("", "bytes that are not text", "UTF-8"),)) from None
    except json.JSONDecodeError as error:
        found = f"not JSON ({error.msg} at character {error.pos + 1})"
        raise FormatError(file, number, (Fault("", found, "one JSON object a line"),)) from None
    except InvalidError as error:
        raise FormatError(file, number, error.faults) from None
    except (RecursionError, ValueError):
        found = "brackets nested too deep, or a number with thousands of digits"
        raise FormatError(file, number, (Fault("", found, "a plain JSON object"),)) from None
    if not isinstance(parsed, dict):
        raise FormatError(file, number, (Fault("", "no JSON object", "a JSON object"),))
    fields = cast("dict[str, object]", parsed)
    written = fields.get("format")
    if written != wanted:
        raise FormatError(file, number, (Fault("format", *_other_format(written, wanted)),))
    return fields


def _other_format(found: object, wanted: str) -> tuple[str, str]:
    """What to say of a format that is not the wanted one: found, expected."""
    kind, _, version = wanted.partition("/")
    name, _, other = str(found).partition("/")
    if (
        name == kind
        and other.isdecimal()
        and len(other) <= MAX_VERSION_DIGITS
        and int(other) > int(version)
    ):
        return f"{shorten(found)}, which needs a newer Maestra", f"{wanted!r} or older"
    return ("missing" if found is None else shorten(found)), repr(wanted)


def _within_limit(line: bytes, file: str, number: int) -> bytes:
    if len(line) > MAX_LINE_BYTES:
        found, expected = (
            "a line that goes on and on",
            f"at most {MAX_LINE_BYTES // 2**20} MB",
        )
        raise FormatError(file, number, (Fault("", found, expected),))
    return line


def _number(text: str) -> int | Decimal:
    """A JSON number with a point or exponent; what 64 bits cannot hold is refused, not rounded."""
    value = Decimal(text)
    if Decimal(repr(float(text))) != value:
        raise InvalidError([Fault("", f"the number {shorten(text)}", "at most 15 digits")])
    return int(value) if value == value.to_integral_value() else value


def _no_constant(text: str) -> NoReturn:
    raise InvalidError([Fault("", text, "a number")])


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    fields = dict(pairs)
    if len(fields) < len(pairs):
        twice = [name for name, times in Counter(name for name, _ in pairs).items() if times > 1]
        raise InvalidError([Fault(shorten(name), "twice", "each name once") for name in twice])
    return fields


def shorten(value: object) -> str:
    """`value` as one short piece of a line, whatever it is."""
    text = json.dumps(value, ensure_ascii=False, default=str)
    return text if len(text) <= 60 else f"{text[:57]}..."
