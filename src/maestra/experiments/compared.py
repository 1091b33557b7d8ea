"""The few-shot learner beside the paper's: how many demonstrations each needs for the six.

The paper's learners get the fewest demonstrations that teach an exercise, chosen by somebody who
knows what they need; the few-shot learner gets random ones.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final

from maestra.experiments.fewshot_paper import paper_sample, paper_trials, right_demonstrations
from maestra.experiments.pages import Cell, PageTable
from maestra.experiments.table import TableRow
from maestra.learning.fewshot.learner import learn

ENOUGH: Final = 0.95
"""The share of draws that must be exact for so many demonstrations to be enough."""
MOST_SHOWN: Final = 5
QUESTIONS: Final = (0, 3)
"""At most; with each number it is another learner, so to say."""


@dataclass(frozen=True, slots=True)
class Needed:
    """How few random demonstrations are enough for one of the paper's exercises."""

    exercise: str
    questions: int
    """At most."""
    demonstrations: int
    """The fewest that are enough; `MOST_SHOWN` if none of up to so many are."""
    exact: int
    """Draws that were learned exactly from so many."""
    draws: int
    learn_s: float
    """The median, without the questions."""


def needed(exercise: str, questions: int, draws: int, clock: Callable[[], float]) -> Needed:
    """Show one of the paper's exercises with ever more demonstrations until they are enough.

    Args:
        exercise: a key of `PAPER_EXERCISES`.
        questions: at most so many are asked.
        draws: how often demonstrations are drawn anew, at least once.
        clock: the time in seconds, from any beginning.
    """
    count = 0
    while True:
        count += 1
        exact = sum(
            paper_trials(exercise, number, count, (questions,), moves_tokens=True)[0].exact
            for number in range(draws)
        )
        if exact >= ENOUGH * draws or count == MOST_SHOWN:
            learn_s = statistics.median(_time(exercise, n, count, clock) for n in range(draws))
            return Needed(exercise, questions, count, exact, draws, learn_s)


def _time(exercise: str, number: int, count: int, clock: Callable[[], float]) -> float:
    sample = paper_sample(exercise, number, moves_tokens=True)
    shown = right_demonstrations(sample, count)
    begun = clock()
    learn(shown)
    return clock() - begun


def compared_table(papers: Iterable[TableRow], ours: Iterable[Needed]) -> PageTable:
    """All learners, exercise by exercise."""
    rows: dict[str, list[tuple[Cell, ...]]] = {}
    for row in papers:
        seconds = "-" if row.learn_s is None else f"{row.learn_s:.4f}"
        shown = f"{row.demonstrations} chosen"
        one = (f"`{row.exercise}`", row.learner, shown, "0", row.outcome, seconds)
        rows.setdefault(row.exercise, []).append(one)
    for mine in ours:
        exact = f"{mine.exact} of {mine.draws} draws"
        seconds = f"{mine.learn_s:.2f}"
        shown = f"{mine.demonstrations} random"
        asked = f"up to {mine.questions}" if mine.questions else "0"
        few = (f"`{mine.exercise}`", "fewshot", shown, asked, exact, seconds)
        rows.setdefault(mine.exercise, []).append(few)
    return PageTable(
        "compared",
        f"Demonstrations that each learner needs; of random ones so many that {100 * ENOUGH:.0f} "
        "% of the draws are learned exactly",
        ("Exercise", "Learner", "Demonstrations", "Questions", "Exact", "Seconds"),
        tuple(row for each in rows.values() for row in each),
    )
