"""A pseudonym within an address of a page.

Most stand there as they are. One that an address cannot hold (`a/b`, `..`, `new`) is written in
base64url after a tilde, so that whoever was named elsewhere can be reached too.
"""

from __future__ import annotations

import re
from base64 import urlsafe_b64decode, urlsafe_b64encode
from typing import Final
from urllib.parse import quote

from maestra.coaching.ports import PatientId

MOST_IN_ADDRESS: Final = 6_000
"""Letters: the longest pseudonym, each of four bytes, in base64url."""
RESERVED: Final = frozenset({"new"})
"""What is a page of its own there."""
_MARK: Final = "~"
_AS_IT_IS: Final = re.compile(r"[^~./\\][^/\\]*")


def segment_of(patient: PatientId) -> str:
    """What stands for the patient between two slashes."""
    if _AS_IT_IS.fullmatch(patient) and patient not in RESERVED:
        return quote(patient, safe="")
    return _MARK + urlsafe_b64encode(patient.encode()).decode().rstrip("=")


def patient_at(segment: str) -> PatientId | None:
    """Whom an address means, its percent signs already read; None: nobody could be meant."""
    if not segment.startswith(_MARK):
        return PatientId(segment)
    padded = segment[1:] + "=" * (-(len(segment) - 1) % 4)
    try:
        return PatientId(urlsafe_b64decode(padded).decode())
    except ValueError:
        return None
