"""The cheapest way to give each row a column of its own: the Hungarian method.

Successive shortest paths with potentials [1, 2]: O(rows^2 x columns), the last factor vectorised.

[1] Kuhn, The Hungarian method for the assignment problem, Naval Research Logistics, 1955.
[2] Jonker, Volgenant, A shortest augmenting path algorithm for dense and sparse linear
    assignment problems, Computing, 1987.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

FORBIDDEN: Final = 1 << 40
"""The cost of a pair that may not be: beyond any sum of counts, far from overflow."""

Costs = np.ndarray[tuple[int, ...], np.dtype[np.int64]]


def cheapest_assignment(costs: Costs) -> tuple[int, ...]:
    """For each row its column, no column twice, so that the sum of `costs` is least.

    Args:
        costs: rows x columns, at least as many columns as rows; `FORBIDDEN` where a row may not
            have a column (it does only if there is no other way).
    """
    rows, columns = costs.shape
    # Row and column 0 stand for "none"; each augmenting path begins at column 0.
    prices = _Prices(np.zeros(rows + 1, np.int64), np.zeros(columns + 1, np.int64))
    owner = np.zeros(columns + 1, np.int64)
    indifferent = (costs == costs[:, :1]).all(axis=1)
    for row in np.flatnonzero(~indifferent) + 1:
        owner[0] = row
        column, before = _shortest_path(costs, prices, owner)
        while column:
            owner[column] = owner[before[column]]
            column = int(before[column])
    # To a row that costs the same everywhere any column is as good: what is left.
    free = np.flatnonzero(owner[1:] == 0) + 1
    owner[free[: indifferent.sum()]] = np.flatnonzero(indifferent) + 1
    column_of = {int(row): column - 1 for column, row in enumerate(owner) if column and row}
    return tuple(column_of[row] for row in range(1, rows + 1))


@dataclass(slots=True)
class _Prices:
    """Potentials: no pair costs less than the sum of its two, and assigned pairs just that."""

    rows: Costs
    columns: Costs


def _shortest_path(costs: Costs, prices: _Prices, owner: Costs) -> tuple[int, Costs]:
    """The column without owner that is nearest to column 0, and the column before each."""
    done = np.zeros(len(owner), np.bool_)
    distance = np.full(len(owner), 4 * FORBIDDEN, np.int64)
    before = np.zeros(len(owner), np.int64)
    column = 0
    while owner[column]:
        done[column] = True
        row = owner[column]
        reduced = costs[row - 1] - prices.rows[row] - prices.columns[1:]
        nearer = np.flatnonzero(~done[1:] & (reduced < distance[1:])) + 1
        distance[nearer] = reduced[nearer - 1]
        before[nearer] = column
        left = np.flatnonzero(~done)
        column = int(left[np.argmin(distance[left])])
        step = distance[column]
        prices.rows[owner[done]] += step
        prices.columns[done] -= step
        distance[left] -= step
    return column, before
