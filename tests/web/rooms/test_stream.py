"""The stream: the state at once, each change after it, and an answer to whatever is told."""

import json
from collections.abc import Callable
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.testclient import WebSocketTestSession
from starlette.websockets import WebSocketDisconnect

from maestra.coaching.events import Begun, EndOrdered, HelpAsked
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.rooms import stream as streams
from maestra.web.rooms.guests import Guest, Part, guest_of
from maestra.web.rooms.messages import MOST_CHARACTERS
from maestra.web.rooms.rooms import Rooms
from maestra.web.rooms.stage import RoomName
from tests.web.rooms.exercises import HERON, PLOVER, placed, right_move, told, wrong_move

Login = Callable[[Role], TestClient]
STREAM = "/api/rooms/1/stream"


@pytest.fixture
def guest(app: FastAPI) -> Callable[[Part], TestClient]:
    """A program or a screen of one part: boards and robots of room 1, screens of heron."""

    def come(part: Part) -> TestClient:
        in_room = part in {Part.BOARD, Part.ROBOT}
        room = RoomName("1") if in_room else None
        whose = HERON if part is Part.SCREEN else None
        one = Guest(part, lambda patient: patient == HERON, room, whose)
        app.dependency_overrides[guest_of] = lambda: one
        return TestClient(app, base_url="http://localhost")

    return come


Guests = Callable[[Part], TestClient]


def answered(socket: WebSocketTestSession, message: str) -> dict[str, Any]:
    """What comes back to `message`, states left out."""
    socket.send_text(message)
    while True:
        answer: dict[str, Any] = socket.receive_json()
        if answer["type"] != "state":
            return answer


def test_whoever_comes_gets_the_whole_state_at_once(rooms: Rooms, guest: Guests) -> None:
    rooms.begin(HERON, "ascending").tell(Begun())
    with guest(Part.CAREGIVER).websocket_connect(STREAM) as socket:
        state = socket.receive_json()
    assert state == rooms.place(RoomName("1")).state.as_json(for_caregiver=True)
    assert state["type"] == "state"
    assert len(state["tokens"]) == len(state["cells"]) == 10


def test_what_is_told_is_acknowledged_and_told_to_everybody(rooms: Rooms, guest: Guests) -> None:
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    move = right_move(room)
    client = guest(Part.SCREEN)
    with client.websocket_connect(STREAM) as one, client.websocket_connect(STREAM) as two:
        first = one.receive_json(), two.receive_json()
        assert first[0] == first[1]
        ack = answered(one, json.dumps({"id": "a1", "event": placed(move)}))
        assert ack == {"type": "ack", "id": "a1"}
        change = two.receive_json()
    assert change["sequence"] == first[0]["sequence"] + 1
    assert change["cells"][move.token] == [move.destination.row, move.destination.column]
    assert change["event"] == placed(move)
    assert {one["command"] for one in change["commands"]} >= {"say", "express"}


def test_what_is_told_again_under_its_id_happens_once(rooms: Rooms, guest: Guests) -> None:
    room = rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        for _ in range(3):
            assert answered(socket, told("a", "begun"))["type"] == "ack"
    assert room.state.sequence == 1


def test_what_the_caregiver_is_asked_reaches_no_patient(rooms: Rooms, guest: Guests) -> None:
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    seen: dict[Part, dict[str, Any]] = {}
    for part in (Part.SCREEN, Part.CAREGIVER):
        with guest(part).websocket_connect(STREAM) as socket:
            socket.receive_json()
            answered(socket, told(part.value, "board-back", cells={"who": [9, 9]}))
            socket.send_text(told(f"{part.value} again", "board-lost"))
            # The state may come before the acknowledgement or after it.
            heard: dict[str, dict[str, Any]] = {}
            while not {"ack", "state"} <= heard.keys():
                message = socket.receive_json()
                heard[message["type"]] = message
            seen[part] = heard["state"]
        with guest(part).websocket_connect(STREAM) as socket:
            seen[part] = socket.receive_json()
    assert seen[Part.SCREEN]["question"] is None
    assert seen[Part.CAREGIVER]["question"]["matter"] == "check-board"


def test_commands_for_the_caregiver_and_notes_stay_with_the_caregiver(
    rooms: Rooms, guest: Guests
) -> None:
    room = rooms.begin(HERON, "ascending")
    kinds: dict[Part, set[str]] = {}
    for part, event in ((Part.SCREEN, Begun()), (Part.CAREGIVER, HelpAsked())):
        with guest(part).websocket_connect(STREAM) as socket:
            socket.receive_json()
            room.tell(event)
            kinds[part] = {one["command"] for one in socket.receive_json()["commands"]}
    assert "record" in kinds[Part.CAREGIVER]
    assert "record" not in kinds[Part.SCREEN]


