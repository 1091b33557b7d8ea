"""What the server remembers about who comes in, until it stops: counts, and the set-up code."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from typing import Final

from maestra.web.access.passwords import Passwords, are_same, as_typed, new_code
from maestra.web.access.throttle import Limit, Throttle

LOOPBACK_HOSTS: Final = frozenset({"localhost", "127.0.0.1", "[::1]"})
"""Names by which a browser on the same computer asks for the server."""


@dataclass(frozen=True, slots=True)
class Limits:
    """How often what may be tried. Failures count, what succeeds is given back."""

    account: Limit = field(default=Limit(10, 90_000))
    """Log-ins of one name: nobody mistypes ten times, and guessing 960 a day finds nothing."""
    address: Limit = field(default=Limit(30, 30_000))
    """Log-ins from one address: a ward behind one router."""
    requests: Limit = field(default=Limit(3_000, 20))
    """What changes something, of one address or account: fifty a second, and a rush of 3,000."""
    noted: Limit = field(default=Limit(1, 60_000))
    """The same denial in the audit: once a minute, so that nobody can flood it."""


@dataclass
class Doors:
    """The state of the entrance; one for each server."""

    passwords: Passwords = field(default_factory=Passwords)
    limits: Limits = field(default_factory=Limits)
    throttle: Throttle = field(default_factory=Throttle)
    hosts: frozenset[str] | None = None
    """By which names the server may be asked for; None: any."""
    setting_up: threading.Lock = field(default_factory=threading.Lock)
    """Held while the code is being used, so that it is used once."""
    _set_up_code: str | None = None

    def open_set_up(self) -> str:
        """Let whoever has the code that is returned make an administrator, once."""
        self._set_up_code = new_code()
        return self._set_up_code

    @property
    def is_set_up_open(self) -> bool:
        """Whether a set-up code is waiting to be used."""
        return self._set_up_code is not None

    def is_set_up_code(self, typed: str) -> bool:
        """Whether this is the code."""
        code = self._set_up_code
        return code is not None and are_same(as_typed(typed), code)

    def close_set_up(self) -> None:
        """The code has been used."""
        self._set_up_code = None
