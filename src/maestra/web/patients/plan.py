"""What caregivers intend with a patient: kept sealed beside the settings, as JSON.

The coach knows nothing of it: it is what the pages need so that nothing typed is lost and every
change can be taken back.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from maestra.coaching.fields import STRICT
from maestra.coaching.settings import Profile

PLAN_FORMAT: Final = "maestra.plan/1"
MOST_EXERCISES: Final = 100
"""Assigned to one patient: more than anybody plays, few enough to be read."""

Typed = Mapping[str, tuple[str, ...]]
"""What stands in a form: by field, in order."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What is intended with one patient."""

    __pydantic_config__ = STRICT
    exercises: Annotated[tuple[str, ...], Field(max_length=MOST_EXERCISES)] = ()
    """Assigned, by name."""
    draft: dict[str, tuple[str, ...]] | None = None
    """The settings' form as it was typed, if it is not in use yet."""
    profile: Profile | None = None
    """One that was said, whose defaults have neither been taken nor left."""
    before: dict[str, Any] = field(default_factory=dict[str, Any])
    """What the last change of settings replaced, as `encode_settings` writes it."""


class PlanJson(BaseModel):
    """The plan with its format."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    format: Literal["maestra.plan/1"]
    plan: Plan


_ADAPTER: Final = TypeAdapter(PlanJson)


def write_plan(plan: Plan) -> str:
    """As the record keeps it; `read_plan` gives the same again."""
    return _ADAPTER.dump_json(PlanJson(format=PLAN_FORMAT, plan=plan)).decode()


def read_plan(text: str) -> Plan:
    """What was kept.

    Raises:
        ValueError: it is of another Maestra.
    """
    try:
        return _ADAPTER.validate_json(text).plan
    except ValidationError as error:
        raise ValueError(f"no {PLAN_FORMAT}: {error.error_count()} faults") from None
