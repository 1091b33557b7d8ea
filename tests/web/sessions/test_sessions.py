"""Sessions: begun, watched, steered, ended; nothing happens that is not kept."""

import pytest
from fastapi import FastAPI

from maestra.coaching.events import Begun, TokenLifted, TokenPlaced
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.session import Phase
from maestra.coaching.settings import Settings
from maestra.core.board import Cell
from maestra.core.state import Move
from maestra.storage.access import Device
from maestra.web.access.visitor import Role
from maestra.web.context import Context
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import MOST_ROOMS, NoRoomLeftError, Rooms
from maestra.web.rooms.stage import RoomName
from tests.web.conftest import StillClock
from tests.web.rooms.exercises import keep_cups, right_move, wrong_move
from tests.web.sessions.conftest import HERON, As, begin


def the_room(rooms: Rooms) -> Room:
    found = rooms.of(HERON)
    assert found is not None
    return found


def make(room: Room, move: Move, cell: Cell | None = None) -> None:
    room.tell(TokenLifted(move.token))
    room.tell(TokenPlaced(move.token, cell or move.destination))


def test_a_session_is_chosen_begun_and_listed(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    assert "No session is under way" in browser.get("/sessions").text
    page = browser.get("/sessions/new-session?patient=heron").text
    assert "Which exercise?" in page
    address = begin(browser)
    watched = browser.get(address).text
    assert "Nobody has sat down yet" in watched
    assert f'data-stream="/api/rooms/{the_room(rooms).name}/stream"' in watched
    assert "nobody sits there yet" in browser.get("/sessions").text


def test_the_caregiver_sees_the_pictures_that_the_patient_sees(
    browsing: As, context: Context
) -> None:
    picture = keep_cups(context.store)
    browser = browsing()
    page = browser.get(begin(browser, exercise="cups")).text
    assert page.count(f'<img src="{picture}"') == 10


def test_assigned_exercises_come_first_and_are_chosen(browsing: As, context: Context) -> None:
    browser = browsing()
    stored = context.store.exercise("ascending")
    context.store.save_exercise("a first one", stored.exercise)
    browser.post("/patients/heron/exercises", data={"exercise": "ascending"})
    page = browser.get("/sessions/new-session?patient=heron").text
    assert page.index('value="ascending" checked') < page.index('value="a first one"')
    assert "Other exercises" in page


def test_without_patients_or_exercises_the_page_says_what_is_missing(
    browsing: As, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "There are no patients yet" in browsing("bob").get("/sessions/new-session").text

    def nothing() -> tuple[()]:
        return ()

    monkeypatch.setattr(context.store, "exercises", nothing)
    assert "There are no exercises yet" in browsing().get("/sessions/new-session").text


@pytest.mark.parametrize(
    ("form", "line"),
    [
        ({"patient": ""}, "Please choose a patient"),
        ({"patient": "plover"}, "Please choose a patient"),
        ({"exercise": "nothing"}, "Please choose an exercise"),
        ({"board": "attic"}, "Please choose a board"),
    ],
)
def test_a_wrong_choice_is_said_and_nothing_begins(
    browsing: As, rooms: Rooms, form: dict[str, str], line: str
) -> None:
    browser = browsing()
    chosen = {"patient": "heron", "exercise": "ascending", "board": "", **form}
    answer = browser.post("/sessions", data=chosen)
    assert answer.status_code == 422
    if form.get("patient") != "":
        assert line in answer.text
    assert rooms.of(HERON) is None


def test_a_patient_plays_in_one_session_at_a_time(browsing: As) -> None:
    browser = browsing()
    begin(browser)
    form = {"patient": "heron", "exercise": "ascending", "board": ""}
    answer = browser.post("/sessions", data=form)
    assert answer.status_code == 422
    assert "in a session already" in answer.text


def test_where_no_room_is_left_it_is_said(
    browsing: As, rooms: Rooms, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> Room:
        raise NoRoomLeftError(MOST_ROOMS)

    monkeypatch.setattr(rooms, "begin", full)
    form = {"patient": "heron", "exercise": "ascending", "board": ""}
    assert "Too many sessions" in browsing().post("/sessions", data=form).text


def test_whoever_starts_a_session_learns_that_there_is_no_voice(
    browsing: As, app: FastAPI, context: Context
) -> None:
    browser = browsing()
    for can_speak in (True, False):
        app.state.rooms = Rooms(context.store, context.clock, can_speak=can_speak)
        page = browser.get("/sessions/new-session").text
        assert ("This computer has no voice" in page) is not can_speak


@pytest.mark.parametrize("room", ["garden", "new", "lobby"])
def test_a_board_with_a_token_can_be_chosen(browsing: As, context: Context, room: str) -> None:
    browser = browsing()
    board = Device("d", "x" * 64, "board", "Wooden board", room, None, None, "ann", 0)
    context.store.access.add_device(board)
    page = browser.get("/sessions/new-session?patient=heron").text
    assert f"Wooden board, in room {room}" in page
    assert begin(browser, board=room) == f"/sessions/{room}"
    assert "Nobody has sat down yet" in browser.get(f"/sessions/{room}").text


# ---------------------------------------------------------------- steering


def test_the_caregiver_begins_pauses_goes_on_and_ends(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    for button, phase in (
        ("begin", Phase.PLAYING),
        ("pause", Phase.PAUSED),
        ("resume", Phase.PLAYING),
        ("end", Phase.ENDED),
    ):
        assert browser.post(f"{address}/do", data={"do": button}).status_code == 200
        assert room.session.phase is phase
    page = browser.get(address).text
    assert "was ended before the exercise was complete" in page
    assert "See it again" in page
    assert "No session is under way" in browser.get("/sessions").text


def test_a_hint_is_given_at_the_level_that_was_ordered(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    the_room(rooms).tell(Begun())
    page = browser.post(f"{address}/do", data={"do": "hint:4"}).text
    assert "Help at level 4 of 5" in page
    assert "The caregiver had asked." in page


def test_only_levels_that_the_settings_allow_are_offered(
    browsing: As, context: Context, rooms: Rooms
) -> None:
    settings = Settings(least_level=1, level=2, most_level=3)
    browser = browsing()
    context.store.save_settings(HERON, write_remembered(Remembered(settings)))
    address = begin(browser)
    the_room(rooms).tell(Begun())
    page = browser.get(address).text
    assert [level for level in range(6) if f'value="hint:{level}"' in page] == [1, 2, 3]
    assert browser.post(f"{address}/do", data={"do": "hint:4"}).status_code == 422


def test_a_refused_move_can_be_said_to_be_right(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    make(room, wrong_move(room))
    page = browser.get(address).text
    assert "was refused." in page
    assert "That was right" in page
    browser.post(f"{address}/do", data={"do": "right"})
    assert len(room.session.position.moves) == 1


def test_a_right_move_can_be_said_to_be_wrong(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    make(room, right_move(room))
    assert "That was wrong" in browser.get(address).text
    browser.post(f"{address}/do", data={"do": "wrong"})
    assert room.session.position.moves == ()


def test_what_is_put_back_is_judged_no_more(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    wrong = wrong_move(room)
    make(room, wrong)
    make(room, wrong, wrong.origin)
    assert "That was right" not in browser.get(address).text


def test_a_move_is_skipped(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    the_room(rooms).tell(Begun())
    assert "Skip this move" in browser.get(address).text
    page = browser.post(f"{address}/do", data={"do": "skip"}).text
    assert "The robot asks you:" in page
    assert "Skip this move" not in page


@pytest.mark.parametrize(("button", "phase"), [("yes", Phase.PAUSED), ("no", Phase.PLAYING)])
def test_after_a_long_silence_the_caregiver_says_yes_or_no_to_a_pause(
    browsing: As, rooms: Rooms, clock: StillClock, button: str, phase: Phase
) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    while room.state.question is None:
        clock.now = Milliseconds(clock.now + 60_000)
        rooms.tick()
    number = room.state.question.number
    assert f'value="yes:{number}"' in browser.get(address).text
    browser.post(f"{address}/do", data={"do": f"{button}:{number}"})
    assert room.session.phase is phase


@pytest.mark.parametrize("button", ["", "fly", "hint", "hint:6", "hint:x", "yes", "no:x", "yes:²"])
def test_there_are_no_other_buttons(browsing: As, rooms: Rooms, button: str) -> None:
    browser = browsing()
    address = begin(browser)
    the_room(rooms).tell(Begun())
    assert browser.post(f"{address}/do", data={"do": button}).status_code == 422


def test_without_script_a_cell_is_pressed_twice_to_move(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    move = right_move(room)
    for cell in (move.origin, move.destination):
        answer = browser.post(address, data={"cell": f"{cell.row},{cell.column}"})
        assert answer.status_code == 200
    assert room.session.position.moves == (move,)
    assert "The move was right." in browser.get(address).text


def test_a_session_that_is_played_to_its_end_says_so(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = the_room(rooms)
    room.tell(Begun())
    while room.session.phase is Phase.PLAYING:
        make(room, right_move(room))
    page = browser.get(address).text
    assert "The exercise is complete." in page
    assert "Right moves of the patient: 5, of these at once: 5" in page
    assert "/progress/heron/sessions/" in browser.get("/sessions").text


# ---------------------------------------------------------------- whose


def test_another_caregivers_session_is_not_there(browsing: As) -> None:
    address = begin(browsing("ann"))
    bob = browsing("bob")
    assert bob.get(address).status_code == 404
    assert bob.post(f"{address}/do", data={"do": "end"}).status_code == 404
    assert "heron" not in bob.get("/sessions").text


def test_researchers_have_no_sessions(browsing: As) -> None:
    researcher = browsing("rita", Role.RESEARCHER)
    assert researcher.get("/sessions").status_code == 403
    assert researcher.get("/sessions/new-session").status_code == 403


def test_an_empty_room_is_no_session(browsing: As, rooms: Rooms) -> None:
    rooms.place(RoomName("garden"))
    browser = browsing()
    assert browser.get("/sessions/garden").status_code == 404
    assert browser.post("/sessions/garden/do", data={"do": "end"}).status_code == 404
    assert browser.get("/sessions/nowhere").status_code == 404


def test_erasing_a_patient_ends_what_they_play(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    browser.post("/patients/heron/erase")
    assert rooms.of(PatientId("heron")) is None
    assert browser.get(address).status_code == 404
