"""What a token looks like on a page: one thing in large, the rest in small, a colour, a shape."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, TypedDict

from maestra.core.tokens import LETTER, NAME, Token, TokenId, Value
from maestra.language.speaker import Speaker

PICTURE: Final = "picture"
COLOURS: Final = frozenset({"colour", "color"})
SHAPES: Final = frozenset({"shape", "forma"})
_LARGE: Final = ("value", "number", LETTER, NAME, "word")
"""What stands in large on a token that shows several things: what people look for first."""

_SHORT: Final = 2
_SHORT_NUMBER: Final = 3
_MEDIUM: Final = 6
"""Characters that fit a token in the largest and in the middle size of its text; what is short
also fits a shape."""

_HUES: Final = {
    "red": "red rojo roja vermell vermella",
    "orange": "orange naranja taronja",
    "yellow": "yellow amarillo amarilla groc groga",
    "green": "green verde verd verda",
    "turquoise": "turquoise turquesa",
    "blue": "blue azul blau blava",
    "purple": "purple violet morado morada violeta lila",
    "pink": "pink rosa",
    "brown": "brown marrón marró marrona",
    "black": "black negro negra negre",
    "white": "white blanco blanca blanc",
    "grey": "grey gray gris grisa",
}
_OUTLINES: Final = {
    "round": "round circle disc redondo redonda círculo rodó rodona rodones cercle",
    "square": "square cuadrado cuadrada quadrat quadrada",
    "triangle": "triangle triangular triángulo",
    "diamond": "diamond rombo rombe",
    "star": "star estrella estel",
    "hexagon": "hexagon hexágono hexàgon",
    "cross": "cross cruz creu",
}


def _by_word(table: Mapping[str, str]) -> Mapping[str, str]:
    return MappingProxyType({word: key for key, words in table.items() for word in words.split()})


HUES: Final = _by_word(_HUES)
"""A colour's word in any of the languages to the name that the style has for it."""
OUTLINES: Final = _by_word(_OUTLINES)
"""The same for shapes."""


class TokenJson(TypedDict):
    """A token as the stream carries it; the browser draws it as the pages do."""

    label: str
    name: str
    notes: list[str]
    colour: str
    shape: str
    picture: str
    size: str


@dataclass(frozen=True, slots=True)
class TokenView:
    """A token as the page shows and names it."""

    id: TokenId
    label: str
    """In large: 19, C, cup, red."""
    name: str
    """Everything it shows, as it is read aloud: 19, red, round."""
    notes: tuple[str, ...] = ()
    """In small, below."""
    colour: str = ""
    """A name of `HUES`, or empty. Never the only cue: the label or a note says it too."""
    shape: str = ""
    """A name of `OUTLINES`, or empty: as tokens look by default."""
    picture: str = ""
    """Its address, or empty."""

    @property
    def size(self) -> str:
        """How large its label can be."""
        longest = max((len(word) for word in self.label.split()), default=0)
        whole = max(longest, len(self.label) // 2)
        if whole <= (_SHORT_NUMBER if self.label.isdecimal() else _SHORT):
            return "short"
        return "medium" if whole <= _MEDIUM else "long"

    def as_json(self) -> TokenJson:
        """The token for the stream."""
        return {
            "label": self.label,
            "name": self.name,
            "notes": list(self.notes),
            "colour": self.colour,
            "shape": self.shape,
            "picture": self.picture,
            "size": self.size,
        }


def token_view(
    token: Token, speaker: Speaker, pictures: Mapping[str, str] = MappingProxyType({})
) -> TokenView:
    """What `token` looks like.

    Args:
        token: one of the deck.
        speaker: says the values in the reader's language.
        pictures: what tokens show under the attribute `picture`, to the addresses of pictures.
    """
    shown = dict(token.attributes)
    said = {name: _said(speaker, name, value) for name, value in shown.items()}
    colour = _known(HUES, shown, COLOURS)
    shape = _known(OUTLINES, shown, SHAPES)
    picture = pictures.get(str(shown.get(PICTURE)), "")
    seen = {name for name in shown if name in SHAPES and shape}
    large = _large(shown, seen)
    # A picture speaks for itself where nothing else is in large.
    label = "" if large == PICTURE and picture else said.get(large, str(token.id))
    rest = [name for name in said if name != large and name not in seen]
    notes = tuple(said[name] for name in rest if not (name == PICTURE and picture))
    order = [large, *rest, *sorted(seen - {large})]
    name = ", ".join(said[one] for one in order if one in said) or str(token.id)
    return TokenView(token.id, label, name, notes, colour, shape, picture)


def _said(speaker: Speaker, attribute: str, value: Value) -> str:
    """The bare value: without an article, and without its attribute."""
    if isinstance(value, str):
        return speaker.words.values.get((attribute, value), value).split("|")[0]
    return speaker.grammar.numeral(value)


def _known(
    table: Mapping[str, str], shown: Mapping[str, Value], attributes: frozenset[str]
) -> str:
    words = (str(value).casefold() for name, value in shown.items() if name in attributes)
    return next((table[word] for word in words if word in table), "")


def _large(shown: Mapping[str, Value], seen: set[str]) -> str:
    """The attribute that stands in large; what is seen as a shape only if there is no other."""
    plain = [name for name in shown if name not in COLOURS and name not in SHAPES | {PICTURE}]
    for name in (*_LARGE, *plain, PICTURE, *sorted(COLOURS)):
        if name in shown:
            return name
    return next((name for name in shown if name not in seen), next(iter(shown), ""))
