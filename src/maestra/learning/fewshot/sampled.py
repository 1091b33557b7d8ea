"""Rows drawn where there are too many to list, each with how many it stands for.

Each scheme is a conjunction of rules about slots and pairs of slots; its rows are drawn from
left to right, a token that the rules still allow being the likelier the more chains of
neighbours it can begin, so the chance of a row is the product of its choices' shares [1]. A row
from any scheme stands for 1 / (sum over schemes of draws x chance) rows, the balance heuristic
[2]: sums over drawn rows are unbiased, and exact where one scheme is an order that is counted.

Nothing is random: the numbers are a hash of the seed.

[1] D. E. Knuth, Estimating the efficiency of backtrack programs, 1975.
[2] E. Veach, L. J. Guibas, Optimally combining sampling techniques, SIGGRAPH 1995.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from maestra.learning.fewshot.space import Rows
from maestra.rules.forms.base import EachSlot, Pairwise
from maestra.rules.plays import NOBODY, Tokens, Truth, as_matrix, as_table
from maestra.rules.rule import Rule
from maestra.rules.setting import Line, Setting

DRAWS: Final = 200
"""Rows of each scheme: an estimate of a share of a half is good to 14 % (two sigma) by one scheme
alone; that of a rule with a scheme of its own is nearly exact."""
SPREAD: Final = 1.2
"""Weights of one packed word are at most so far apart."""
SINGLE: Final = 12
"""Rules that are schemes on their own."""
PAIRED: Final = 4
"""Rules about slots, and about pairs, of which any two are a scheme."""


@dataclass(frozen=True, eq=False)
class Scheme:
    """Which token may lie on each goal cell, given those to its left."""

    slots: tuple[Truth, ...]
    """For each goal cell: by token."""
    links: tuple[tuple[tuple[int, Truth], ...], ...]
    """For each goal cell: earlier cells, and which tokens go with which there."""
    gaps: bool
    """Whether a cell may stay empty."""
    ahead: tuple[NDArray[np.float64], ...]
    """For each goal cell, by token: how many chains of neighbours to the right end begin so, up
    to a factor."""


def sampled(
    setting: Setting, rules: Sequence[Rule], shown: Sequence[Tokens], *, full: bool, seed: int
) -> Rows:
    """Rows from `setting`, with weights that add up to about how many there are.

    Args:
        setting: the start.
        rules: those that are likely to be counted, the likeliest first.
        shown: rows that must be among them; each stands at least for itself.
        full: whether rows have no gaps.
        seed: any number.
    """
    schemes = schemes_of(setting, rules, gaps=not full)
    drawn = [draw(setting, one, DRAWS, seed + k) for k, one in enumerate(schemes)]
    rows = np.concatenate([np.array(shown, np.intp), *drawn])
    rows, inverse, counts = np.unique(rows, axis=0, return_inverse=True, return_counts=True)
    # What was shown was not drawn: counted as a draw, a rare row would stand for far too many.
    np.subtract.at(counts, inverse.ravel()[: len(shown)], 1)
    chances = sum(chance(setting, one, rows) for one in schemes)
    weight = np.maximum(counts / (DRAWS * np.maximum(chances, 1e-300)), 0.0)
    own = np.zeros(len(rows), np.bool_)
    own[inverse.ravel()[: len(shown)]] = True
    weight[own] = np.clip(weight[own], 1.0, None)
    return _in_words(rows, weight)


def _in_words(rows: Tokens, weight: NDArray[np.float64]) -> Rows:
    """The rows by weight, 64 of nearly the same to a packed word, which has their mean."""
    order = np.argsort(weight, kind="stable")
    parts: list[Tokens] = []
    weights: list[NDArray[np.float64]] = []
    first = 0
    while first < len(order):
        near = order[first : first + 64]
        near = near[weight[near] <= SPREAD * weight[near[0]]]
        filling = np.repeat(near[:1], 64 - len(near))
        parts.append(rows[np.concatenate([near, filling])])
        share = np.zeros(64)
        share[: len(near)] = weight[near].mean()
        weights.append(share)
        first += len(near)
    return Rows(np.concatenate(parts), np.concatenate(weights))


def schemes_of(setting: Setting, rules: Sequence[Rule], *, gaps: bool) -> list[Scheme]:
    """Anything, each of the first rules, and two by two."""
    slots = [r for r in rules if isinstance(r, EachSlot) and r.along() is Line.ROW]
    pairs = [r for r in rules if isinstance(r, Pairwise) and r.along() is Line.ROW]
    singles = [r for r in rules if isinstance(r, EachSlot | Pairwise) and r.along() is Line.ROW]
    twos = [(one, two) for one in slots[:PAIRED] for two in pairs[:PAIRED]]
    return [
        _scheme(setting, chosen, gaps=gaps)
        for chosen in ((), *((rule,) for rule in singles[:SINGLE]), *twos)
    ]


def _scheme(setting: Setting, rules: Sequence[EachSlot | Pairwise], *, gaps: bool) -> Scheme:
    tokens = len(setting.deck.tokens)
    slots = [
        as_table(setting, setting.movable, nobody=False)[:tokens].copy()
        for _ in range(setting.length)
    ]
    links: list[list[tuple[int, Truth]]] = [[] for _ in range(setting.length)]
    for rule in rules:
        if isinstance(rule, EachSlot):
            for cell, mask in enumerate(rule.allowed(setting)):
                slots[cell] &= as_table(setting, mask, nobody=False)[:tokens]
        else:
            for i, j, masks in rule.links(setting):
                links[j].append((i, as_matrix(setting, masks)[:, :tokens]))
    for cell, token in enumerate(setting.given):
        if token is not None:
            slots[cell] = np.arange(tokens) == token
    return Scheme(tuple(slots), tuple(map(tuple, links)), gaps, _ahead(slots, links))


def _ahead(
    slots: Sequence[Truth], links: Sequence[Sequence[tuple[int, Truth]]]
) -> tuple[NDArray[np.float64], ...]:
    """Chains counted from the right end; exact for an order, where no token comes twice."""
    tokens = len(slots[0])
    chains = [np.ones(tokens) for _ in slots]
    for cell in range(len(slots) - 2, -1, -1):
        goes = np.broadcast_to(slots[cell + 1], (tokens, tokens)).astype(np.float64)
        for earlier, matrix in links[cell + 1]:
            if earlier == cell:
                goes = goes * matrix[:tokens]
        found = goes @ chains[cell + 1]
        # Only shares matter: numbers are kept from growing without end.
        chains[cell] = found / max(float(found.max()), 1e-300)
    return tuple(chains)


def _choices(scheme: Scheme, rows: Tokens, cell: int) -> Truth:
    """For each row the tokens that may come on `cell` after what lies to its left."""
    free = np.repeat(scheme.slots[cell][None], len(rows), axis=0)
    for earlier in range(cell):
        lies = rows[:, earlier]
        there = np.flatnonzero(lies != NOBODY)
        free[there, lies[there]] = False
    for earlier, matrix in scheme.links[cell]:
        free &= matrix[rows[:, earlier]]
    return free


def _shares(setting: Setting, scheme: Scheme, rows: Tokens, cell: int) -> NDArray[np.float64]:
    """For each row how likely each token is to come on `cell`, and in the last column nobody."""
    share = _choices(scheme, rows, cell) * scheme.ahead[cell]
    gap = scheme.gaps and setting.given[cell] is None
    nobody = share.mean(axis=1) + 1e-9 if gap else np.zeros(len(rows))
    return np.column_stack([share, nobody])


def draw(setting: Setting, scheme: Scheme, number: int, seed: int) -> Tokens:
    """Rows drawn from left to right; fewer than `number` where some came to a dead end."""
    rows = np.full((number, setting.length), NOBODY, np.intp)
    alive = np.ones(number, np.bool_)
    for cell in range(setting.length):
        shares = np.cumsum(_shares(setting, scheme, rows, cell), axis=1)
        total = shares[:, -1]
        alive &= total > 0
        level = uniform(number, seed * 1_000 + cell) * total
        which = (shares <= level[:, None]).sum(axis=1)
        rows[:, cell] = np.where(which < shares.shape[1] - 1, which, NOBODY)
    return rows[alive]


def chance(setting: Setting, scheme: Scheme, rows: Tokens) -> NDArray[np.float64]:
    """How likely `draw` is to draw each row."""
    likely = np.ones(len(rows))
    for cell in range(setting.length):
        shares = _shares(setting, scheme, rows, cell)
        # Nobody, -1, is the last column.
        mine = shares[np.arange(len(rows)), rows[:, cell]]
        likely *= mine / np.maximum(shares.sum(axis=1), 1e-300)
    return likely


def uniform(number: int, seed: int) -> NDArray[np.float64]:
    """Numbers from 0 to below 1 by hashing `seed` and their places (splitmix64)."""
    state = np.arange(number, dtype=np.uint64) + np.uint64(seed) * np.uint64(number)
    state = (state + np.uint64(1)) * np.uint64(0x9E3779B97F4A7C15)
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB)):
        state = (state ^ (state >> np.uint64(shift))) * np.uint64(factor)
    state ^= state >> np.uint64(31)
    return np.asarray((state >> np.uint64(11)) / 2.0**53, np.float64)
