"""English: what a report on progress says."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

REPORT: Final[Mapping[str, str]] = MappingProxyType(
    {
        "title": "Progress of {patient}",
        "nothing-yet": "No session has been played yet.",
        "exercise": "Exercise",
        "session": "Session",
        "sessions": "Sessions",
        "begun": "Begun",
        "completion": "Done",
        "completed": "yes",
        "broken-off": "no",
        "steps": "Steps",
        "first-attempts": "Right at once",
        "reaction": "Reaction",
        "assistance": "Help",
        "lasted": "Lasted",
        "trend": "Trend",
        "rising": "rising",
        "falling": "falling",
        "steady": "no clear trend",
        "too-few": "too few sessions",
        "percent": "{number} %",
        "seconds": "{number} s",
        "minutes": "{number} min",
        "level": "{number} of 5",
        "how-to-read": (
            "Right at once: steps that the patient made without a refused attempt "
            "before. Reaction: median time from the patient's turn until a token is "
            "lifted. Help: mean level from 0 (none) to 5 (the robot places the token), "
            "the highest of each step."
        ),
    }
)
