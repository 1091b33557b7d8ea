"""Passwords, codes and tokens: how they are made, and what is kept of them."""

from __future__ import annotations

import hashlib
import hmac
import secrets
import threading
import unicodedata
from functools import cached_property
from typing import Final

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

MEMORY_KIB: Final = 19 * 1024
PASSES: Final = 2
"""With one lane, the first of OWASP's recommendations for Argon2id (Password Storage Cheat
Sheet, 2024); the larger ones of RFC 9106 would not leave a small computer enough for the rest."""
AT_ONCE: Final = 2
"""Hashes made at the same time, so that a flood of log-ins cannot fill the memory."""
LEAST_LETTERS: Final = 10
MOST_LETTERS: Final = 200
"""Of a password: long ones are welcome, and endless ones would keep the computer busy."""
LEAST_DIFFERENT: Final = 5
"""Different letters in a password: "aaaaaaaaaa" is none."""
CODE_LETTERS: Final = "ABCDEFGHJKMNPQRSTUVWXYZ23456789"
"""For codes that are typed from a screen or paper: no 0 and O, no 1, I and L."""
CODE_GROUPS: Final = 4
"""Of four letters each: 79 bits."""
TOKEN_BYTES: Final = 32


class Passwords:
    """Makes and checks Argon2id hashes."""

    def __init__(self, memory_kib: int = MEMORY_KIB, passes: int = PASSES) -> None:
        """Use this much memory and time for each hash."""
        self._hasher = PasswordHasher(time_cost=passes, memory_cost=memory_kib, parallelism=1)
        self._room = threading.BoundedSemaphore(AT_ONCE)

    def hashed(self, password: str) -> str:
        """What is kept of a password."""
        with self._room:
            return self._hasher.hash(_plain(password))

    def matches(self, kept: str | None, password: str) -> bool:
        """Whether this is the password; takes as long where there is none to compare with."""
        known = self.nobodys if kept is None else kept
        with self._room:
            try:
                self._hasher.verify(known, _plain(password))
            except (VerificationError, InvalidHashError):
                return False
        return kept is not None

    def is_outdated(self, kept: str) -> bool:
        """Whether it was made with other parameters than are used now."""
        return self._hasher.check_needs_rehash(kept)

    @cached_property
    def nobodys(self) -> str:
        """What is compared with where there is no such account, at the same cost."""
        return self.hashed(new_token())


def is_weak(password: str, name: str) -> bool:
    """Whether a password would be found soon: short, of few letters, or the name in it."""
    plain = _plain(password)
    return (
        not LEAST_LETTERS <= len(plain) <= MOST_LETTERS
        or len(set(plain)) < LEAST_DIFFERENT
        or (len(name) > 2 and name.casefold() in plain.casefold())  # noqa: PLR2004 - "Jo" may be
    )


def new_token() -> str:
    """What a browser or a program shows to be known again: 256 random bits."""
    return secrets.token_urlsafe(TOKEN_BYTES)


def new_code() -> str:
    """What somebody types once: four groups of four letters."""
    letters = [secrets.choice(CODE_LETTERS) for _ in range(4 * CODE_GROUPS)]
    return "-".join("".join(letters[k : k + 4]) for k in range(0, len(letters), 4))


def as_typed(code: str) -> str:
    """A code however it was typed: small letters, without strokes, with spaces."""
    letters = "".join(one for one in code.upper() if one.isalnum())[: 4 * CODE_GROUPS]
    return "-".join(letters[k : k + 4] for k in range(0, len(letters), 4))


def digest(token: str) -> str:
    """What is kept of a token; it is random enough that nobody finds it from this."""
    return hashlib.sha256(token.encode()).hexdigest()


def are_same(one: str, other: str) -> bool:
    """Whether two secrets are the same, without telling by the time how far they are."""
    return hmac.compare_digest(one.encode(), other.encode())


def _plain(password: str) -> str:
    """The same letters however a keyboard composes them."""
    return unicodedata.normalize("NFKC", password)
