"""Literals as JSON: how exercises write what a precondition demands."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Final, TypeAlias, assert_never, cast

from pydantic import BaseModel, ConfigDict, Field, StrictBool, StrictInt, StrictStr
from pydantic.config import JsonDict
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import WithJsonSchema

from maestra.core.board import Cell, Column, Row
from maestra.core.faults import Fault, InvalidError
from maestra.core.formats import encode_attributes
from maestra.core.json_faults import Expecting
from maestra.core.tokens import Attributes, Value, expected_value
from maestra.rules.features import CellFeature, PairFeature, TokenFeature
from maestra.rules.strips.literals import Contains, Literal, Placed, Related, Shows

if TYPE_CHECKING:
    from maestra.rules.features import Feature
    from maestra.rules.strips.vocabulary import Vocabulary


def _value(value: object) -> object:
    if (expected := expected_value(value)) is not None:
        raise ValueError(expected)
    return value


_AnyValue = Annotated[
    object,
    PlainValidator(_value),
    WithJsonSchema({"type": ["number", "string"]}),
]
ShownJson: TypeAlias = dict[StrictStr, _AnyValue]
"""What a token shows: its attributes by name."""
_Pair: TypeAlias = tuple[StrictInt, StrictInt]
_CellJson = Annotated[_Pair, Expecting("a cell, [row, column]")]
_PlacedJson = Annotated[
    StrictBool | StrictInt | _Pair, Expecting("true, a whole number or a cell, [row, column]")
]

_KINDS: Final = (
    ("feature", "value"),
    ("cell", "relation", "converse"),
    ("cell", "feature"),
    ("cell", "shown"),
)
"""The fields that go together."""
_EXPECTED_FIELDS: Final = ", or ".join(" and ".join(kind) for kind in _KINDS)


def _describe_kinds(schema: JsonDict) -> None:
    """Say in the JSON Schema which fields go together; no field has a default then."""
    for described in cast("dict[str, JsonDict]", schema["properties"]).values():
        described.pop("default", None)
    schema["oneOf"] = [{"required": [*kind], "maxProperties": len(kind)} for kind in _KINDS]


class LiteralJson(BaseModel):
    """One demand of a precondition.

    `feature` and `value`: of the move's own cells. `cell`, `relation` and `converse`: some token
    on the cell stands in the relation to the moved one. `cell` and `feature`: some token on the
    cell has the feature. `cell` and `shown`: a token on the cell shows just this.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, json_schema_extra=_describe_kinds)

    feature: Annotated[
        StrictStr,
        Field(
            description="A feature of the exercise: of the move's cells beside `value`, of one "
            "token beside `cell`.",
            examples=["destination", "odd:value"],
        ),
    ] = ""
    value: Annotated[
        _PlacedJson,
        Field(
            description="What the feature of the move's cells must be: a cell for `origin` and "
            "`destination`, a number for a row or column, true for the others.",
            examples=[[1, 1], 2, True],
        ),
    ] = False
    cell: Annotated[_CellJson, Field(description="Where the token must lie.")] = (0, 0)
    relation: Annotated[
        StrictStr,
        Field(description="A feature of two tokens.", examples=["less-than:value"]),
    ] = ""
    converse: Annotated[
        StrictBool,
        Field(
            description="False: the token on the cell is the first and the moved one the second, "
            "as in 'the one there is less than the moved one'. True: the other way round."
        ),
    ] = False
    shown: Annotated[
        ShownJson, Field(description="All attributes that the token on the cell must show.")
    ] = Field(default_factory=dict[str, object])


class LiteralDecoder:
    """Finds the literals of one vocabulary by what JSON says of them."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        """Prepare for `vocabulary`."""
        self._vocabulary = vocabulary

    def place_of(self, written: LiteralJson) -> int:
        """The bit of the literal that is `written`.

        Raises:
            InvalidError: fields that do not go together, or a literal that the vocabulary lacks.
        """
        fields = written.model_fields_set
        if not any(fields == set(kind) for kind in _KINDS):
            found = " and ".join(sorted(fields)) or "no field"
            raise InvalidError([Fault("", found, _EXPECTED_FIELDS)])
        literal = self._literal(written)
        try:
            place = None if literal is None else self._vocabulary.place_of(literal)
        except KeyError:
            place = None
        if place is None or not _same_type(literal, self._vocabulary.literal_at(place)):
            level = self._vocabulary.level.value
            expected = f"a literal over its own features, cells and tokens, at level {level}"
            raise InvalidError([Fault("", "not one of the exercise's literals", expected)])
        return place

    def _literal(self, written: LiteralJson) -> Literal | None:
        """The literal, in the vocabulary or not; None if no feature has the name."""
        fields = written.model_fields_set
        if "value" in fields:
            feature = self._features.get(written.feature)
            return _placed(feature, written.value) if isinstance(feature, CellFeature) else None
        cell = _cell(written.cell)
        if "shown" in fields:
            return Contains(cell, attributes_of(written.shown))
        feature = self._features.get(written.relation or written.feature)
        match feature:
            case PairFeature() if "relation" in fields:
                return Related(cell, feature, written.converse)
            case TokenFeature() if "feature" in fields:
                return Shows(cell, feature)
            case _:
                return None

    @cached_property
    def _features(self) -> dict[str, Feature]:
        return {feature.label: feature for feature in self._vocabulary.features}


def encode_literal(literal: Literal) -> dict[str, object]:
    """A literal as exercises write it."""
    match literal:
        case Placed(feature, value):
            written = encode_cell(value) if isinstance(value, Cell) else value
            return {"feature": feature.label, "value": written}
        case Related(cell, feature, converse):
            return {"cell": encode_cell(cell), "relation": feature.label, "converse": converse}
        case Shows(cell, feature):
            return {"cell": encode_cell(cell), "feature": feature.label}
        case Contains(cell, shown):
            return {"cell": encode_cell(cell), "shown": encode_attributes(shown)}
        case _:
            assert_never(literal)


def encode_cell(cell: Cell) -> list[int]:
    """A cell as all formats write it."""
    return [cell.row, cell.column]


def attributes_of(shown: dict[str, object]) -> Attributes:
    """What a token shows, as `Token` keeps it."""
    return tuple(sorted((name, cast("Value", value)) for name, value in shown.items()))


def _placed(feature: CellFeature, value: bool | int | tuple[int, int]) -> Placed:  # noqa: FBT001 - a yes or no is one of the things it can be
    return Placed(feature, _cell(value) if isinstance(value, tuple) else value)


def _cell(pair: tuple[int, int]) -> Cell:
    return Cell(Row(pair[0]), Column(pair[1]))


def _same_type(one: Literal | None, other: Literal) -> bool:
    """Whether no 1 stands for true, which Python takes to be equal."""
    if isinstance(one, Placed) and isinstance(other, Placed):
        return type(one.value) is type(other.value)
    return True
