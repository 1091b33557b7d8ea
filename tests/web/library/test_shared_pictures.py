"""Exercises that are shared with the pictures on their tokens."""

import io
import json
from base64 import b64encode
from collections.abc import Callable
from typing import cast

import pytest
from fastapi.testclient import TestClient
from httpx2 import Response
from PIL import ExifTags, Image

from maestra.core.board import Board
from maestra.core.tokens import Deck, Token, TokenId
from maestra.rules.exercise_format import decode_with_pictures, encode_exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.telling import told_exercise
from maestra.storage.drafts import Drafts, StoredPicture
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.library.collection import exercise_id
from maestra.web.library.files import MOST_BYTES, MOST_BYTES_BESIDES
from maestra.web.teach.pictures import stored

Login = Callable[[Role], TestClient]
CUPS = told_exercise(
    (FullRow(),),
    Board(2, 2),
    Deck(tuple(Token(TokenId(one), (("picture", one),)) for one in ("cup", "mug"))),
)
CUPS_TEXT = encode_exercise(CUPS)
SPACES = b" " * MOST_BYTES_BESIDES


def photograph(colour: str = "red") -> bytes:
    """A JPEG that says by what it was taken."""
    exif = Image.Exif()
    exif[ExifTags.Base.Model] = "Camera of Anna"
    made = io.BytesIO()
    Image.new("RGB", (30, 20), colour).save(made, "JPEG", exif=exif)
    return made.getvalue()


def picture(content: bytes | None = None) -> dict[str, str]:
    """As a file carries it."""
    carried = b64encode(photograph() if content is None else content).decode()
    return {"media_type": "image/jpeg", "content": carried}


def carrying(pictures: object, text: str = CUPS_TEXT) -> bytes:
    """An exercise's file with this for its pictures."""
    return json.dumps({**json.loads(text), "pictures": pictures}).encode()


@pytest.fixture
def browser(somebody: Login) -> TestClient:
    return somebody(Role.CAREGIVER)


def bring_in(browser: TestClient, content: bytes, name: str) -> Response:
    return browser.post("/library/files", files={"file": (name, io.BytesIO(content))})


def keep_cups(context: Context) -> dict[str, StoredPicture]:
    """An exercise with two pictures, and one that no token shows any more."""
    drafts, version = Drafts(context.store), context.store.save_exercise("Cups", CUPS_TEXT)
    kept = {
        value: stored(photograph(colour), value)
        for value, colour in (("cup", "red"), ("mug", "blue"), ("gone", "green"))
    }
    shown = {value: drafts.keep_picture(one) for value, one in kept.items()}
    drafts.save_shown("Cups", version, shown)
    return {value: one for value, one in kept.items() if value != "gone"}


def shown_by(context: Context, name: str) -> dict[str, StoredPicture]:
    drafts = Drafts(context.store)
    return {value: drafts.picture(one) for value, one in drafts.shown(name, 1).items()}


@pytest.mark.parametrize("path", ["/library/{id}/file", "/api/exercises/{id}/file"])
def test_a_file_carries_the_pictures_of_its_tokens(
    context: Context, browser: TestClient, path: str
) -> None:
    kept = keep_cups(context)
    file = browser.get(path.format(id=exercise_id("Cups"))).content
    exercise, carried = decode_with_pictures(file)
    assert exercise == CUPS
    assert {value: one.content for value, one in carried.items()} == {
        value: one.content for value, one in kept.items()
    }
    bring_in(browser, file, "Mugs.exercise.json")
    browser.post("/api/exercises", params={"title": "Sent"}, content=file)
    for name in ("Mugs", "Sent"):
        assert context.store.exercise(name).exercise == CUPS_TEXT
        there = shown_by(context, name)
        assert there.keys() == {"cup", "mug"}
        for colour, value in enumerate(("cup", "mug")):
            dot = Image.open(io.BytesIO(there[value].content)).convert("RGB").getpixel((9, 9))
            assert cast("tuple[int, ...]", dot)[2 * colour] > 200


def test_pictures_of_others_are_written_anew(context: Context, browser: TestClient) -> None:
    assert b"Anna" in photograph()
    bring_in(browser, carrying({"cup": picture()}), "Theirs.json")
    (there,) = shown_by(context, "Theirs").values()
    assert there.media_type == "image/webp"
    assert b"Anna" not in there.content


def test_a_large_file_is_taken_if_its_pictures_make_it_large(
    context: Context, browser: TestClient
) -> None:
    # What stands behind a JPEG's end is not looked at.
    large = photograph() + bytes(MOST_BYTES_BESIDES)
    bring_in(browser, carrying({"cup": picture(large)}), "Large.json")
    (there,) = shown_by(context, "Large").values()
    assert len(there.content) < 1000


def test_what_cannot_be_read_is_saved_as_it_is(context: Context, browser: TestClient) -> None:
    version = context.store.save_exercise("Broken", "{}")
    drafts = Drafts(context.store)
    shown = {"cup": drafts.keep_picture(stored(photograph(), "cup"))}
    drafts.save_shown("Broken", version, shown)
    assert browser.get(f"/library/{exercise_id('Broken')}/file").text == "{}"


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (b" " * (MOST_BYTES + 1), "15360 kB, expected at most 15360 kB"),
        (CUPS_TEXT.encode() + SPACES, "kB besides pictures, expected at most 1024 kB"),
        (carrying({"cup": picture(), "mug": 7}) + SPACES, "kB besides pictures, expected"),
        (carrying([]) + SPACES, "kB besides pictures, expected at most 1024 kB"),
        (SPACES + b"?", "not JSON"),
        (carrying({"cup": picture(b"<svg/>")}), "pictures.cup: something else, expected a pic"),
        (carrying({"dog": picture()}), "pictures.dog: a picture that no token shows"),
    ],
    ids=[
        "too large",
        "too large without pictures",
        "too large beside its pictures",
        "too large beside what are none",
        "a large file of nothing",
        "no picture",
        "a picture of nothing",
    ],
)
def test_a_file_that_cannot_be_kept_says_why_and_leaves_nothing(
    context: Context, browser: TestClient, content: bytes, line: str
) -> None:
    answer = bring_in(browser, content, "Mine.json")
    assert answer.status_code == 422
    assert "The file “Mine” cannot be used:" in answer.text
    assert line in answer.text
    assert not context.store.exercises()
