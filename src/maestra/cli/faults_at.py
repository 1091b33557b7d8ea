"""Where in a file something is wrong, when only its content says so."""

import contextlib
import re
from collections.abc import Generator
from dataclasses import replace
from typing import Final

from maestra.core.faults import InvalidError
from maestra.core.json_lines import FormatError

_NUMBERED: Final = re.compile(r"^demonstration \d+: ")
"""How faults between several decks say which one it is; the line says it better."""


@contextlib.contextmanager
def at_line(file: str, number: int) -> Generator[None]:
    """What is wrong in here is wrong with this line of this file.

    Raises:
        FormatError: in place of an `InvalidError`.
    """
    try:
        yield
    except FormatError:
        raise
    except InvalidError as error:
        faults = [replace(fault, where=_NUMBERED.sub("", fault.where)) for fault in error.faults]
        raise FormatError(file, number, tuple(faults)) from None
