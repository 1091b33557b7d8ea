"""Rules as JSON: what docs/schemas/rules-1.schema.json says, and no more.

Each rule is an object whose ``form`` says which form it is; tests and relations of tokens are
tagged alike with ``test`` and ``relation``. A field that has its default value may be left out.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from functools import cache
from typing import Annotated, Any, Final, Literal, TypeAlias, cast

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    TypeAdapter,
    ValidationError,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, ErrorDetails, core_schema

from maestra.core.faults import Fault, InvalidError, shorten
from maestra.core.json_lines import FormatError, decode_object
from maestra.rules.rule import MAX_RULES, Rule

RULES_FORMAT: Final = "maestra.rules/1"


class RulesJson(BaseModel):
    """The rules of an exercise; a play is right when it keeps all of them."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    format: Annotated[Literal["maestra.rules/1"], Field(description="This format's name.")]
    rules: Annotated[
        tuple[Rule, ...],
        Field(max_length=MAX_RULES, description="A conjunction: all of them must hold."),
    ]


@cache
def rule_adapter() -> TypeAdapter[Rule]:
    """Built when the first rule is read or written: it takes longer than all imports."""
    return TypeAdapter(Rule)


class _AsWritten:
    """An annotation: read as it is, described by the rules' schema."""

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        del source, handler
        return core_schema.any_schema()

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        del schema
        return handler(rule_adapter().core_schema)


RuleJson: TypeAlias = Annotated[object, _AsWritten()]
"""A rule within another file's model: what is written, which `decode_rule` reads."""


def encode_rule(rule: Rule) -> dict[str, Any]:
    """The rule as JSON has it; `decode_rule` gives the same rule again."""
    return cast("dict[str, Any]", _tag_first(rule_adapter().dump_python(rule, mode="json")))


def _tag_first(written: object) -> object:
    """The same with each object's tag before its other fields, for people who read it."""
    match written:
        case dict():
            # The tag is each part's last field, after those that must be given.
            fields = list(cast("dict[str, object]", written).items())
            return {name: _tag_first(value) for name, value in (*fields[-1:], *fields[:-1])}
        case list():
            return [_tag_first(part) for part in cast("list[object]", written)]
        case _:
            return written


def decode_rule(written: object) -> Rule:
    """The rule that `written` describes: the parsed JSON, fractions as Decimal.

    Raises:
        InvalidError: it is none; with every fault and its place.
    """
    try:
        return rule_adapter().validate_python(written)
    except ValidationError as error:
        raise InvalidError(faults_of_rule(error, written)) from None


def encode_rules(rules: Sequence[Rule]) -> str:
    """A file of rules, one a line."""
    lines = ",\n  ".join(json.dumps(encode_rule(rule), ensure_ascii=False) for rule in rules)
    return f'{{"format": "{RULES_FORMAT}",\n "rules": [\n  {lines}\n ]}}\n'


def decode_rules(text: bytes, file: str = "-") -> tuple[Rule, ...]:
    """The rules in a file's bytes.

    Raises:
        FormatError: they are none; with every fault.
    """
    fields = decode_object(text, file, 1, RULES_FORMAT)
    try:
        return RulesJson.model_validate(fields).rules
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_rule(error, fields)) from None


def faults_of_rule(error: ValidationError, written: object) -> tuple[Fault, ...]:
    """What pydantic found wrong in `written`, in our words."""
    details = error.errors(include_url=False)
    return tuple(_fault(detail, written) for detail in details)


def _fault(detail: ErrorDetails, written: object) -> Fault:
    where = _path(detail["loc"], written)
    match detail["type"]:
        case "missing":
            return Fault(where, "missing", "a field of this name")
        case "unexpected_keyword_argument" | "extra_forbidden":
            return Fault(where, "unknown field", "a field of this form")
        case "union_tag_not_found":
            tag = str(detail.get("ctx", {})["discriminator"]).strip("'")
            return Fault(_join(where, tag), "missing", "which one it is")
        case "union_tag_invalid":
            context = detail.get("ctx", {})
            tag = str(context["discriminator"]).strip("'")
            found = shorten(cast("str", context["tag"]))
            return Fault(_join(where, tag), found, f"one of {context['expected_tags']}")
        case "value_error":
            return _value_fault(where, detail)
        case _:
            return Fault(where, shorten(detail["input"]), detail["msg"])


def _value_fault(where: str, detail: ErrorDetails) -> Fault:
    """The first fault of a part that refused itself, or what a field expected."""
    error = detail.get("ctx", {})["error"]
    if isinstance(error, InvalidError):
        return error.faults[0].under(where) if where else error.faults[0]
    return Fault(where, shorten(detail["input"]), str(error))


def _path(place: Sequence[int | str], written: object) -> str:
    """The place with dots and brackets; the tags that pydantic puts in are left out."""
    path, here = "", written
    for number, step in enumerate(place):
        if isinstance(step, int):
            path = f"{path}[{step}]"
            here = cast("Sequence[object]", here)[step] if isinstance(here, list | tuple) else None
        elif isinstance(here, dict) and step in here:
            path = _join(path, step)
            here = cast("dict[str, object]", here)[step]
        elif number == len(place) - 1 and isinstance(here, dict) and step not in here.values():
            path = _join(path, step)
    return path


def _join(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name
