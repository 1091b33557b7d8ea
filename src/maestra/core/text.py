"""What may be an id, a name, a word, a value: text that any terminal and any file can show."""

import re
import unicodedata
from typing import Final

from maestra.core.faults import Fault, shorten

MAX_TEXT: Final = 1_000
"""Characters in an id, a name, a string value, a label: a tag's UID has 20."""

PLAIN: Final = r"^[^\x00-\x1f\x7f-\x9f]*$"
"""No control characters, for they change what a terminal shows; as pydantic and JSON Schema
write it."""

# Half a surrogate pair is no character, and no file can hold it.
_NOT_PLAIN: Final = re.compile("[\x00-\x1f\x7f-\x9f\ud800-\udfff]")


def is_plain(text: str) -> bool:
    """Whether `text` has neither control characters nor halves of characters."""
    return _NOT_PLAIN.search(text) is None


def without_accents(text: str) -> str:
    """The letters alone: ``más`` is ``mas``."""
    apart = unicodedata.normalize("NFKD", text)
    return "".join(letter for letter in apart if not unicodedata.combining(letter))


def faults_of_name(where: str, text: str) -> list[Fault]:
    """What is wrong with an id, a name or a word: it must say something, shortly and plainly."""
    if not text:
        return [Fault(where, "an empty name", "at least one character")]
    return faults_of_text(where, text)


def faults_of_text(where: str, text: str) -> list[Fault]:
    """What is wrong with a text, which may be empty."""
    if len(text) > MAX_TEXT:
        return [Fault(where, f"{len(text)} characters", f"at most {MAX_TEXT}")]
    if not is_plain(text):
        return [Fault(where, shorten(text), "text without control characters")]
    return []
