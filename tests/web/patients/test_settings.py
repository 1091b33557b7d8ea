"""Settings: each explained, saved as typed, proposed by the profile, taken back."""

import re
from typing import Any

import pytest

from maestra.coaching.ports import PatientId
from maestra.coaching.settings import (
    Hand,
    Helper,
    Mental,
    Physical,
    Profile,
    Reach,
    Settings,
    encode_settings,
    settings_for,
)
from maestra.language import Language
from maestra.language.coach_settings import setting_explanation, setting_name
from maestra.web.context import Context
from maestra.web.patients import fields, kinds
from maestra.web.patients.care import FOLLOWING, Care, proposals
from maestra.web.patients.plan import Plan, read_plan, write_plan
from tests.web.patients.conftest import PROFILE, As, make

HERON = PatientId("heron")


def form_of(settings: Settings, **typed: str | list[str]) -> dict[str, Any]:
    """The settings' form as a browser sends it, some of it typed otherwise."""
    return {**{name: list(value) for name, value in fields.typed_of(settings).items()}, **typed}


def kept(context: Context) -> Settings:
    return Care(context.store).remembered(HERON).settings


@pytest.mark.parametrize("language", Language)
def test_each_setting_stands_there_with_its_explanation(browsing: As, language: Language) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.cookies.set("maestra-language", language.value)
    page = browser.get("/patients/heron/settings").text.replace("&#39;", "'")
    for name in (*kinds.PROFILE, *kinds.KINDS):
        assert setting_name(name, language) in page
        assert setting_explanation(name, language) in page


def test_every_setting_of_the_coach_can_be_set() -> None:
    assert {*kinds.KINDS, "profile"} == set(encode_settings(Settings()))
    assert set(kinds.PROFILE) == set(encode_settings(Settings())["profile"])


