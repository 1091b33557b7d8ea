"""All text of the pages in each language, from the gettext catalogues in `catalogues/`.

A text's key is its English sentence. Each area of the app has a catalogue of its own, so that a
translator sees what belongs together; here they are one.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from types import MappingProxyType
from typing import Final

from babel.messages.pofile import read_po

from maestra.language import Language

CATALOGUES: Final = files("maestra.web") / "catalogues"


class UntranslatedError(KeyError):
    """A text that a language's catalogues lack."""


@cache
def texts(language: Language) -> Mapping[str, str]:
    """Each text of the pages in `language`, by its English sentence.

    Raises:
        ValueError: two catalogues translate the same text differently.
    """
    found: dict[str, str] = {}
    for area in sorted(_areas(language), key=lambda one: one.name):
        with area.open("rb") as file:
            for message in read_po(file):
                key, text = str(message.id), str(message.string)
                if key and found.setdefault(key, text) != text:
                    raise ValueError(f"{language.value}/{area.name} has “{key}” once more")
    return MappingProxyType(found)


def translate(language: Language, sentence: str, **parts: object) -> str:
    """A text of the pages, its gaps ``{so}`` filled.

    Raises:
        UntranslatedError: the catalogues lack it.
    """
    try:
        text = texts(language)[sentence]
    except KeyError:
        raise UntranslatedError(f"{language.value}: {sentence}") from None
    return text.format(**parts) if parts else text


def _areas(language: Language) -> list[Traversable]:
    folder = CATALOGUES / language.value
    return [one for one in folder.iterdir() if one.name.endswith(".po")]
