"""Where drafts lie: whose they are, one change at a time, each kept before it is answered."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from threading import Lock
from typing import Final
from weakref import WeakValueDictionary

from fastapi import HTTPException

from maestra.storage.drafts import DraftId, Drafts, StoredDraft
from maestra.web.access.ownership import own_draft
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context
from maestra.web.teach.actions import Action, CannotError, Why, act
from maestra.web.teach.draft import Draft
from maestra.web.teach.draft_format import decode_draft, encode_draft

MAX_DRAFTS: Final = 100
"""Of one account: more than anybody finds again; what is done is saved in the library."""
MAX_SEED: Final = 2**31
READ_BACK: Final = 64
"""Drafts whose text was read last."""


class StaleError(Exception):
    """A form of a page that is older than the draft: what it answered is no longer asked."""


@dataclass(frozen=True, slots=True)
class Kept:
    """A draft as it is kept."""

    id: DraftId
    version: int
    """Each change makes the next one."""
    changed_utc: str
    draft: Draft


Work = Callable[[Draft], Action]
"""What is to be done with a draft, worked out from it as it is then."""


class Desk:
    """Somebody's drafts."""

    def __init__(self, context: Context, visitor: Visitor) -> None:
        """The drafts of `visitor` in the store of `context`."""
        self._drafts = Drafts(context.store)
        self._clock = context.clock
        self._visitor = visitor

    def all(self) -> tuple[Kept, ...]:
        """Theirs, the one that was changed last first."""
        return tuple(map(_read, self._drafts.of(self._visitor.account)))

    def add(self, draft: Draft) -> Kept:
        """Keep a new draft.

        Raises:
            CannotError: there are `MAX_DRAFTS` already.
        """
        if len(self._drafts.of(self._visitor.account)) >= MAX_DRAFTS:
            raise CannotError(Why.TOO_MANY_DRAFTS)
        new = DraftId(secrets.token_hex(16))
        return self._keep(self._drafts.add, new, 1, draft)

    def find(self, draft: str) -> Kept:
        """A draft of theirs.

        Raises:
            HTTPException: 404, there is none, or it is somebody else's.
        """
        try:
            stored = self._drafts.draft(DraftId(draft))
        except KeyError:
            raise HTTPException(404, "no such draft") from None
        own_draft(self._visitor, stored.account)
        return _read(stored)

    def change(self, draft: str, work: Work, at: str | None = None) -> Kept:
        """Do something with a draft of theirs; it is kept when this returns.

        Args:
            draft: its id.
            work: says what, from the draft as it is; nobody else changes it meanwhile.
            at: the draft's mark that whoever asks has seen; None: whatever it is by now.

        Raises:
            HTTPException: 404, as `find`.
            StaleError: something was taught or moved since.
            CannotError: it cannot be done.
        """
        with _turn(DraftId(draft)):
            now = self.find(draft)
            if at is not None and at != now.draft.mark:
                raise StaleError
            after = act(now.draft, work(now.draft))
            if after == now.draft:
                return now
            return self._keep(self._drafts.change, now.id, now.version + 1, after)

    def delete(self, draft: str) -> None:
        """Forget a draft of theirs.

        Raises:
            HTTPException: 404, as `find`.
        """
        with _turn(DraftId(draft)):
            self._drafts.delete(self.find(draft).id)

    def _keep(
        self, keep: Callable[[StoredDraft], None], name: DraftId, version: int, draft: Draft
    ) -> Kept:
        utc = self._clock.utc().isoformat()
        keep(StoredDraft(name, self._visitor.account, version, utc, encode_draft(draft)))
        return Kept(name, version, utc, draft)


def new_seed() -> int:
    """How tokens are dealt, and which plays an exam has: no two alike."""
    return secrets.randbelow(MAX_SEED)


class _Turn:
    """Whoever holds its lock changes the draft."""

    def __init__(self) -> None:
        self.lock: Final = Lock()


_TURNS: Final[WeakValueDictionary[DraftId, _Turn]] = WeakValueDictionary()
_DOOR: Final = Lock()


@contextmanager
def _turn(draft: DraftId) -> Generator[None]:
    """One change of a draft at a time; forgotten when nobody waits for it any more."""
    with _DOOR:
        turn = _TURNS.setdefault(draft, _Turn())
    with turn.lock:
        yield


def _read(stored: StoredDraft) -> Kept:
    return Kept(stored.draft, stored.version, stored.changed_utc, _decoded(stored.content))


@lru_cache(maxsize=READ_BACK)
def _decoded(content: str) -> Draft:
    return decode_draft(content)
