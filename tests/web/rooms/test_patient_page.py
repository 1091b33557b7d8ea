"""The patient's page without script, in the patient's language, in rooms and on screens."""

import re
from collections.abc import Callable

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from maestra.coaching.events import Begun, EndOrdered, Paused, TokenLifted, TokenPlaced
from maestra.coaching.settings import Helper, Modality, Settings
from maestra.core.board import Cell
from maestra.language import Language
from maestra.web.access.devices import Device, DeviceId, DeviceKind, screen_of
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.paths import PATIENT_PAGE
from maestra.web.rooms.guests import Guest, Part, guest_of
from maestra.web.rooms.patient_page import SCREEN_STREAM
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from maestra.web.rooms.stage import RoomName
from tests.web.rooms.exercises import (
    HERON,
    PLOVER,
    keep_cups,
    prepare,
    right_move,
    wrong_move,
)

Login = Callable[[Role], TestClient]


@pytest.fixture
def caregiver(somebody: Login) -> TestClient:
    return somebody(Role.ADMINISTRATOR)


@pytest.fixture
def screen(app: FastAPI) -> TestClient:
    """Heron's screen."""
    device = Device(DeviceId("d"), DeviceKind.SCREEN, "tablet", None, HERON)
    guest = Guest(Part.SCREEN, lambda patient: patient == HERON, None, HERON)
    app.dependency_overrides[screen_of] = lambda: device
    app.dependency_overrides[guest_of] = lambda: guest
    return TestClient(app, base_url="http://localhost")


def begun(rooms: Rooms, context: Context, settings: Settings) -> Room:
    prepare(context.store, settings)
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    return room


def press(browser: TestClient, cell: Cell, path: str = "/rooms/1") -> str:
    return browser.post(path, data={"cell": f"{cell.row},{cell.column}"}).text


def held(room: Room) -> list[str]:
    return list(room.state.held)


def seen(page: str) -> set[str]:
    """The buttons that are not hidden."""
    buttons = re.findall(r"<button(?! class=\"cell)([^>]*)>([^<]*)</button>", page)
    return {text for attributes, text in buttons if " hidden" not in attributes}


def test_a_patient_plays_without_script_by_pressing_cells(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings())
    first = right_move(room)
    page = press(caregiver, first.origin)
    assert "in your hand" in page
    assert held(room) == [first.token]
    other = next(one for one in room.session.position.now.cells if one != first.token)
    press(caregiver, room.session.position.now.cells[other])
    assert held(room) == [other]
    press(caregiver, room.session.position.now.cells[other])
    assert held(room) == []
    press(caregiver, first.origin)
    press(caregiver, first.destination)
    assert room.state.moves == 1
    nowhere = caregiver.post("/rooms/1", data={"cell": "99,99"})
    assert nowhere.status_code == 200
    assert room.state.moves == 1


def test_what_the_robot_is_to_put_back_is_put_back_without_script(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings(robot_moves=True, put_back=Helper.ROBOT))
    move = wrong_move(room)
    caregiver.post(
        "/rooms/1",
        data={"token": move.token, "cell": f"{move.destination.row},{move.destination.column}"},
    )
    assert room.session.table.cells[move.token] == move.origin
    assert room.state.awaiting == ()


