"""Counting tries, with the time passed in."""

from hypothesis import given
from hypothesis import strategies as st

from maestra.coaching.fields import Milliseconds
from maestra.web.access.throttle import (
    EMPTY,
    NO_WAIT,
    Bucket,
    Limit,
    Throttle,
    drained,
    wait_ms,
)

LIMIT = Limit(3, 1000)


def at(ms: int) -> Milliseconds:
    return Milliseconds(ms)


def test_so_many_may_at_once_and_one_more_after_each_while() -> None:
    throttle = Throttle()
    assert [throttle.take("try", "ada", LIMIT, at(0)) for _ in range(5)] == [0, 0, 0, 1000, 1000]
    assert throttle.take("try", "ada", LIMIT, at(999)) == 1
    assert throttle.take("try", "ada", LIMIT, at(1000)) == NO_WAIT
    assert throttle.take("try", "ada", LIMIT, at(1000)) == 1000


def test_names_and_kinds_are_counted_apart() -> None:
    throttle = Throttle()
    for _ in range(3):
        throttle.take("try", "ada", LIMIT, at(0))
    assert throttle.take("try", "eva", LIMIT, at(0)) == NO_WAIT
    assert throttle.take("read", "ada", LIMIT, at(0)) == NO_WAIT
    assert throttle.take("try", "ada", LIMIT, at(0)) != NO_WAIT


def test_what_is_given_back_was_not_taken() -> None:
    throttle = Throttle()
    for _ in range(10):
        assert throttle.take("try", "ada", LIMIT, at(0)) == NO_WAIT
        throttle.give_back("try", "ada", LIMIT, at(0))
    throttle.give_back("try", "ada", LIMIT, at(0))
    assert [throttle.take("try", "ada", LIMIT, at(0)) for _ in range(4)] == [0, 0, 0, 1000]


def test_only_so_many_names_are_remembered_and_the_emptied_go_first() -> None:
    throttle = Throttle(most_keys=2)
    throttle.take("try", "old", LIMIT, at(0))
    for _ in range(3):
        throttle.take("try", "full", LIMIT, at(2000))
    throttle.take("try", "new", LIMIT, at(2000))
    assert throttle.take("try", "full", LIMIT, at(2000)) == 1000
    assert len(throttle) == 2
    throttle.take("try", "newest", LIMIT, at(2000))
    assert len(throttle) == 2


@given(st.lists(st.integers(0, 5000), max_size=60), st.integers(1, 5), st.integers(1, 2000))
def test_never_more_than_the_limit_within_any_time(
    pauses: list[int], most: int, each_ms: int
) -> None:
    throttle, limit, now = Throttle(), Limit(most, each_ms), 0
    granted: list[int] = []
    for pause in pauses:
        now += pause
        if throttle.take("try", "ada", limit, at(now)) == NO_WAIT:
            granted.append(now)
    for first in range(len(granted)):
        for last in range(first, len(granted)):
            span = granted[last] - granted[first]
            assert last - first + 1 <= most + span / each_ms + 1e-6


@given(st.floats(0, 5), st.integers(0, 10_000))
def test_after_the_wait_that_is_said_one_more_fits(level: float, now: int) -> None:
    bucket = Bucket(level, at(now))
    wait = wait_ms(bucket, LIMIT, at(now))
    assert wait_ms(bucket, LIMIT, at(now + wait)) == NO_WAIT


def test_a_bucket_is_never_less_than_empty() -> None:
    assert drained(EMPTY, LIMIT, at(10_000)).level == 0
