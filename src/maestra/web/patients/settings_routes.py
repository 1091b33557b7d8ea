"""The pages on how the robot treats a patient: settings, profile, and what will be said."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, Final

from fastapi import APIRouter, HTTPException, Query
from fastapi.responses import HTMLResponse, Response

from maestra.coaching.settings import Modality, Settings
from maestra.core.faults import InvalidError
from maestra.language.coach_settings import setting_name
from maestra.robots.phrases import NoVoiceError
from maestra.rules.exercise_format import decode_exercise
from maestra.web.access.audit import Act
from maestra.web.pages import Pages
from maestra.web.patients import fields, kinds
from maestra.web.patients.care import proposals
from maestra.web.patients.desk import UNPROCESSABLE, AtDesk, Desk, titles
from maestra.web.patients.plan import Plan
from maestra.web.patients.preview import Line, rehearse
from maestra.web.patients.routes import Done
from maestra.web.patients.whose import Filled
from maestra.web.rooms.routes import WAV, PhrasesHere

MOST_WAYS: Final = 1_000_000
"""Seeds of a preview."""

router: Final = APIRouter(include_in_schema=False)


@router.get("/patients/{pseudonym}/settings")
def settings(desk: AtDesk, done: Done = "") -> HTMLResponse:
    """Everything that can be set, as it is or as it was typed."""
    return _settings(desk, done=done)


@router.post("/patients/{pseudonym}/settings")
def change(desk: AtDesk, typed: Filled) -> Response:
    """Use the settings as they were typed."""
    now = desk.care.remembered(desk.patient).settings
    meant = fields.settings_of(typed, now, desk.pages)
    if not isinstance(meant, Settings):
        desk.care.keep_draft(desk.patient, fields.changes(typed, now))
        return _settings(desk, faults=meant)
    desk.care.change(desk.patient, meant)
    desk.note(Act.CHANGED, "settings")
    return desk.to("/settings?done=changed")


@router.post("/patients/{pseudonym}/settings/draft", status_code=204)
def draft(desk: AtDesk, typed: Filled) -> Response:
    """Keep what has been typed so far; it is not in use yet."""
    changed = fields.changes(typed, desk.care.remembered(desk.patient).settings)
    if changed:
        desk.care.keep_draft(desk.patient, changed)
    else:
        desk.care.forget_draft(desk.patient)
    return Response(status_code=204)


@router.post("/patients/{pseudonym}/settings/forget")
def forget(desk: AtDesk) -> Response:
    """Let the form be as the settings are."""
    desk.care.forget_draft(desk.patient)
    return desk.to("/settings?done=forgotten")


@router.post("/patients/{pseudonym}/settings/undo")
def undo(desk: AtDesk) -> Response:
    """Take the last change back."""
    try:
        desk.care.undo(desk.patient)
    except InvalidError:
        return desk.to("/settings?done=not-undone")
    desk.note(Act.CHANGED, "settings")
    return desk.to("/settings?done=undone")


@router.post("/patients/{pseudonym}/profile")
def propose(desk: AtDesk, typed: Filled) -> Response:
    """Keep what the patient can and cannot do, and show what would follow from it."""
    profile = fields.profile_of(typed)
    if profile is None:
        return _settings(desk, faults={"mental": desk.pages.say("Please choose one of these.")})
    desk.care.propose(desk.patient, profile)
    return desk.to("/settings#follows")


@router.post("/patients/{pseudonym}/profile/take")
def take(desk: AtDesk, typed: Filled) -> Response:
    """Use the profile, and of what follows from it what was ticked."""
    desk.care.take(desk.patient, typed.get("take", ()))
    desk.note(Act.CHANGED, "profile")
    return desk.to("/settings?done=taken")


@router.post("/patients/{pseudonym}/profile/leave")
def leave(desk: AtDesk) -> Response:
    """Let the profile be as it was."""
    desk.care.leave(desk.patient)
    return desk.to("/settings")


ExampleName = Annotated[str, Query(max_length=1_000)]
Way = Annotated[int, Query(ge=1, le=MOST_WAYS)]


@router.get("/patients/{pseudonym}/preview")
def preview(
    desk: AtDesk, phrases: PhrasesHere, exercise: ExampleName = "", way: Way = 1
) -> HTMLResponse:
    """What the robot will say, with what is typed if that can be."""
    now, tried = desk.care.remembered(desk.patient).settings, _tried(desk)
    known = titles(desk.context)
    examples = _examples(desk, known)
    chosen = exercise if exercise in examples else next(iter(examples), "")
    return desk.page(
        "patients/preview.html",
        lines=_rehearsed(desk, chosen, tried, way) if chosen else (),
        levels=[desk.pages.say(words) for words in kinds.LEVEL_WORDS],
        settings=tried,
        is_draft=tried != now,
        exercises=[(one, known[one]) for one in examples],
        exercise=chosen,
        way=way,
        next_way=way % MOST_WAYS + 1,
        can_be_heard=phrases.can_speak and Modality.SPEECH in tried.modalities,
    )


@router.get("/patients/{pseudonym}/preview/heard")
def heard(
    desk: AtDesk,
    phrases: PhrasesHere,
    exercise: ExampleName,
    way: Way,
    line: Annotated[int, Query(ge=0, le=1_000)],
) -> Response:
    """One line of the preview as sound, as fast and as loud as the settings say."""
    tried = _tried(desk)
    if exercise not in _examples(desk, titles(desk.context)):
        raise HTTPException(404, "no such exercise")
    said = [one.said for one in _rehearsed(desk, exercise, tried, way)][line : line + 1]
    if not said or not said[0]:
        raise HTTPException(404, "nothing is said there")
    try:
        return Response(phrases.spoken(" ".join(said[0]), tried), media_type=WAV)
    except NoVoiceError:
        raise HTTPException(404, "nothing can be heard") from None


# ---------------------------------------------------------------- within


def _settings(
    desk: Desk, *, done: str = "", faults: Mapping[str, str] | None = None
) -> HTMLResponse:
    now, plan = desk.care.remembered(desk.patient).settings, desk.care.plan(desk.patient)
    typed = {**fields.typed_of(now), **(plan.draft or {})}
    said, wrong, pages = plan.profile or now.profile, faults or {}, desk.pages
    return desk.page(
        "patients/settings.html",
        UNPROCESSABLE if wrong else 200,
        done=done,
        profile=fields.fields(kinds.PROFILE, fields.profile_typed(said), wrong, pages),
        proposals=_proposed(now, plan, pages),
        groups=[
            (pages.say(head), fields.fields(group, typed, wrong, pages))
            for head, group in kinds.GROUPS.items()
        ],
        has_draft=plan.draft is not None,
        before=list(_in_words(plan.before, pages)),
        faults=wrong,
    )


def _proposed(now: Settings, plan: Plan, pages: Pages) -> list[dict[str, object]] | None:
    """What would follow from the profile that was said; None if none was."""
    if plan.profile is None:
        return None
    return [
        {
            "name": one.name,
            "title": setting_name(one.name, pages.language),
            "now": kinds.words_of(one.name, one.now, pages),
            "proposed": kinds.words_of(one.name, one.proposed, pages),
            "is_own": one.is_own,
        }
        for one in proposals(now, plan.profile)
    ]


def _in_words(written: Mapping[str, Any], pages: Pages) -> Iterator[tuple[str, str]]:
    """Each setting's name and value, the profile's one by one."""
    parts: dict[str, Any] = {**written.get("profile", {}), **written}
    for name, value in parts.items():
        if name != "profile":
            yield setting_name(name, pages.language), kinds.words_of(name, value, pages)


def _tried(desk: Desk) -> Settings:
    """The settings as they are typed, if they can be so; else those in use."""
    now, plan = desk.care.remembered(desk.patient).settings, desk.care.plan(desk.patient)
    typed = {**fields.typed_of(now), **(plan.draft or {})}
    meant = fields.settings_of(typed, now, desk.pages)
    return meant if isinstance(meant, Settings) else now


def _examples(desk: Desk, known: Mapping[str, str]) -> list[str]:
    """Exercises to speak about: those assigned, or else all."""
    assigned = desk.care.plan(desk.patient).exercises
    return [one for one in known if one in assigned] or list(known)


def _rehearsed(desk: Desk, name: str, settings: Settings, way: int) -> tuple[Line, ...]:
    """What is said; nothing where the exercise cannot be played with its own tokens."""
    exercise = decode_exercise(desk.context.store.exercise(name).exercise.encode(), name)
    try:
        return rehearse(exercise, settings, way)
    except InvalidError:
        return ()
