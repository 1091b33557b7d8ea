"""Boards, robots and patients' screens: made, connected, revoked; and whose patients are whose."""

import re
from typing import Annotated

import pytest
from fastapi import Depends, FastAPI, HTTPException
from fastapi.testclient import TestClient
from httpx2 import Response

from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import PatientId
from maestra.core.faults import InvalidError
from maestra.web.access.audit import READ_AGAIN
from maestra.web.access.devices import (
    Device,
    OnScreen,
    Participant,
    device_of,
    participant_of,
)
from maestra.web.access.logins import SCREEN_MS
from maestra.web.access.ownership import (
    demand_patient,
    own_draft,
    own_patient,
    patients_of,
    sees_names,
)
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from tests.web.conftest import StillClock
from tests.web.people import Person, add_account, logged_in, new_browser, quick_doors

HERON, PLOVER = PatientId("heron"), PatientId("plover")


@pytest.fixture
def context(context: Context) -> Context:
    return Context(context.store, context.folder, context.clock, doors=quick_doors())


@pytest.fixture
def app(app: FastAPI) -> FastAPI:
    @app.get("/api/test/device")
    def device(device: Annotated[Device, Depends(device_of)]) -> str:
        return f"{device.kind.value} {device.label} {device.room}"

    @app.get("/api/test/screen")
    def screen(device: OnScreen) -> str:
        return f"{device.patient}"

    @app.get("/api/test/participant")
    def participant(one: Annotated[Participant, Depends(participant_of)]) -> str:
        return one.label if isinstance(one, Device) else one.name

    return app


@pytest.fixture
def chief(app: FastAPI, context: Context) -> Person:
    return logged_in(app, context, "Chief", Role.ADMINISTRATOR)


@pytest.fixture
def ada(app: FastAPI, context: Context) -> Person:
    ada = logged_in(app, context, "Ada")
    own_patient(context, ada.visitor, HERON)
    return ada


def code_in(answer: Response) -> str:
    assert answer.status_code == 200, answer.text
    found = re.search(r"<code>([A-Za-z0-9_-]+)</code>", answer.text)
    assert found is not None
    return found[1]


def bearer(token: str) -> dict[str, str]:
    return {"authorization": f"Bearer {token}"}


# ---------------------------------------------------------------- boards and robots


@pytest.mark.parametrize("kind", ["board", "robot"])
def test_a_program_is_known_by_its_token_until_it_is_revoked(
    app: FastAPI, context: Context, chief: Person, kind: str
) -> None:
    typed = {"kind": kind, "label": "the one", "room": "room1"}
    made = chief.browser.post("/devices/programs", data=typed)
    token = code_in(made)
    # What is shown only once would be lost in another language.
    assert "data-language" not in made.text
    assert token not in chief.browser.get("/devices").text
    program = TestClient(app, base_url="http://localhost")
    for path, expected in (
        ("device", f"{kind} the one room1"),
        ("participant", "the one"),
    ):
        assert program.get(f"/api/test/{path}", headers=bearer(token)).json() == expected
        assert program.get(f"/api/test/{path}", headers=bearer(token + "x")).status_code == 401
        assert program.get(f"/api/test/{path}", headers={"authorization": "x"}).status_code == 401
        assert program.get(f"/api/test/{path}").status_code == 401
    # It opens nothing that people open.
    assert program.get("/", headers=bearer(token), follow_redirects=False).status_code == 303
    assert program.get("/api/test/screen", headers=bearer(token)).status_code == 401
    (device,) = context.store.access.devices()
    assert token not in repr(device)
    chief.browser.post(f"/devices/{device.device}/remove")
    assert program.get("/api/test/device", headers=bearer(token)).status_code == 401


def test_only_administrators_make_programs(ada: Person, context: Context) -> None:
    typed = {"kind": "board", "label": "one", "room": "room1"}
    assert ada.browser.post("/devices/programs", data=typed).status_code == 403
    assert "A board or a robot" not in ada.browser.get("/devices").text
    assert context.store.access.devices() == ()


@pytest.mark.parametrize(
    "changed", [{"label": ""}, {"label": "x" * 61}, {"room": ""}, {"room": "no room!"}]
)
def test_a_program_that_cannot_be_is_not_made(
    context: Context, chief: Person, changed: dict[str, str]
) -> None:
    typed = {"kind": "board", "label": "one", "room": "room1"} | changed
    answer = chief.browser.post("/devices/programs", data=typed)
    assert answer.status_code == 422
    assert "Please write a" in answer.text
    assert context.store.access.devices() == ()


