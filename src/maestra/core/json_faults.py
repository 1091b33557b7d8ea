"""What pydantic found wrong, in our words: the field's path, what is there, what should be."""

from collections.abc import Iterator, Mapping, Sized
from dataclasses import dataclass
from itertools import chain
from typing import Final, cast, get_args

from pydantic import BaseModel, GetCoreSchemaHandler, ValidationError
from pydantic_core import CoreSchema, ErrorDetails, core_schema

from maestra.core.faults import Fault, shorten

MAX_FAULTS: Final = 10_000
"""Faults that are put in words: nobody mends so many one by one."""
_CONTAINERS: Final[Mapping[str, str]] = {
    "dict_type": "a JSON object",
    "model_type": "a JSON object",
    "tuple_type": "a list",
}
"""Pydantic's types of error for what holds other fields, each with what was expected."""
_OF_KEY: Final = "[key]"
"""What pydantic ends a place with when an object's name is wrong, not what stands under it."""


@dataclass(frozen=True, slots=True)
class Expecting:
    """An annotation: whatever is wrong with this field is one fault, and `phrase` was expected.

    Not for what holds other fields, whose own faults it would hide.
    """

    phrase: str

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """The field's schema; its errors say `phrase`."""
        return core_schema.custom_error_schema(
            handler(source), custom_error_type="expecting", custom_error_message=self.phrase
        )


@dataclass(frozen=True, slots=True)
class AtMost:
    """An annotation: a list or object with more entries is one fault, its entries unread.

    Pydantic's own limit counts only entries that are right, so that a line of a million wrong
    ones would be a million faults.
    """

    most: int

    def __get_pydantic_core_schema__(
        self, source: object, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        """The field's schema, asked only when there are not too many entries."""
        return core_schema.no_info_before_validator_function(self._check, handler(source))

    def _check(self, value: object) -> object:
        if _entries(value) > self.most:
            raise ValueError(f"at most {self.most} entries")
        return value


def faults_of_validation(error: ValidationError, model: type[BaseModel]) -> tuple[Fault, ...]:
    """Every fault that pydantic found in what should be a `model`; of very many the first."""
    details = error.errors(include_url=False)[:MAX_FAULTS]
    return tuple(_fault(detail, model) for detail in details)


def _fault(detail: ErrorDetails, model: type[BaseModel]) -> Fault:
    place, written, context = detail["loc"], detail["input"], detail.get("ctx", {})
    where = _path(place)
    match detail["type"]:
        case "missing":
            return Fault(where, "missing", "a field of this name")
        case "extra_forbidden":
            known = ", ".join(sorted(_model_at(model, place[:-1]).model_fields))
            return Fault(where, "unknown field", f"one of {known}")
        case "value_error":
            return Fault(where, shorten(written), str(context["error"]))
        case "too_long":
            found = f"more than {context['max_length']}"
            return Fault(where, found, f"at most {context['max_length']}")
        case _:
            expected = _CONTAINERS.get(detail["type"], detail["msg"])
            return Fault(where, shorten(written), expected)


def _entries(value: object) -> int:
    return len(cast("Sized", value)) if isinstance(value, list | dict) else 0


def _path(place: tuple[int | str, ...]) -> str:
    """The place with dots and brackets: ``moves[2].origin``."""
    steps = place[:-1] if place[-1:] == (_OF_KEY,) else place
    path = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in steps)
    return path.removeprefix(".")


def _model_at(model: type[BaseModel], place: tuple[int | str, ...]) -> type[BaseModel]:
    """The model at `place` within `model`; steps into lists and objects change nothing."""
    for step in place:
        if isinstance(step, str) and step in model.model_fields:
            model = next(_models_in(model.model_fields[step].annotation), model)
    return model


def _models_in(annotation: object) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return iter([annotation])
    return chain.from_iterable(map(_models_in, get_args(annotation)))
