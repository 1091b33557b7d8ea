"""The pictures that an exercise's file carries for its tokens: for screens, no rule asks of them.

Pure; it knows nothing of what the bytes are, so whoever shows them must look at them first.
"""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictStr
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import WithJsonSchema

from maestra.core.faults import Fault, refuse
from maestra.core.formats import DeckJson
from maestra.core.json_faults import AtMost, Expecting
from maestra.core.text import MAX_TEXT, PLAIN
from maestra.core.tokens import Deck

PICTURE: Final = "picture"
"""The attribute whose values pictures belong to."""
MAX_PICTURES: Final = 100
"""Of one file: more tokens than the largest board of a screen has cells for."""
MAX_PICTURE_BYTES: Final = 4 * 2**20
"""Of one picture: a photograph of a telephone in its usual quality."""

_MAX_LETTERS: Final = 4 * -(-MAX_PICTURE_BYTES // 3)
"""Of so many bytes in base64: four letters for three."""


@dataclass(frozen=True, slots=True)
class CarriedPicture:
    """A picture as a file carries it."""

    media_type: str
    content: bytes


NO_PICTURES: Final[Mapping[str, CarriedPicture]] = MappingProxyType({})


def _decoded(value: object) -> bytes:
    expected = f"a picture of at most {MAX_PICTURE_BYTES // 2**20} MB in base64"
    if not isinstance(value, str) or not 0 < len(value) <= _MAX_LETTERS:
        raise ValueError(expected)
    try:
        return b64decode(value, validate=True)
    except ValueError:
        raise ValueError(expected) from None


_Shown = Annotated[
    StrictStr,
    Field(min_length=1, max_length=MAX_TEXT, pattern=PLAIN),
    Expecting("what a token shows under `picture`"),
]


class PictureJson(BaseModel):
    """A picture."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    media_type: Annotated[
        Literal["image/png", "image/jpeg", "image/webp", "image/gif"],
        Expecting("one of image/png, image/jpeg, image/webp, image/gif"),
        Field(description="What the bytes are."),
    ]
    content: Annotated[
        bytes,
        PlainValidator(_decoded),
        WithJsonSchema(
            {
                "type": "string",
                "contentEncoding": "base64",
                "minLength": 4,
                "maxLength": _MAX_LETTERS,
                "description": "The bytes in base64.",
            }
        ),
    ]


class PicturedJson(DeckJson):
    """The fields of a file that make its deck, and what the deck's tokens look like."""

    pictures: Annotated[
        dict[_Shown, PictureJson],
        Field(
            max_length=MAX_PICTURES,
            description="Pictures for screens, each under what tokens show under the attribute "
            "`picture`. No rule asks of them.",
            examples=[{"cup": {"media_type": "image/webp", "content": "UklGRg=="}}],
        ),
        AtMost(MAX_PICTURES),
    ] = Field(default_factory=dict[str, PictureJson])

    def carried(self, deck: Deck) -> Mapping[str, CarriedPicture]:
        """The pictures, by what the tokens of `deck` show.

        Raises:
            InvalidError: no token shows what a picture stands under.
        """
        shown = pictured(deck)
        expected = "what a token shows under `picture`"
        refuse(
            [
                Fault(f"pictures.{value}", "a picture that no token shows", expected)
                for value in self.pictures
                if value not in shown
            ]
        )
        return MappingProxyType(
            {
                value: CarriedPicture(one.media_type, one.content)
                for value, one in self.pictures.items()
            }
        )


def pictured(deck: Deck) -> frozenset[str]:
    """What the deck's tokens show under `picture`."""
    values = (token.value(PICTURE) for token in deck.tokens)
    return frozenset(str(value) for value in values if value is not None)


def encode_pictures(pictures: Mapping[str, CarriedPicture]) -> str:
    """The field with its name, a picture a line."""
    lines = (
        f"{json.dumps(value, ensure_ascii=False)}: {json.dumps(_encode(one))}"
        for value, one in pictures.items()
    )
    return '"pictures": {\n  ' + ",\n  ".join(lines) + "\n }"


def _encode(picture: CarriedPicture) -> dict[str, str]:
    content = b64encode(picture.content).decode("ascii")
    return {"media_type": picture.media_type, "content": content}
