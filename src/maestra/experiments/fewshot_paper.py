"""The paper's six exercises, learned from a few random demonstrations instead of chosen ones.

As in the paper [1, section 4.1] the goal row is filled from left to right, which alone must not
become a rule; what is learned is exact when it allows just the right rows, all of them compared.

[1] Andriella et al., Natural Teaching of Robot-Assisted Rearranging Exercises, ICSR 2019.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from types import MappingProxyType
from typing import Final

import numpy as np

from maestra.core.demonstration import Demonstration
from maestra.experiments.demonstrators import played
from maestra.experiments.fewshot import Outcome, lessons, outcome
from maestra.experiments.random_exercises import Make, Person, Sample, truths
from maestra.learning.fewshot.space import Context, Order, rows_of
from maestra.rules.forms.base import Direction
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.patterns import given_row
from maestra.rules.forms.selection import EveryToken
from maestra.rules.forms.sources import StraightUp, from_row
from maestra.rules.paper import BOARD, LETTER_DECK, NUMBER_DECK, WORD
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.token_tests import has

STARTS: Final = 3
"""Fresh ones that the learned rules are compared with the truth on."""

RULES: Final[Mapping[str, tuple[Rule, ...]]] = MappingProxyType(
    {
        "odd-ascending": (FullRow(), EveryToken(has("odd", "value")), Ordered("value")),
        "ascending": (FullRow(), Ordered("value")),
        "descending": (FullRow(), Ordered("value", Direction.FALLING)),
        "first-row": (FullRow(), from_row(1), StraightUp()),
        "curie": (FullRow(), given_row("letter", tuple(WORD))),
        "letters": (FullRow(), Ordered("letter")),
    }
)
"""What is right in each of the paper's exercises, by its key in `PAPER_EXERCISES`."""
LETTERED: Final = frozenset({"curie", "letters"})
"""Those that are played with letters."""


def paper_sample(key: str, number: int, *, moves_tokens: bool) -> Sample:
    """One of the paper's exercises and somebody who shows it.

    Args:
        key: of `PAPER_EXERCISES`.
        number: decides what is drawn.
        moves_tokens: whether each demonstration begins with the tokens elsewhere.
    """
    rules = RULES[key]
    deck = LETTER_DECK if key in LETTERED else NUMBER_DECK
    filled = 1 if StraightUp() in rules else None
    make = Make((), len(deck.tokens))
    return Sample(number, key, make, deck, BOARD, rules, Person.UNIFORM, moves_tokens, filled)


def paper_trials(
    key: str, number: int, count: int, questions: Sequence[int], *, moves_tokens: bool
) -> tuple[Outcome, ...]:
    """One of the paper's exercises shown `count` times: what came of it, as `fewshot.trials`."""
    sample = paper_sample(key, number, moves_tokens=moves_tokens)
    shown = right_demonstrations(sample, count)
    known: dict[tuple[Rule, ...], bool] = {}
    outcomes: list[Outcome] = []
    for most, lesson in zip(questions, lessons(sample, shown, questions), strict=True):
        if lesson.rules not in known:
            known[lesson.rules] = allows_the_same(sample, lesson.rules)
        exact = known[lesson.rules]
        outcomes.append(outcome(sample, most, lesson, (exact, exact)))
    return tuple(outcomes)


def right_demonstrations(sample: Sample, count: int) -> list[Demonstration]:
    """Rows drawn uniformly from all right ones, each filled from left to right."""
    rng = Random(f"{sample.family} {sample.seed}")  # noqa: S311 - what is drawn is no secret
    start = sample.start(sample.deck, rng)
    shown: list[Demonstration] = []
    for _ in range(count):
        if sample.moves_tokens:
            start = sample.start(sample.deck, rng)
        context = _context(Setting(sample.deck, start))
        right = np.flatnonzero(truths(sample.truth, context))
        row = [int(token) for token in context.rows.row[rng.choice(right)]]
        play = played(context.setting, row, context.order)
        shown.append(Demonstration(sample.deck, start, play.moves()))
    return shown


def allows_the_same(sample: Sample, rules: Sequence[Rule]) -> bool:
    """Whether `rules` allow just the right rows, from fresh starts, filled either way."""
    rng = Random(f"{sample.family} {sample.seed} fresh")  # noqa: S311 - as above
    for _ in range(STARTS):
        setting = Setting(sample.deck, sample.start(sample.deck, rng))
        for back in (False, True):
            context = _context(setting, back=back)
            if (truths(sample.truth, context) != truths(rules, context)).any():
                return False
    return True


def _context(setting: Setting, *, back: bool = False) -> Context:
    order: Order = tuple(range(setting.length))
    order = order[::-1] if back else order
    return Context(setting, order, rows_of(setting, order, full=True))
