"""How often something may be tried: buckets that empty by and by; the clock is an argument."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import Final

from maestra.coaching.fields import Milliseconds

MOST_KEYS: Final = 10_000
"""Names and addresses that are remembered: about two megabytes."""
NO_WAIT: Final = Milliseconds(0)


@dataclass(frozen=True, slots=True)
class Limit:
    """So many at once, and one more after each while."""

    most: int
    each_ms: int


@dataclass(frozen=True, slots=True)
class Bucket:
    """How full it was when."""

    level: float
    at: Milliseconds


EMPTY: Final = Bucket(0.0, Milliseconds(0))


def drained(bucket: Bucket, limit: Limit, now: Milliseconds) -> Bucket:
    """The bucket as it is now."""
    return Bucket(max(0.0, bucket.level - (now - bucket.at) / limit.each_ms), now)


def wait_ms(bucket: Bucket, limit: Limit, now: Milliseconds) -> Milliseconds:
    """How long until one more fits; 0 if it does now."""
    over = drained(bucket, limit, now).level + 1 - limit.most
    return Milliseconds(max(0, int(-(-over * limit.each_ms // 1))))


class Throttle:
    """Counts for many names and addresses; may be asked from any thread."""

    def __init__(self, most_keys: int = MOST_KEYS) -> None:
        """Begin with nothing counted."""
        self._most_keys = most_keys
        self._buckets: dict[tuple[str, str], tuple[Bucket, Limit]] = {}
        self._lock = threading.Lock()

    def __len__(self) -> int:
        """How many names and addresses are remembered."""
        return len(self._buckets)

    def take(self, kind: str, key: str, limit: Limit, now: Milliseconds) -> Milliseconds:
        """Count one more; 0 if it may be, else how long to wait, and nothing is counted."""
        with self._lock:
            bucket = drained(self._bucket(kind, key), limit, now)
            wait = wait_ms(bucket, limit, now)
            if wait == NO_WAIT:
                # Anew at the end, so that the first ones are those not used for longest.
                self._buckets.pop((kind, key), None)
                self._buckets[kind, key] = (Bucket(bucket.level + 1, now), limit)
                self._forget(now)
            return wait

    def give_back(self, kind: str, key: str, limit: Limit, now: Milliseconds) -> None:
        """Uncount one, which was no failure."""
        with self._lock:
            bucket = drained(self._bucket(kind, key), limit, now)
            self._buckets[kind, key] = (Bucket(max(0.0, bucket.level - 1), now), limit)

    def _bucket(self, kind: str, key: str) -> Bucket:
        return self._buckets.get((kind, key), (EMPTY, None))[0]

    def _forget(self, now: Milliseconds) -> None:
        if len(self._buckets) <= self._most_keys:
            return
        self._buckets = {
            key: (bucket, limit)
            for key, (bucket, limit) in self._buckets.items()
            if drained(bucket, limit, now).level > 0
        }
        while len(self._buckets) > self._most_keys:
            del self._buckets[next(iter(self._buckets))]
