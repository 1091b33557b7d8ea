"""How an exercise came into the library."""

from __future__ import annotations

from enum import Enum


class Origin(Enum):
    """Where a version comes from."""

    TAUGHT = "taught"
    """Shown on a board, with questions and perhaps rules in words."""
    IMPORTED = "imported"
    """From a file."""
    COPIED = "copied"
    """From another exercise of the library, or from an earlier version."""
    PAPER = "paper"
    """One of the paper's six."""
    INCLUDED = "included"
    """Another one that comes with Maestra."""