@pytest.mark.parametrize(
    ("message", "where"),
    [
        ("nonsense", ""),
        ("[]", ""),
        ("{}", "id"),
        (json.dumps({"id": "a", "event": {"event": "begun", "more": 1}}), "event.begun.more"),
        (json.dumps({"id": "a", "event": {"event": "dance"}}), "event"),
        (json.dumps({"id": "", "event": {"event": "begun"}}), "id"),
        (json.dumps({"id": "x" * 65, "event": {"event": "begun"}}), "id"),
        (" " * (MOST_CHARACTERS + 1), ""),
        ('{"id": "\\ud800", "event": {"event": "begun"}}', ""),
    ],
)
def test_what_means_nothing_is_a_fault_and_nothing_happens(
    rooms: Rooms, guest: Guests, message: str, where: str
) -> None:
    room = rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        answer = answered(socket, message)
        assert answer["type"] == "fault"
        assert any(fault["where"] == where for fault in answer["faults"]), answer
    assert room.state.sequence == 0


@pytest.mark.parametrize(
    ("part", "event"),
    [
        (Part.BOARD, "begun"),
        (Part.BOARD, "help-asked"),
        (Part.ROBOT, "board-lost"),
        (Part.SCREEN, "end-ordered"),
        (Part.SCREEN, "paused"),
        (Part.CAREGIVER, "time-passed"),
    ],
)
def test_nobody_tells_what_is_not_theirs(
    rooms: Rooms, guest: Guests, part: Part, event: str
) -> None:
    room = rooms.begin(HERON, "ascending")
    with guest(part).websocket_connect(STREAM) as socket:
        answer = answered(socket, told("a", event))
        assert answer["type"] == "fault"
        assert answer["id"] == "a"
    assert room.state.sequence == 0


def test_a_board_waits_in_an_empty_room_and_sees_what_begins(rooms: Rooms, guest: Guests) -> None:
    with guest(Part.BOARD).websocket_connect(STREAM) as socket:
        assert socket.receive_json()["phase"] == "empty"
        assert answered(socket, told("a", "board-lost"))["faults"][0]["where"] == "room"
        rooms.begin(PLOVER, "ascending")
        assert socket.receive_json()["phase"] == "ready"


def test_a_board_has_no_business_in_another_room(rooms: Rooms, guest: Guests) -> None:
    rooms.begin(HERON, "ascending", room=RoomName("2"))
    with (
        pytest.raises(WebSocketDisconnect),
        guest(Part.BOARD).websocket_connect("/api/rooms/2/stream"),
    ):
        pass


@pytest.mark.parametrize("room", ["1", "no"])
def test_rooms_of_others_and_rooms_that_are_none_look_alike(
    rooms: Rooms, guest: Guests, room: str
) -> None:
    rooms.begin(PLOVER, "ascending")
    with (
        pytest.raises(WebSocketDisconnect),
        guest(Part.SCREEN).websocket_connect(f"/api/rooms/{room}/stream"),
    ):
        pass


def test_who_follows_one_patient_does_not_see_the_next(rooms: Rooms, guest: Guests) -> None:
    room = rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        socket.receive_json()
        room.tell(EndOrdered())
        assert socket.receive_json()["phase"] == "ended"
        rooms.begin(PLOVER, "ascending")
        with pytest.raises(WebSocketDisconnect) as left:
            socket.receive_json()
    assert left.value.code == streams.OVER