def test_the_form_as_it_stands_changes_nothing(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron", mental="moderate", physical="marked")
    before = kept(context)
    assert before == settings_for(Profile(Mental.MODERATE, Physical.MARKED))
    browser.post("/patients/heron/settings", data=form_of(before))
    assert kept(context) == before
    assert "Before the last change" not in browser.get("/patients/heron/settings").text


def test_what_is_saved_is_in_use_and_can_be_taken_back_and_forth(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    make(browser, "heron")
    before = kept(context)
    form = form_of(before, speech_wpm="120", modalities=["text"], errorless="yes")
    page = browser.post("/patients/heron/settings", data=form).text
    assert "Saved." in page
    assert "Speed of speech: 150" in page
    after = kept(context)
    assert (after.speech_wpm, after.errorless) == (120, True)
    browser.post("/patients/heron/settings/undo")
    assert kept(context) == before
    browser.post("/patients/heron/settings/undo")
    assert kept(context) == after


def test_what_cannot_go_together_any_more_is_not_taken_back(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.post("/patients/heron/settings", data=form_of(kept(context), speech_wpm="120"))
    plan = read_plan(context.store.plan(HERON))
    spoilt = Plan(before={**plan.before, "speech_wpm": 1})
    context.store.save_plan(HERON, write_plan(spoilt))
    assert "cannot be taken back" in browser.post("/patients/heron/settings/undo").text


@pytest.mark.parametrize(
    ("typed", "field", "line"),
    [
        ({"speech_wpm": "109"}, "speech_wpm", "a number from 110 to 180"),
        ({"speech_wpm": "fast"}, "speech_wpm", "a number from 110 to 180"),
        ({"volume": "1_0"}, "volume", "a number from 0 to 100"),
        ({"volume": ""}, "volume", "a number from 0 to 100"),
        ({"rounds": "9" * 5_000}, "rounds", "a number from 1 to 20"),
        ({"modalities": []}, "modalities", "choose at least one"),
        ({"modalities": ["smoke"]}, "modalities", "choose at least one"),
        ({"persona": "pirate"}, "persona", "choose one of these"),
        ({"level": "0", "least_level": "2"}, "level", "from the least help to the most"),
        ({"difficulty.digits": "3", "hardest.digits": "1"}, "difficulty", "to the hardest"),
        ({"easiest.digits": "x"}, "easiest", "to the hardest"),
    ],
)
def test_a_wrong_setting_is_said_at_its_field_and_what_was_typed_stays(
    browsing: As,
    context: Context,
    typed: dict[str, str | list[str]],
    field: str,
    line: str,
) -> None:
    browser = browsing()
    make(browser, "heron")
    before = kept(context)
    answer = browser.post("/patients/heron/settings", data=form_of(before, **typed))
    assert answer.status_code == 422
    said = answer.text.split(f'id="field-{field}-fault">')[1].partition("</p>")[0]
    assert line in said
    assert kept(context) == before
    assert "typed and is not in use yet" in browser.get("/patients/heron/settings").text


def test_what_is_typed_is_kept_before_it_is_saved(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    form = form_of(kept(context), speech_wpm="1")
    assert browser.post("/patients/heron/settings/draft", data=form).status_code == 204
    page = browser.get("/patients/heron/settings").text
    assert re.search(r'name="speech_wpm"[^>]* value="1"', page)
    assert "not in use yet" in browser.get("/patients/heron").text
    assert kept(context).speech_wpm == 150
    browser.post("/patients/heron/settings/forget")
    assert re.search(r'name="speech_wpm"[^>]* value="150"', _settings(browsing))


def test_a_draft_that_says_what_is_so_is_none(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    for typed in ({"volume": "7"}, {}):
        form = form_of(kept(context), **typed)
        browser.post("/patients/heron/settings/draft", data=form)
    assert "not in use yet" not in _settings(browsing)


def _settings(browsing: As) -> str:
    return browsing().get("/patients/heron/settings").text


# ---------------------------------------------------------------- the profile


def test_a_new_profile_proposes_its_defaults_before_anything_changes(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    make(browser, "heron")
    before = kept(context)
    page = browser.post("/patients/heron/profile", data={**PROFILE, "mental": "severe"}).text
    assert "These settings would follow" in page
    assert re.search(r'value="speech_wpm" checked', page)
    assert kept(context) == before
    browser.post("/patients/heron/profile/leave")
    assert "These settings would follow" not in _settings(browsing)
    assert kept(context) == before


def test_only_what_is_ticked_is_taken_with_what_bounds_it(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.post("/patients/heron/profile", data={**PROFILE, "mental": "severe"})
    browser.post("/patients/heron/profile/take", data={"take": ["speech_wpm", "difficulty"]})
    usual, now = settings_for(Profile(Mental.SEVERE)), kept(context)
    assert now.profile.mental is Mental.SEVERE
    assert (now.speech_wpm, now.hardest) == (usual.speech_wpm, usual.hardest)
    assert now.errorless is False
    browser.post("/patients/heron/settings/undo")
    assert kept(context) == settings_for(Profile())


def test_what_was_set_by_hand_is_proposed_but_not_ticked(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.post("/patients/heron/settings", data=form_of(kept(context), speech_wpm="170"))
    page = browser.post("/patients/heron/profile", data={**PROFILE, "mental": "severe"}).text
    assert re.search(r'value="speech_wpm">', page)
    assert re.search(r'value="patience_s" checked', page)
    assert "set by hand" in page


def test_a_profile_from_which_nothing_follows_is_in_use_at_once(
    browsing: As, context: Context
) -> None:
    browser = browsing()
    make(browser, "heron")
    browser.post("/patients/heron/profile", data={**PROFILE, "hand": "left"})
    assert kept(context).profile.hand is Hand.LEFT
    assert "These settings would follow" not in _settings(browsing)


def test_a_profile_of_other_words_is_refused(browsing: As) -> None:
    browser = browsing()
    make(browser, "heron")
    answer = browser.post("/patients/heron/profile", data={**PROFILE, "hand": "third"})
    assert answer.status_code == 422


def test_taking_when_nothing_is_proposed_changes_nothing(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    before = kept(context)
    browser.post("/patients/heron/profile/take", data={"take": ["speech_wpm"]})
    assert kept(context) == before


def test_what_follows_from_a_profile_is_just_what_can_be_proposed() -> None:
    differing: set[str] = set()
    usual = encode_settings(settings_for(Profile()))
    for mental in Mental:
        for physical in Physical:
            for hand in Hand:
                for reach in Reach:
                    profile = Profile(mental, physical, hand, reach)
                    other = encode_settings(settings_for(profile))
                    differing |= {name for name in usual if other[name] != usual[name]}
    assert differing - {"profile"} <= set(FOLLOWING)
    assert set(FOLLOWING) - differing == {"easiest"}


def test_the_proposed_level_stays_within_the_bounds_that_were_set() -> None:
    settings = Settings(level=1, most_level=2)
    found = {one.name: one.proposed for one in proposals(settings, Profile(Mental.SEVERE))}
    assert found["level"] == 2


def test_a_draft_survives_a_taken_profile(browsing: As, context: Context) -> None:
    browser = browsing()
    make(browser, "heron")
    form = form_of(kept(context), volume="33")
    browser.post("/patients/heron/settings/draft", data=form)
    browser.post("/patients/heron/profile", data={**PROFILE, "mental": "severe"})
    browser.post("/patients/heron/profile/take", data={"take": ["speech_wpm"]})
    page = _settings(browsing)
    assert re.search(r'name="volume"[^>]* value="33"', page)
    assert re.search(r'name="speech_wpm"[^>]* value="110"', page)


# ---------------------------------------------------------------- the rest


def test_a_plan_comes_back_as_it_was_kept() -> None:
    plan = Plan(("a",), {"x": ("1", "2")}, Profile(hand=Hand.LEFT), {"volume": 3})
    assert read_plan(write_plan(plan)) == plan


@pytest.mark.parametrize("text", ["", "{}", '{"format": "maestra.plan/2", "plan": {}}'])
def test_a_plan_of_another_kind_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"maestra\.plan/1"):
        read_plan(text)


def test_of_whom_nothing_is_kept_has_the_defaults(context: Context) -> None:
    context.store.save_name(HERON, "Rosa")
    assert kept(context) == settings_for(Profile())
    assert kept(context).put_back is Helper.PATIENT