# ---------------------------------------------------------------- screens


def make_screen(person: Person, patient: str = HERON, pin: str = "4711") -> Response:
    typed = {"patient": patient, "label": "tablet", "pin": pin}
    return person.browser.post("/devices/screens", data=typed)


def test_a_screen_opens_one_patients_page_with_code_and_pin(
    app: FastAPI, context: Context, ada: Person
) -> None:
    code = code_in(make_screen(ada))
    tablet = new_browser(app)
    assert "Code of the screen" in tablet.get("/screen").text
    assert tablet.post("/screen", data={"code": code, "pin": "4712"}).status_code == 422
    assert tablet.post("/screen", data={"code": "AAAA-BBBB", "pin": "4711"}).status_code == 422
    assert tablet.post("/screen", data={"pin": "4711"}).status_code == 422
    opened = tablet.post("/screen", data={"code": code.lower().replace("-", ""), "pin": "4711"})
    assert opened.headers["location"] == "/patient"
    assert tablet.get("/api/test/screen").json() == HERON
    assert tablet.get("/api/test/participant").json() == "tablet"
    assert "Code of the screen" not in tablet.get("/screen").text
    # Pages of caregivers lead back to the PIN.
    assert tablet.get("/").headers["location"] == "/screen"
    # Its code alone is no token of a program.
    assert tablet.get("/api/test/device", headers=bearer(code)).status_code == 401
    lines = context.store.custody.audit()
    assert (lines[0].act, lines[0].account, lines[0].patient) == ("screen-opened", None, HERON)
    assert "4711" not in repr(context.store.access.devices())


def test_a_screen_asks_for_the_pin_again_each_day_and_when_it_was_closed(
    app: FastAPI, ada: Person, clock: StillClock
) -> None:
    code = code_in(make_screen(ada))
    tablet = new_browser(app)
    tablet.post("/screen", data={"code": code, "pin": "4711"})
    clock.now = Milliseconds(20 * 3_600_000)
    assert tablet.get("/api/test/screen").status_code == 200
    clock.now = Milliseconds(SCREEN_MS + 1000)
    assert tablet.get("/api/test/screen").status_code == 401
    assert tablet.post("/screen", data={"pin": "4711"}).headers["location"] == "/patient"
    assert "Close the patient" in tablet.get("/screen").text
    assert tablet.post("/screen/close").headers["location"] == "/screen"
    assert tablet.get("/api/test/screen").status_code == 401


def test_opening_a_screen_logs_the_caregiver_out_of_it(ada: Person) -> None:
    code = code_in(make_screen(ada))
    assert ada.browser.post("/screen", data={"code": code, "pin": "4711"}).status_code == 303
    assert ada.browser.get("/account").headers["location"] == "/screen"


def test_a_revoked_screen_is_closed_at_once(app: FastAPI, context: Context, ada: Person) -> None:
    code = code_in(make_screen(ada))
    tablet = new_browser(app)
    tablet.post("/screen", data={"code": code, "pin": "4711"})
    (device,) = context.store.access.devices()
    assert ada.browser.post(f"/devices/{device.device}/remove").status_code == 303
    assert tablet.get("/api/test/screen").status_code == 401
    assert tablet.post("/screen", data={"pin": "4711"}).status_code == 422


def test_the_pin_lets_a_tablet_be_something_else_again(app: FastAPI, ada: Person) -> None:
    code = code_in(make_screen(ada))
    tablet = new_browser(app)
    tablet.post("/screen", data={"code": code, "pin": "4711"})
    assert tablet.post("/screen/leave", data={"pin": "1"}).status_code == 422
    assert tablet.get("/api/test/screen").status_code == 200
    assert tablet.post("/screen/leave", data={"pin": "4711"}).status_code == 303
    assert tablet.get("/").headers["location"] == "/login"
    assert "Code of the screen" in tablet.get("/screen").text


@pytest.mark.parametrize("path", ["/screen", "/screen/leave"])
def test_a_pin_cannot_be_guessed(app: FastAPI, ada: Person, path: str) -> None:
    code = code_in(make_screen(ada))
    tablet = new_browser(app)
    tablet.post("/screen", data={"code": code, "pin": "4711"})
    for _ in range(10):
        assert "Code or PIN is not right" in tablet.post(path, data={"pin": "1234"}).text
    assert "Too many tries" in tablet.post(path, data={"pin": "4711"}).text


