"""The keys of what a report on a patient's progress says."""

from __future__ import annotations

from enum import Enum


class ReportKey(Enum):
    """A heading or a word of a report; each language has each."""

    TITLE = "title"
    NOTHING_YET = "nothing-yet"
    EXERCISE = "exercise"
    SESSION = "session"
    SESSIONS = "sessions"
    BEGUN = "begun"
    COMPLETION = "completion"
    COMPLETED = "completed"
    BROKEN_OFF = "broken-off"
    STEPS = "steps"
    FIRST_ATTEMPTS = "first-attempts"
    REACTION = "reaction"
    ASSISTANCE = "assistance"
    LASTED = "lasted"
    TREND = "trend"
    RISING = "rising"
    FALLING = "falling"
    STEADY = "steady"
    TOO_FEW = "too-few"
    PERCENT = "percent"
    SECONDS = "seconds"
    MINUTES = "minutes"
    LEVEL = "level"
    HOW_TO_READ = "how-to-read"
