"""How long the few-shot learner takes, and how it grows with tokens, goal cells, demonstrations.

Rows are listed while there are few and sampled beyond. How far sampled sizes are off is measured
where the true ones can be computed: numbers in order are a choice of tokens, any row is an
arrangement of them.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, comb, perm
from random import Random
from typing import Final, TypeAlias

from maestra.core.board import Board
from maestra.core.demonstration import Demonstration
from maestra.core.state import State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.experiments.demonstrators import played
from maestra.experiments.pages import PageTable
from maestra.experiments.svg import Picture, Point, Series, draw
from maestra.learning.fewshot.learner import learn
from maestra.learning.fewshot.questions import next_question
from maestra.learning.fewshot.space import pack, size_of
from maestra.rules.forms.order import Ordered
from maestra.rules.forms.selection import EveryToken
from maestra.rules.rule import Rule
from maestra.rules.setting import Setting
from maestra.rules.token_tests import has

COLOURS: Final = ("red", "blue", "green")
STORED: Final = 1.5
"""Storage cells for each token, as on the paper's board."""
ODD: Final = EveryToken(has("odd", "value"))
RISING: Final = Ordered("value")

Clock: TypeAlias = Callable[[], float]
"""The time in seconds, from any beginning."""


@dataclass(frozen=True, slots=True)
class Size:
    """A lesson's size."""

    tokens: int
    cells: int
    """Goal cells, all of which are filled."""
    demonstrations: int = 3
    rows: int | None = None
    """Of the board; None: as many as the tokens need."""

    @property
    def layouts(self) -> int:
        """In how many ways the goal row can be filled."""
        return perm(self.tokens, self.cells)


@dataclass(frozen=True, slots=True)
class Speed:
    """What a lesson of a size takes, in seconds: the median, the fastest and the slowest."""

    size: Size
    learn_s: float
    fastest_s: float
    slowest_s: float
    question_s: float
    """To find the next question after one demonstration, for after more there often is none; the
    median."""
    memory_mb: float
    """What the process had at most until then, the program and its libraries included."""


@dataclass(frozen=True, slots=True)
class Goal:
    """A size, and what it may take."""

    name: str
    size: Size
    learn_s: float
    question_s: float | None = None


GOALS: Final = (
    Goal("the paper's board: 10 tokens, 5 goal cells", Size(10, 5), 0.05, 0.1),
    Goal("20 tokens, 8 goal cells", Size(20, 8), 2.0),
    Goal("100 tokens, 20 rows, 10 goal cells", Size(100, 10, rows=20), 10.0),
)
MOST_MEMORY_MB: Final = 300
GROWTHS: Final[dict[str, tuple[Size, ...]]] = {
    "tokens": tuple(Size(tokens, 5) for tokens in (6, 8, 10, 12, 13, 14, 16, 20, 30, 50, 75, 100)),
    "cells": tuple(Size(20, cells) for cells in range(3, 11)),
    "demonstrations": tuple(Size(10, 5, count) for count in range(1, 13)),
}
"""What each curve goes over: tokens with five goal cells, goal cells with twenty tokens,
demonstrations on the paper's board."""
ESTIMATED: Final = (Size(20, 8), Size(50, 8), Size(100, 10, rows=20))
"""Sizes whose rows are sampled."""


def lesson_of(size: Size, seed: int = 1) -> list[Demonstration]:
    """Random right plays of "odd numbers, rising", each from a start of its own.

    Half of the tokens are odd, or as many as the row needs; they have a colour besides.
    """
    rng = Random(seed)  # noqa: S311 - what is measured is no secret
    odd = max(size.cells, ceil(size.tokens / 2))
    values = [
        *rng.sample(range(11, 11 + 10 * size.tokens, 2), odd),
        *rng.sample(range(10, 10 + 10 * size.tokens, 2), size.tokens - odd),
    ]
    deck = Deck(
        tuple(
            Token(TokenId(f"t{k:03}"), (("value", value), ("colour", rng.choice(COLOURS))))
            for k, value in enumerate(values)
        )
    )
    board = Board(size.rows or 1 + ceil(STORED * size.tokens / size.cells), size.cells)
    order = tuple(range(size.cells))
    shown: list[Demonstration] = []
    for _ in range(size.demonstrations):
        cells = rng.sample(board.storage_cells, size.tokens)
        start = State(board, {t.id: c for t, c in zip(deck.tokens, cells, strict=True)})
        row = sorted(rng.sample(range(odd), size.cells), key=values.__getitem__)
        shown.append(Demonstration(deck, start, played(Setting(deck, start), row, order).moves()))
    return shown


def speed_of(size: Size, repeat: int, clock: Clock, memory_mb: Clock) -> Speed:
    """What lessons of a size take, a new one each time.

    Args:
        size: of the lessons.
        repeat: how many, at least one.
        clock: the time in seconds.
        memory_mb: what the process had at most.
    """
    learning: list[float] = []
    asking: list[float] = []
    for number in range(repeat):
        shown = lesson_of(size, number)
        begun = clock()
        learn(shown)
        learning.append(clock() - begun)
        unsure = learn(shown[:1])
        begun = clock()
        next_question(unsure)
        asking.append(clock() - begun)
    return Speed(
        size,
        statistics.median(learning),
        min(learning),
        max(learning),
        statistics.median(asking),
        memory_mb(),
    )


