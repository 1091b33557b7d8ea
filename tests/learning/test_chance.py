from hypothesis import given
from hypothesis import strategies as st

from maestra.learning.chance import hashed, shuffled


def test_one_number_is_hashed_as_splitmix64_does() -> None:
    assert hashed(0) == 0xE220A8397B1DCDAF


@given(st.lists(st.integers(), max_size=6), st.integers(), st.integers())
def test_what_is_hashed_has_64_bits_and_depends_on_every_number(
    numbers: list[int], one: int, other: int
) -> None:
    assert 0 <= hashed(*numbers, one) < 2**64
    if one % 2**64 != other % 2**64:
        assert hashed(*numbers, one) != hashed(*numbers, other)


@given(st.lists(st.integers()), st.integers())
def test_shuffling_keeps_every_item(items: list[int], seed: int) -> None:
    assert sorted(shuffled(items, seed)) == sorted(items)


def test_every_order_comes_about_equally_often() -> None:
    orders = [tuple(shuffled("abc", seed)) for seed in range(6000)]
    assert all(900 < orders.count(order) < 1100 for order in set(orders))
    assert len(set(orders)) == 6
