"""How hard the tokens of a deck are, and how that follows the patient.

Two things make numbers hard to put in order: how many digits they have, and how close together
they lie. After each first attempt at a move the difficulty takes a small step: up after a right
one, down, and four times as far, after another. Such a weighted up-down rule settles where steps
up and down balance [1]: with p right first attempts, p = 4 (1 - p), so at p = 0.8, the middle of
the 70 to 90 % that we aim at. The search finds a level only as far as levels differ: between two
neighbouring ones it goes to and fro.

Departures from [1]: the steps are counted in quarters of a level, so that one wrong attempt takes
just one level back; and the difficulty never leaves the caregiver's bounds.

[1] Kaernbach, Simple adaptive testing with the weighted up-down method, Perception &
Psychophysics 49, 1991 (its abstract: each right answer makes it harder, each wrong one easier, by
steps of different size, which can settle at any point).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Final

from pydantic import Field, StrictInt

from maestra.coaching.chance import Chance
from maestra.coaching.fields import STRICT
from maestra.core.json_faults import Expecting
from maestra.core.tokens import Deck, Token

MOST_DIGITS: Final = 3
MOST_SIMILAR: Final = 5
QUARTERS: Final = 4
"""Of a level that a right first attempt adds one of: 4 = 0.8 / (1 - 0.8)."""
_SPREAD: Final = (1.0, 0.6, 0.35, 0.2, 0.1)
"""Which share of all numbers with so many digits a deck is dealt from, by similarity."""

_Digits = Annotated[
    StrictInt, Field(ge=1, le=MOST_DIGITS), Expecting(f"1 to {MOST_DIGITS} digits")
]
_Similarity = Annotated[
    StrictInt, Field(ge=1, le=MOST_SIMILAR), Expecting(f"1 (far apart) to {MOST_SIMILAR}")
]


@dataclass(frozen=True, slots=True)
class Difficulty:
    """How hard tokens with numbers are."""

    __pydantic_config__ = STRICT
    digits: _Digits = 2
    similarity: _Similarity = 1
    """1: spread over all numbers with so many digits; 5: within a tenth of them."""

    @classmethod
    def easiest(cls) -> Difficulty:
        """One digit, far apart."""
        return cls(1, 1)

    @classmethod
    def hardest(cls) -> Difficulty:
        """Three digits, close together."""
        return cls(MOST_DIGITS, MOST_SIMILAR)

    def is_between(self, easiest: Difficulty, hardest: Difficulty) -> bool:
        """Whether it is within these bounds, each of the two for itself."""
        return (
            easiest.digits <= self.digits <= hardest.digits
            and easiest.similarity <= self.similarity <= hardest.similarity
        )


@dataclass(frozen=True, slots=True)
class Staircase:
    """Where the search for the right difficulty stands, within the caregiver's bounds."""

    easiest: Difficulty
    hardest: Difficulty
    quarters: int
    """How far up the ladder of difficulties, in quarters of a step."""

    @classmethod
    def at(cls, difficulty: Difficulty, easiest: Difficulty, hardest: Difficulty) -> Staircase:
        """Begin with `difficulty`, or the nearest step there is."""
        steps = ladder(easiest, hardest)
        wanted = (difficulty.digits, difficulty.similarity)
        nearest = min(
            range(len(steps)),
            key=lambda k: (
                abs(steps[k].digits - wanted[0]) * MOST_SIMILAR
                + abs(steps[k].similarity - wanted[1])
            ),
        )
        return cls(easiest, hardest, QUARTERS * nearest)

    @property
    def difficulty(self) -> Difficulty:
        """The present one."""
        return ladder(self.easiest, self.hardest)[self.quarters // QUARTERS]

    def after(self, *, right_at_first: bool) -> Staircase:
        """Once a move was tried for the first time."""
        top = QUARTERS * len(ladder(self.easiest, self.hardest)) - 1
        quarters = self.quarters + (1 if right_at_first else -QUARTERS)
        return replace(self, quarters=min(max(quarters, 0), top))


def ladder(easiest: Difficulty, hardest: Difficulty) -> tuple[Difficulty, ...]:
    """The difficulties within bounds, from easy to hard: closer together, then one digit more."""
    return tuple(
        Difficulty(digits, similarity)
        for digits in range(easiest.digits, hardest.digits + 1)
        for similarity in range(easiest.similarity, hardest.similarity + 1)
    )


def fits(deck: Deck) -> str | None:
    """The attribute whose numbers can be dealt anew: the only one, whole on each token."""
    names = {name for token in deck.tokens for name, _ in token.attributes}
    if len(names) != 1:
        return None
    (name,) = names
    return name if all(isinstance(token.value(name), int) for token in deck.tokens) else None


def deal(deck: Deck, difficulty: Difficulty, chance: Chance) -> tuple[Deck, Chance]:
    """A deck like `deck` with other numbers, of this difficulty; unchanged if it does not fit.

    As many tokens, with the same ids, all different. Where a tenth of the numbers with so many
    digits are fewer than the tokens, the numbers lie next to one another.
    """
    name = fits(deck)
    numbers = range(_first_with(difficulty.digits), _first_with(difficulty.digits + 1))
    count = len(deck.tokens)
    if name is None or len(numbers) < count:
        return deck, chance
    width = max(count, round(len(numbers) * _SPREAD[difficulty.similarity - 1]))
    first, chance = chance.below(len(numbers) - width + 1)
    order, chance = chance.shuffled(range(width))
    tokens = tuple(
        Token(token.id, ((name, numbers[first + offset]),))
        for token, offset in zip(deck.tokens, order[:count], strict=True)
    )
    return replace(deck, tokens=tokens), chance


def _first_with(digits: int) -> int:
    """The smallest number with so many digits; 0 has one too."""
    return 0 if digits == 1 else 10 ** (digits - 1)
