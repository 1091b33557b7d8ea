"""What is wrong with an input: every fault at once, each with its place and what was expected."""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from typing import Final, TypeVar

_Built = TypeVar("_Built")

MAX_SAID: Final = 10
"""Faults that a message spells out; a file that is wrong throughout must not fill the screen."""
MAX_PIECE: Final = 200
"""Characters of a place, of what was found, of what was expected: a line stays one a person reads.
"""
MAX_QUOTED: Final = 60
"""Characters of a quoted value."""


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing that is wrong, said so that the person who wrote it can mend it."""

    where: str
    """The field's path, for example ``moves[2].origin``; empty for the whole."""
    found: str
    expected: str

    def __str__(self) -> str:
        """The fault as a part of a line: place, what is there, what should be."""
        place = f"{one_line(self.where)}: " if self.where else ""
        return f"{place}{one_line(self.found)}, expected {one_line(self.expected)}"

    def under(self, place: str) -> "Fault":
        """The same fault, seen from outside `place`: ``origin`` becomes ``moves[2].origin``."""
        return replace(self, where=f"{place}.{self.where}" if self.where else place)


class InvalidError(ValueError):
    """A thing that cannot be built; carries all of its faults, never only the first."""

    def __init__(self, faults: Sequence[Fault]) -> None:
        """Keep `faults`, at least one."""
        self.faults: tuple[Fault, ...] = tuple(faults)
        super().__init__(self.faults)

    def __str__(self) -> str:
        """The faults on one line; of very many, how many more there are."""
        said = "; ".join(str(fault) for fault in self.faults[:MAX_SAID])
        more = len(self.faults) - MAX_SAID
        return f"{said}; and {more} more" if more > 0 else said


def refuse(faults: Sequence[Fault]) -> None:
    """Raise `InvalidError` if there is any fault."""
    if faults:
        raise InvalidError(faults)


def attempt(build: Callable[[], _Built], faults: list[Fault], where: str = "") -> _Built | None:
    """What `build` makes; None when it refuses, its faults then added to `faults`."""
    try:
        return build()
    except InvalidError as error:
        faults += [fault.under(where) if where else fault for fault in error.faults]
        return None


def one_line(text: str) -> str:
    """`text` as a piece of a line, safe on any terminal: no control characters, not too long."""
    if len(text) > MAX_PIECE:
        text = f"{text[: MAX_PIECE - 3]}..."
    if text.isprintable():
        return text
    return "".join(sign if sign.isprintable() else _escape(sign) for sign in text)


def shorten(value: object) -> str:
    """`value` as JSON writes it, cut to one short piece of a line."""
    try:
        text = json.dumps(value, ensure_ascii=False, default=_plain)
    except RecursionError:
        text = "brackets nested too deep"
    return text if len(text) <= MAX_QUOTED else f"{text[: MAX_QUOTED - 3]}..."


def _plain(value: object) -> float | str:
    return float(value) if isinstance(value, Decimal) else str(value)


def _escape(sign: str) -> str:
    return sign.encode("unicode_escape", "surrogatepass").decode("ascii")
