"""Pictures are what their bytes are, not what their names say; only what is seen is kept."""

import io
import struct
import zlib
from collections.abc import Callable
from typing import cast

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from hypothesis import given
from hypothesis import strategies as st
from PIL import ExifTags, Image, ImageSequence, PngImagePlugin

from maestra.core.faults import InvalidError
from maestra.web.access.devices import participant_of
from maestra.web.access.visitor import Role
from maestra.web.teach import pictures
from maestra.web.teach.decks import Unfit, UnfitError
from maestra.web.teach.pictures import LARGEST_SIDE, name_of, stored

Login = Callable[[Role], TestClient]
RED, BLUE = (220, 30, 30), (30, 30, 220)


def png(width: int, height: int) -> bytes:
    """A grey one; of a large one only the first rows, which is enough to say how large it is."""

    def chunk(kind: bytes, body: bytes) -> bytes:
        checked = zlib.crc32(kind + body)
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", checked)

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
    rows = zlib.compress(b"".join(b"\0" + b"\x80" * width for _ in range(min(height, 99))))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def written(image: Image.Image, format: str, **options: object) -> bytes:  # noqa: A002 - as Pillow
    made = io.BytesIO()
    image.save(made, format, **options)
    return made.getvalue()


def red_above_blue() -> Image.Image:
    image = Image.new("RGB", (60, 40), BLUE)
    image.paste(RED, (0, 0, 60, 20))
    return image


def seen(content: bytes) -> Image.Image:
    """What a browser shows of a kept picture."""
    return Image.open(io.BytesIO(stored(content, "cup.jpg").content))


def is_near(found: object, wanted: tuple[int, ...]) -> bool:
    pixel = cast("tuple[int, ...]", found)
    return all(abs(one - other) < 40 for one, other in zip(pixel, wanted, strict=True))


GIF = written(red_above_blue(), "GIF")
KINDS = {kind: written(red_above_blue(), kind) for kind in ("PNG", "JPEG", "WEBP", "GIF")}


@pytest.mark.parametrize("kind", KINDS)
def test_each_kind_is_known_by_its_bytes(kind: str) -> None:
    assert stored(KINDS[kind], "x").media_type == "image/webp"
    kept = seen(KINDS[kind])
    assert (kept.format, kept.size) == ("WEBP", (60, 40))
    assert is_near(kept.getpixel((30, 5)), RED)
    assert is_near(kept.getpixel((30, 35)), BLUE)


def photograph() -> bytes:
    """As a telephone makes one: lying on its side, with where, when and by what it was taken."""
    exif = Image.Exif()
    exif[ExifTags.Base.Orientation] = 6
    exif[ExifTags.Base.Model] = "Camera of Anna"
    exif[ExifTags.Base.DateTime] = "2026:05:04 12:00:00"
    place = exif.get_ifd(ExifTags.IFD.GPSInfo)
    place[ExifTags.GPS.GPSLatitudeRef] = "N"
    place[ExifTags.GPS.GPSLatitude] = (41.0, 23.0, 3.0)
    return written(red_above_blue(), "JPEG", exif=exif, comment=b"at home", quality=95)


def test_a_photograph_is_kept_upright_and_without_place_time_and_camera() -> None:
    taken = Image.open(io.BytesIO(photograph()))
    assert ExifTags.GPS.GPSLatitude in taken.getexif().get_ifd(ExifTags.IFD.GPSInfo)
    kept = stored(photograph(), "cup.jpg").content
    for secret in (b"Exif", b"Anna", b"2026", b"at home"):
        assert secret not in kept
    image = Image.open(io.BytesIO(kept))
    image.load()
    assert not image.getexif()
    assert image.size == (40, 60)
    # The top of what was taken is on the right of it when it is turned.
    assert is_near(image.getpixel((35, 30)), RED)
    assert is_near(image.getpixel((5, 30)), BLUE)


@pytest.mark.parametrize("kind", ["PNG", "WEBP"])
def test_what_other_kinds_tell_besides_is_not_kept_either(kind: str) -> None:
    exif = Image.Exif()
    exif[ExifTags.Base.Model] = "Camera of Anna"
    notes = PngImagePlugin.PngInfo()
    notes.add_text("Comment", "Anna")
    telling = {"exif": exif, "icc_profile": b"Anna", "xmp": b"<Anna/>", "pnginfo": notes}
    content = written(red_above_blue(), kind, **telling)
    assert b"Anna" in content
    assert b"Anna" not in stored(content, "cup").content


def test_a_large_picture_is_kept_small_in_its_proportions() -> None:
    assert seen(written(Image.new("RGB", (3000, 1500)), "JPEG")).size == (640, 320)
    assert seen(written(Image.new("L", (100, 5000)), "PNG")).size == (13, LARGEST_SIDE)


@pytest.mark.parametrize("mode", ["RGBA", "LA", "P"])
def test_what_can_be_looked_through_still_can(mode: str) -> None:
    clear = Image.new("RGBA", (9, 9), (0, 0, 0, 0)).convert(mode)
    options = {"transparency": 0} if mode == "P" else {}
    assert seen(written(clear, "PNG", **options)).getpixel((4, 4)) == (0, 0, 0, 0)


@pytest.mark.parametrize("kind", ["GIF", "WEBP", "PNG"])
def test_what_moves_stands_still(kind: str) -> None:
    second = Image.new("RGB", (60, 40), (0, 255, 0))
    film = written(red_above_blue(), kind, save_all=True, append_images=[second], duration=100)
    assert len(list(ImageSequence.Iterator(Image.open(io.BytesIO(film))))) == 2
    kept = seen(film)
    assert len(list(ImageSequence.Iterator(kept))) == 1
    assert is_near(kept.convert("RGB").getpixel((30, 5)), RED)


