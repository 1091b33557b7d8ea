"""What was judged otherwise goes back to the exercise, and nothing changes by itself."""

from dataclasses import replace

import pytest

from maestra.coaching.chance import Chance
from maestra.coaching.difficulty import Difficulty
from maestra.coaching.events import Begun, EndOrdered, TokenLifted, TokenPlaced, VerdictOverridden
from maestra.coaching.settings import Settings
from maestra.coaching.sitting import laid_out
from maestra.core.demonstration import Demonstration
from maestra.core.state import Move, State
from maestra.language import Language
from maestra.rules.exercise import Evidence, LearnStatus, RuledExercise
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.timing import FillOrder
from maestra.web.access.visitor import AccountId, Role, Visitor
from maestra.web.context import Context
from maestra.web.patients.addresses import segment_of
from maestra.web.rooms.room import Room
from maestra.web.rooms.rooms import Rooms
from maestra.web.sessions.evidence import said_in
from maestra.web.teach.desk import Desk
from maestra.web.teach.understanding import dialogue_of, exercise_of
from tests.web.rooms.exercises import ASCENDING, right_move, wrong_move
from tests.web.sessions.conftest import HERON, As, begin

ANN = Visitor(AccountId("ann"), "Ann", Role.CAREGIVER, Language.EN)


def make(room: Room, move: Move) -> None:
    room.tell(TokenLifted(move.token))
    room.tell(TokenPlaced(move.token, move.destination))


def ascending_out_of_order(room: Room) -> list[Move]:
    """The least tokens in their order, but the second cell is filled first."""
    session = room.session
    now, deck = session.position.now, session.game.referee.deck
    values = sorted((token.value("value"), token.id) for token in deck.tokens)
    goal = now.board.goal_cells
    moves = [
        Move(token, now.cells[token], cell) for (_, token), cell in zip(values, goal, strict=False)
    ]
    return [moves[1], moves[0], *moves[2:]]


def played(browsing: As, rooms: Rooms, *, moves: int) -> str:
    """A session in which another order of placement was granted; where it is replayed."""
    begin(browsing())
    room = rooms.of(HERON)
    assert room is not None
    assert room.stored is not None
    room.tell(Begun())
    for move in ascending_out_of_order(room)[:moves]:
        make(room, move)
        if move not in room.session.position.moves:
            room.tell(VerdictOverridden(allowed=True))
    room.tell(EndOrdered())
    return f"/progress/heron/sessions/{segment_of(room.stored.session)}"


def test_what_was_judged_otherwise_is_offered_after_the_session(
    browsing: As, rooms: Rooms
) -> None:
    address = played(browsing, rooms, moves=1)
    browser = browsing()
    room = rooms.of(HERON)
    assert room is not None
    for page in (f"/sessions/{room.name}", address):
        text = browser.get(page).text
        assert "What you judged otherwise" in text
        assert "you said that was right" in text


def test_while_the_session_lasts_nothing_is_offered(browsing: As, rooms: Rooms) -> None:
    browser = browsing()
    address = begin(browser)
    room = rooms.of(HERON)
    assert room is not None
    room.tell(Begun())
    make(room, right_move(room))
    room.tell(VerdictOverridden(allowed=False))
    assert "you said that was wrong" not in browser.get(address).text


def test_where_nothing_was_judged_otherwise_there_is_nothing_to_take_back(
    browsing: As, rooms: Rooms
) -> None:
    browser = browsing()
    begin(browser)
    room = rooms.of(HERON)
    assert room is not None
    assert room.stored is not None
    room.tell(Begun())
    make(room, wrong_move(room))
    room.tell(EndOrdered())
    address = f"/progress/heron/sessions/{segment_of(room.stored.session)}"
    assert "What you judged otherwise" not in browser.get(address).text
    assert browser.post(f"{address}/teach").status_code == 404


def test_a_told_exercise_learns_from_a_session_whose_row_is_full(
    browsing: As, rooms: Rooms, context: Context
) -> None:
    address = played(browsing, rooms, moves=5)
    answer = browsing().post(f"{address}/teach", follow_redirects=False)
    assert answer.status_code == 303
    (kept,) = Desk(context, ANN).all()
    assert answer.headers["location"] == f"/teach/{kept.id}"
    assert len(kept.draft.demonstrations) == 1
    exercise = exercise_of(kept.draft)
    assert isinstance(exercise, RuledExercise)
    assert dialogue_of(kept.draft) is not None
    assert not any(isinstance(one.rule, FillOrder) for one in exercise.rules)
    assert context.store.exercise("ascending").version == 1


def test_a_told_exercise_keeps_the_verdict_until_something_is_shown(
    browsing: As, rooms: Rooms, context: Context
) -> None:
    address = played(browsing, rooms, moves=1)
    browsing().post(f"{address}/teach")
    (kept,) = Desk(context, ANN).all()
    assert kept.draft.taught.told == ASCENDING.conjunction
    assert len(kept.draft.taught.answers) == 1
    assert browsing().get(f"/teach/{kept.id}").status_code == 200


def test_an_exercise_that_is_gone_cannot_learn(
    browsing: As, rooms: Rooms, monkeypatch: pytest.MonkeyPatch, context: Context
) -> None:
    address = played(browsing, rooms, moves=1)

    def gone(*_: object) -> None:
        raise KeyError("ascending")

    monkeypatch.setattr(context.store, "exercise", gone)
    assert browsing().post(f"{address}/teach").status_code == 404


def test_only_who_cares_for_the_patient_takes_it_back(browsing: As, rooms: Rooms) -> None:
    address = played(browsing, rooms, moves=1)
    assert browsing("bob").post(f"{address}/teach").status_code == 404
    researcher = browsing("rita", Role.RESEARCHER)
    assert researcher.post(f"{address}/teach").status_code == 403
    assert "What you judged otherwise" not in researcher.get(address).text


def test_a_record_without_a_start_says_nothing() -> None:
    assert said_in([]) is None


def learned(context: Context, *, told: bool) -> None:
    """Let the exercise rest on a demonstration: the tokens in ascending order, left to right."""
    start = laid_out(ASCENDING, Settings(difficulty=Difficulty(2, 1)), Chance(3))[1]
    values = sorted((token.value("value"), token.id) for token in ASCENDING.deck.tokens)
    start = State(ASCENDING.board, dict(start.cells))
    moves = tuple(
        Move(token, start.cells[token], cell)
        for (_, token), cell in zip(values, start.board.goal_cells, strict=False)
    )
    shown = Demonstration(ASCENDING.deck, start, moves)
    status = LearnStatus.TOLD if told else LearnStatus.LEARNED
    exercise = replace(ASCENDING, status=status, evidence=Evidence((shown,)))
    context.store.save_exercise("ascending", encode_exercise(exercise))


@pytest.mark.parametrize("told", [True, False])
def test_an_exercise_with_demonstrations_learns_besides_them(
    browsing: As, rooms: Rooms, context: Context, *, told: bool
) -> None:
    browser = browsing()
    learned(context, told=told)
    address = played(lambda: browser, rooms, moves=1)
    browser.post(f"{address}/teach")
    (kept,) = Desk(context, ANN).all()
    assert kept.draft.taught.told is None
    assert len(kept.draft.demonstrations) == 1
    exercise = exercise_of(kept.draft)
    assert isinstance(exercise, RuledExercise)
    assert not any(isinstance(one.rule, FillOrder) for one in exercise.rules)
    assert len(exercise.evidence.answers) == (3 if told else 1)
