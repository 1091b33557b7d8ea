"""Rooms over a record of their own."""

import pytest
from fastapi import FastAPI

from maestra.web.context import Context
from maestra.web.rooms.rooms import Rooms
from tests.web.rooms.exercises import prepare


@pytest.fixture
def rooms(app: FastAPI, context: Context) -> Rooms:
    """The application's, with an exercise and patients to play it."""
    prepare(context.store)
    found = app.state.rooms
    assert isinstance(found, Rooms)
    return found
