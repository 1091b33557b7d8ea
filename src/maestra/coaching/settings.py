"""What a caregiver sets before a session: the paper's first loop, and what follows from it.

The caregiver says what the patient can and cannot do (`Profile`); `settings_for` works a default
for every setting out of it, and each can then be set otherwise. No default is a medical fact:
they are our assumptions, listed with the reasons in docs/explanation/the-coach.md. The plain
explanation of each setting and of each of its values is in `language.coach_settings`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Final, cast

from pydantic import Field, StrictBool, StrictInt, TypeAdapter

from maestra.coaching.difficulty import Difficulty
from maestra.coaching.fields import MAX_LEVEL, STRICT, Level, Milliseconds, decode
from maestra.core.faults import Fault, refuse
from maestra.core.json_faults import Expecting
from maestra.language import Language

SLOWEST_WPM: Final = 110
FASTEST_WPM: Final = 180
"""Words a minute that older listeners follow."""
MOST_ATTEMPTS: Final = 10
SHORTEST_PATIENCE_S: Final = 5
LONGEST_PATIENCE_S: Final = 120
MOST_ROUNDS: Final = 20


class Mental(Enum):
    """How far thinking and remembering are impaired."""

    NONE = "none"
    VERY_MILD = "very-mild"
    MILD = "mild"
    MODERATE = "moderate"
    SEVERE = "severe"


class Physical(Enum):
    """How far moving is impaired."""

    NONE = "none"
    SLIGHT = "slight"
    MARKED = "marked"


class Hand(Enum):
    """Which hand moves tokens."""

    LEFT = "left"
    RIGHT = "right"


class Reach(Enum):
    """How far the hand gets."""

    WHOLE_BOARD = "whole-board"
    NEAR_ROWS = "near-rows"


class Modality(Enum):
    """A way in which the robot makes itself understood."""

    SPEECH = "speech"
    TEXT = "text"
    GESTURE = "gesture"


class Behaviour(Enum):
    """How the robot begins, before it knows the patient."""

    CHALLENGING = "challenging"
    NEUTRAL = "neutral"
    HELPING = "helping"


class Persona(Enum):
    """What the robot puts first."""

    HUMAN_CENTRED = "human-centred"
    """It waits and encourages."""
    EXERCISE_CENTRED = "exercise-centred"
    """It drives on."""


class Helper(Enum):
    """Who puts a wrong token back."""

    ROBOT = "robot"
    PATIENT = "patient"
    CAREGIVER = "caregiver"


class PolicyName(Enum):
    """How the robot decides how much to help."""

    FIXED = "fixed"
    LADDER = "ladder"
    ADAPTIVE = "adaptive"


@dataclass(frozen=True, slots=True)
class Profile:
    """What a patient can and cannot do."""

    __pydantic_config__ = STRICT
    mental: Mental = Mental.NONE
    physical: Physical = Physical.NONE
    hand: Hand = Hand.RIGHT
    reach: Reach = Reach.WHOLE_BOARD


_Wpm = Annotated[
    StrictInt,
    Field(ge=SLOWEST_WPM, le=FASTEST_WPM),
    Expecting(f"{SLOWEST_WPM} to {FASTEST_WPM} words a minute"),
]
_Volume = Annotated[StrictInt, Field(ge=0, le=100), Expecting("0 to 100 percent")]
_Patience = Annotated[
    StrictInt,
    Field(ge=SHORTEST_PATIENCE_S, le=LONGEST_PATIENCE_S),
    Expecting(f"{SHORTEST_PATIENCE_S} to {LONGEST_PATIENCE_S} seconds"),
]
_Attempts = Annotated[
    StrictInt, Field(ge=1, le=MOST_ATTEMPTS), Expecting(f"1 to {MOST_ATTEMPTS} attempts")
]
_Rounds = Annotated[
    StrictInt, Field(ge=1, le=MOST_ROUNDS), Expecting(f"1 to {MOST_ROUNDS} rounds")
]


@dataclass(frozen=True, slots=True)
class Settings:
    """Everything that a caregiver can set; kept with each session.

    Raises:
        InvalidError: levels that exclude one another, or no way to be understood.
    """

    __pydantic_config__ = STRICT
    profile: Profile = field(default_factory=Profile)
    language: Language = Language.EN
    speech_wpm: _Wpm = 150
    volume: _Volume = 80
    modalities: tuple[Modality, ...] = (Modality.SPEECH, Modality.TEXT, Modality.GESTURE)
    behaviour: Behaviour = Behaviour.NEUTRAL
    persona: Persona = Persona.HUMAN_CENTRED
    put_back: Helper = Helper.PATIENT
    robot_moves: StrictBool = False
    """Whether the robot may move tokens."""
    errorless: StrictBool = False
    """The hint comes before an error can happen."""
    attempts: _Attempts = 4
    """After so many the robot shows the token itself."""
    patience_s: _Patience = 15
    """Silence before each prompt; never a limit."""
    policy: PolicyName = PolicyName.ADAPTIVE
    level: Level = 1
    """Of the policy `fixed`, and where the others begin."""
    least_level: Level = 0
    most_level: Level = MAX_LEVEL
    rounds: _Rounds = 1
    """Plays in a sitting."""
    one_switch: StrictBool = False
    """One key, or a touch anywhere, is enough: rows and cells are offered one after another."""
    show_score: StrictBool = False
    """Whether the patient sees how many moves were right."""
    difficulty: Difficulty = field(default_factory=Difficulty)
    """Of the tokens, where the exercise's rules fit others."""
    easiest: Difficulty = field(default_factory=Difficulty.easiest)
    hardest: Difficulty = field(default_factory=Difficulty.hardest)

    def __post_init__(self) -> None:
        """Put the modalities in order and refuse what cannot be, naming every fault."""
        wanted = tuple(one for one in Modality if one in self.modalities)
        object.__setattr__(self, "modalities", wanted)
        faults = [] if wanted else [Fault("modalities", "none", "speech, text or gesture")]
        if not self.least_level <= self.level <= self.most_level:
            expected = f"from least_level to most_level, {self.least_level} to {self.most_level}"
            faults.append(Fault("level", str(self.level), expected))
        if not self.difficulty.is_between(self.easiest, self.hardest):
            expected = "no easier than `easiest` and no harder than `hardest`"
            faults.append(Fault("difficulty", str(self.difficulty), expected))
        refuse(faults)

    @property
    def patience(self) -> Milliseconds:
        """Silence before each prompt."""
        return Milliseconds(1000 * self.patience_s)

    @property
    def ready_helpers(self) -> tuple[Helper, ...]:
        """Who puts a wrong token back: the chosen one first, then the fall-backs in turn."""
        able = [one for one in Helper if one is not Helper.ROBOT or self.robot_moves]
        chosen = able.index(self.put_back) if self.put_back in able else 0
        return (*able[chosen:], *able[:chosen])


