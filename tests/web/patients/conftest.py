"""Caregivers with patients, over a record with an exercise."""

from collections.abc import Callable

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from maestra.language import Language
from maestra.rules.exercise_format import encode_exercise
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context
from tests.web.rooms.exercises import ASCENDING

As = Callable[..., TestClient]


@pytest.fixture
def browsing(app: FastAPI, context: Context) -> As:
    """A browser of an account; there is an exercise to assign."""
    context.store.save_exercise("ascending", encode_exercise(ASCENDING))

    def logged_in(account: str = "ann", role: Role = Role.CAREGIVER) -> TestClient:
        visitor = Visitor(AccountId(account), account.title(), role, Language.EN)
        app.dependency_overrides[visitor_of] = lambda: visitor
        return TestClient(app, base_url="http://localhost")

    return logged_in


PROFILE = {"mental": "none", "physical": "none", "hand": "right", "reach": "whole-board"}


def make(browser: TestClient, pseudonym: str, **more: str) -> None:
    form = {"pseudonym": pseudonym, "language": "en", **PROFILE, **more}
    assert browser.post("/patients", data=form).status_code == 200
