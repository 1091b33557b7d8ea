"""Many plays from the same start at once, as numpy arrays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from maestra.rules.pairs import Related
from maestra.rules.setting import Line, Mask, Play, Setting

Truth: TypeAlias = NDArray[np.bool_]
Tokens: TypeAlias = NDArray[np.intp]
"""Tokens by number; -1 where there is none, which picks the last entry of every table below.

Kept column by column where there are many plays: what is asked of short lines, one a play, is
then worked out several times faster.
"""

NOBODY = -1


@dataclass(frozen=True, slots=True, eq=False)
class Plays:
    """Plays from one start: one line of each array a play."""

    setting: Setting
    row: Tokens
    """plays x goal cells: what lies there."""
    time: Tokens
    """plays x goal cells: what was placed first, second, ...; -1 after the last."""
    cells: Tokens
    """plays x goal cells: onto which goal cell; -1 after the last."""

    def __len__(self) -> int:
        """How many plays."""
        return len(self.row)

    def line(self, line: Line) -> Tokens:
        """The tokens in the slots of `line`."""
        return self.row if line is Line.ROW else self.time

    @classmethod
    def of(cls, setting: Setting, plays: Sequence[Play]) -> Plays:
        """These plays; all from `setting`."""
        shape = (len(plays), setting.length)
        arrays = [np.full(shape, NOBODY, np.intp, order="F") for _ in range(3)]
        row, time, cells = arrays
        for k, play in enumerate(plays):
            row[k] = [NOBODY if token is None else token for token in play.row]
            for t, (token, cell) in enumerate(play.placed):
                time[k, t], cells[k, t] = token, cell
        return cls(setting, row, time, cells)

    @classmethod
    def layouts(cls, setting: Setting, row: Tokens, order: Sequence[int] | None = None) -> Plays:
        """Plays that leave these rows, placed cell by cell in `order`, else from left to right.

        Args:
            setting: the start; `row` agrees with what it gives.
            row: plays x goal cells.
            order: all goal cells, from 0, in the order of placement.
        """
        row = np.asfortranarray(row, np.intp)
        cells = [
            k
            for k in (range(setting.length) if order is None else order)
            if setting.given[k] is None
        ]
        time = np.full(row.shape, NOBODY, np.intp, order="F")
        time[:, : len(cells)] = row[:, cells]
        cells_in_time = np.full(row.shape, NOBODY, np.intp, order="F")
        cells_in_time[:, : len(cells)] = cells
        empty = time == NOBODY
        if empty[:, : len(cells)].any():
            # Empty cells are no placements: the others move up, in the same order.
            cells_in_time[empty] = NOBODY
            places = np.argsort(empty, axis=1, kind="stable")
            time = np.asfortranarray(np.take_along_axis(time, places, axis=1))
            cells_in_time = np.asfortranarray(np.take_along_axis(cells_in_time, places, axis=1))
        return cls(setting, row, time, cells_in_time)


def close_ranks(tokens: Tokens) -> Tokens:
    """The tokens of each line moved to its beginning, gaps at its end."""
    gaps = tokens == NOBODY
    if not gaps.any():
        return tokens
    places = np.argsort(gaps, axis=1, kind="stable")
    return np.asfortranarray(np.take_along_axis(tokens, places, axis=1))


def as_table(setting: Setting, mask: Mask, *, nobody: bool) -> Truth:
    """Whether each token is in a set; the last entry is for no token at all."""

    def work_out() -> Truth:
        count = len(setting.deck.tokens)
        return np.array([*(bool(mask >> k & 1) for k in range(count)), nobody])

    return setting.remember(("table", mask, nobody), work_out)


def as_matrix(setting: Setting, masks: Related) -> Truth:
    """Which pairs are related, first token x second; true where there is no token."""

    def work_out() -> Truth:
        rows = [as_table(setting, mask, nobody=True) for mask in masks]
        return np.vstack([*rows, np.ones(len(masks) + 1, np.bool_)])

    return setting.remember(("matrix", masks), work_out)
