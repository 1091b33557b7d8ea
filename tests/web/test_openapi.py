"""Requests invented from the OpenAPI document: nothing fails, nothing is undocumented."""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, Final, Protocol

import pytest
from fastapi import FastAPI
from fastapi.routing import APIRoute
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis.generation import GenerationMode

from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.settings import Settings
from maestra.storage.opening import open_store, place
from maestra.web.access.guard import visitor_of
from maestra.web.access.visitor import Role, Visitor
from maestra.web.application import ROUTERS, create_app
from maestra.web.context import Context
from maestra.web.library.collection import exercise_id
from maestra.web.library.included import first_start
from maestra.web.rooms.guests import as_guest, guest_of
from tests.web.people import add_account, quick_doors

EXAMPLES: Final = int(os.environ.get("MAESTRA_REQUESTS", "10"))
"""Of each kind for each operation; `make requests` invents more."""
# Schemathesis is typed in part only, which the strict checker takes for a fault of ours.
schemathesis: Any = import_module("schemathesis")
programs: Any = import_module("schemathesis.python.asgi")
conformance: Any = import_module("schemathesis.specs.openapi.checks")
CHECKS: Final[list[Any]] = [
    schemathesis.checks.not_a_server_error,
    conformance.status_code_conformance,
    conformance.content_type_conformance,
    conformance.response_headers_conformance,
    conformance.response_schema_conformance,
]
SLOW: Final = [HealthCheck.too_slow, HealthCheck.filter_too_much, HealthCheck.data_too_large]
OPERATIONS: Final = sorted(
    (route.path, method)
    for router in ROUTERS
    for route in router.routes
    if isinstance(route, APIRoute) and route.include_in_schema
    for method in route.methods or ()
)
REAL: Final = {
    "exercise": exercise_id("Spell CURIE"),
    "pseudonym": "heron",
    "name": "1",
    "form": "bids",
}
"""What gaps of paths are filled with to meet something that is there."""


class Invented(Protocol):
    """A request that was invented."""

    def call_and_validate(self, *, session: object, checks: list[Any]) -> object:
        """Send it; what the document does not say of the answer is a failure."""
        ...


@dataclass(frozen=True, slots=True)
class Asked:
    """An app's document, and a program that asks the app."""

    document: Any
    client: Any

    def requests(self, path: str, method: str) -> st.SearchStrategy[Invented]:
        """As documented, about what is there, and wrong ones."""
        operation = self.document[path][method]
        gaps = {one.name for one in operation.path_parameters}
        real = {name: value for name, value in REAL.items() if name in gaps}
        wrong = operation.as_strategy(generation_mode=GenerationMode.NEGATIVE)
        there = operation.as_strategy(path_parameters=real) if real else wrong
        return st.one_of(operation.as_strategy(), there, wrong)


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Asked]:
    """An administrator's program, over a record with something in it."""
    folder: Path = tmp_path_factory.mktemp("openapi")
    store = open_store(place(str(folder / "data"), str(folder / "keys")))
    first_start(store, "2026-05-04T12:00:00+00:00")
    store.save_settings(PatientId("heron"), write_remembered(Remembered(Settings())))
    context = Context(store, folder / "cache", doors=quick_doors())
    app = create_app(context)
    _let_in(app, context, add_account(context, "Alba", Role.ADMINISTRATOR))
    with programs.get_client(app) as client:
        yield Asked(schemathesis.openapi.from_asgi("/api/openapi.json", app), client)
    store.close()


def _let_in(app: FastAPI, context: Context, visitor: Visitor) -> None:
    app.dependency_overrides[visitor_of] = lambda: visitor
    app.dependency_overrides[guest_of] = lambda: as_guest(context, visitor)


@pytest.mark.parametrize(("path", "method"), OPERATIONS)
def test_no_request_fails_and_every_answer_is_documented(
    asked: Asked, path: str, method: str
) -> None:
    @given(request=asked.requests(path, method))
    @settings(max_examples=EXAMPLES, suppress_health_check=SLOW)
    def holds(request: Invented) -> None:
        request.call_and_validate(session=asked.client, checks=CHECKS)

    holds()