NO_PICTURES = {
    "svg": b"<svg xmlns='http://www.w3.org/2000/svg'><script>alert(1)</script></svg>",
    "html": b"<html>",
    "text": b"a text, and nothing but a text",
    "nothing": b"",
    "TIFF": written(red_above_blue(), "TIFF"),
    "BMP": written(red_above_blue(), "BMP"),
    "without a dot": png(0, 3),
    "the end is missing": photograph()[:-300],
    **{f"half a {kind}": content[: len(content) // 2] for kind, content in KINDS.items()},
}


@pytest.mark.parametrize("kind", NO_PICTURES)
def test_what_is_no_picture_or_a_broken_one_is_refused(kind: str) -> None:
    with pytest.raises(UnfitError) as refused:
        stored(NO_PICTURES[kind], "cup.png")
    assert refused.value.why is Unfit.NO_PICTURE


@pytest.mark.parametrize("size", [(8_000, 5_001), (10_000, 10_000), (20_000, 20_000)])
def test_a_small_file_with_too_many_dots_is_refused(size: tuple[int, int]) -> None:
    with pytest.raises(UnfitError) as refused:
        stored(png(*size), "cup.png")
    assert refused.value.why is Unfit.LARGE_PICTURE


def test_a_picture_of_too_many_bytes_is_refused() -> None:
    with pytest.raises(InvalidError, match="bytes"):
        stored(png(3, 3) + b"\0" * pictures.MOST_BYTES, "cup.png")


@given(st.sampled_from(sorted(KINDS)), st.integers(0, 2000), st.binary(max_size=12))
def test_whatever_is_broken_is_kept_or_refused(kind: str, place: int, content: bytes) -> None:
    whole = KINDS[kind]
    place %= len(whole)
    try:
        stored(whole[:place] + content + whole[place + len(content) :], "cup")
    except UnfitError as error:
        assert error.why in {Unfit.NO_PICTURE, Unfit.LARGE_PICTURE}  # noqa: PT017 - or neither


@pytest.mark.parametrize(
    ("file", "name"),
    [
        ("my_cup.jpg", "my cup"),
        ("C:\\pictures\\dog.PNG", "dog"),
        ("../../etc/passwd", "passwd"),
        (".jpg", ".jpg"),
        ("", "?"),
        ("x" * 90 + ".png", "x" * 40),
    ],
)
def test_a_picture_is_called_as_its_file(file: str, name: str) -> None:
    assert name_of(file) == name


@pytest.fixture
def caregiver(app: FastAPI, somebody: Login) -> TestClient:
    app.dependency_overrides[participant_of] = lambda: None
    return somebody(Role.CAREGIVER)


def sent(*files: tuple[str, bytes]) -> list[tuple[str, tuple[str, bytes, str]]]:
    return [("files", (name, content, "text/html")) for name, content in files]


def test_ones_own_pictures_are_on_the_tokens(caregiver: TestClient) -> None:
    files = sent(("cup.png", png(3, 3)), ("cup.gif", GIF))
    page = caregiver.post("/teach/pictures", files=files).text
    assert page.count('<img src="/pictures/') == 2
    address = page.split('<img src="')[1].split('"')[0]
    picture = caregiver.get(address)
    assert picture.headers["content-type"] == "image/webp"
    assert picture.headers["x-content-type-options"] == "nosniff"
    assert picture.content in {stored(png(3, 3), "").content, stored(GIF, "").content}
    assert "sandbox" in picture.headers["content-security-policy"]
    assert "immutable" in picture.headers["cache-control"]


def test_pictures_are_added_and_called_otherwise(caregiver: TestClient) -> None:
    root = caregiver.post("/teach/pictures", files=sent(("cup.png", png(3, 3)))).url.path
    page = caregiver.post(f"{root}/tokens/pictures", files=sent(("dog.gif", GIF))).text
    assert 'value="dog"' in page
    fields = {"property": ["picture", "size"], "value": ["mug", "1", "dog", "2"]}
    page = caregiver.post(f"{root}/tokens/table", data=fields).text
    assert page.count('<img src="/pictures/') == 2
    assert 'value="mug"' in page


@pytest.mark.parametrize("file", [("cup.png", b"<svg/>"), ("cup.svg", b"<svg/>")])
def test_a_file_that_is_no_picture_is_refused_by_its_name(
    caregiver: TestClient, file: tuple[str, bytes]
) -> None:
    answer = caregiver.post("/teach/pictures", files=sent(file))
    assert answer.status_code == 422
    assert f"{file[0]} is no PNG, JPEG, WebP or GIF." in answer.text


def test_too_large_a_picture_is_refused_where_it_was_chosen(caregiver: TestClient) -> None:
    root = caregiver.post("/teach", data={"deck": "numbers"}).url.path
    huge = png(3, 3) + b"\0" * pictures.MOST_BYTES
    answer = caregiver.post(f"{root}/tokens/pictures", files=sent(("cup.png", huge)))
    assert answer.status_code == 422
    assert "cup.png is larger than 4 MB." in answer.text
    wide = caregiver.post(f"{root}/tokens/pictures", files=sent(("w.png", png(20_000, 20_000))))
    assert "w.png has more dots than a page can show." in wide.text


def test_a_picture_that_is_not_there_is_not_found(caregiver: TestClient) -> None:
    assert caregiver.get(f"/pictures/{'0' * 64}").status_code == 404


def test_nobody_sees_pictures_without_logging_in(app: FastAPI, context: object) -> None:
    del context
    stranger = TestClient(app, base_url="http://localhost")
    answer = stranger.get(f"/pictures/{'0' * 64}", follow_redirects=False)
    assert answer.status_code == 303
