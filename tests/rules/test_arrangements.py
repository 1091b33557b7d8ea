from itertools import permutations

from hypothesis import assume, given
from hypothesis import strategies as st

from maestra.core.board import Board, Cell
from maestra.rules.arrangements import Arrangements

STORAGE = Board(3, 2).storage_cells


@st.composite
def arrangements(draw: st.DrawFn) -> Arrangements:
    some = st.one_of(st.none(), st.frozensets(st.sampled_from(STORAGE), min_size=1))
    origins = tuple(draw(st.lists(some, min_size=1, max_size=3)))
    return Arrangements(STORAGE, origins, draw(st.integers(0, len(STORAGE) - len(origins))))


def every_origins(one: Arrangements) -> list[tuple[Cell, ...]]:
    return [
        cells
        for cells in permutations(one.storage, len(one.origins))
        if all(some is None or cell in some for cell, some in zip(cells, one.origins, strict=True))
    ]


@given(arrangements())
def test_the_numbered_origins_are_all_choices_each_once(one: Arrangements) -> None:
    numbered = [one.nth_origins(number) for number in range(one.of_origins)]
    assert sorted(numbered) == sorted(every_origins(one))


@given(arrangements())
def test_the_numbered_cells_of_unmoved_tokens_are_all_choices_each_once(
    one: Arrangements,
) -> None:
    assume(one.of_origins)
    origins = one.nth_origins(0)
    free = [cell for cell in one.storage if cell not in origins]
    numbered = [one.nth_unmoved(origins, number) for number in range(one.of_unmoved)]
    assert sorted(numbered) == sorted(permutations(free, one.unmoved))


@given(arrangements())
def test_where_a_token_may_begin_is_where_some_choice_puts_it(one: Arrangements) -> None:
    listed = every_origins(one)
    for step in range(len(one.origins)):
        begins = {cell for cell in one.storage if one.may_begin_at(step, cell)}
        assert begins == {cells[step] for cells in listed}


@given(arrangements())
def test_a_cell_may_be_spared_if_some_choice_leaves_it(one: Arrangements) -> None:
    listed = every_origins(one)
    spared = {cell for cell in one.storage if one.may_be_spared(cell)}
    assert spared == {cell for cell in one.storage if any(cell not in c for c in listed)}


def test_ten_steps_with_cells_of_their_own_are_counted_at_once() -> None:
    cells = Board(11, 10).storage_cells
    origins = tuple(frozenset({cell}) for cell in cells[:50])
    assert Arrangements(cells, origins, 0).of_origins == 1
