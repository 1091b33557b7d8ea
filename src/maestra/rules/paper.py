"""The paper's six exercises [1, section 4], each given by what is right.

The paper prints six of the ten numbers and five of the ten letters. Of the numbers exactly five
must be odd and the four it does not print larger than the others, for six tokens may go first
when the order is ascending; of the letters no more is known than that they spell CURIE.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from types import MappingProxyType
from typing import Final

from maestra.core.board import Board, Cell, Row
from maestra.core.tokens import Deck, Token, TokenId, Value
from maestra.rules.features import select_features
from maestra.rules.right_plays import Placement, Placements, RightPlays, from_anywhere
from maestra.rules.strips.vocabulary import Level, Vocabulary

BOARD: Final = Board()
NUMBERS: Final = (19, 23, 32, 34, 36, 46, 51, 57, 63, 68)
LETTERS: Final = "CURIEAGBDO"
WORD: Final = "CURIE"


def _deck(attribute: str, values: Sequence[Value]) -> Deck:
    return Deck(tuple(Token(TokenId(str(value)), ((attribute, value),)) for value in values))


_FIRST_STORAGE_ROW: Final = tuple(
    frozenset({Cell(Row(BOARD.goal_row + 1), cell.column)}) for cell in BOARD.goal_cells
)
NUMBER_DECK: Final = _deck("value", NUMBERS)
LETTER_DECK: Final = _deck("letter", LETTERS)


@dataclass(frozen=True, slots=True)
class PaperExercise:
    """One of the six."""

    key: str
    """What the command line calls it."""
    number: str
    """What the paper calls it, (i) to (vi)."""
    title: str
    plays: Callable[[], RightPlays]
    """All of its right plays; enumerated when first asked for, and once."""
    fewest: int
    """The fewest demonstrations by the paper [1, section 4.1]."""
    features: tuple[str, ...] | None = None
    """What the caregiver selected beforehand; None: the defaults count."""

    def vocabulary(self, level: Level = Level.A) -> Vocabulary:
        """What can be said of it."""
        plays = self.plays()
        return Vocabulary(
            plays.board, plays.deck, level, select_features(plays.deck, self.features)
        )


def from_left_to_right(placements: Placements) -> bool:
    """Whether the goal row is filled from its left end."""
    return all(one.destination.column == step for step, one in enumerate(placements, start=1))


def _value(deck: Deck, placement: Placement) -> int:
    (value,) = (value for _, value in deck.by_id[placement.token].attributes)
    return int(value) if not isinstance(value, str) else ord(value)


def ascending(placements: Placements) -> bool:
    """From left to right, each number larger than the one before."""
    return from_left_to_right(placements) and _rises(NUMBER_DECK, placements)


def odd_ascending(placements: Placements) -> bool:
    """The same with odd numbers only."""
    return ascending(placements) and all(_value(NUMBER_DECK, one) % 2 for one in placements)


def descending(placements: Placements) -> bool:
    """From left to right, each number smaller than the one before."""
    return from_left_to_right(placements) and _rises(NUMBER_DECK, placements[::-1])


def alphabetical(placements: Placements) -> bool:
    """From left to right, each letter later in the alphabet than the one before."""
    return from_left_to_right(placements) and _rises(LETTER_DECK, placements)


def spells_the_word(placements: Placements) -> bool:
    """From left to right, the word's letters in turn."""
    spelled = "".join(one.token for one in placements)
    return from_left_to_right(placements) and WORD.startswith(spelled)


def from_the_first_storage_row(step: int, _placement: Placement) -> frozenset[Cell]:
    """Each token comes from straight below, out of the first storage row."""
    return _FIRST_STORAGE_ROW[step - 1]


def _rises(deck: Deck, placements: Placements) -> bool:
    values = [_value(deck, one) for one in placements]
    return all(before < after for before, after in pairwise(values))


@cache
def _plays(
    deck: Deck,
    begins: Callable[[Placements], bool],
    origins: Callable[[int, Placement], frozenset[Cell] | None] = from_anywhere,
) -> RightPlays:
    """Right is a full goal row all of whose beginnings are."""
    return RightPlays(BOARD, deck, begins, begins, origins)


_ALL: Final = (
    PaperExercise(
        "odd-ascending",
        "i",
        "Five odd numbers, ascending",
        lambda: _plays(NUMBER_DECK, odd_ascending),
        2,
    ),
    PaperExercise(
        "ascending", "ii", "Five numbers, ascending", lambda: _plays(NUMBER_DECK, ascending), 12
    ),
    PaperExercise(
        "descending",
        "iii",
        "Five numbers, descending",
        lambda: _plays(NUMBER_DECK, descending),
        12,
    ),
    PaperExercise(
        "first-row",
        "iv",
        "First storage row to goal row",
        lambda: _plays(NUMBER_DECK, from_left_to_right, from_the_first_storage_row),
        10,
        ("cells",),
    ),
    PaperExercise("curie", "v", "Spell CURIE", lambda: _plays(LETTER_DECK, spells_the_word), 2),
    PaperExercise(
        "letters",
        "vi",
        "Five letters, alphabetical",
        lambda: _plays(LETTER_DECK, alphabetical),
        12,
    ),
)

PAPER_EXERCISES: Final[Mapping[str, PaperExercise]] = MappingProxyType(
    {exercise.key: exercise for exercise in _ALL}
)
"""The six in the paper's order, by their keys."""
