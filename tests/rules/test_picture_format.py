"""Pictures in an exercise's file: carried through, refused with their place."""

import json
from base64 import b64encode
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move
from maestra.core.tokens import Deck, Token, TokenId
from maestra.learning.grounded import learn_grounded
from maestra.rules.exercise import Exercise
from maestra.rules.exercise_format import decode_exercise, decode_with_pictures, encode_exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.picture_format import (
    MAX_PICTURE_BYTES,
    MAX_PICTURES,
    CarriedPicture,
    pictured,
)
from maestra.rules.telling import dealt, told_exercise
from scripts.write_schemas import schemas
from tests.rules.exercise_files import refusal
from tests.rules.lessons import Lesson, lessons

VALIDATOR: Any = Draft202012Validator(json.loads(schemas()["exercise-1.schema.json"]))
SHOWN = ("cup", "tassa", "3", "4")
DECK = Deck(tuple(Token(TokenId(f"t{k}"), (("picture", one),)) for k, one in enumerate(SHOWN)))
EXERCISE = told_exercise((FullRow(),), Board(3, 2), DECK)
MEDIA_TYPES = ("image/png", "image/jpeg", "image/webp", "image/gif")
CUP = {"media_type": "image/webp", "content": "UklGRg=="}


def read(text: str) -> tuple[Exercise, dict[str, CarriedPicture]]:
    exercise, pictures = decode_with_pictures(text.encode())
    return exercise, dict(pictures)


def with_field(pictures: object) -> bytes:
    return json.dumps({**json.loads(encode_exercise(EXERCISE)), "pictures": pictures}).encode()


@given(
    st.dictionaries(
        st.sampled_from(SHOWN),
        st.builds(CarriedPicture, st.sampled_from(MEDIA_TYPES), st.binary(min_size=1)),
    )
)
def test_pictures_that_are_written_and_read_are_the_same(
    pictures: dict[str, CarriedPicture],
) -> None:
    written = encode_exercise(EXERCISE, pictures)
    VALIDATOR.validate(json.loads(written))
    assert read(written) == (EXERCISE, pictures)
    assert decode_exercise(written.encode()) == EXERCISE


@given(lessons())
def test_without_pictures_a_file_is_as_it_was(lesson: Lesson) -> None:
    exercise = learn_grounded(lesson.demonstrations)
    written = encode_exercise(exercise)
    assert "pictures" not in json.loads(written)
    assert encode_exercise(exercise, {}) == written
    assert read(written) == (exercise, {})


def test_exercises_made_of_actions_carry_pictures_too() -> None:
    start = dealt(DECK, Board(3, 2))
    token, origin = next(iter(start.cells.items()))
    move = Move(token, origin, start.board.goal_cells[0])
    exercise = learn_grounded([Demonstration(DECK, start, (move,))])
    pictures = {"cup": CarriedPicture("image/webp", b"RIFF")}
    assert read(encode_exercise(exercise, pictures)) == (exercise, pictures)


@pytest.mark.parametrize(
    ("pictures", "told"),
    [
        ([], "pictures: [], expected a JSON object"),
        ({"cup": "UklGRg=="}, 'pictures.cup: "UklGRg==", expected a JSON object'),
        ({"cup": {**CUP, "media_type": "image/svg+xml"}}, "pictures.cup.media_type: "),
        ({"cup": {**CUP, "colour": 1}}, "pictures.cup.colour: unknown field"),
        ({"cup": {"media_type": "image/png"}}, "pictures.cup.content: missing"),
        *(
            (
                {"cup": {**CUP, "content": content}},
                ", expected a picture of at most 4 MB in base64",
            )
            for content in ("", "====", "UklGRg=", "UklG Rg==", "ñ", "Ukl\nGRg==", 7, None)
        ),
        ({"": CUP}, "expected what a token shows under `picture`"),
        (
            {"dog": CUP},
            "pictures.dog: a picture that no token shows, expected what a token shows",
        ),
        ({str(k): CUP for k in range(MAX_PICTURES + 1)}, "at most 100 entries"),
    ],
)
def test_bad_pictures_are_refused_with_their_place(pictures: object, told: str) -> None:
    assert told in refusal(with_field(pictures))


def test_a_picture_that_is_too_large_is_refused() -> None:
    right, large = (
        b64encode(bytes(size)).decode() for size in (MAX_PICTURE_BYTES, MAX_PICTURE_BYTES + 3)
    )
    decode_exercise(with_field({"cup": {**CUP, "content": right}}))
    line = refusal(with_field({"cup": {**CUP, "content": large}}))
    assert line.endswith("expected a picture of at most 4 MB in base64")
    assert len(line) < 200


def test_what_tokens_show_is_what_pictures_stand_under() -> None:
    assert pictured(DECK) == {"cup", "tassa", "3", "4"}
    assert pictured(Deck((Token(TokenId("a"), (("picture", 3),)),))) == {"3"}
    assert pictured(Deck((Token(TokenId("a"), (("value", 3),)),))) == set()
