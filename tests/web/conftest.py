"""The web app over a record of its own, asked without a browser."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from maestra.coaching.fields import Milliseconds
from maestra.language import Language
from maestra.storage.opening import open_store, place
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.application import create_app
from maestra.web.context import Context
from maestra.web.rooms.guests import as_guest, guest_of

NOON = datetime(2026, 5, 4, 12, tzinfo=UTC)


@dataclass
class StillClock:
    """A clock that a test moves."""

    now: Milliseconds = field(default=Milliseconds(0))

    def monotonic(self) -> Milliseconds:
        """As it was set."""
        return self.now

    def utc(self) -> datetime:
        """Noon and as much later."""
        return NOON + timedelta(milliseconds=self.now)


@pytest.fixture
def clock() -> StillClock:
    return StillClock()


@pytest.fixture
def context(tmp_path: Path, clock: StillClock) -> Iterator[Context]:
    store = open_store(place(str(tmp_path / "data"), str(tmp_path / "keys")))
    yield Context(store, tmp_path / "cache", clock)
    store.close()


@pytest.fixture
def app(context: Context) -> FastAPI:
    return create_app(context)


@pytest.fixture
def somebody(app: FastAPI, context: Context) -> Callable[[Role], TestClient]:
    """A browser of somebody who is logged in and has a role."""

    def logged_in(role: Role) -> TestClient:
        visitor = Visitor(AccountId(role.value), role.value.title(), role, Language.EN)
        app.dependency_overrides[visitor_of] = lambda: visitor
        app.dependency_overrides[guest_of] = lambda: as_guest(context, visitor)
        return TestClient(app, base_url="http://localhost")

    return logged_in
