"""Catalan."""

from typing import Final

from maestra.language.ca.grammar import Catalan
from maestra.language.ca.words import WORDS as WORDS
from maestra.language.tongue import Grammar

GRAMMAR: Final[Grammar] = Catalan()
