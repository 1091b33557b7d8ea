"""The published schemas of the record's files fit the files that are written."""

import gzip
import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from maestra.coaching.ports import PatientId
from maestra.storage.backup import back_up, back_up_keys
from maestra.storage.store import SqlStore
from scripts.write_schemas import schemas
from tests.storage.played import keep_session

ANNA = PatientId("anna")


def validator(name: str) -> Any:  # noqa: ANN401 - jsonschema has no types
    return Draft202012Validator(json.loads(schemas()[f"{name}-1.schema.json"]))


@pytest.fixture
def filled(store: SqlStore) -> SqlStore:
    keep_session(store, ANNA)
    store.save_name(ANNA, "Anna Example")
    store.save_settings(ANNA, json.dumps({"format": "maestra.settings/1", "settings": {}}))
    return store


def test_every_signed_head_is_as_the_schema_says(filled: SqlStore) -> None:
    heads = [json.loads(line) for line in filled.vault.heads()]
    assert {head["kind"] for head in heads} == {"begun", "written"}
    for head in heads:
        validator("head").validate(head)
    assert not validator("head").is_valid({**heads[0], "signature": ""})


def test_a_backup_begins_as_the_schema_says(filled: SqlStore, tmp_path: Path) -> None:
    back_up(filled, tmp_path / "backup.gz")
    with gzip.open(tmp_path / "backup.gz", "rb") as file:
        header = json.loads(file.readline())
    validator("backup").validate(header)
    assert not validator("backup").is_valid({**header, "store": "../keys"})


def test_the_keys_are_as_the_schema_says(filled: SqlStore, tmp_path: Path) -> None:
    back_up_keys(filled, tmp_path / "keys.json")
    keys = json.loads((tmp_path / "keys.json").read_text())
    validator("keys").validate(keys)
    assert len(keys["subjects"]) == 1
    assert not validator("keys").is_valid({**keys, "subjects": {"../x": keys["tags"]}})
    for line in keys["heads"]:
        validator("head").validate(json.loads(line))


def test_everything_of_a_patient_is_as_the_schema_says(filled: SqlStore) -> None:
    everything = json.loads(json.dumps(filled.everything(ANNA)))
    validator("patient").validate(everything)
    assert everything["sessions"][0]["events"]
    filled.save_plan(PatientId("ben"), json.dumps({"exercises": []}))
    validator("patient").validate(json.loads(json.dumps(filled.everything(PatientId("ben")))))
    assert not validator("patient").is_valid({**everything, "address": "here"})
