"""Pages that others lead to, and which paths are ours at all."""

from __future__ import annotations

from typing import Final

API: Final = "/api/"
"""What programs use; everything else is pages."""
HOME: Final = "/"
SET_UP: Final = "/set-up"
LOGIN: Final = "/login"
CODE: Final = "/login/code"
LOGOUT: Final = "/logout"
ACCOUNT: Final = "/account"
NEW_PASSWORD: Final = "/account/new-password"
SCREEN: Final = "/screen"
"""Where the PIN of a patient's screen is asked for."""
PATIENT_PAGE: Final = "/patient"
"""What a patient's screen shows."""


def is_ours(path: str) -> bool:
    """Whether a path leads to a page of this server: "//elsewhere" would lead away."""
    plain = all(" " < letter < "\x7f" for letter in path)
    return plain and path.startswith("/") and not path.startswith(("//", "/\\"))
