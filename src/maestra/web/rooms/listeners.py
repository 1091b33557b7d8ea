"""Who follows a room: each with a short queue, so that nobody slow holds others up."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Mapping, Sequence
from typing import Final

from maestra.coaching.ports import PatientId

MOST_WAITING: Final = 8
"""Messages that wait for one listener. Each holds the whole state, so a slower one misses nothing
that still matters when it gets the newest alone; and 500 of them take no more than 8 MB."""


class LeftError(Exception):
    """What the listener followed is over, and what comes next is not for them."""


class Listener:
    """One end of a stream; made in the event loop that will wait for its messages."""

    def __init__(
        self,
        *,
        for_caregiver: bool = False,
        is_board: bool = False,
        follows: PatientId | None = None,
    ) -> None:
        """Begin with nothing to tell.

        Args:
            for_caregiver: whether what the caregiver is asked is for them.
            is_board: whether this is the board on which tokens are moved.
            follows: the one whose sessions they follow; None: whoever plays.
        """
        self.for_caregiver: Final = for_caregiver
        self.is_board: Final = is_board
        self.follows: Final = follows
        self._loop = asyncio.get_running_loop()
        self._waiting: deque[str] = deque()
        self._woken = asyncio.Event()
        self._is_over = False

    def offer(self, message: str) -> None:
        """Have `message` sent; from any thread, and never waits."""
        self._call(message)

    def end(self) -> None:
        """Have the stream closed; from any thread."""
        self._call(None)

    async def next(self, within_s: float) -> str | None:
        """The next message; None if there is none in this time.

        Raises:
            LeftError: there will be no more.
        """
        if not self._waiting and not self._is_over:
            self._woken.clear()
            try:
                async with asyncio.timeout(within_s):
                    await self._woken.wait()
            except TimeoutError:
                return None
        if self._is_over:
            raise LeftError
        return self._waiting.popleft()

    @property
    def loop(self) -> asyncio.AbstractEventLoop:
        """Where it waits."""
        return self._loop

    def put(self, message: str) -> None:
        """The same as `offer`, in the loop itself."""
        self._put(message)

    def _call(self, message: str | None) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._put, message)

    def _put(self, message: str | None) -> None:
        if len(self._waiting) >= MOST_WAITING:
            self._waiting.clear()
        if message is None:
            self._is_over = True
        else:
            self._waiting.append(message)
        self._woken.set()


def offer_all(messages: Mapping[Listener, str]) -> None:
    """Offer each listener its message; a loop is woken once for all of its listeners."""
    of_loop: dict[asyncio.AbstractEventLoop, list[Listener]] = {}
    for listener in messages:
        of_loop.setdefault(listener.loop, []).append(listener)
    for loop, listeners in of_loop.items():
        if not loop.is_closed():
            loop.call_soon_threadsafe(_put_all, listeners, messages)


def _put_all(listeners: Sequence[Listener], messages: Mapping[Listener, str]) -> None:
    for listener in listeners:
        listener.put(messages[listener])
