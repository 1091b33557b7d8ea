"""The published schema says what the reader does, as far as a schema can."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from jsonschema import Draft202012Validator

from maestra.core.demonstration import Demonstration
from maestra.core.formats import decode_demonstration, encode_demonstration
from scripts.write_schemas import FOLDER, schemas
from tests.core.bad_lines import LINE, WRONG_PLAY, WRONG_SHAPE
from tests.strategies import demonstrations

EXAMPLES = Path(__file__).parents[2] / "examples"
SCHEMA: dict[str, Any] = json.loads(schemas()["demonstration-1.schema.json"])
VALIDATOR: Any = Draft202012Validator(SCHEMA)


def test_the_published_schemas_are_those_of_the_models() -> None:
    published = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.iterdir()}
    assert published == schemas(), "run: make schemas"


@pytest.mark.parametrize("file", sorted(schemas()))
def test_each_schema_is_one_and_has_a_name(file: str) -> None:
    schema = json.loads(schemas()[file])
    Draft202012Validator.check_schema(schema)
    assert schema["$id"] == f"urn:maestra:{file.removesuffix('.schema.json').replace('-', ':')}"
    assert schema["title"].startswith("maestra.")


def fields_of(schema: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Each named field of `schema` and of its parts."""
    for part in (schema, *schema.get("$defs", {}).values()):
        yield from part.get("properties", {}).items()


@pytest.mark.parametrize("file", sorted(schemas()))
def test_each_field_is_described(file: str) -> None:
    fields = list(fields_of(json.loads(schemas()[file])))
    assert fields
    assert [name for name, field in fields if "description" not in field] == []


def test_the_documented_line_is_valid() -> None:
    assert VALIDATOR.is_valid(json.loads(LINE))


@given(demonstrations())
def test_every_demonstration_is_written_as_the_schema_says(shown: Demonstration) -> None:
    VALIDATOR.validate(json.loads(encode_demonstration(shown)))


@pytest.mark.parametrize(
    "line", [case[1] for case in WRONG_SHAPE], ids=[case[0] for case in WRONG_SHAPE]
)
def test_a_line_of_another_shape_is_refused_by_the_schema_too(line: bytes) -> None:
    assert not VALIDATOR.is_valid(json.loads(line))


@pytest.mark.parametrize(
    "line", [case[1] for case in WRONG_PLAY], ids=[case[0] for case in WRONG_PLAY]
)
def test_fields_that_contradict_each_other_are_beyond_a_schema(line: bytes) -> None:
    assert VALIDATOR.is_valid(json.loads(line))


def test_the_examples_in_the_schema_are_examples() -> None:
    only_one_field: Any = Draft202012Validator({**SCHEMA, "required": []})
    examples = [
        {name: example}
        for name, field in SCHEMA["properties"].items()
        for example in field.get("examples", [])
    ]
    assert examples
    assert all(only_one_field.is_valid(example) for example in examples)


def test_optional_fields_have_the_defaults_of_the_schema() -> None:
    shown = decode_demonstration(LINE)
    spelled_out = {
        name: field["default"]
        for name, field in SCHEMA["properties"].items()
        if "default" in field
    }
    assert spelled_out
    assert decode_demonstration(json.dumps(json.loads(LINE) | spelled_out).encode()) == shown
