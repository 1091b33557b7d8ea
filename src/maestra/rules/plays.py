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
Tokens: TypeAlias = NDArray[np.int16]
"""Tokens by number; -1 where there is none, which picks the last entry of every table below."""

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
        arrays = [np.full(shape, NOBODY, np.int16) for _ in range(3)]
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
        given = np.array([token is not None for token in setting.given])
        cells = np.array(order if order is not None else range(setting.length), np.int16)
        cells = cells[~given[cells]]
        padded = np.full(row.shape, NOBODY, np.int16)
        padded[:, : len(cells)] = cells
        time = np.where(padded == NOBODY, NOBODY, np.take_along_axis(row, padded, axis=1))
        empty = time == NOBODY
        # Empty cells are no placements: the others move up, in the same order.
        places = np.argsort(empty, axis=1, kind="stable")
        cells_in_time = np.where(empty, NOBODY, padded)
        return cls(
            setting,
            row,
            np.take_along_axis(time, places, axis=1).astype(np.int16),
            np.take_along_axis(cells_in_time, places, axis=1).astype(np.int16),
        )


def close_ranks(tokens: Tokens) -> Tokens:
    """The tokens of each line moved to its beginning, gaps at its end."""
    places = np.argsort(tokens == NOBODY, axis=1, kind="stable")
    return np.take_along_axis(tokens, places, axis=1)


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
