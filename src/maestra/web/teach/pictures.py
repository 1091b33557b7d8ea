"""Pictures for tokens: what may come in, what is kept of it, and how it is served.

What comes in is decoded and written anew, so that nothing is kept but what is to be seen: not the
place, the time or the camera that photographs tell of, nor a thumbnail of what was cut away.
"""

from __future__ import annotations

import io
import re
import threading
from collections.abc import Mapping
from pathlib import PurePath
from typing import Annotated, Final

from fastapi import APIRouter, Depends, HTTPException, Path, Response
from PIL import Image, ImageOps

from maestra.core.faults import Fault
from maestra.storage.drafts import Digest, Drafts, StoredPicture
from maestra.storage.store import SqlStore
from maestra.web.access.devices import participant_of
from maestra.web.context import Here
from maestra.web.teach.decks import MOST_LETTERS, Unfit, UnfitError

MOST_BYTES: Final = 4 * 1024 * 1024
"""Of one picture: a photograph of a telephone in its usual quality."""
MOST_PIXELS: Final = 40_000_000
"""Of one picture: what a telephone's camera makes. Decoded it takes 160 MB for a moment; a small
file that unfolds to more was made to fill the memory."""
LARGEST_SIDE: Final = 640
"""Pixels of what is kept: a cell of the largest screens, twice as dense as it is laid out."""
MOST_AT_ONCE: Final = 20
"""Files of one form."""
KEPT_FOR_S: Final = 365 * 24 * 3600
"""In the browser: a picture of these bytes never changes."""

_FORMATS: Final = ("PNG", "JPEG", "WEBP", "GIF")
"""That come in: whatever cameras and browsers make, and no others of the decoder's many."""
_QUALITY: Final = 85
"""Of the WebP that is kept: a photograph takes some 50 kB, a drawing keeps its edges."""
_DECODING: Final = threading.Lock()
"""One picture at a time: twenty threads with a large one each would fill a small computer."""

router: Final = APIRouter()


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


def addresses(shown: Mapping[str, Digest]) -> Mapping[str, str]:
    """Where pictures are served, by what the tokens show."""
    return {value: f"/pictures/{digest}" for value, digest in shown.items()}


def shown_in(store: SqlStore, exercise: str, version: int) -> Mapping[str, str]:
    """The addresses of the pictures of an exercise's version, by what its tokens show."""
    return addresses(Drafts(store).shown(exercise, version))


def stored(content: bytes, file: str) -> StoredPicture:
    """The picture in a file's bytes, upright and still, with nothing else that was in the file.

    Raises:
        UnfitError: it is too large, or no PNG, JPEG, WebP or GIF, or a broken one.
    """
    if len(content) > MOST_BYTES:
        found, expected = f"{len(content)} bytes", f"at most {MOST_BYTES} bytes"
        raise _refused(Unfit.LARGE_FILE, file, found, expected)
    try:
        with _DECODING, Image.open(io.BytesIO(content), formats=_FORMATS) as image:
            return StoredPicture("image/webp", _anew(image))
    except (Image.DecompressionBombError, Image.DecompressionBombWarning):
        expected = f"at most {MOST_PIXELS} pixels in all"
        raise _refused(Unfit.LARGE_PICTURE, file, "a larger picture", expected) from None
    except Exception:  # noqa: BLE001 - broken bytes make each decoder fail in ways of its own
        expected = "a picture: PNG, JPEG, WebP or GIF"
        raise _refused(Unfit.NO_PICTURE, file, "something else", expected) from None


def name_of(file: str) -> str:
    """What a picture is called, by the name of its file: ``my_cup.jpg`` is ``my cup``."""
    stem = PurePath(file.replace("\\", "/")).stem
    words = re.sub(r"[\s_\x00-\x1f\x7f]+", " ", stem).strip()
    return words[:MOST_LETTERS] or "?"


def _anew(image: Image.Image) -> bytes:
    """What is to be seen, as WebP: of a film the first picture, for nothing moves by itself.

    Raises:
        DecompressionBombError: it has too many pixels; nothing was decoded yet.
        Exception: whatever its decoder finds wrong.
    """
    if image.width * image.height > MOST_PIXELS:
        raise Image.DecompressionBombError
    # A JPEG is decoded at about the size that is kept; the others ignore it.
    image.draft("RGB", (LARGEST_SIDE, LARGEST_SIDE))
    upright = ImageOps.exif_transpose(image)
    plain = upright.convert("RGBA" if upright.has_transparency_data else "RGB")
    plain.thumbnail((LARGEST_SIDE, LARGEST_SIDE))
    # Some encoders write down what was read besides the dots.
    plain.info.clear()
    written = io.BytesIO()
    plain.save(written, "WEBP", quality=_QUALITY)
    return written.getvalue()


def _refused(why: Unfit, file: str, found: str, expected: str) -> UnfitError:
    return UnfitError(why, Fault(file[:MOST_LETTERS], found, expected))
