"""Tables of results, and pages of the documentation that hold them.

A page is written by hand but for its tables: each stands between ``<!-- table NAME -->`` and
``<!-- end NAME -->``, and the command that measures it writes it there.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from typing import TypeAlias

from maestra.core.faults import Fault, InvalidError
from maestra.experiments.results import Record
from maestra.experiments.shares import Share

Cell: TypeAlias = str | Share
"""Words or a number; or a share with its interval."""


@dataclass(frozen=True, slots=True)
class PageTable:
    """One table of results."""

    name: str
    title: str
    headings: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


def in_words(cell: Cell) -> str:
    """``92.4 (90.1-94.2)``: percent, and the interval that holds the true share with 95 %."""
    match cell:
        case Share(of=0):
            return "-"
        case Share(count, of, low, high):
            return f"{100 * count / of:.1f} ({100 * low:.1f}-{100 * high:.1f})"
        case str():
            return cell


def table_json(table: PageTable) -> Record:
    """The table as a JSON object: a share with its counts and interval, as they are."""
    rows = [
        [asdict(cell) if isinstance(cell, Share) else cell for cell in row] for row in table.rows
    ]
    return {
        "name": table.name,
        "title": table.title,
        "headings": list(table.headings),
        "rows": rows,
    }


def filled(page: str, tables: Iterable[PageTable]) -> str:
    """The page with these tables in their places, everything else as it is.

    Raises:
        InvalidError: the page has no place for one of them.
    """
    faults: list[Fault] = []
    for table in tables:
        begin, end = f"<!-- table {table.name} -->", f"<!-- end {table.name} -->"
        place = re.compile(f"{re.escape(begin)}.*?{re.escape(end)}", re.DOTALL)
        whole = f"{begin}\n{markdown(table)}\n{end}"
        # The page is put together, not substituted: a table may hold a backslash.
        found = place.search(page)
        if found is None:
            faults.append(Fault(table.name, "missing", f"{begin} and {end}"))
        else:
            page = page[: found.start()] + whole + page[found.end() :]
    if faults:
        raise InvalidError(faults)
    return page


def markdown(table: PageTable) -> str:
    """The title as a sentence of its own, and the table."""
    lines = [
        _line(table.headings),
        _line("---" if k == 0 else "--:" for k in range(len(table.headings))),
        *(_line(map(in_words, row)) for row in table.rows),
    ]
    return "\n".join([table.title, "", *lines])


def _line(cells: Iterable[str]) -> str:
    return f"| {' | '.join(cells)} |"


def percent(share: float) -> str:
    """``95 %``."""
    return f"{100 * share:.0f} %"
