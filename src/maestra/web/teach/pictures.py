"""Pictures for tokens: what they are by their bytes, how large, and how they are served."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import PurePath
from typing import Annotated, Final

from fastapi import APIRouter, Depends, HTTPException, Path, Response

from maestra.core.faults import Fault
from maestra.storage.drafts import Digest, Drafts, StoredPicture
from maestra.web.access.devices import participant_of
from maestra.web.context import Here
from maestra.web.teach.decks import MOST_LETTERS, Unfit, UnfitError

MOST_BYTES: Final = 4 * 1024 * 1024
"""Of one picture: a photograph of a telephone in its usual quality."""
MOST_PIXELS: Final = 40_000_000
"""Of one picture: what a telephone's camera makes; more would only be work for the browser."""
MOST_AT_ONCE: Final = 20
"""Files of one form."""
KEPT_FOR_S: Final = 365 * 24 * 3600
"""In the browser: a picture of these bytes never changes."""

router: Final = APIRouter()


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture that may be kept."""

    media_type: str
    width: int
    height: int


@router.get(
    "/pictures/{digest}",
    include_in_schema=False,
    dependencies=[Depends(participant_of)],
)
def picture(context: Here, digest: Annotated[str, Path(pattern="^[0-9a-f]{64}$")]) -> Response:
    """A picture; to whoever is logged in, and to patients' screens."""
    try:
        found = Drafts(context.store).picture(Digest(digest))
    except KeyError:
        raise HTTPException(404, "no such picture") from None
    headers = {
        "Cache-Control": f"private, max-age={KEPT_FOR_S}, immutable",
        # Whatever the bytes are, nothing in them runs.
        "Content-Security-Policy": "default-src 'none'; sandbox",
        "Content-Disposition": "inline",
    }
    return Response(found.content, media_type=found.media_type, headers=headers)


def stored(content: bytes, file: str) -> StoredPicture:
    """The picture in a file's bytes.

    Raises:
        UnfitError: it is too large, or no PNG, JPEG, WebP or GIF.
    """
    if len(content) > MOST_BYTES:
        raise _refused(
            Unfit.LARGE_FILE, file, f"{len(content)} bytes", f"at most {MOST_BYTES} bytes"
        )
    found = recognised(content)
    if found is None:
        expected = "a picture: PNG, JPEG, WebP or GIF"
        raise _refused(Unfit.NO_PICTURE, file, "something else", expected)
    if not 0 < found.width * found.height <= MOST_PIXELS:
        pixels = f"{found.width} x {found.height} pixels"
        expected = f"at most {MOST_PIXELS} pixels in all"
        raise _refused(Unfit.LARGE_PICTURE, file, pixels, expected)
    return StoredPicture(found.media_type, content)


def name_of(file: str) -> str:
    """What a picture is called, by the name of its file: ``my_cup.jpg`` is ``my cup``."""
    stem = PurePath(file.replace("\\", "/")).stem
    words = re.sub(r"[\s_\x00-\x1f\x7f]+", " ", stem).strip()
    return words[:MOST_LETTERS] or "?"


def recognised(content: bytes) -> Picture | None:
    """What the bytes are and how large the picture is; None if they are none that is known."""
    if content.startswith(b"\x89PNG\r\n\x1a\n") and content[12:16] == b"IHDR":
        return Picture("image/png", _big(content[16:20]), _big(content[20:24]))
    if content[:6] in {b"GIF87a", b"GIF89a"}:
        return Picture("image/gif", _little(content[6:8]), _little(content[8:10]))
    if content[:4] == b"RIFF" and content[8:12] == b"WEBP":
        return _webp(content)
    if content.startswith(b"\xff\xd8\xff"):
        return _jpeg(content)
    return None


def _webp(content: bytes) -> Picture | None:
    """Each of the three kinds has its size elsewhere (WebP container specification)."""
    kind = content[12:16]
    if kind == b"VP8X" and len(content) >= 30:  # noqa: PLR2004 - where the size ends
        return Picture("image/webp", 1 + _little(content[24:27]), 1 + _little(content[27:30]))
    if kind == b"VP8L" and content[20:21] == b"\x2f":
        packed = _little(content[21:25])
        return Picture("image/webp", 1 + (packed & 0x3FFF), 1 + (packed >> 14 & 0x3FFF))
    if kind == b"VP8 " and content[23:26] == b"\x9d\x01\x2a":
        width, height = _little(content[26:28]), _little(content[28:30])
        return Picture("image/webp", width & 0x3FFF, height & 0x3FFF)
    return None


_FRAMES: Final = frozenset({*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC})
"""Markers of a JPEG's frame, which says how large the picture is (ITU T.81, table B.1)."""


def _jpeg(content: bytes) -> Picture | None:
    place = 2
    while place + 9 <= len(content) and content[place] == 0xFF:  # noqa: PLR2004 - a marker begins
        marker = content[place + 1]
        if marker in _FRAMES:
            height, width = (
                _big(content[place + 5 : place + 7]),
                _big(content[place + 7 : place + 9]),
            )
            return Picture("image/jpeg", width, height)
        place += 2 + max(2, _big(content[place + 2 : place + 4]))
    return None


def _big(part: bytes) -> int:
    return int.from_bytes(part, "big")


def _little(part: bytes) -> int:
    return int.from_bytes(part, "little")


def _refused(why: Unfit, file: str, found: str, expected: str) -> UnfitError:
    return UnfitError(why, Fault(file[:MOST_LETTERS], found, expected))
