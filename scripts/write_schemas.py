"""Write docs/schemas from the models that read the files: python scripts/write_schemas.py."""

import json
from pathlib import Path
from typing import Final

from pydantic import BaseModel
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from maestra.coaching.recording import SESSION_FORMAT, StartJson
from maestra.coaching.remembered import SETTINGS_FORMAT, SettingsJson
from maestra.core.formats import DEMONSTRATION_FORMAT, DemonstrationJson
from maestra.language.lexicon_format import WORDS_FORMAT, WordsJson
from maestra.rules.exercise_format import EXERCISE_FORMAT, ExerciseJson
from maestra.rules.rule_json import RULES_FORMAT, RulesJson
from maestra.storage.formats import (
    BACKUP_FORMAT,
    HEAD_FORMAT,
    KEYS_FORMAT,
    PATIENT_FORMAT,
    BackupJson,
    HeadJson,
    KeysJson,
    PatientJson,
)

FOLDER: Final = Path(__file__).parents[1] / "docs" / "schemas"
MODELS: Final[dict[str, type[BaseModel]]] = {
    BACKUP_FORMAT: BackupJson,
    DEMONSTRATION_FORMAT: DemonstrationJson,
    EXERCISE_FORMAT: ExerciseJson,
    HEAD_FORMAT: HeadJson,
    KEYS_FORMAT: KeysJson,
    PATIENT_FORMAT: PatientJson,
    RULES_FORMAT: RulesJson,
    SESSION_FORMAT: StartJson,
    SETTINGS_FORMAT: SettingsJson,
    WORDS_FORMAT: WordsJson,
}
"""Each format with the model that reads it."""


class _Schema(GenerateJsonSchema):
    """What integrators read: no title that repeats a field's name, no name that escapes."""

    def field_title_should_be_set(self, schema: object) -> bool:
        del schema
        return False

    def dict_schema(self, schema: core_schema.DictSchema) -> JsonSchemaValue:
        """Pydantic would let any value stand under a name that does not match the pattern."""
        written = super().dict_schema(schema)
        for pattern, value in written.pop("patternProperties", {}).items():
            written["additionalProperties"] = value
            written.setdefault("propertyNames", {})["pattern"] = pattern
        return written


def main() -> None:
    """Write every schema."""
    FOLDER.mkdir(exist_ok=True)
    for file, content in schemas().items():
        (FOLDER / file).write_text(content, encoding="utf-8")
        print(FOLDER.name, file, sep="/")


def schemas() -> dict[str, str]:
    """The name of each schema's file with its content."""
    return {
        f"{_name(kind)}-{_version(kind)}.schema.json": _content(kind, model)
        for kind, model in MODELS.items()
    }


def _content(kind: str, model: type[BaseModel]) -> str:
    schema = {
        "$schema": GenerateJsonSchema.schema_dialect,
        "$id": f"urn:maestra:{_name(kind)}:{_version(kind)}",
        **model.model_json_schema(schema_generator=_Schema),
        "title": kind,
    }
    return json.dumps(schema, ensure_ascii=False, indent=2) + "\n"


def _name(kind: str) -> str:
    return kind.removeprefix("maestra.").partition("/")[0]


def _version(kind: str) -> str:
    return kind.partition("/")[2]


if __name__ == "__main__":
    main()
