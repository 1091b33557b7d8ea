"""Pictures are what their bytes are, not what their names say."""

import struct
import zlib
from collections.abc import Callable

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from hypothesis import given
from hypothesis import strategies as st

from maestra.core.faults import InvalidError
from maestra.web.access.devices import participant_of
from maestra.web.access.visitor import Role
from maestra.web.teach import pictures
from maestra.web.teach.pictures import Picture, name_of, recognised, stored

Login = Callable[[Role], TestClient]


def png(width: int, height: int) -> bytes:
    def chunk(kind: bytes, body: bytes) -> bytes:
        checked = zlib.crc32(kind + body)
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", checked)

    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
    rows = zlib.compress(b"".join(b"\0" + b"\x80" * width for _ in range(min(height, 99))))
    return b"\x89PNG\r\n\x1a\n" + head + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


GIF = b"GIF89a" + struct.pack("<HH", 30, 20) + b"\0" * 9
WEBP = b"RIFF\x20\0\0\0WEBP"
LOSSY = WEBP + b"VP8 " + b"\0" * 7 + b"\x9d\x01\x2a" + struct.pack("<HH", 30, 20)
LOSSLESS = WEBP + b"VP8L" + b"\0" * 4 + b"\x2f" + struct.pack("<I", 29 | 19 << 14)
EXTENDED = WEBP + b"VP8X" + b"\0" * 8 + b"\x1d\0\0" + b"\x13\0\0"
JPEG = (
    b"\xff\xd8\xff\xe0\x00\x10JFIF\0\x01\x01\0\0\x01\0\x01\0\0"
    b"\xff\xc0\x00\x11\x08" + struct.pack(">HH", 20, 30) + b"\x03" + b"\0" * 9
)


@pytest.mark.parametrize(
    ("content", "media_type"),
    [
        (png(30, 20), "image/png"),
        (GIF, "image/gif"),
        (LOSSY, "image/webp"),
        (LOSSLESS, "image/webp"),
        (EXTENDED, "image/webp"),
        (JPEG, "image/jpeg"),
    ],
    ids=["png", "gif", "lossy", "lossless", "extended", "jpeg"],
)
def test_each_kind_is_known_by_its_bytes(content: bytes, media_type: str) -> None:
    assert recognised(content) == Picture(media_type, 30, 20)
    assert stored(content, "x").media_type == media_type


@pytest.mark.parametrize(
    "content",
    [
        b"<svg xmlns='http://www.w3.org/2000/svg'><script>alert(1)</script></svg>",
        b"<html>",
        b"",
        b"\xff\xd8\xff\xe0",
        JPEG[:22],
        WEBP + b"VP8?" + b"\0" * 30,
        WEBP + b"VP8X",
        b"\x89PNG\r\n\x1a\n" + b"\0" * 30,
    ],
    ids=["svg", "html", "empty", "short jpeg", "no frame", "webp?", "short webp", "png?"],
)
def test_what_is_no_picture_is_refused(content: bytes) -> None:
    with pytest.raises(InvalidError):
        stored(content, "cup.png")


@pytest.mark.parametrize("size", [(20_000, 20_000), (0, 3)])
def test_a_picture_of_too_many_dots_or_of_none_is_refused(size: tuple[int, int]) -> None:
    with pytest.raises(InvalidError):
        stored(png(*size), "cup.png")


def test_a_picture_of_too_many_bytes_is_refused() -> None:
    with pytest.raises(InvalidError, match="bytes"):
        stored(png(3, 3) + b"\0" * pictures.MOST_BYTES, "cup.png")


@given(st.binary(max_size=80))
def test_any_bytes_are_looked_at_without_failing(content: bytes) -> None:
    for start in (b"", b"\xff\xd8\xff", WEBP + b"VP8 ", WEBP + b"VP8L", b"GIF89a"):
        recognised(start + content)


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
    assert picture.headers["content-type"] in {"image/png", "image/gif"}
    assert picture.headers["x-content-type-options"] == "nosniff"
    assert picture.content in {png(3, 3), GIF}
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
