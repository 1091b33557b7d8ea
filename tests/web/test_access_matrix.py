"""Each route, each kind of visitor, each kind of owner: what is answered, with real log-ins."""

import re
import secrets
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any, Final, cast

import pytest
from fastapi.testclient import TestClient
from httpx2 import Response
from starlette.routing import Mount
from starlette.websockets import WebSocketDisconnect

from maestra.coaching.events import Begun, EndOrdered
from maestra.coaching.ports import PatientId
from maestra.rules.exercise_format import encode_exercise
from maestra.storage.drafts import DraftId, Drafts, StoredPicture
from maestra.storage.opening import open_store, place
from maestra.web.access.devices import DeviceKind, make_program, make_screen
from maestra.web.access.doors import Limits
from maestra.web.access.throttle import Limit
from maestra.web.access.visitor import Role, Visitor
from maestra.web.application import ROUTERS, create_app
from maestra.web.context import Context
from maestra.web.library.collection import exercise_id
from maestra.web.rooms.rooms import Rooms
from maestra.web.rooms.stage import RoomName
from tests.web.access_table import TABLE, Is, Line, Who
from tests.web.conftest import StillClock
from tests.web.people import add_account, log_in, new_browser, quick_doors
from tests.web.rooms.exercises import ASCENDING

# It comes to every route by log-ins of its own; counting lines would take most of its time.
pytestmark = pytest.mark.no_cover

TABLE_ROOM: Final = RoomName("table")
EXERCISE: Final = "ascending"
PIN: Final = "4711"
NAME: Final = "Montserrat Casademunt"
"""Of each patient; researchers and other caregivers must not meet it anywhere."""
PLENTY: Final = Limit(10**6, 1)
PEOPLE: Final = {
    Who.OWNER: Role.CAREGIVER,
    Who.OTHER: Role.CAREGIVER,
    Who.RESEARCHER: Role.RESEARCHER,
    Who.ADMINISTRATOR: Role.ADMINISTRATOR,
}
HERON, PLOVER = PatientId("heron"), PatientId("plover")


class House:
    """An app in which everybody has been let in who can be."""

    def __init__(self, context: Context) -> None:
        self.context = context
        self.app = create_app(context)
        self.visitors = {
            who: add_account(context, who.value, role) for who, role in PEOPLE.items()
        }
        context.store.save_exercise(EXERCISE, encode_exercise(ASCENDING))
        for patient, who in ((HERON, Who.OWNER), (PLOVER, Who.OTHER)):
            context.store.custody.own(patient, self.visitors[who].account)
        self._chief = self.visitors[Who.ADMINISTRATOR]
        self._tokens = {
            Who.BOARD: self._program(DeviceKind.BOARD, TABLE_ROOM),
            Who.ELSEWHERE: self._program(DeviceKind.ROBOT, "elsewhere"),
        }
        self._codes = {
            Who.SCREEN: make_screen(context, self._chief, "screen", HERON, PIN),
            Who.STRANGER: make_screen(context, self._chief, "stranger", PLOVER, PIN),
        }
        self._browsers: dict[Who, TestClient] = {}
        self._last_draft = DraftId("none yet")

    def _program(self, kind: DeviceKind, room: str) -> str:
        return make_program(self.context, self._chief, kind, kind.value, room)

    @property
    def owner(self) -> Visitor:
        return self.visitors[Who.OWNER]

    @property
    def rooms(self) -> Rooms:
        return cast("Rooms", self.app.state.rooms)

    def browser(self, who: Who) -> TestClient:
        """A browser, or a program, of this kind of visitor, let in as such are."""
        if who not in self._browsers:
            browser = new_browser(self.app)
            if who in PEOPLE:
                assert log_in(browser, who.value).headers["location"] == "/"
            elif who in self._codes:
                typed = {"code": self._codes[who], "pin": PIN}
                assert browser.post("/screen", data=typed).headers["location"] == "/patient"
            elif who in self._tokens:
                browser.headers["authorization"] = f"Bearer {self._tokens[who]}"
            self._browsers[who] = browser
        return self._browsers[who]

    def forget(self, who: Who) -> None:
        """Let them come in anew next time: what was asked may have sent them out."""
        self._browsers.pop(who, None)

    # ------------------------------------------------ what stands in gaps, new each time

    def gaps(self, path: str) -> dict[str, str]:
        makers: dict[str, Callable[[], str]] = {
            "account": lambda: add_account(self.context, secrets.token_hex(8)).account,
            "device": self._device,
            "digest": self._picture,
            "draft": self._draft,
            "exercise": self._exercise,
            "pseudonym": self._patient,
            "room": self._room,
        }
        found = {gap: makers[gap]() for gap in makers if f"{{{gap}}}" in path}
        if "{said}" in path:
            found["said"] = self._said()
        if "{session}" in path:
            found["session"] = self._session(PatientId(found["pseudonym"]))
        return found

    def _patient(self) -> str:
        patient = PatientId(f"patient-{secrets.token_hex(4)}")
        self.context.store.custody.own(patient, self.owner.account)
        self.context.store.save_name(patient, NAME)
        return patient

    def _device(self) -> str:
        patient = PatientId(self._patient())
        make_screen(self.context, self.owner, "one more", patient, PIN)
        devices = self.context.store.access.devices()
        return next(one.device for one in devices if one.patient == patient)

    def _draft(self) -> str:
        # One at a time: an account may only have so many.
        with suppress(KeyError):
            Drafts(self.context.store).delete(self._last_draft)
        answer = self.browser(Who.OWNER).post("/api/drafts", json={"ready": "numbers"})
        assert answer.status_code == 201, answer.text
        self._last_draft = DraftId(answer.json()["id"])
        return self._last_draft

    def _exercise(self) -> str:
        name = f"exercise {secrets.token_hex(4)}"
        self.context.store.save_exercise(name, encode_exercise(ASCENDING))
        return exercise_id(name)

    def _room(self) -> str:
        there = self.rooms.of(HERON)
        if there is None or not there.state.is_under_way:
            self.rooms.begin(HERON, EXERCISE, room=TABLE_ROOM)
        return TABLE_ROOM

    def _session(self, patient: PatientId) -> str:
        room = self.rooms.begin(patient, EXERCISE)
        room.tell(EndOrdered())
        assert room.stored is not None
        return room.stored.session

    def _said(self) -> str:
        """Something that the robot said in the room."""
        room = self.rooms.named(TABLE_ROOM)
        if room.state.said is None:
            room.tell(Begun())
        assert room.state.said is not None
        return str(room.state.said.number)

    def _picture(self) -> str:
        return Drafts(self.context.store).keep_picture(StoredPicture("image/png", b"a cup"))


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Iterator[House]:
    folder = tmp_path_factory.mktemp("house")
    store = open_store(place(str(folder / "data"), str(folder / "keys")))
    # So many are refused here that limits would come first.
    doors = quick_doors(Limits(PLENTY, PLENTY, PLENTY, PLENTY))
    yield House(Context(store, Path(folder / "cache"), StillClock(), doors=doors))
    store.close()


