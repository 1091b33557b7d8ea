"""Whether an order of placement is asked for, or people only fill as they are used to.

An order that everybody is used to says little: the shown orders are weighed against how often
people who may fill anyhow would fill so. A person keeps to a habit through all demonstrations.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, TypeAlias

import numpy as np

from maestra.learning.fewshot.prior import FILLING, HABITS, SLIP, TRUST
from maestra.rules.answers import Answer, Reply, RowQuestion, RuleQuestion
from maestra.rules.forms.timing import Filling, FillOrder
from maestra.rules.setting import Index, Play

Fillings: TypeAlias = tuple[tuple[Filling | None, float], ...]
"""How likely each order of placement is asked for, likeliest first; None: none is."""
ASKED: Final = 0.05
"""From then on rows are asked about in the order that may be asked for."""


def fillings(plays: Sequence[Play], answers: Sequence[Answer]) -> Fillings:
    """How likely each order of placement is asked for, likeliest first; None: none is."""
    scores = {filling: share * _shown(plays, filling) for filling, share in FILLING.items()}
    for answer in answers:
        match answer.question:
            case RuleQuestion(FillOrder(asked)) if answer.reply is not Reply.UNSURE:
                for filling in scores:
                    agrees = (filling is asked) == (answer.reply is Reply.YES)
                    scores[filling] *= TRUST if agrees else 1 - TRUST
            case RowQuestion(play) if answer.reply is Reply.YES:
                for filling in scores:
                    if filling is not None and not FillOrder(filling).holds(play):
                        scores[filling] *= (1 - TRUST) / TRUST
            case _:
                pass
    total = sum(scores.values())
    ranked = sorted(scores.items(), key=lambda one: -one[1])
    return tuple((filling, score / total) for filling, score in ranked)


def another_order(order: Sequence[Index], known: Fillings) -> tuple[Index, ...]:
    """All goal cells the other way round, or as is likely to be asked for if something is.

    Where cells are filled in an order that is wrong, a "no" says nothing of the row.
    """
    back = tuple(order[::-1])
    filling, share = next(one for one in known if one[0] is not None)
    if filling is None or share < ASKED:
        return back
    keys = FillOrder(filling).keys(len(order))
    return tuple(sorted(back, key=lambda cell: keys[cell]))


def out_of_order(position: Play, known: Fillings) -> float:
    """How likely it is that an order is asked for which the position does not keep to."""
    return sum(
        share
        for filling, share in known
        if filling is not None and not FillOrder(filling).holds(position)
    )


def _shown(plays: Sequence[Play], filling: Filling | None) -> float:
    """How likely the shown orders of placement are if `filling` is asked for."""
    if filling is not None:
        return float(np.prod([_fills(play, filling) for play in plays]))
    return sum(
        share * float(np.prod([_fills(play, habit) for play in plays]))
        for habit, share in HABITS.items()
    )


def _fills(play: Play, filling: Filling | None) -> float:
    """How likely a play is filled so by somebody who means or is used to `filling`."""
    free = {k for k, token in enumerate(play.setting.given) if token is None}
    any_way = 1.0
    chance = 1.0
    rule = None if filling is None else FillOrder(filling)
    now = Play.begin(play.setting)
    for token, cell in play.placed:
        any_way /= len(free)
        if rule is not None:
            right = rule.next_cells(now)
            chance *= 1 / len(right) if cell in right else 0.0
        free.remove(cell)
        now = now.after(token, cell)
    return any_way if rule is None else (1 - SLIP) * chance + SLIP * any_way
