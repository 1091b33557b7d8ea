"""What a session on the terminal says and shows; nothing here knows what a terminal is."""

from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

from maestra.core.state import State
from maestra.core.tokens import Deck


class Tone(Enum):
    """How a line is meant; a terminal with colours shows it."""

    PLAIN = "plain"
    HEADING = "heading"
    GOOD = "good"
    WRONG = "wrong"
    NEW = "new"
    ASIDE = "aside"


@dataclass(frozen=True, slots=True)
class Said:
    """A line to say."""

    text: str
    tone: Tone = Tone.PLAIN


@dataclass(frozen=True, slots=True)
class Drawn:
    """A board to draw."""

    state: State
    deck: Deck


Output: TypeAlias = Said | Drawn
Outputs: TypeAlias = tuple[Output, ...]
