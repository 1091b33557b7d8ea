"""Sessions in rooms: what is acknowledged is kept, and a restart loses nothing."""

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from maestra.coaching.events import (
    Begun,
    BoardLost,
    EndOrdered,
    Event,
    HelpAsked,
    HintOrdered,
    Paused,
    Resumed,
    Skipped,
    TokenLifted,
    TokenPlaced,
    TokenPutBack,
    VerdictOverridden,
)
from maestra.coaching.fields import Milliseconds
from maestra.coaching.remembered import read_remembered
from maestra.coaching.settings import Helper, Settings
from maestra.web.context import Context
from maestra.web.rooms.room import NobodyPlaysError, Room
from maestra.web.rooms.rooms import NoRoomLeftError, Rooms, TakenError
from maestra.web.rooms.stage import RoomName
from tests.web.conftest import StillClock
from tests.web.rooms.exercises import HERON, PLOVER, prepare, right_move, wrong_move

ONE = RoomName("1")


def play_to_the_end(room: Room) -> None:
    room.tell(Begun())
    while room.state.is_under_way:
        move = right_move(room)
        room.tell(TokenPlaced(move.token, move.destination))


def test_a_room_is_empty_until_a_session_begins(rooms: Rooms) -> None:
    room = rooms.place(ONE)
    assert room.state.phase == "empty"
    with pytest.raises(NobodyPlaysError):
        room.tell(Begun())
    assert rooms.begin(HERON, "ascending") is room
    assert room.state.phase == "ready"
    room.tell(Begun())
    assert room.state.phase == "playing"
    assert rooms.of(HERON) is room
    assert rooms.of(PLOVER) is None


def test_several_rooms_are_played_in_at_once(rooms: Rooms) -> None:
    first, second = rooms.begin(HERON, "ascending"), rooms.begin(PLOVER, "ascending")
    assert (first.name, second.name) == ("1", "2")
    first.tell(Begun())
    assert (first.state.phase, second.state.phase) == ("playing", "ready")


def test_a_patient_or_a_room_that_is_taken_is_refused(rooms: Rooms) -> None:
    rooms.begin(HERON, "ascending", room=ONE)
    with pytest.raises(TakenError):
        rooms.begin(HERON, "ascending")
    with pytest.raises(TakenError):
        rooms.begin(PLOVER, "ascending", room=ONE)


def test_a_played_exercise_is_kept_with_what_was_learned_of_the_patient(
    rooms: Rooms, context: Context
) -> None:
    before = context.store.settings(HERON)
    room = rooms.begin(HERON, "ascending")
    play_to_the_end(room)
    assert room.state.phase == "ended"
    assert room.state.moves == 5
    (kept,) = context.store.sessions(HERON)
    assert kept.ended_utc is not None
    after = read_remembered(context.store.settings(HERON).encode())
    assert after != read_remembered(before.encode())
    assert rooms.begin(HERON, "ascending") is room


def test_the_same_event_told_twice_happens_once(rooms: Rooms, context: Context) -> None:
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun(), "a")
    first = room.tell(HelpAsked(), "b")
    assert room.tell(HelpAsked(), "b") == first
    assert room.tell(HelpAsked(), "c") != first
    kept = list(context.store.events.entries(room.stored.session if room.stored else None))
    assert [one.kind for one in kept].count("event") == 3


def test_time_that_passes_becomes_a_prompt(rooms: Rooms, clock: StillClock) -> None:
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    said = room.state.said
    rooms.tick()
    assert room.state.said == said
    clock.now = Milliseconds(60_000)
    rooms.tick()
    assert room.state.said != said


def test_what_was_said_lately_can_be_heard_again(rooms: Rooms) -> None:
    room = rooms.begin(HERON, "ascending")
    said = room.tell(Begun()).said
    assert said is not None
    room.tell(HelpAsked())
    assert room.sentence(said.number)[0] == said.text
    with pytest.raises(KeyError):
        room.sentence(999)


