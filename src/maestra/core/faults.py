"""What is wrong with an input: every fault at once, each with its place and what was expected."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing that is wrong, said so that the person who wrote it can mend it."""

    where: str
    """The field's path, for example ``moves[2].origin``; empty for the whole."""
    found: str
    expected: str

    def __str__(self) -> str:
        """The fault as a part of a line: place, what is there, what should be."""
        place = f"{self.where}: " if self.where else ""
        return f"{place}{self.found}, expected {self.expected}"


class InvalidError(ValueError):
    """A thing that cannot be built; carries all of its faults, never only the first."""

    def __init__(self, faults: Sequence[Fault]) -> None:
        """Keep `faults` (at least one) and say them on one line."""
        super().__init__("; ".join(str(fault) for fault in faults))
        self.faults: tuple[Fault, ...] = tuple(faults)


def refuse(faults: Sequence[Fault]) -> None:
    """Raise `InvalidError` if there is any fault."""
    if faults:
        raise InvalidError(faults)