@dataclass(frozen=True, slots=True)
class _Mentally:
    """What follows from a mental impairment."""

    behaviour: Behaviour
    level: int
    patience_s: int
    speech_wpm: int
    attempts: int
    hardest: Difficulty


_BY_MENTAL: Final = MappingProxyType(
    {
        Mental.NONE: _Mentally(Behaviour.CHALLENGING, 0, 15, 150, 4, Difficulty(3, 5)),
        Mental.VERY_MILD: _Mentally(Behaviour.NEUTRAL, 1, 15, 150, 4, Difficulty(3, 4)),
        Mental.MILD: _Mentally(Behaviour.NEUTRAL, 1, 15, 140, 4, Difficulty(2, 4)),
        Mental.MODERATE: _Mentally(Behaviour.HELPING, 2, 20, 130, 3, Difficulty(2, 3)),
        Mental.SEVERE: _Mentally(Behaviour.HELPING, 3, 25, 110, 2, Difficulty(1, 2)),
    }
)
_PATIENCE_FOR_HANDS_S: Final = MappingProxyType(
    {Physical.NONE: 0, Physical.SLIGHT: 5, Physical.MARKED: 10}
)
"""A slower hand needs longer before silence means anything."""


def settings_for(profile: Profile, language: Language = Language.EN) -> Settings:
    """The defaults for a patient; each may be set otherwise.

    The more thinking is impaired, the more the robot helps from the beginning, the sooner it
    shows a token, the slower it speaks and the easier tokens may get; severely: without errors.
    The more moving is impaired, the longer it waits, and where it is markedly so the robot moves
    tokens, if there is one that can.
    """
    mentally = _BY_MENTAL[profile.mental]
    marked = profile.physical is Physical.MARKED
    easiest, hardest = Difficulty.easiest(), mentally.hardest
    return Settings(
        profile=profile,
        language=language,
        speech_wpm=mentally.speech_wpm,
        behaviour=mentally.behaviour,
        put_back=Helper.ROBOT if marked else Helper.PATIENT,
        robot_moves=marked,
        errorless=profile.mental is Mental.SEVERE,
        attempts=mentally.attempts,
        patience_s=mentally.patience_s + _PATIENCE_FOR_HANDS_S[profile.physical],
        level=mentally.level,
        difficulty=Difficulty(min(2, hardest.digits), min(2, hardest.similarity)),
        easiest=easiest,
        hardest=hardest,
    )


@cache
def _adapter() -> TypeAdapter[Settings]:
    return TypeAdapter(Settings)


def encode_settings(settings: Settings) -> dict[str, Any]:
    """The settings as JSON has them; `decode_settings` gives the same again."""
    return cast("dict[str, Any]", _adapter().dump_python(settings, mode="json"))


def decode_settings(written: object) -> Settings:
    """The settings that the parsed JSON describes.

    Raises:
        InvalidError: it describes none; with every fault and its place.
    """
    return decode(_adapter(), written)
