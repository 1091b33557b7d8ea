"""The preview says what the robot will say, because it is the robot that says it."""

import html
import re
from dataclasses import replace

import pytest
from fastapi import FastAPI

from maestra.coaching.ports import PatientId
from maestra.coaching.settings import (
    Helper,
    Mental,
    Modality,
    Profile,
    Settings,
    settings_for,
)
from maestra.core.board import Board, Column, Row
from maestra.core.faults import Fault, InvalidError
from maestra.core.tokens import Deck
from maestra.language import Language
from maestra.language.coach import ways_to_say
from maestra.language.coach_keys import CoachKey
from maestra.robots.phrases import Phrases
from maestra.rules.exercise import LearnStatus, RuledExercise, meant_rules
from maestra.rules.exercise_format import encode_exercise
from maestra.rules.forms.length import FullRow
from maestra.rules.paper import NUMBER_DECK
from maestra.web.context import Context
from maestra.web.patients import settings_routes
from maestra.web.patients.care import Care
from maestra.web.patients.preview import Line, Moment, rehearse
from tests.web.patients.conftest import PROFILE, As, make
from tests.web.rooms.exercises import ASCENDING


def at(lines: tuple[Line, ...], moment: Moment) -> Line:
    return next(one for one in lines if one.moment is moment)


@pytest.mark.parametrize("language", Language)
def test_every_moment_is_said_in_the_patients_language(language: Language) -> None:
    lines = rehearse(ASCENDING, Settings(language=language), 1)
    assert {one.moment for one in lines} == set(Moment)
    assert at(lines, Moment.GREETING).said[0] in ways_to_say(CoachKey.WELCOME, language)
    assert at(lines, Moment.GOODBYE).said[0] in ways_to_say(CoachKey.GOODBYE, language)
    assert at(lines, Moment.PRAISE).said[0] in ways_to_say(CoachKey.PRAISE, language)


def test_help_is_heard_at_each_level_that_is_allowed_and_no_other() -> None:
    settings = Settings(least_level=1, level=2, most_level=4)
    lines = rehearse(ASCENDING, settings, 1)
    assert [one.level for one in lines if one.moment is Moment.PROMPT] == [1, 2, 3, 4]


def test_who_puts_back_is_heard_after_a_wrong_move() -> None:
    patient = at(rehearse(ASCENDING, Settings(), 1), Moment.REFUSAL)
    robot = replace(Settings(), put_back=Helper.ROBOT, robot_moves=True)
    caregiver = replace(Settings(), put_back=Helper.CAREGIVER)
    assert patient.points
    assert not patient.asked
    assert at(rehearse(ASCENDING, robot, 1), Moment.REFUSAL).moves
    assert at(rehearse(ASCENDING, caregiver, 1), Moment.REFUSAL).asked


def test_without_speech_and_text_nothing_is_said() -> None:
    settings = replace(Settings(), modalities=(Modality.GESTURE,))
    assert all(not one.said for one in rehearse(ASCENDING, settings, 1))


def test_another_way_says_the_same_otherwise() -> None:
    said = {at(rehearse(ASCENDING, Settings(), way), Moment.GREETING).said for way in range(9)}
    assert len(said) > 1


def test_an_exercise_of_one_move_is_complete_with_it() -> None:
    narrow, deck = Board(Row(3), Column(1)), Deck(NUMBER_DECK.tokens[:2])
    rules = (FullRow(),)
    short = RuledExercise(narrow, deck, meant_rules(rules, [1.0]), 1.0, LearnStatus.TOLD, rules)
    moments = [one.moment for one in rehearse(short, Settings(), 1)]
    assert Moment.COMPLETE in moments
    assert not {Moment.PRAISE, Moment.REFUSAL} & set(moments)


def test_a_patient_who_is_severely_impaired_is_shown_the_token_at_once() -> None:
    lines = rehearse(ASCENDING, settings_for(Profile(Mental.SEVERE)), 1)
    assert "1" in " ".join(at(lines, Moment.GREETING).said)


def test_the_page_shows_the_preview_of_an_assigned_exercise(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    context.store.save_exercise("another", encode_exercise(ASCENDING))
    make(browser, "heron", language="es")
    page = browser.get("/patients/heron/preview").text
    assert '<option value="another" selected' in page
    browser.post("/patients/heron/exercises", data={"exercise": ["ascending"]})
    page = browser.get("/patients/heron/preview", params={"way": 3}).text
    assert 'value="another"' not in page
    assert '<q lang="es">' in page
    assert "When the exercise is complete" in page


def test_the_preview_is_with_what_is_typed_if_that_can_be(browsing: As) -> None:
    browser = browsing()
    make(browser, "heron")
    form = {"modalities": ["gesture"], "language": "ca"}
    everything = {**PROFILE, **form}
    browser.post("/patients/heron/settings/draft", data=everything)
    # Most of the form is missing, so it cannot be used yet.
    assert "It says nothing" not in browser.get("/patients/heron/preview").text


def test_without_exercises_the_preview_leads_to_teaching(
    browsing: As, context: Context, monkeypatch: pytest.MonkeyPatch
) -> None:
    browser = browsing()
    make(browser, "heron")

    def nothing() -> tuple[()]:
        return ()

    monkeypatch.setattr(context.store, "exercises", nothing)
    assert "Teach one" in browser.get("/patients/heron/preview").text
    assert "Teach one" in browser.get("/patients/heron").text


def test_each_line_can_be_heard_where_there_is_a_voice(browsing: As) -> None:
    browser = browsing()
    make(browser, "heron", language="es")
    page = browser.get("/patients/heron/preview").text
    sounds = re.findall(r'<audio [^>]*src="([^"]*)"', page)
    assert len(sounds) == len(Moment) + 5
    answer = browser.get(html.unescape(sounds[0]))
    assert answer.headers["content-type"] == "audio/wav"
    assert answer.content[:4] == b"RIFF"


@pytest.mark.parametrize(
    "query",
    ["exercise=nothing&way=1&line=0", "exercise=ascending&way=1&line=99"],
)
def test_what_is_not_said_cannot_be_heard(browsing: As, query: str) -> None:
    browser = browsing()
    make(browser, "heron")
    assert browser.get(f"/patients/heron/preview/heard?{query}").status_code == 404


def test_without_speech_nothing_can_be_heard(browsing: As, context: Context, app: FastAPI) -> None:
    browser = browsing()
    make(browser, "heron")
    settings = replace(Settings(), modalities=(Modality.TEXT,))
    Care(context.store).change(PatientId("heron"), settings)
    assert "<audio" not in browser.get("/patients/heron/preview").text
    settings = replace(Settings(), modalities=(Modality.GESTURE,))
    Care(context.store).change(PatientId("heron"), settings)
    query = "exercise=ascending&way=1&line=0"
    assert browser.get(f"/patients/heron/preview/heard?{query}").status_code == 404
    Care(context.store).change(PatientId("heron"), Settings())
    app.state.phrases = Phrases(context.folder, "no such program")
    assert browser.get(f"/patients/heron/preview/heard?{query}").status_code == 404


def test_an_exercise_that_does_not_fit_its_board_has_no_preview(
    browsing: As, monkeypatch: pytest.MonkeyPatch
) -> None:
    browser = browsing()
    make(browser, "heron")

    def refuse(*_: object) -> None:
        raise InvalidError([Fault("deck", "too few", "more")])

    monkeypatch.setattr(settings_routes, "rehearse", refuse)
    assert "cannot be played with its own tokens" in browser.get("/patients/heron/preview").text
