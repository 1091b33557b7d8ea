"""A caregiver with a patient who is about to play."""

from collections.abc import Callable

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.settings import Settings
from maestra.language import Language
from maestra.rules.exercise_format import encode_exercise
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context
from maestra.web.rooms.guests import as_guest, guest_of
from maestra.web.rooms.rooms import Rooms
from tests.web.rooms.exercises import ASCENDING

HERON = PatientId("heron")
As = Callable[..., TestClient]


@pytest.fixture
def rooms(app: FastAPI) -> Rooms:
    found = app.state.rooms
    assert isinstance(found, Rooms)
    return found


@pytest.fixture
def browsing(app: FastAPI, context: Context) -> As:
    """A browser of an account; `heron` is ann's patient, and there is an exercise."""
    store = context.store
    store.save_exercise("ascending", encode_exercise(ASCENDING))
    store.custody.own(HERON, "ann")
    store.save_settings(HERON, write_remembered(Remembered(Settings())))

    def logged_in(account: str = "ann", role: Role = Role.CAREGIVER) -> TestClient:
        visitor = Visitor(AccountId(account), account.title(), role, Language.EN)
        app.dependency_overrides[visitor_of] = lambda: visitor
        app.dependency_overrides[guest_of] = lambda: as_guest(context, visitor)
        return TestClient(app, base_url="http://localhost")

    return logged_in


def begin(browser: TestClient, **more: str) -> str:
    """Begin a session; the address of its page."""
    form = {"patient": "heron", "exercise": "ascending", "board": "", **more}
    answer = browser.post("/sessions", data=form, follow_redirects=False)
    assert answer.status_code == 303
    return answer.headers["location"]
