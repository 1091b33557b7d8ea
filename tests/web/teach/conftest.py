"""Tokens are dealt alike in each test: what Maestra asks depends on where they lie."""

import secrets
from types import SimpleNamespace

import pytest

from maestra.web.teach import desk


@pytest.fixture(autouse=True)
def dealt_alike(monkeypatch: pytest.MonkeyPatch) -> None:
    def fourth(_: int) -> int:
        return 4

    seeds = SimpleNamespace(token_hex=secrets.token_hex, randbelow=fourth)
    monkeypatch.setattr(desk, "secrets", seeds)
