"""What is kept of a patient between sessions: the settings, and what the policy has learned.

One JSON object, `maestra.settings/1`. Pure: it decodes bytes that somebody else read.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictInt, ValidationError

from maestra.coaching.difficulty import QUARTERS, Staircase
from maestra.coaching.policies import (
    Adaptive,
    Policy,
    decode_policy,
    encode_policy,
    policy_for,
    rested,
)
from maestra.coaching.session import Session
from maestra.coaching.settings import PolicyName, Settings, decode_settings, encode_settings
from maestra.core.faults import InvalidError
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object

SETTINGS_FORMAT: Final = "maestra.settings/1"


class SettingsJson(BaseModel):
    """A patient's settings as a file."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    format: Annotated[Literal["maestra.settings/1"], Field(description="This format's name.")]
    settings: Annotated[
        dict[str, Any], Field(description="By name; what is not there keeps its default.")
    ]
    policy: Annotated[
        dict[str, Any] | None,
        Field(description="What the policy has learned of the patient, if anything."),
    ] = None
    quarters: Annotated[
        StrictInt | None,
        Field(description="How far up the ladder of difficulties, in quarters of a step.", ge=0),
    ] = None


@dataclass(frozen=True, slots=True)
class Remembered:
    """A patient, as far as the coach knows them."""

    settings: Settings
    policy: Policy | None = None
    quarters: int | None = None
    """How far up the ladder of difficulties; None: where the settings' own is."""

    @property
    def best_policy(self) -> Policy:
        """The one to begin with: what was learned, if the settings still want that."""
        if self.settings.policy is PolicyName.ADAPTIVE and isinstance(self.policy, Adaptive):
            return rested(self.policy)
        return policy_for(self.settings)

    @property
    def staircase(self) -> Staircase:
        """Where the search for the right difficulty stands."""
        settings = self.settings
        stairs = Staircase.at(settings.difficulty, settings.easiest, settings.hardest)
        if self.quarters is None or self.quarters // QUARTERS != stairs.quarters // QUARTERS:
            return stairs
        return replace(stairs, quarters=self.quarters)

    def after(self, session: Session) -> Remembered:
        """The patient once `session` has ended: what was learned, and tokens as hard as suits.

        First attempts that were not right count before those that were: which came when is not
        kept, and so the difficulty rather falls too far than rises too far.
        """
        stairs, tally = self.staircase, session.tally
        for right in [False] * (tally.moves - tally.first_time) + [True] * tally.first_time:
            stairs = stairs.after(right_at_first=right)
        settings = replace(self.settings, difficulty=stairs.difficulty)
        return Remembered(settings, session.policy, stairs.quarters)


def write_remembered(patient: Remembered) -> str:
    """The file."""
    fields: dict[str, object] = {
        "format": SETTINGS_FORMAT,
        "settings": encode_settings(patient.settings),
    }
    if patient.policy is not None:
        fields["policy"] = encode_policy(patient.policy)
    if patient.quarters is not None:
        fields["quarters"] = patient.quarters
    return json.dumps(fields, ensure_ascii=False, indent=1) + "\n"


def read_remembered(content: bytes, file: str = "-") -> Remembered:
    """What a file's bytes say of a patient.

    Raises:
        FormatError: they say nothing of the kind; with every fault.
    """
    fields = decode_object(content, file, 1, SETTINGS_FORMAT)
    try:
        written = SettingsJson.model_validate(fields)
        policy = None if written.policy is None else decode_policy(written.policy)
        return Remembered(decode_settings(written.settings), policy, written.quarters)
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_validation(error, SettingsJson)) from None
    except InvalidError as error:
        raise FormatError(file, 1, error.faults) from None
