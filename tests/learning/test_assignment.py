from itertools import permutations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from maestra.learning.assignment import FORBIDDEN, Costs, cheapest_assignment


@st.composite
def tables(draw: st.DrawFn) -> Costs:
    rows = draw(st.integers(1, 4))
    columns = draw(st.integers(rows, 5))
    cost = st.integers(0, 9) | st.just(FORBIDDEN)
    row = st.lists(cost, min_size=columns, max_size=columns)
    return np.array(draw(st.lists(row, min_size=rows, max_size=rows)), np.int64)


@given(tables())
def test_no_other_assignment_is_cheaper(costs: Costs) -> None:
    rows, columns = costs.shape
    found = cheapest_assignment(costs)
    assert len(set(found)) == rows

    def total(chosen: tuple[int, ...]) -> int:
        return sum(int(costs[row, column]) for row, column in enumerate(chosen))

    assert total(found) == min(total(chosen) for chosen in permutations(range(columns), rows))


def test_no_rows_need_no_columns() -> None:
    assert cheapest_assignment(np.zeros((0, 3), np.int64)) == ()
