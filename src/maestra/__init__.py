"""Maestra learns a tabletop exercise from demonstrations, says its rules in words and judges moves."""

from typing import Final

__all__ = ["__version__"]

# Written here and in pyproject.toml; a test compares the two, for reading the installed
# metadata would cost every start of the command a tenth of its time.
__version__: Final = "0.1.0"