def answered(house: House, line: Line, who: Who) -> Is:
    """What a visitor meets."""
    text = f"{line.path} {line.form} {line.json}"
    gaps = house.gaps(text)

    def filled(value: Any) -> Any:  # noqa: ANN401 - a form's or JSON's part, whatever it is
        if isinstance(value, str):
            return re.sub(r"\{(\w+)\}", lambda found: gaps[found[1]], value)
        if isinstance(value, dict):
            fields = cast("dict[str, Any]", value)
            return {name: filled(one) for name, one in fields.items()}
        return value

    browser, path = house.browser(who), filled(line.path)
    if line.method == "WS":
        return joined(browser, path)
    answer = browser.request(
        line.method, path, data=filled(line.form), json=filled(line.json), files=line.files
    )
    if who in {Who.RESEARCHER, Who.OTHER}:
        assert NAME not in answer.text
    return met(answer)


def met(answer: Response) -> Is:
    assert answer.status_code < 500, answer.text
    location = answer.headers.get("location", "")
    is_led = answer.status_code == 303 and re.match(r"/login\?|/login$|/screen$", location)
    if is_led or answer.status_code == 401:
        return Is.LED
    return {403: Is.DENIED, 404: Is.MISSING}.get(answer.status_code, Is.IN)


def joined(browser: TestClient, path: str) -> Is:
    try:
        with browser.websocket_connect(f"ws://localhost{path}") as stream:
            assert stream.receive_json()["type"] == "state"
            return Is.IN
    except WebSocketDisconnect as refused:
        if "no such" in refused.reason or refused.code == 4404:
            return Is.MISSING
        return Is.DENIED if "may not" in refused.reason else Is.LED


def is_for_everybody(line: Line) -> bool:
    return set(line.row.values()) == {Is.IN}


@pytest.mark.parametrize("line", TABLE, ids=lambda line: line.name)
def test_each_visitor_meets_what_the_table_says(house: House, line: Line) -> None:
    found: dict[Who, Is] = {}
    for who in Who:
        found[who] = answered(house, line, who)
        if is_for_everybody(line) and found[who] is Is.LED:
            # The entrance leads to the entrance; that is what it is there for.
            found[who] = Is.IN
        if is_for_everybody(line):
            house.forget(who)
    assert {who: one for who, one in found.items() if one is not line.row[who]} == {}


def routes() -> set[tuple[str, str]]:
    """All that the app answers, with the names of gaps left out."""
    found: set[tuple[str, str]] = {("GET", "/api/openapi.json")}
    for router in ROUTERS:
        for route in router.routes:
            methods: set[str] = getattr(route, "methods", None) or {"WS"}
            found |= {(method, plain(getattr(route, "path"))) for method in methods}  # noqa: B009
    return found


def plain(path: str) -> str:
    return re.sub(r"\{\w+\}", "{}", path.split("?", maxsplit=1)[0])


def test_every_route_stands_in_the_table() -> None:
    declared = {(line.method, line.path.split("?")[0]) for line in TABLE}
    in_table = {(method, plain(path)) for method, path in declared}
    missing = {
        (method, path)
        for method, path in routes()
        if not any(
            method == one and re.fullmatch(re.sub(r"\\\{\\\}", "[^/]+", re.escape(path)), other)
            for one, other in in_table
        )
    }
    assert missing == set()
    assert len(declared) == len(TABLE)


def test_every_line_of_the_table_is_a_route() -> None:
    known = routes() | {("GET", "/static/maestra.css")}
    for line in TABLE:
        assert any(
            line.method == method
            and re.fullmatch(re.sub(r"\\\{\\\}", "[^/]+", re.escape(path)), plain(line.path))
            for method, path in known
        ), line.name


def test_nothing_is_mounted_but_what_is_static(house: House) -> None:
    mounted = [route.path for route in house.app.routes if isinstance(route, Mount)]
    assert mounted == ["/static"]