def test_who_is_logged_out_follows_no_longer(
    app: FastAPI, rooms: Rooms, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(streams, "CHECKED_S", 0.0)
    room = rooms.begin(HERON, "ascending")
    one = Guest(Part.CAREGIVER, lambda _: True, is_still_welcome=lambda: False)
    app.dependency_overrides[guest_of] = lambda: one
    with TestClient(app, base_url="http://localhost").websocket_connect(STREAM) as socket:
        socket.receive_json()
        room.tell(Begun())
        with pytest.raises(WebSocketDisconnect) as left:
            socket.receive_json()
    assert left.value.code == streams.OVER


def test_silence_is_filled_with_pings(
    rooms: Rooms, guest: Guests, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(streams, "PING_S", 0.01)
    rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        socket.receive_json()
        assert socket.receive_json() == {"type": "ping"}


def test_bytes_close_the_stream(rooms: Rooms, guest: Guests) -> None:
    rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        socket.receive_json()
        socket.send_bytes(b"\x00")
        with pytest.raises(WebSocketDisconnect) as left:
            socket.receive_json()
    assert left.value.code == streams.NO_TEXT


def test_a_page_of_another_site_opens_no_stream(rooms: Rooms, guest: Guests) -> None:
    rooms.begin(HERON, "ascending")
    client = guest(Part.CAREGIVER)
    for origin, is_ours in (("http://elsewhere.example", False), ("http://testserver", True)):
        headers = {"origin": origin}
        if is_ours:
            with client.websocket_connect(STREAM, headers=headers) as socket:
                socket.receive_json()
        else:
            with (
                pytest.raises(WebSocketDisconnect),
                client.websocket_connect(STREAM, headers=headers),
            ):
                pass


def test_what_cannot_be_kept_now_can_be_told_again(
    rooms: Rooms, guest: Guests, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError("disk full")

    room = rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        socket.receive_json()
        with monkeypatch.context() as patched:
            patched.setattr(type(context.store.events), "append", full)
            answer = answered(socket, told("a", "begun"))
            assert (answer["type"], answer["again"]) == ("fault", True)
        assert room.state.sequence == 0
        assert answered(socket, told("a", "begun"))["type"] == "ack"
    assert room.state.sequence == 1


def test_a_session_that_runs_wild_is_stopped(
    rooms: Rooms, guest: Guests, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("maestra.web.rooms.room.MOST_EVENTS", 2)
    rooms.begin(HERON, "ascending")
    with guest(Part.SCREEN).websocket_connect(STREAM) as socket:
        answers = [answered(socket, told(str(k), "help-asked"))["type"] for k in range(3)]
    assert answers == ["ack", "ack", "fault"]


def test_nobody_comes_in_without_being_known(rooms: Rooms, app: FastAPI) -> None:
    rooms.begin(HERON, "ascending")
    client = TestClient(app, base_url="http://localhost")
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(STREAM):
        pass
    assert client.get("/api/rooms/1").status_code == 401


# ---------------------------------------------------------------- without a stream


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.ADMINISTRATOR)


def test_a_session_is_begun_played_and_ended_without_a_stream(
    rooms: Rooms, caregiver: TestClient
) -> None:
    begun = caregiver.post("/api/rooms", json={"patient": "heron", "exercise": "ascending"})
    assert begun.status_code == 201
    assert begun.json()["phase"] == "ready"
    room = rooms.place(RoomName("1"))
    caregiver.post("/api/rooms/1/events", json={"id": "a", "event": {"event": "begun"}})
    move = wrong_move(room)
    state = caregiver.post("/api/rooms/1/events", json={"id": "b", "event": placed(move)}).json()
    assert state["cells"][move.token] == [move.destination.row, move.destination.column]
    assert caregiver.get("/api/rooms/1").json() == state
    assert caregiver.get("/api/rooms").json() == [state]
    for _ in range(2):
        assert caregiver.post("/api/rooms/1/end").json()["phase"] == "ended"
    late = caregiver.post("/api/rooms/1/events", json={"id": "c", "event": {"event": "paused"}})
    assert late.json()["phase"] == "ended"


@pytest.mark.parametrize(
    ("beginning", "status"),
    [
        ({"patient": "nobody", "exercise": "ascending"}, 404),
        ({"patient": "heron", "exercise": "none"}, 404),
        ({"patient": "heron", "exercise": "ascending", "version": 7}, 404),
        ({"patient": "heron", "exercise": "ascending", "room": "no such!"}, 422),
        ({"patient": "heron"}, 422),
        ({"patient": "plover", "exercise": "ascending", "room": "1"}, 409),
    ],
)
def test_what_cannot_begin_is_refused(
    rooms: Rooms, caregiver: TestClient, beginning: dict[str, object], status: int
) -> None:
    rooms.begin(HERON, "ascending")
    answer = caregiver.post("/api/rooms", json=beginning)
    assert answer.status_code == status
    assert answer.json()["status"] == status


def test_nothing_can_happen_in_an_empty_room(
    rooms: Rooms, guest: Guests, caregiver: TestClient
) -> None:
    rooms.place(RoomName("1"))
    paused = {"id": "c", "event": {"event": "paused"}}
    assert caregiver.post("/api/rooms/1/events", json=paused).status_code == 422
    assert caregiver.post("/api/rooms/1/end").json()["phase"] == "empty"
    board = guest(Part.BOARD)
    assert board.post("/api/rooms/1/end").status_code == 403


def test_a_researcher_has_no_business_in_rooms(rooms: Rooms, somebody: Login) -> None:
    rooms.begin(HERON, "ascending")
    assert somebody(Role.RESEARCHER).get("/api/rooms/1").status_code == 403


def test_caregivers_see_the_rooms_of_their_own_patients(
    rooms: Rooms, context: Context, somebody: Login
) -> None:
    rooms.begin(HERON, "ascending")
    rooms.begin(PLOVER, "ascending")
    browser = somebody(Role.CAREGIVER)
    context.store.custody.entrust(PLOVER, Role.CAREGIVER.value)
    assert [one["room"] for one in browser.get("/api/rooms").json()] == ["2"]
    assert browser.get("/api/rooms/1").status_code == 404
    assert browser.get("/api/rooms/2").status_code == 200