def test_a_token_that_the_robot_is_to_move_is_awaited_until_it_lies_there(
    rooms: Rooms, context: Context
) -> None:
    prepare(context.store, Settings(robot_moves=True, put_back=Helper.ROBOT))
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    move = wrong_move(room)
    (command,) = room.tell(TokenPlaced(move.token, move.destination)).awaiting
    assert (command.token, command.destination) == (move.token, move.origin)
    assert room.tell(TokenPlaced(move.token, move.origin)).awaiting == ()


def test_rooms_are_not_without_end(rooms: Rooms, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("maestra.web.rooms.rooms.MOST_ROOMS", 1)
    rooms.place(ONE)
    room = rooms.begin(HERON, "ascending", room=RoomName("2"))
    assert rooms.all() == (room,)
    with pytest.raises(NoRoomLeftError):
        rooms.place(RoomName("3"))


def test_the_session_of_an_erased_patient_is_gone(rooms: Rooms, context: Context) -> None:
    room = rooms.begin(HERON, "ascending")
    context.store.erase(HERON)
    with pytest.raises(NobodyPlaysError):
        room.tell(Begun())
    assert room.state.phase == "empty"
    room = rooms.begin(PLOVER, "ascending")
    rooms.forget(PLOVER)
    assert room.state.phase == "empty"


# ---------------------------------------------------------------- after a restart


def restarted(rooms: Rooms, context: Context) -> Rooms:
    """The rooms of a server that was stopped without a word and started again."""
    return Rooms(context.store, context.clock, can_speak=rooms.can_speak)


EVENTS: tuple[Event, ...] = (
    Begun(),
    HelpAsked(),
    Paused(),
    Resumed(),
    Skipped(),
    HintOrdered(4),
    VerdictOverridden(allowed=True),
    BoardLost(),
)


@given(choices=st.lists(st.integers(0, 11), max_size=14))
@settings(
    max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None
)
def test_a_session_goes_on_after_a_restart_as_it_was(
    rooms: Rooms, context: Context, choices: list[int]
) -> None:
    rooms.forget(HERON)
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun())
    for choice in choices:
        if not room.state.is_under_way:
            break
        if choice < len(EVENTS):
            room.tell(EVENTS[choice])
            continue
        # A verdict that was changed may leave no right move.
        right = room.session.game.referee.right_moves(room.session.position)
        move = right[0] if choice % 2 and right else wrong_move(room)
        room.tell(TokenLifted(move.token))
        room.tell(
            TokenPutBack(move.token) if choice == 11 else TokenPlaced(move.token, move.destination)
        )
    if room.state.is_under_way and room.state.phase != "paused":
        room.tell(Paused())
    before = room.state
    again = restarted(rooms, context).of(HERON)
    if before.is_under_way:
        assert again is not None
        assert again.state == before
        room.tell(EndOrdered())
    else:
        assert again is None


def test_a_restored_session_is_paused_and_knows_what_it_was_told(
    rooms: Rooms, context: Context, clock: StillClock
) -> None:
    room = rooms.begin(HERON, "ascending")
    room.tell(Begun(), "first")
    clock.now = Milliseconds(20 * 3_600_000)
    again = restarted(rooms, context).of(HERON)
    assert again is not None
    assert again.state.phase == "paused"
    assert again.tell(Begun(), "first") == again.state
    assert again.session.now < clock.now
    again.tell(Resumed())
    play_to_the_end(again)
    assert context.store.sessions(HERON)[0].ended_utc is not None


def test_a_session_that_ended_while_nothing_could_be_kept_is_closed_later(
    rooms: Rooms, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError("disk full")

    room = rooms.begin(HERON, "ascending")
    with monkeypatch.context() as patched:
        patched.setattr("maestra.web.rooms.room.rise", full)
        play_to_the_end(room)
    assert context.store.sessions(HERON)[0].ended_utc is None
    rooms.tick()
    assert context.store.sessions(HERON)[0].ended_utc is not None