@dataclass(frozen=True, slots=True)
class Estimate:
    """How far the sampled size of a rule is off, relative to the true one."""

    size: Size
    rule: str
    true: float
    median: float
    most: float


def estimates(size: Size, repeat: int) -> Iterator[Estimate]:
    """How far what the learner goes by is off, over `repeat` lessons and samples."""
    odd = max(size.cells, ceil(size.tokens / 2))
    true: dict[str, tuple[tuple[Rule, ...], int]] = {
        "any row": ((), perm(size.tokens, size.cells)),
        "odd numbers": ((ODD,), perm(odd, size.cells)),
        "rising": ((RISING,), comb(size.tokens, size.cells)),
        "odd numbers, rising": ((ODD, RISING), comb(odd, size.cells)),
    }
    errors: dict[str, list[float]] = {name: [] for name in true}
    for seed in range(repeat):
        context = learn(lesson_of(size, seed), seed=seed).belief.contexts[0]
        for name, (rules, count) in true.items():
            allowed = context.rows.real.copy()
            for rule in rules:
                allowed &= context.truth(rule)
            errors[name].append(abs(size_of(pack(allowed), context.rows) / count - 1))
    for name, found in errors.items():
        yield Estimate(size, name, true[name][1], statistics.median(found), max(found))


def speed_table(speeds: Iterable[tuple[Goal, Speed]]) -> PageTable:
    """The goals, and what was measured."""
    rows = [
        (
            goal.name,
            f"{speed.size.layouts:,}",
            _seconds(speed.learn_s),
            _seconds(speed.fastest_s),
            f"under {_seconds(goal.learn_s)}",
            _seconds(speed.question_s),
            "" if goal.question_s is None else f"under {_seconds(goal.question_s)}",
            f"{speed.memory_mb:.0f} MB",
        )
        for goal, speed in speeds
    ]
    return PageTable(
        "speed",
        "Learning from three demonstrations, and finding a question after one; memory is that of "
        f"the whole process, and under {MOST_MEMORY_MB} MB is wanted",
        (
            "What",
            "Ways to fill the row",
            "Learn, median",
            "fastest",
            "Wanted",
            "Next question, median",
            "Wanted",
            "Memory",
        ),
        tuple(rows),
    )


def estimates_table(found: Iterable[Estimate]) -> PageTable:
    """How far estimates are off."""
    rows = [
        (
            f"{one.size.tokens} tokens, {one.size.cells} goal cells",
            one.rule,
            f"{one.true:.2g}",
            f"{100 * one.median:.1f} %",
            f"{100 * one.most:.1f} %",
        )
        for one in found
    ]
    return PageTable(
        "estimates",
        "How far the sampled number of rows that a rule allows is off",
        ("Size", "Rule", "Truly", "Median error", "Largest error"),
        tuple(rows),
    )


def growth_svg(what: str, speeds: Sequence[Speed]) -> str:
    """One curve of `GROWTHS` as a picture."""
    points = tuple(
        Point(_along(what, one.size), one.learn_s, one.fastest_s, one.slowest_s) for one in speeds
    )
    ends = ", ".join(f"{_seconds(one.mean)} at {one.x}" for one in (points[0], points[-1]))
    return draw(
        Picture(
            title=f"Seconds to learn, by {_WORDS[what]}",
            description=f"Median of several lessons; band from fastest to slowest. {ends}.",
            horizontal=_WORDS[what],
            vertical="seconds",
            series=(Series("learning, median", points),),
            top=_round_up(max(point.high for point in points)),
        )
    )


def growth_rows(what: str, speeds: Iterable[Speed]) -> Iterator[dict[str, object]]:
    """One curve as rows of a CSV file."""
    for one in speeds:
        yield {
            "by": what,
            "tokens": one.size.tokens,
            "cells": one.size.cells,
            "demonstrations": one.size.demonstrations,
            "learn_s": round(one.learn_s, 4),
            "fastest_s": round(one.fastest_s, 4),
            "slowest_s": round(one.slowest_s, 4),
            "question_s": round(one.question_s, 4),
        }


_WORDS: Final = {
    "tokens": "tokens, with 5 goal cells",
    "cells": "goal cells, with 20 tokens",
    "demonstrations": "demonstrations, on the paper's board",
}


def _along(what: str, size: Size) -> int:
    return {
        "tokens": size.tokens,
        "cells": size.cells,
        "demonstrations": size.demonstrations,
    }[what]


def _seconds(value: float) -> str:
    return f"{1000 * value:.0f} ms" if value < 1 else f"{value:.1f} s"


def _round_up(value: float) -> float:
    """The next of 1, 2 or 5 times a power of ten."""
    power = 1e-3
    while True:
        for factor in (1, 2, 5):
            if value <= factor * power:
                return factor * power
        power *= 10
