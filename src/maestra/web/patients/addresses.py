"""A pseudonym, or a session's id, within an address of a page.

Most stand there as they are. One that an address cannot hold (`a/b`, `..`, `new`) is written in
base64url after a tilde, so that whoever was named elsewhere can be reached too.
"""

from __future__ import annotations

import re
from base64 import urlsafe_b64decode, urlsafe_b64encode
from typing import Final
from urllib.parse import quote

MOST_IN_ADDRESS: Final = 6_000
"""Letters: the longest pseudonym, each of four bytes, in base64url."""
RESERVED: Final = frozenset({"new"})
"""What is a page of its own there."""
_MARK: Final = "~"
_AS_IT_IS: Final = re.compile(r"[^~./\\][^/\\]*")


def segment_of(name: str) -> str:
    """What stands for a name between two slashes."""
    if _AS_IT_IS.fullmatch(name) and name not in RESERVED:
        return quote(name, safe="")
    return _MARK + urlsafe_b64encode(name.encode()).decode().rstrip("=")


def name_at(segment: str) -> str | None:
    """What an address means, its percent signs already read; None: nothing could be meant."""
    if not segment.startswith(_MARK):
        return segment
    padded = segment[1:] + "=" * (-(len(segment) - 1) % 4)
    try:
        return urlsafe_b64decode(padded).decode()
    except ValueError:
        return None
