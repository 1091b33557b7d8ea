"""Exit codes, and the words and errors that all commands share; imports nothing."""

from typing import Final

THE_ANSWER_IS_NO: Final = 1
"""A refused play, an ambiguous lesson."""
BAD_INPUT: Final = 2
"""Files or arguments that are wrong; one line on standard error says how."""
FAULT_OF_OURS: Final = 70
"""A fault in Maestra itself (EX_SOFTWARE of sysexits.h)."""
INTERRUPTED: Final = 130
"""Ctrl-C: 128 and the signal's number, as shells report it."""
PIPE_CLOSED: Final = 141
"""Nobody reads our output any more: 128 and the number of SIGPIPE."""

STANDARD_INPUT: Final = "standard input"
STANDARD_OUTPUT: Final = "standard output"
"""Their names in messages."""


class ReaderGoneError(Exception):
    """Nobody reads our output any more; typer would take a BrokenPipeError for a fault."""
