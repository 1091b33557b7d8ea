"""A patient who has played."""

from collections.abc import Callable

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.settings import Mental, Profile, settings_for
from maestra.language import Language
from maestra.rules.exercise_format import encode_exercise
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context
from tests.web.rooms.exercises import ASCENDING

HERON = PatientId("heron")
As = Callable[..., TestClient]


@pytest.fixture
def browsing(app: FastAPI, context: Context) -> As:
    """A browser of an account; `heron` is ann's patient and may play an exercise."""
    store = context.store
    store.save_exercise("ascending", encode_exercise(ASCENDING))
    store.custody.own(HERON, "ann")
    settings = settings_for(Profile(Mental.MODERATE))
    store.save_settings(HERON, write_remembered(Remembered(settings)))
    store.save_name(HERON, "Rosa Vidal")

    def logged_in(
        account: str = "ann", role: Role = Role.CAREGIVER, language: Language = Language.EN
    ) -> TestClient:
        visitor = Visitor(AccountId(account), account.title(), role, language)
        app.dependency_overrides[visitor_of] = lambda: visitor
        browser = TestClient(app, base_url="http://localhost")
        browser.cookies.set("maestra-language", language.value)
        return browser

    return logged_in
