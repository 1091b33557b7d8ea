"""The second factor: six digits that a telephone makes anew every 30 seconds (RFC 6238)."""

from __future__ import annotations

from datetime import datetime
from typing import Final

import pyotp
import segno
from pyotp.totp import TOTP

from maestra.web.access.passwords import are_same

STEP_S: Final = 30
TOLERANCE_STEPS: Final = 1
"""Before and after: clocks of telephones differ, and typing takes time."""
ISSUER: Final = "Maestra"
MODULE_PX: Final = 5
"""Of the drawing's squares: about 5 cm on a screen."""


def new_secret() -> str:
    """What the telephone and the server share: 160 random bits in base32."""
    return pyotp.random_base32()


def step_of(secret: str, code: str, utc: datetime, last_step: int) -> int | None:
    """The step that `code` belongs to, if it is right now and newer than the last one used."""
    now = int(utc.timestamp()) // STEP_S
    typed = "".join(one for one in code if one.isdigit())
    for step in range(now - TOLERANCE_STEPS, now + TOLERANCE_STEPS + 1):
        is_right = are_same(TOTP(secret).generate_otp(step), typed)
        if is_right and step > last_step:
            return step
    return None


def drawing(secret: str, name: str) -> str:
    """The secret as a QR code in SVG, for the telephone's camera."""
    address = TOTP(secret).provisioning_uri(name=name, issuer_name=ISSUER)
    return segno.make(address, error="m").svg_inline(
        scale=MODULE_PX, border=4, dark="#000", light="#fff"
    )


def in_groups(secret: str) -> str:
    """The secret to be typed, four letters at a time."""
    return " ".join(secret[k : k + 4] for k in range(0, len(secret), 4))
