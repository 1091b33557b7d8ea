from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from maestra.learning import covering
from maestra.learning.covering import smallest_cover, union, without_needless

SETS = st.lists(st.integers(1, 2**7 - 1), max_size=7)


def by_trying_all(sets: list[int]) -> int:
    return next(
        size
        for size in range(len(sets) + 1)
        if any(union(some) == union(sets) for some in combinations(sets, size))
    )


@given(SETS)
def test_no_smaller_choice_holds_everything(sets: list[int]) -> None:
    cover = smallest_cover(sets, 10_000)
    assert cover.chosen is not None
    assert union(sets[index] for index in cover.chosen) == union(sets)
    assert len(cover.chosen) == cover.lower_bound == by_trying_all(sets)


@given(SETS, st.integers(0, 5))
def test_a_search_that_gives_up_bounds_from_below(sets: list[int], nodes: int) -> None:
    cover = smallest_cover(sets, nodes)
    assert cover.lower_bound <= by_trying_all(sets)
    assert cover.chosen is None or len(cover.chosen) == cover.lower_bound


def test_no_choice_as_large_as_a_known_one_is_looked_for() -> None:
    cover = smallest_cover([0b01, 0b10], 100, below=2)
    assert cover.chosen is None
    assert cover.lower_bound == 2


def test_very_many_sets_are_searched_without_comparing_each_pair() -> None:
    sets = [1 << place for place in range(2)] + [
        (number << 2) | 0b11 for number in range(covering.MAX_COMPARED)
    ]
    cover = smallest_cover(sets, 100_000)
    assert cover.chosen is not None
    assert union(sets[index] for index in cover.chosen) == union(sets)


def test_a_set_that_the_others_make_up_goes() -> None:
    assert without_needless([0b0110, 0b0011, 0b1100]) == (1, 2)


@given(SETS)
def test_of_what_is_left_none_can_go(sets: list[int]) -> None:
    kept = [sets[index] for index in without_needless(sets)]
    assert union(kept) == union(sets)
    assert all(union([*kept[:n], *kept[n + 1 :]]) != union(sets) for n in range(len(kept)))
