"""Simulated patients: the same seeds, the same session; hints help; weariness ends."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from maestra.coaching.chance import Chance
from maestra.coaching.commands import Command, LookAt, PointAt, Say
from maestra.coaching.patients import (
    Heard,
    Mind,
    Patient,
    decide,
    has_had_enough,
    patient_of,
    perceive,
    unanswered,
)
from maestra.coaching.session import Ending
from maestra.coaching.settings import (
    Helper,
    Mental,
    Physical,
    PolicyName,
    Profile,
    Settings,
    settings_for,
)
from maestra.coaching.simulation import Simulation
from maestra.core.state import Move
from maestra.language.coach_keys import CoachKey
from maestra.rules.position import Position
from tests.coaching.plain_referee import ASCENDING, NOTHING, START, PlainReferee, cell, game, token

PERFECT = Patient(1.0, 1.0, 2_000, 0.0, 9.0, 10**9)
LOST = Patient(0.0, 1.0, 2_000, 0.0, 3.0, 10**9)
ABSENT = Patient(1.0, 0.0, 2_000, 0.0, 3.0, 10**9)
CLUMSY = Patient(1.0, 1.0, 2_000, 1.0, 9.0, 10**9)
QUIET = Settings(policy=PolicyName.FIXED, level=0)


@given(st.integers(0, 2**64 - 1), st.sampled_from(Mental), st.sampled_from(Physical))
def test_a_session_follows_from_its_seeds(seed: int, mental: Mental, physical: Physical) -> None:
    profile = Profile(mental, physical)
    patient = patient_of(profile, Chance(seed))
    settings = settings_for(profile)
    played = Simulation(game(settings, ASCENDING, seed), patient, seed).play()
    assert played.session.ending is not None
    again = Simulation(game(settings, ASCENDING, seed), patient, seed).play()
    assert again.events == played.events


def test_whoever_has_the_rule_in_mind_needs_no_help() -> None:
    played = Simulation(game(QUIET), PERFECT, 1).play()
    assert played.session.ending is Ending.COMPLETE
    assert played.session.tally.errors == 0


def test_whoever_does_not_is_helped_through_by_hints() -> None:
    helped = replace(QUIET, level=4)
    played = Simulation(game(helped), LOST, 1).play()
    assert played.session.ending is Ending.COMPLETE
    assert played.session.tally.errors == 0


def test_whoever_is_not_at_it_gives_up() -> None:
    played = Simulation(game(QUIET), ABSENT, 1).play()
    assert played.session.ending is Ending.STOPPED
    assert played.session.tally.silences > 0


@pytest.mark.parametrize("helper", Helper)
def test_slips_are_put_back_by_whoever_is_asked(helper: Helper) -> None:
    settings = replace(QUIET, put_back=helper, robot_moves=True)
    patient = replace(CLUMSY, slip=0.8, tolerance=99)
    played = Simulation(game(settings), patient, 4).play()
    assert played.session.tally.errors > 0
    assert played.session.ending is Ending.COMPLETE
    assert not played.session.table.astray(played.session.position.now)


def test_a_game_that_cannot_be_played_is_given_up() -> None:
    played = Simulation(game(QUIET, NOTHING), ABSENT, 1).play()
    assert played.session.ending is Ending.STOPPED


def test_traits_follow_the_profile_and_differ_from_person_to_person() -> None:
    people = [patient_of(Profile(Mental.SEVERE, Physical.MARKED), Chance(k)) for k in range(20)]
    others = [patient_of(Profile(), Chance(k)) for k in range(20)]
    assert max(one.memory for one in people) < min(one.memory for one in others)
    assert min(one.reaction_ms for one in people) > max(one.reaction_ms for one in others)
    assert len({one.memory for one in people}) == 20
    assert all(one.attention <= 1 for one in others)


def test_hints_are_heard_and_refusals_remembered() -> None:
    say = Say(CoachKey.LOOK_AT_ROW.value, {}, "")
    mind = perceive(Mind(), [say, LookAt((cell(2, 1),)), LookAt(())], None)
    assert mind.heard == Heard(CoachKey.LOOK_AT_ROW, (cell(2, 1),))
    tried = Move(token(3), cell(2, 3), cell(1, 1))
    refused = perceive(mind, [Say(CoachKey.REFUSED.value, {}, "")], tried)
    assert refused.refused == (tried,)
    assert refused.weariness == 1.0
    assert perceive(refused, [Say(CoachKey.REFUSED.value, {}, "")], None) == refused
    assert perceive(refused, [Say(CoachKey.PRAISE.value, {}, "")], tried) == Mind()


def test_pointing_where_to_put_back_is_no_hint() -> None:
    tried = Move(token(3), cell(2, 3), cell(1, 1))
    asked: list[Command] = [
        Say(CoachKey.REFUSED.value, {}, ""),
        Say(CoachKey.PLEASE_PUT_BACK.value, {}, ""),
        PointAt((cell(1, 1), cell(2, 3))),
    ]
    assert perceive(Mind(), asked, tried).heard == Heard()


def test_weariness_and_time_are_borne_for_so_long() -> None:
    mind = Mind()
    assert not has_had_enough(LOST, mind, 0)
    assert has_had_enough(replace(LOST, stamina_ms=5), mind, 6)
    for _ in range(7):
        mind = unanswered(mind)
    assert has_had_enough(LOST, mind, 0)


@given(st.integers(0, 2**64 - 1))
def test_a_row_is_looked_at_and_what_was_refused_avoided(seed: int) -> None:
    referee, position = PlainReferee(ASCENDING), Position.begin(START)
    heard = Heard(CoachKey.LOOK_AT_ROW, (cell(2, 1), cell(2, 2)))
    deed, _ = decide(LOST, Mind(heard), referee, position, Chance(seed))
    assert deed.move is not None
    assert deed.move.origin in heard.cells
    tried = Move(token(13), cell(2, 1), cell(1, 1))
    mindful = replace(PERFECT, memory=0.999999)
    nothing_right = PlainReferee(NOTHING)
    deed, _ = decide(mindful, Mind(heard, (tried,)), nothing_right, position, Chance(seed))
    assert deed.move is not None
    assert deed.move.token == token(21)


def test_where_nothing_can_be_moved_nothing_is() -> None:
    referee, position = PlainReferee(NOTHING), Position.begin(START)
    nowhere = Heard(CoachKey.LOOK_AT_ROW, (cell(3, 3),))
    deed, _ = decide(LOST, Mind(nowhere), referee, position, Chance(1))
    assert deed.move is None


@given(st.integers(0, 2**64 - 1))
def test_a_reminder_brings_the_rule_to_mind_more_often(seed: int) -> None:
    referee, position = PlainReferee(ASCENDING), Position.begin(START)
    deed, _ = decide(LOST, Mind(Heard(CoachKey.REMIND)), referee, position, Chance(seed))
    assert deed.move is not None


def test_a_slip_with_no_free_neighbour_lands_where_it_was_meant() -> None:
    referee = PlainReferee(ASCENDING)
    position = Position.begin(START)
    for value, column in ((3, 1), (21, 3)):
        position = position.after(Move(token(value), START.cells[token(value)], cell(1, column)))
    shown = Heard(CoachKey.THIS_ONE, (cell(2, 1), cell(1, 2)))
    deed, _ = decide(CLUMSY, Mind(shown), referee, position, Chance(1))
    assert deed.move == Move(token(13), cell(2, 1), cell(1, 2))
