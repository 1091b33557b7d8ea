"""What `maestra experiment` prints for people."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path
from typing import Final

from rich.console import Console
from rich.table import Table

from maestra.cli.streams import write_file
from maestra.experiments.assistance_bound import BoundRow
from maestra.experiments.coaching import Comparison, Mean, PolicyRow
from maestra.experiments.curve import Choice, CurvePoint, CurveSettings
from maestra.experiments.pages import PageTable, filled, in_words
from maestra.experiments.shares import Share
from maestra.experiments.table import TableRow

PIPED_WIDTH: Final = 250
"""Characters in a line that nobody sees on a screen."""


def print_table(rows: Iterable[TableRow]) -> None:
    """The six exercises, a line for each learner."""
    table = Table("exercise", "learner", "result", box=None, pad_edge=False)
    for title in ("fewest", "paper", "learn s", "explain s"):
        table.add_column(title, justify="right")
    before = ""
    for row in rows:
        proven = row.demonstrations == row.lower_bound
        table.add_row(
            row.exercise if row.exercise != before else "",
            row.learner,
            row.outcome,
            f"{row.demonstrations}" if proven else f"{row.lower_bound}-{row.demonstrations}",
            f"{row.fewest_in_paper}",
            _seconds(row.learn_s),
            _seconds(row.explain_s),
        )
        before = row.exercise
    _print(table)


def print_curve(
    settings: CurveSettings, points: Sequence[CurvePoint], shown_at: Collection[int]
) -> None:
    """The curves after the numbers in `shown_at`, and at their ends."""
    title = f"{settings.paper_exercise.title}, vocabulary {settings.level.value}"
    table = Table("demonstrations", title=title, title_justify="left", box=None, pad_edge=False)
    for heading in ("runs", "mean %", "deviation", "10 %", "90 %"):
        table.add_column(heading, justify="right")
    for choice in Choice:
        mine = [point for point in points if point.choice == choice]
        for point in mine:
            if point.demonstrations in shown_at or point is mine[-1]:
                table.add_row(
                    f"{point.demonstrations} {choice.value}",
                    f"{point.runs}",
                    *(f"{v:.1f}" for v in (point.mean, point.deviation, point.low, point.high)),
                )
    _print(table)


def print_tables(tables: Iterable[PageTable]) -> None:
    """Each table below its title."""
    for one in tables:
        table = Table(*one.headings, title=one.title, title_justify="left", box=None)
        for row in one.rows:
            table.add_row(*map(in_words, row))
        _print(table)


def write_page(path: str, tables: Iterable[PageTable]) -> None:
    """Put the tables into their places in a page that is there.

    Raises:
        InvalidError: it has no place for one of them.
        OSError: it cannot be read or written.
    """
    write_file(path, filled(Path(path).read_text(encoding="utf-8"), tables))


def print_policies(rows: Iterable[PolicyRow], compared: Iterable[Comparison]) -> None:
    """A line for each profile and policy, then what the adaptive one saves."""
    table = Table("profile", "policy", box=None, pad_edge=False)
    for heading in ("completed", "assistance", "errors", "minutes", "right at first"):
        table.add_column(heading, justify="right")
    for row in rows:
        means = (row.assistance, row.errors, row.minutes)
        shares = (_share(row.complete), *map(_mean, means), _share(row.first_time))
        table.add_row(row.profile, row.policy, *shares)
    _print(table)
    saved = Table("adaptive against the most helpful", box=None, pad_edge=False)
    for heading in ("completed more often by", "assistance saved"):
        saved.add_column(heading, justify="right")
    for one in compared:
        saved.add_row(one.profile, _mean(one.completed_more), _mean(one.saved))
    _print(saved)


def print_bound(rows: Iterable[BoundRow]) -> None:
    """What level 5 throughout comes to, and what would be enough."""
    table = Table("profile", box=None, pad_edge=False)
    for heading in ("completed, most %", "help, most", "completed %", "help", "saved %"):
        table.add_column(heading, justify="right")
    for row in rows:
        most = (f"{100 * row.complete_with_most:.1f}", f"{row.levels_with_most:.1f}")
        least = (f"{100 * row.complete:.1f}", f"{row.levels:.1f}", f"{100 * row.saved:.0f}")
        table.add_row(row.profile, *most, *least)
    _print(table)


def _mean(mean: Mean) -> str:
    """``3.2 (2.9 to 3.5)``, the interval that holds the true mean with 95 % confidence."""
    return f"{mean.value:.2f} ({mean.low:.2f} to {mean.high:.2f})"


def _share(share: Share) -> str:
    """``7/20 (18-57 %)``, the interval that holds the true share with 95 % confidence."""
    return f"{share.count}/{share.of} ({100 * share.low:.0f}-{100 * share.high:.0f} %)"


def _print(table: Table) -> None:
    # A pipe has no width of its own: nothing may be cut there.
    width = None if sys.stdout.isatty() else PIPED_WIDTH
    Console(width=width).print(table)


def _seconds(value: float | None) -> str:
    return "" if value is None else f"{value:.4f}"
