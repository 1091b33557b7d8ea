"""What is kept of a patient between sessions: the settings, and what the policy has learned.

One JSON object, `maestra.settings/1`. Pure: it decodes bytes that somebody else read.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from maestra.coaching.policies import (
    Adaptive,
    Policy,
    decode_policy,
    encode_policy,
    policy_for,
    rested,
)
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


@dataclass(frozen=True, slots=True)
class Remembered:
    """A patient, as far as the coach knows them."""

    settings: Settings
    policy: Policy | None = None

    @property
    def best_policy(self) -> Policy:
        """The one to begin with: what was learned, if the settings still want that."""
        if self.settings.policy is PolicyName.ADAPTIVE and isinstance(self.policy, Adaptive):
            return rested(self.policy)
        return policy_for(self.settings)


def write_remembered(patient: Remembered) -> str:
    """The file."""
    fields: dict[str, object] = {
        "format": SETTINGS_FORMAT,
        "settings": encode_settings(patient.settings),
    }
    if patient.policy is not None:
        fields["policy"] = encode_policy(patient.policy)
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
        return Remembered(decode_settings(written.settings), policy)
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_validation(error, SettingsJson)) from None
    except InvalidError as error:
        raise FormatError(file, 1, error.faults) from None
