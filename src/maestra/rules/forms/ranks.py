"""Ranks along a line, exact for one play and as small whole numbers for many."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from maestra.rules.forms.base import Direction
from maestra.rules.plays import Plays, Truth, as_table, close_ranks
from maestra.rules.setting import Index, Line, Play, Rank, Setting

SIGN: Final = {Direction.RISING: 1, Direction.FALLING: -1}
NO_LIMIT: Final = int(np.iinfo(np.int64).max)
PAIR: Final = 2


def ranks_along(play: Play, line: Line, attribute: str, direction: Direction) -> list[Rank] | None:
    """The ranks of the tokens in order, turned round if falling; None if one has none."""
    known = play.setting.ranks(attribute)
    ranks: list[Rank] = []
    for token in play.slots(line):
        if token is not None:
            rank = known[token]
            if rank is None:
                return None
            ranks.append(SIGN[direction] * rank)
    return ranks


def rank_table(setting: Setting, attribute: str, direction: Direction) -> NDArray[np.int64]:
    """Each token's place among the ranks that occur, from 0; -1 where there is none."""

    def work_out() -> NDArray[np.int64]:
        sign = SIGN[direction]
        ranks = [None if r is None else sign * r for r in setting.ranks(attribute)]
        order = {rank: k for k, rank in enumerate(sorted({r for r in ranks if r is not None}))}
        return np.array([*(-1 if r is None else order[r] for r in ranks), -1], np.int64)

    return setting.remember(("rank table", attribute, direction), work_out)


def dense_ranks(
    plays: Plays, line: Line, attribute: str, direction: Direction
) -> tuple[NDArray[np.int64], Truth]:
    """The ranks along the line without gaps, and which of them are there."""
    tokens = plays.line(line)
    if line is Line.ROW:
        tokens = close_ranks(tokens)
    return rank_table(plays.setting, attribute, direction)[tokens], tokens >= 0


def all_ranked(plays: Plays, line: Line, attribute: str) -> Truth:
    """Whether every token of the line has a rank."""
    ranks = plays.setting.ranks(attribute)
    if None not in ranks:
        return np.ones(len(plays), np.bool_)
    ranked = plays.setting.mask(lambda k: ranks[k] is not None)
    table = as_table(plays.setting, ranked, nobody=True)
    return np.asarray(table[plays.line(line)].all(axis=1))


def few_of_each(
    tokens: Iterable[Index], key: Callable[[Index], Hashable], number: int
) -> list[Index]:
    """Of tokens with the same key no more than `number`: the others could only stand in."""
    seen: Counter[Hashable] = Counter()
    few: list[Index] = []
    for token in tokens:
        if seen[key(token)] < number:
            seen[key(token)] += 1
            few.append(token)
    return few
