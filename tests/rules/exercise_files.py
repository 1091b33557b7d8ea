"""Exercise files with something wrong, and what is said of them."""

from __future__ import annotations

import json
from copy import deepcopy
from typing import Any, TypeAlias

import pytest

from maestra.core.json_lines import FormatError
from maestra.rules.exercise_format import decode_exercise

Path: TypeAlias = tuple[str | int, ...]
Fields: TypeAlias = dict[str, Any]


def changed(good: Fields, *changes: tuple[Path, object]) -> bytes:
    """A good exercise with some fields changed."""
    fields: Any = deepcopy(good)
    for path, value in changes:
        within = fields
        for step in path[:-1]:
            within = within[step]
        within[path[-1]] = value
    return json.dumps(fields).encode()


def without(good: Fields, *path: str | int) -> bytes:
    """A good exercise that lacks one field."""
    fields: Any = deepcopy(good)
    within = fields
    for step in path[:-1]:
        within = within[step]
    del within[path[-1]]
    return json.dumps(fields).encode()


def refusal(content: bytes) -> str:
    """What is wrong with a file that is refused, without its place."""
    with pytest.raises(FormatError) as caught:
        decode_exercise(content, "e.json")
    line = str(caught.value)
    assert line.startswith("e.json, line 1: ")
    return line.removeprefix("e.json, line 1: ")
