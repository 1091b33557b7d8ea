"""The rules of the paper's six exercises: what a caregiver means who teaches them."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from maestra.rules.exercise import RuledExercise
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.paper import BOARD, LETTER_DECK, NUMBER_DECK, WORD
from maestra.rules.rule import Rule
from maestra.rules.telling import told_exercise
from maestra.rules.token_tests import has

_OF_ALL: Final[tuple[Rule, ...]] = (FullRow(), FillOrder(Filling.LEFT_TO_RIGHT))
_RULES: Final[Mapping[str, tuple[Rule, ...]]] = MappingProxyType(
    {
        "odd-ascending": (EveryToken(has("odd", "value")), Ordered("value")),
        "ascending": (Ordered("value"),),
        "descending": (Ordered("value", Direction.FALLING),),
        "first-row": (from_row(1), StraightUp()),
        "curie": (given_row("letter", tuple(WORD)),),
        "letters": (Ordered("letter"),),
    }
)
_WITH_LETTERS: Final = frozenset({"curie", "letters"})


def paper_exercise(key: str) -> RuledExercise:
    """One of the six, by its key, as rules that were told.

    Raises:
        KeyError: it is none of them.
    """
    deck = LETTER_DECK if key in _WITH_LETTERS else NUMBER_DECK
    return told_exercise((*_OF_ALL, *_RULES[key]), BOARD, deck)
