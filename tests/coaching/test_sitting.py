"""How a session begins and ends in the record."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from maestra.boards.replay import ReplayBoard
from maestra.coaching.chance import Chance
from maestra.coaching.events import Begun, EndOrdered, HelpAsked
from maestra.coaching.fields import Milliseconds
from maestra.coaching.ports import PatientId, SessionId
from maestra.coaching.remembered import Remembered, write_remembered
from maestra.coaching.running import Running
from maestra.coaching.settings import Settings
from maestra.coaching.sitting import (
    Chosen,
    Sitting,
    known_patient,
    laid_out,
    rise,
    sit_down,
)
from maestra.core.state import State
from maestra.core.tokens import Deck
from maestra.rules.exercise import Exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.forms.selection import EveryToken
from maestra.rules.judging import Judge
from maestra.rules.paper_rules import paper_exercise
from maestra.rules.position import Position
from maestra.rules.telling import told_exercise
from maestra.rules.token_tests import has
from maestra.storage.opening import open_store, place
from maestra.storage.store import SqlStore
from tests.coaching.test_recording import EXERCISE, UTC

ANNA = PatientId("anna")
CHOSEN = Chosen("ascending", 1, EXERCISE)


@pytest.fixture
def store(tmp_path: Path) -> Iterator[SqlStore]:
    opened = open_store(place(str(tmp_path / "data"), str(tmp_path / "keys")))
    yield opened
    opened.close()


def seated(store: SqlStore) -> tuple[Sitting, Running]:
    sitting = sit_down(SessionId("s"), ANNA, CHOSEN, Remembered(Settings()), seed=7, utc=UTC)
    sitting.keep(store)
    return sitting, running(sitting, store)


def running(sitting: Sitting, store: SqlStore) -> Running:
    return Running(SessionId("s"), sitting.start, ReplayBoard(()), (), store.events, UTC)


def test_a_session_is_known_with_its_settings_before_it_begins(store: SqlStore) -> None:
    sitting, _ = seated(store)
    (kept,) = store.sessions(ANNA)
    assert kept == sitting.stored
    assert known_patient(store, ANNA).settings == Settings()
    assert sitting.start.patient == ANNA


def test_what_was_learned_is_kept_once_however_often_it_is_done(store: SqlStore) -> None:
    sitting, played = seated(store)
    for event in (Begun(), HelpAsked(), EndOrdered()):
        played.feed(event, Milliseconds(1_000), UTC)
    rise(store, sitting.stored, played.session, UTC)
    after = known_patient(store, ANNA)
    assert after != Remembered(Settings())
    rise(store, sitting.stored, played.session, UTC)
    assert known_patient(store, ANNA) == after
    assert store.sessions(ANNA) == (replace(sitting.stored, ended_utc=UTC),)


def test_what_the_caregiver_set_meanwhile_stays(store: SqlStore) -> None:
    sitting, played = seated(store)
    louder = Remembered(Settings(volume=100))
    store.save_settings(ANNA, write_remembered(louder))
    played.feed(EndOrdered(), Milliseconds(1_000), UTC)
    rise(store, sitting.stored, played.session, UTC)
    assert known_patient(store, ANNA).settings.volume == 100


def test_a_session_that_the_store_has_goes_on_where_it_was(store: SqlStore) -> None:
    sitting, played = seated(store)
    played.feed(Begun(), Milliseconds(1_000), UTC, "a")
    played.feed(HelpAsked(), Milliseconds(2_000), UTC)
    again = running(sitting, store)
    assert again.session == played.session
    assert again.has_heard("a")
    assert not again.has_heard("b")
    assert again.feed(HelpAsked(), Milliseconds(3_000), UTC, "a") == ()
    assert again.feed(HelpAsked(), Milliseconds(3_000), UTC, "b")
    assert len(list(store.events.entries(SessionId("s")))) == 7


# ---------------------------------------------------------------- dealing


FOURTH = paper_exercise("first-row")


def can_begin(exercise: Exercise, deck: Deck, state: State) -> bool:
    return any(Judge(exercise, deck).allowed_moves(Position.begin(state)))


def test_tokens_are_dealt_again_until_some_move_is_right() -> None:
    deck, ids = FOURTH.deck, [token.id for token in FOURTH.deck.tokens]
    stuck = 0
    for seed in range(40):
        cells, _ = Chance(seed).shuffled(FOURTH.board.storage_cells)
        shuffled = State(FOURTH.board, dict(zip(ids, cells, strict=False)))
        stuck += not can_begin(FOURTH, deck, shuffled)
        assert can_begin(FOURTH, *laid_out(FOURTH, Settings(), Chance(seed)))
    assert stuck


def test_where_no_move_ever_is_right_the_tokens_are_dealt_all_the_same() -> None:
    both = (FullRow(), EveryToken(has("odd", "value")), EveryToken(has("even", "value")))
    never = told_exercise(both, FOURTH.board, FOURTH.deck)
    deck, state = laid_out(never, Settings(), Chance(1))
    assert set(state.cells) == {token.id for token in deck.tokens}
    assert not can_begin(never, deck, state)
