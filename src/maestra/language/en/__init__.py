"""English."""

from typing import Final

from maestra.language.en.grammar import English
from maestra.language.en.words import WORDS as WORDS
from maestra.language.tongue import Grammar

GRAMMAR: Final[Grammar] = English()
