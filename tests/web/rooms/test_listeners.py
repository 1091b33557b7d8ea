"""Nobody slow holds others up, and nobody slow misses what still matters."""

import asyncio

import pytest

from maestra.web.rooms.listeners import MOST_WAITING, LeftError, Listener, offer_all

LATER_S = 5.0


@pytest.mark.asyncio
async def test_messages_come_in_order() -> None:
    listener = Listener()
    for number in range(3):
        listener.offer(str(number))
    assert [await listener.next(LATER_S) for _ in range(3)] == ["0", "1", "2"]
    assert await listener.next(0.01) is None


@pytest.mark.asyncio
async def test_whoever_is_too_slow_gets_the_newest_and_no_backlog() -> None:
    listener = Listener()
    for number in range(10 * MOST_WAITING + 3):
        offer_all({listener: str(number)})
    await asyncio.sleep(0)
    got: list[str] = []
    while (message := await listener.next(0.01)) is not None:
        got.append(message)
    assert len(got) <= MOST_WAITING
    assert got[-1] == str(10 * MOST_WAITING + 2)


@pytest.mark.asyncio
async def test_what_is_over_is_told_at_once_whatever_waits() -> None:
    listener = Listener()
    listener.offer("late")
    listener.end()
    await asyncio.sleep(0)
    with pytest.raises(LeftError):
        await listener.next(LATER_S)


def test_a_loop_that_has_ended_is_left_alone() -> None:
    async def made() -> Listener:
        return Listener()

    listener = asyncio.run(made())
    listener.offer("too late")
    offer_all({listener: "too late"})
