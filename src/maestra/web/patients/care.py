"""A patient's settings and plan in the record, and every change a caregiver makes to them."""

from __future__ import annotations

import threading
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

from maestra.coaching.ports import PatientId
from maestra.coaching.remembered import Remembered, read_remembered, write_remembered
from maestra.coaching.settings import (
    Profile,
    Settings,
    decode_settings,
    encode_settings,
    settings_for,
)
from maestra.language import Language
from maestra.storage.store import SqlStore
from maestra.web.patients.plan import Plan, Typed, read_plan, write_plan

TOGETHER: Final = (
    frozenset({"level", "least_level", "most_level"}),
    frozenset({"difficulty", "easiest", "hardest"}),
)
"""Settings that bound one another: what is undone or proposed of one is so of all."""

FOLLOWING: Final = (
    "speech_wpm",
    "behaviour",
    "patience_s",
    "level",
    "attempts",
    "errorless",
    "put_back",
    "robot_moves",
    "difficulty",
    "easiest",
    "hardest",
)
"""The settings that `settings_for` works out of a profile; a test compares."""
_FIRST: Final = {group: next(n for n in FOLLOWING if n in group) for group in TOGETHER}

_CHANGING: Final = threading.Lock()
"""Plan and settings are read, changed and written as one; several requests may come at once."""


@dataclass(frozen=True, slots=True)
class Proposal:
    """A setting that follows from what was said about the patient, and is another one now."""

    name: str
    now: object
    """As JSON has it."""
    proposed: object
    is_own: bool
    """Whether a caregiver chose the present one, against what followed from the profile."""


@dataclass(frozen=True, slots=True)
class Care:
    """What is set and intended, patient by patient."""

    store: SqlStore

    def remembered(self, patient: PatientId) -> Remembered:
        """The settings, and what the coach has learned; of whom nothing is kept, the defaults."""
        try:
            kept = self.store.settings(patient)
        except KeyError:
            return Remembered(settings_for(Profile()))
        return read_remembered(kept.encode(), "the settings")

    def plan(self, patient: PatientId) -> Plan:
        """What is intended; nothing, of whom nothing is kept."""
        try:
            return read_plan(self.store.plan(patient))
        except KeyError:
            return Plan()

    def begin(self, patient: PatientId, profile: Profile, language: Language) -> None:
        """Keep a new patient, with the settings that follow from the profile.

        Raises:
            InvalidError: the pseudonym cannot be one.
        """
        settings = settings_for(profile, language)
        self.store.save_settings(patient, write_remembered(Remembered(settings)))

    def keep_draft(self, patient: PatientId, typed: Typed) -> None:
        """Keep the settings' form as it stands; nothing is in use yet."""
        self._plan(patient, draft=dict(typed))

    def forget_draft(self, patient: PatientId) -> None:
        """Let the form be as the settings are."""
        self._plan(patient, draft=None)

    def assign(self, patient: PatientId, exercises: Collection[str]) -> None:
        """Let these be the exercises that the patient plays."""
        self._plan(patient, exercises=tuple(sorted(exercises)))

    def change(self, patient: PatientId, settings: Settings) -> None:
        """Let these be in use from the next session on; `undo` takes it back."""
        with _CHANGING:
            self._change(patient, settings, self.plan(patient))

    def undo(self, patient: PatientId) -> None:
        """Take the last change of settings back; once more takes that back.

        Raises:
            InvalidError: what was before does not go with what is now.
        """
        with _CHANGING:
            plan = self.plan(patient)
            now = encode_settings(self.remembered(patient).settings)
            self._change(patient, decode_settings({**now, **plan.before}), plan)

    def propose(self, patient: PatientId, profile: Profile) -> None:
        """Keep what was said about the patient until its defaults are taken or left.

        Where nothing else would follow, it is in use at once.
        """
        with _CHANGING:
            plan = replace(self.plan(patient), profile=profile)
            settings = self.remembered(patient).settings
            if proposals(settings, profile):
                self.store.save_plan(patient, write_plan(plan))
            else:
                settings = replace(settings, profile=profile)
                self._change(patient, settings, plan, draft=plan.draft)

    def take(self, patient: PatientId, wanted: Collection[str]) -> None:
        """Use the profile that was said, and of what follows from it the settings `wanted`."""
        with _CHANGING:
            plan = self.plan(patient)
            if plan.profile is None:
                return
            settings = self.remembered(patient).settings
            changed = encode_settings(replace(settings, profile=plan.profile))
            for one in proposals(settings, plan.profile):
                if one.name in wanted:
                    changed |= _with_bounds(one.name, _following(settings, plan.profile))
            self._change(patient, decode_settings(changed), plan, draft=plan.draft)

    def leave(self, patient: PatientId) -> None:
        """Let the profile be as it was."""
        self._plan(patient, profile=None)

    def _plan(self, patient: PatientId, **changes: Any) -> None:  # noqa: ANN401 - any field
        with _CHANGING:
            plan = self.plan(patient)
            changed = replace(plan, **changes)
            if changed != plan:
                self.store.save_plan(patient, write_plan(changed))

    def _change(
        self,
        patient: PatientId,
        settings: Settings,
        plan: Plan,
        draft: dict[str, tuple[str, ...]] | None = None,
    ) -> None:
        """Save settings and plan; what was proposed is then settled, and what was typed."""
        known = self.remembered(patient)
        before = _difference(encode_settings(known.settings), encode_settings(settings))
        if before:
            self.store.save_settings(patient, write_remembered(replace(known, settings=settings)))
        settled = replace(plan, draft=draft, profile=None, before=before or plan.before)
        self.store.save_plan(patient, write_plan(settled))


def proposals(settings: Settings, profile: Profile) -> tuple[Proposal, ...]:
    """What else would follow from `profile`: each setting that is another one now."""
    now = encode_settings(settings)
    usual = encode_settings(settings_for(settings.profile, settings.language))
    following = _following(settings, profile)
    found = {name for name, value in following.items() if now[name] != value}
    # Of settings that bound one another the first stands for all.
    for group in TOGETHER:
        if found & group:
            found = (found - group) | {_FIRST[group]}
    return tuple(
        Proposal(
            name, now[name], value, is_own=_with_bounds(name, now) != _with_bounds(name, usual)
        )
        for name, value in following.items()
        if name in found
    )


def _following(settings: Settings, profile: Profile) -> dict[str, Any]:
    """What follows from `profile`, within the bounds of help that were set."""
    written = encode_settings(settings_for(profile, settings.language))
    following = {name: written[name] for name in FOLLOWING}
    following["level"] = min(max(following["level"], settings.least_level), settings.most_level)
    return following


def _with_bounds(name: str, written: Mapping[str, Any]) -> dict[str, Any]:
    """The setting, and those that bound it."""
    group = next((group for group in TOGETHER if name in group), frozenset({name}))
    return {each: written[each] for each in group if each in written}


def _difference(before: Mapping[str, Any], after: Mapping[str, Any]) -> dict[str, Any]:
    """Of `before`, what is otherwise afterwards, with what bounds it."""
    found: dict[str, Any] = {}
    for name, value in before.items():
        if after[name] != value:
            found |= _with_bounds(name, before)
    return found
