"""Which tokens lie where in right rows, against listing every row."""

from itertools import pairwise, permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.rules.summaries import right_rows
from maestra.rules.summaries.right_rows import RightRows, UndecidedError

TOKENS = 5


@st.composite
def some_rows(draw: st.DrawFn) -> RightRows:
    """Rows of up to four places over five tokens, with or without a relation of neighbours."""
    places = draw(st.integers(1, 4))
    sets = st.integers(0, 2**TOKENS - 1)
    alike = draw(st.booleans())
    domains = (draw(sets),) * places if alike else tuple(draw(sets) for _ in range(places))
    kind = draw(st.sampled_from(["none", "order", "any"]))
    match kind:
        case "none":
            return RightRows(domains)
        case "order":
            ranks = [draw(st.integers(0, 3)) for _ in range(TOKENS)]
            before = tuple(
                sum(1 << other for other in range(TOKENS) if ranks[other] < ranks[token])
                for token in range(TOKENS)
            )
            return RightRows(domains, before)
        case _:
            return RightRows(domains, tuple(draw(sets) for _ in range(TOKENS)))


def listed(rows: RightRows) -> list[tuple[int, ...]]:
    """Every row, the slow and obvious way."""
    return [
        row
        for row in permutations(range(TOKENS), len(rows.domains))
        if all(domain >> token & 1 for domain, token in zip(rows.domains, row, strict=True))
        and all(
            rows.before is None or rows.before[right] >> left & 1 for left, right in pairwise(row)
        )
    ]


@given(some_rows())
def test_what_is_possible_on_a_place_is_what_some_row_has_there(rows: RightRows) -> None:
    every = listed(rows)
    for place in range(len(rows.domains)):
        assert rows.possible(place) == sum({1 << row[place] for row in every})


@given(some_rows())
def test_what_lies_together_is_what_some_row_has_together(rows: RightRows) -> None:
    every = listed(rows)
    places = range(len(rows.domains))
    for place in places:
        for token in range(TOKENS):
            for other in set(places) - {place}:
                together = {1 << row[other] for row in every if row[place] == token}
                assert rows.together(place, token, other) == sum(together)


def test_too_many_rows_are_refused_not_guessed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(right_rows, "MAX_WORK", 3)
    rows = RightRows((0b11111, 0b01111, 0b11111))
    with pytest.raises(UndecidedError):
        rows.possible(0)