@pytest.mark.parametrize(
    ("changed", "line"),
    [
        ({"pin": "123"}, "4 to 8 digits"),
        ({"pin": "123456789"}, "4 to 8 digits"),
        ({"pin": "١٢٣٤"}, "4 to 8 digits"),
        ({"pin": "abcd"}, "4 to 8 digits"),
        ({"label": " "}, "write a name"),
        ({"patient": PLOVER}, "one of your patients"),
        ({"patient": "nobody"}, "one of your patients"),
    ],
)
def test_a_screen_that_cannot_be_is_not_made(
    context: Context, ada: Person, changed: dict[str, str], line: str
) -> None:
    context.store.save_settings(PLOVER, "{}")
    typed = {"patient": HERON, "label": "tablet", "pin": "4711"} | changed
    answer = ada.browser.post("/devices/screens", data=typed)
    assert answer.status_code == 422
    assert line in answer.text
    assert context.store.access.devices() == ()


def test_caregivers_see_the_screens_of_their_patients_alone(
    app: FastAPI, context: Context, ada: Person, chief: Person
) -> None:
    make_screen(ada)
    chief.browser.post(
        "/devices/programs", data={"kind": "board", "label": "the board", "room": "room1"}
    )
    eva = logged_in(app, context, "Eva")
    assert "tablet" in ada.browser.get("/devices").text
    assert "the board" not in ada.browser.get("/devices").text
    assert "heron" not in eva.browser.get("/devices").text
    everything = chief.browser.get("/devices").text
    assert "the board" in everything
    assert "heron" in everything
    for device in context.store.access.devices():
        assert eva.browser.post(f"/devices/{device.device}/remove").status_code == 404
    assert ada.browser.post("/devices/nothing/remove").status_code == 404
    assert len(context.store.access.devices()) == 2


# ---------------------------------------------------------------- whose is what


def test_patients_are_their_caregivers_and_to_others_as_if_not_there(
    context: Context, ada: Person
) -> None:
    eva = add_account(context, "Eva")
    study = add_account(context, "Study", Role.RESEARCHER)
    chief = add_account(context, "Chief", Role.ADMINISTRATOR)
    for visitor in (ada.visitor, study, chief):
        assert demand_patient(context, visitor, "heron") == HERON
        assert patients_of(context, visitor) == (HERON,)
    refusals: list[tuple[int, str]] = []
    for visitor, pseudonym in ((ada.visitor, "nobody"), (eva, "nobody"), (eva, "heron")):
        with pytest.raises(HTTPException) as refused:
            demand_patient(context, visitor, pseudonym)
        refusals.append((refused.value.status_code, refused.value.detail))
    assert refusals == [(404, "no such patient")] * 3
    assert patients_of(context, eva) == ()
    assert [sees_names(one) for one in (ada.visitor, study, chief)] == [True, False, True]
    denied = [one for one in context.store.custody.audit() if one.act == "denied"]
    assert (eva.account, HERON) in {(one.account, one.patient) for one in denied}


def test_a_read_is_noted_once_in_five_minutes(
    context: Context, ada: Person, clock: StillClock
) -> None:
    for _ in range(3):
        demand_patient(context, ada.visitor, "heron")
    clock.now = Milliseconds(READ_AGAIN.each_ms)
    demand_patient(context, ada.visitor, "heron")
    reads = [one for one in context.store.custody.audit() if one.act == "read"]
    assert [(one.account, one.patient) for one in reads] == [(ada.visitor.account, HERON)] * 2


def test_a_pseudonym_is_taken_once(context: Context, ada: Person) -> None:
    eva = add_account(context, "Eva")
    assert own_patient(context, ada.visitor, "heron") == HERON
    with pytest.raises(InvalidError, match="taken"):
        own_patient(context, eva, "heron")
    with pytest.raises(InvalidError):
        own_patient(context, eva, "")


def test_drafts_are_private(context: Context, ada: Person) -> None:
    chief = add_account(context, "Chief", Role.ADMINISTRATOR)
    own_draft(ada.visitor, ada.visitor.account)
    with pytest.raises(HTTPException) as refused:
        own_draft(chief, ada.visitor.account)
    assert refused.value.status_code == 404
