"""Style, module and pictures: compressed, and asked for again only when they have changed."""

from __future__ import annotations

import mimetypes
from importlib.resources import files
from typing import Final

from starlette.middleware.gzip import GZipMiddleware
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Scope

LEAST_COMPRESSED: Final = 1_000
"""Bytes: less fits one packet anyway."""


class _Static(StaticFiles):
    """Files that a browser keeps, and asks about each time: a new Maestra is seen at once."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        answer = await super().get_response(path, scope)
        answer.headers["Cache-Control"] = "no-cache"
        return answer


def assets() -> ASGIApp:
    """What answers under /static.

    Only these are compressed: pages hold what is somebody's, and how much they shrink would tell
    of it (BREACH).
    """
    # Not every system knows it, and browsers are told not to guess.
    mimetypes.add_type("image/webp", ".webp")
    folder = _Static(directory=str(files("maestra.web") / "static"))
    return GZipMiddleware(folder, minimum_size=LEAST_COMPRESSED)