def test_the_page_offers_at_most_three_things_at_every_moment(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    prepare(context.store, Settings(show_score=True))
    room = rooms.begin(HERON, "ascending")
    assert seen(caregiver.get("/rooms/1").text) == {"Let us begin"}
    page = caregiver.post("/rooms/1", data={"wish": "begin"}).text
    voice = {"Say it again"} if rooms.can_speak else set[str]()
    assert seen(page) == {*voice, "Help me", "I have finished"}
    said = room.state.said
    caregiver.post("/rooms/1", data={"wish": "help"})
    assert room.state.said != said
    caregiver.post("/rooms/1", data={"wish": "done"})
    assert room.state.is_under_way
    room.tell(Paused())
    assert seen(caregiver.get("/rooms/1").text) == {*voice, "Go on playing"}
    assert "Help me" in seen(caregiver.post("/rooms/1", data={"wish": "go-on"}).text)
    room.tell(EndOrdered())
    page = caregiver.get("/rooms/1").text
    assert seen(page) == voice
    assert "Right moves:" in page


def test_a_sitting_has_as_many_rounds_as_were_set(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings(rounds=2))
    for number in (1, 2):
        assert "Once more" not in seen(caregiver.get("/rooms/1").text)
        while room.state.is_under_way:
            move = right_move(room)
            room.tell(TokenPlaced(move.token, move.destination))
        assert ("Once more" in seen(caregiver.get("/rooms/1").text)) is (number == 1)
        first = room.stored
        for _ in range(2):
            caregiver.post("/rooms/1", data={"wish": "again"})
        assert (room.stored == first) is (number == 2)
    assert len(context.store.sessions(HERON)) == 2


def test_tokens_show_the_pictures_of_their_exercise(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    picture = keep_cups(context.store)
    room = rooms.begin(HERON, "cups")
    room.tell(Begun())
    assert picture in caregiver.get("/rooms/1").text
    drawn = [one.picture for one in (room.state.tokens or {}).values() if one.picture]
    assert drawn == [picture] * 10


def test_the_page_is_in_the_patients_language_whoever_looks(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    begun(rooms, context, Settings(language=Language.CA))
    page = caregiver.get("/rooms/1", headers={"accept-language": "es"}).text
    assert '<html lang="ca">' in page
    assert "He acabat" in page
    assert "Right moves" not in page


def test_a_patient_who_is_not_spoken_to_reads(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings(modalities=(Modality.TEXT,)))
    page = caregiver.get("/rooms/1").text
    assert "Say it again" not in seen(page)
    assert room.state.said is not None
    assert room.state.said.text in page


def test_one_switch_is_offered_to_whom_it_is_set_for(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    begun(rooms, context, Settings(one_switch=True))
    assert "data-scan" in caregiver.get("/rooms/1").text


def test_an_empty_room_greets(rooms: Rooms, caregiver: TestClient) -> None:
    rooms.place(RoomName("1"))
    page = caregiver.get("/rooms/1")
    assert "Your exercise begins soon." in page.text
    assert caregiver.post("/rooms/1", data={"cell": "1,1"}).status_code == 200


@pytest.mark.parametrize("pressed", [{"wish": "dance"}, {"cell": "a1"}, {"cell": "1"}])
def test_what_no_button_sends_is_refused(
    rooms: Rooms, context: Context, caregiver: TestClient, pressed: dict[str, str]
) -> None:
    begun(rooms, context, Settings())
    assert caregiver.post("/rooms/1", data=pressed).status_code == 422


def test_a_token_whose_cell_was_taken_meanwhile_can_still_be_seen(
    rooms: Rooms, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings())
    one, two = list(room.session.position.now.cells.items())[:2]
    room.tell(TokenLifted(one[0]))
    room.tell(TokenPlaced(two[0], one[1]))
    cells = room.state.cells or {}
    assert len(set(cells.values())) == len(cells) == 10
    assert caregiver.get("/rooms/1").status_code == 200


# ---------------------------------------------------------------- a patient's screen


def test_a_screen_waits_in_the_patients_language_until_the_session_begins(
    rooms: Rooms, context: Context, screen: TestClient
) -> None:
    prepare(context.store, Settings(language=Language.ES))
    assert "Su ejercicio empieza enseguida." in screen.get(PATIENT_PAGE).text
    with screen.websocket_connect(SCREEN_STREAM) as socket:
        assert socket.receive_json()["phase"] == "empty"
        rooms.begin(PLOVER, "ascending")
        rooms.begin(HERON, "ascending")
        assert socket.receive()["code"] == 4404
    with screen.websocket_connect(SCREEN_STREAM) as socket:
        state = socket.receive_json()
        assert (state["phase"], state["room"]) == ("ready", "2")
    assert "Vamos a empezar" in screen.get(PATIENT_PAGE).text
    screen.post(PATIENT_PAGE, data={"wish": "begin"})
    assert rooms.place(RoomName("2")).state.phase == "playing"


def test_a_screen_of_nobody_known_greets_in_the_browsers_language(
    context: Context, screen: TestClient
) -> None:
    assert context.store.patients() == ()
    page = screen.get(PATIENT_PAGE, headers={"accept-language": "ca"})
    assert "El vostre exercici comença de seguida." in page.text
    assert screen.post(PATIENT_PAGE, data={"wish": "begin"}).status_code == 200


def test_a_screen_follows_the_patient_to_another_room(
    rooms: Rooms, context: Context, screen: TestClient
) -> None:
    room = begun(rooms, context, Settings())
    with screen.websocket_connect(SCREEN_STREAM) as socket:
        assert socket.receive_json()["room"] == "1"
        room.tell(EndOrdered())
        assert socket.receive_json()["phase"] == "ended"
        rooms.begin(HERON, "ascending", room=RoomName("garden"))
        assert socket.receive()["code"] == 4404
    assert rooms.of(HERON) is rooms.place(RoomName("garden"))


def test_a_caregiver_has_no_screens_stream(rooms: Rooms, caregiver: TestClient) -> None:
    rooms.begin(HERON, "ascending")
    with (
        pytest.raises(WebSocketDisconnect) as left,
        caregiver.websocket_connect(SCREEN_STREAM),
    ):
        pass
    assert left.value.code == 4404


# ---------------------------------------------------------------- speech


def test_what_was_said_can_be_heard(rooms: Rooms, context: Context, caregiver: TestClient) -> None:
    room = begun(rooms, context, Settings())
    address = room.state.as_json(for_caregiver=False)["said"]["speech"]
    heard = caregiver.get(address)
    assert heard.headers["content-type"] == "audio/wav"
    assert heard.content.startswith(b"RIFF")
    assert caregiver.get("/api/rooms/1/speech/999").status_code == 404


def test_without_a_voice_there_is_text_alone(
    rooms: Rooms, app: FastAPI, context: Context, caregiver: TestClient
) -> None:
    room = begun(rooms, context, Settings())
    app.state.phrases._program = None
    said = room.state.said
    assert said is not None
    assert caregiver.get(f"/api/rooms/1/speech/{said.number}").status_code == 404
    mute = Rooms(context.store, context.clock).of(HERON)
    assert mute is not None
    assert mute.state.as_json(for_caregiver=False)["said"]["speech"] is None
