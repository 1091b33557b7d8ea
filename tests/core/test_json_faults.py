from typing import Annotated, Any

import pytest
from pydantic import BaseModel, ConfigDict, Field, StrictInt, ValidationError

from maestra.core.faults import Fault, shorten
from maestra.core.json_faults import AtMost, Expecting, faults_of_validation


class Leaf(BaseModel):
    """A model within another."""

    model_config = ConfigDict(extra="forbid")
    size: Annotated[StrictInt, Field(ge=1), Expecting("a size from 1")] = 1


class Tree(BaseModel):
    """All ways to hold another model."""

    model_config = ConfigDict(extra="forbid")
    leaf: Leaf | None = None
    rows: dict[str, tuple[Leaf, ...]] = Field(default_factory=dict[str, tuple[Leaf, ...]])
    few: Annotated[tuple[int, ...] | None, AtMost(2)] = None
    plain: dict[str, Annotated[dict[str, int], Field(max_length=1)]] = Field(
        default_factory=dict[str, dict[str, int]]
    )


def fault_of(fields: dict[str, Any]) -> Fault:
    with pytest.raises(ValidationError) as caught:
        Tree.model_validate(fields)
    (fault,) = faults_of_validation(caught.value, Tree)
    return fault


def test_what_was_expected_is_said_whatever_is_wrong() -> None:
    assert fault_of({"leaf": {"size": 0}}) == Fault("leaf.size", "0", "a size from 1")
    assert fault_of({"leaf": {"size": "x"}}) == Fault("leaf.size", '"x"', "a size from 1")


def test_an_unknown_field_is_told_with_the_known_ones_of_its_own_object() -> None:
    unknown = "unknown field"
    assert fault_of({"x": 1}) == Fault("x", unknown, "one of few, leaf, plain, rows")
    assert fault_of({"leaf": {"x": 1}}) == Fault("leaf.x", unknown, "one of size")
    assert fault_of({"rows": {"leaf": [{}, {"x": 1}]}}) == (
        Fault("rows.leaf[1].x", unknown, "one of size")
    )


def test_a_container_of_another_kind_or_too_full_is_named() -> None:
    assert fault_of({"rows": {"a": 1}}) == Fault("rows.a", "1", "a list")
    assert fault_of({"plain": [1]}) == Fault("plain", "[1]", "a JSON object")
    assert fault_of({"plain": {"a": {"b": 1, "c": 2}}}) == (
        Fault("plain.a", "more than 1", "at most 1")
    )


@pytest.mark.parametrize("value", [[1, 2, 3], ["x"] * 9, {"a": 1, "b": 2, "c": 3}])
def test_too_many_entries_are_one_fault_whatever_they_are(value: object) -> None:
    assert fault_of({"few": value}) == Fault("few", shorten(value), "at most 2 entries")


def test_entries_that_are_not_too_many_are_looked_at() -> None:
    assert Tree.model_validate({"few": [1, 2]}).few == (1, 2)
    assert fault_of({"few": 1}) == Fault("few", "1", "a list")


def test_a_fault_we_have_no_words_for_is_told_in_pydantics() -> None:
    fault = fault_of({"plain": {"a": {"b": "x"}}})
    assert fault.where == "plain.a.b"
    assert "valid integer" in fault.expected
