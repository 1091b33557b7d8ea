"""The language of whoever sits at the terminal."""

import contextlib
import os

from maestra.language import Language


def own_language() -> Language:
    """The language of the user's environment, or English."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if value := os.environ.get(variable):
            with contextlib.suppress(ValueError):
                return Language(value[:2].lower())
            break
    return Language.EN
