"""The fields of rules as JSON has them: which values they take, and what to say of others.

Frozen dataclasses stay what they are; pydantic reads the annotations here at the boundary.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from decimal import Decimal
from typing import Annotated, Any, Final, NewType, TypeAlias, cast

from pydantic import ConfigDict, Field, GetJsonSchemaHandler, StrictBool, StrictInt, StrictStr
from pydantic.functional_serializers import PlainSerializer
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import JsonSchemaValue, WithJsonSchema
from pydantic_core import CoreSchema

from maestra.core.board import MAX_SIDE
from maestra.core.json_faults import Expecting
from maestra.core.text import MAX_TEXT, PLAIN
from maestra.core.tokens import MAX_NUMBER, MAX_TOKENS, Value, expected_value
from maestra.rules.features import TokenFeature
from maestra.rules.registry import PARAMETER_FEATURES, TOKEN_FEATURES

MAX_LISTED: Final = 100
"""Places, tests, letters in one rule: as many as the widest board has cells."""


def _value(value: object) -> Value:
    if (expected := expected_value(value)) is not None:
        raise ValueError(expected)
    return cast("Value", value)


def _number(value: object) -> int | Decimal:
    if isinstance(value, str):
        raise ValueError("a number")  # noqa: TRY004 - pydantic turns only ValueError into a fault
    return cast("int | Decimal", _value(value))


def _plain(value: Value) -> int | float | str:
    """As JSON writes it; the float has the same 15 digits."""
    return float(value) if isinstance(value, Decimal) else value


def _feature(value: object) -> TokenFeature:
    """A feature that exists, from its name and its attribute."""
    written = cast("dict[object, object]", value) if isinstance(value, dict) else {}
    name, attribute = written.get("name"), written.get("attribute")
    if set(written) != {"name", "attribute"} or not (
        isinstance(name, str) and isinstance(attribute, str) and attribute
    ):
        raise ValueError("an object with the texts name and attribute")
    if not _is_feature(name):
        known = ", ".join((*TOKEN_FEATURES, *(f"{family}-K" for family in PARAMETER_FEATURES)))
        raise ValueError(f"a feature: {known}")
    return TokenFeature(name, attribute)


def _written(feature: TokenFeature) -> dict[str, str]:
    return {"name": feature.name, "attribute": feature.attribute}


def _is_feature(name: str) -> bool:
    return name in TOKEN_FEATURES or any(
        name.startswith(f"{family}-") and definition.accepts(name.removeprefix(f"{family}-"))
        for family, definition in PARAMETER_FEATURES.items()
    )


_NUMBER_SCHEMA: Final[JsonSchemaValue] = {
    "type": "number",
    "minimum": -MAX_NUMBER,
    "maximum": MAX_NUMBER,
}
_TEXT_SCHEMA: Final[JsonSchemaValue] = {"type": "string", "maxLength": MAX_TEXT, "pattern": PLAIN}
_SERIALIZED: Final = PlainSerializer(_plain, when_used="json")

Number: TypeAlias = Annotated[
    int | Decimal, PlainValidator(_number), _SERIALIZED, WithJsonSchema(_NUMBER_SCHEMA)
]
Shown: TypeAlias = Annotated[
    Value,
    PlainValidator(_value),
    _SERIALIZED,
    WithJsonSchema({"anyOf": [_NUMBER_SCHEMA, _TEXT_SCHEMA]}),
]
Feature: TypeAlias = Annotated[
    TokenFeature,
    PlainValidator(_feature),
    PlainSerializer(_written, when_used="json"),
    WithJsonSchema(
        {
            "type": "object",
            "properties": {"name": _TEXT_SCHEMA, "attribute": _TEXT_SCHEMA},
            "required": ["name", "attribute"],
            "additionalProperties": False,
        }
    ),
]
Flag: TypeAlias = StrictBool
Name: TypeAlias = Annotated[
    StrictStr,
    Field(min_length=1, max_length=MAX_TEXT, pattern=PLAIN),
    Expecting(f"text of 1 to {MAX_TEXT} characters without control characters"),
]
Letters: TypeAlias = Annotated[
    StrictStr,
    Field(min_length=1, max_length=MAX_LISTED, pattern=PLAIN),
    Expecting(f"1 to {MAX_LISTED} letters"),
]
Amount: TypeAlias = Annotated[
    StrictInt,
    Field(ge=0, le=MAX_TOKENS),
    Expecting(f"a whole number from 0 to {MAX_TOKENS}"),
]
Side: TypeAlias = Annotated[
    StrictInt, Field(ge=1, le=MAX_SIDE), Expecting(f"a whole number from 1 to {MAX_SIDE}")
]
Position = NewType("Position", int)
"""A place on a line: 1 the first, 2 the second..., -1 the last..., 0 the middle."""
Place: TypeAlias = Annotated[
    Position,
    Field(ge=-MAX_SIDE, le=MAX_SIDE, strict=True),
    Expecting(f"a whole number from -{MAX_SIDE} to {MAX_SIDE}"),
]

MEANINGS: Final[dict[str, str]] = {
    "form": "Which form of rule this is.",
    "relation": "How two tokens relate; of a word, the deck's relation that says what it is.",
    "amount": "By how much, how many times, or to what.",
    "among": "Only tokens that pass this test are looked at.",
    "attribute": "What the tokens show, or where they come from: origin:row, origin:column.",
    "column": "A column, from 1 at the left.",
    "comparison": "How the first number or place in an order compares to the second.",
    "condition": "What must be so for the consequence to be asked.",
    "consequence": "What must be so then.",
    "constant": "What is added to the right side of a sum, or multiplies that of a product.",
    "directed": "From the first token to the second only; otherwise either way round.",
    "direction": "Which way the order goes.",
    "extreme": "Which end of the order.",
    "feature": "A feature of one token: its name, its parameter with it, and the attribute.",
    "filling": "Which free goal cell is next.",
    "first": "What comes first: a test, or a place.",
    "follower": "The test of the token that follows.",
    "immediately": "The very next one; otherwise any later one.",
    "left": "The places on the left side.",
    "letters": "A letter for each place: the same letter, the same value.",
    "line": "What first, next and last go by: the goal row, or the order in time.",
    "mirrored": "The column as far from the other side, instead of the same.",
    "name": "A relation that the deck declares.",
    "negated": "That it is not so.",
    "number": "A number; null for as many as there are goal cells.",
    "of": "The test that must fail.",
    "operation": "How the numbers of a side go together.",
    "other": "The attribute of the second token, if another one.",
    "pairs": "Which pairs of places.",
    "position": "A place: 1 the first, 2 the second..., -1 the last..., 0 the middle.",
    "ratio": "The same ratio, instead of the same difference.",
    "reading": "How the model row is read.",
    "repeat": "Again from the start after the last.",
    "right": "The places on the right side.",
    "row": "A storage row, from 1; the goal row is passed over.",
    "second": "What comes second: a test, or a place.",
    "strict": "Ties are wrong.",
    "test": "A test of one token; which one it is.",
    "tests": "A test for each place.",
    "value": "What is shown, or what a word is paired with.",
}
"""What each field means, for the published schema."""


class Strict:
    """A part of a rule: unknown fields of its JSON form are refused, known ones explained."""

    __slots__ = ("_hash",)
    __pydantic_config__ = ConfigDict(extra="forbid")
    _hash: int
    """No field: this class is no dataclass, and no copy takes it along."""

    def __init_subclass__(cls) -> None:
        """Work each hash out once: rules are looked up by the thousand while one is learned.

        A slotted dataclass is made twice, the second time with the `__hash__` of its fields.
        """
        work_out = cast("Callable[[Strict], int] | None", cls.__dict__.get("__hash__"))
        if work_out is None:
            return

        def remembered(self: Strict) -> int:
            try:
                return self._hash
            except AttributeError:
                found = work_out(self)
                object.__setattr__(self, "_hash", found)
                return found

        type.__setattr__(cls, "__hash__", remembered)

    @classmethod
    def __get_pydantic_json_schema__(
        cls, core_schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """The fields with their meanings; the tag is always written."""
        schema = handler(core_schema)
        resolved = handler.resolve_ref_schema(schema)
        for name, field in cast("dict[str, dict[str, Any]]", resolved["properties"]).items():
            field.setdefault("description", MEANINGS[name])
        tag = next(field.name for field in fields(cast("Any", cls)) if field.kw_only)
        resolved["required"] = [*resolved.get("required", []), tag]
        return schema
