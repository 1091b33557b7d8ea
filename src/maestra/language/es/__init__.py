"""Spanish."""

from typing import Final

from maestra.language.es.grammar import Spanish
from maestra.language.es.words import WORDS as WORDS
from maestra.language.tongue import Grammar

GRAMMAR: Final[Grammar] = Spanish()
