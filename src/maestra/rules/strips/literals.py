"""What a precondition can demand: literals, and their notation in the paper's figures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias, assert_never

from maestra.core.board import Cell
from maestra.core.tokens import LETTER

if TYPE_CHECKING:
    from maestra.core.tokens import Attributes, Value
    from maestra.rules.features import CellFeature, PairFeature, TokenFeature
    from maestra.rules.registry import CellValue


@dataclass(frozen=True, slots=True)
class Placed:
    """The move's cells have `feature` with this `value`: ``to = l11``."""

    feature: CellFeature
    value: CellValue


@dataclass(frozen=True, slots=True)
class Related:
    """Some token on `cell` stands in the relation to the moved one.

    As it stands, ``exists v' (contains(cell, v') and R(v', v))``; as its converse, ``R(v, v')``.
    """

    cell: Cell
    feature: PairFeature
    converse: bool


@dataclass(frozen=True, slots=True)
class Shows:
    """Some token on `cell` has the feature: ``exists v' (contains(cell, v') and odd(v'))``."""

    cell: Cell
    feature: TokenFeature


@dataclass(frozen=True, slots=True)
class Contains:
    """A token on `cell` shows just this: ``contains(cell, v19)``."""

    cell: Cell
    shown: Attributes


Literal: TypeAlias = Placed | Related | Shows | Contains


def symbol(shown: Attributes) -> str:
    """A token in formulas: ``v19`` for the value 19, ``C`` for a letter, else all it shows."""
    return "-".join(_symbol(name, value) for name, value in shown) or "token"


def formula(literal: Literal, shown: Attributes) -> str:
    """The literal in the paper's notation, for the action that moves a token showing `shown`."""
    moved = symbol(shown)
    match literal:
        case Placed(feature, value):
            return _placed_formula(feature, value)
        case Related(cell, feature, converse):
            terms = f"{moved}, v'" if converse else f"v', {moved}"
            return f"∃v' (contains({cell.name}, v') ∧ {feature.name}({terms}))"
        case Shows(cell, feature):
            return f"∃v' (contains({cell.name}, v') ∧ {feature.name}(v'))"
        case Contains(cell, other):
            return f"contains({cell.name}, {symbol(other)})"
        case _:
            assert_never(literal)


def _symbol(name: str, value: Value) -> str:
    if isinstance(value, str):
        return value if name == LETTER else value.replace(" ", "-")
    return f"v{value}" if name == "value" else f"{name}{value}"


def _placed_formula(feature: CellFeature, value: CellValue) -> str:
    match feature.name:
        case "origin":
            return f"from = {_name(value)}"
        case "destination":
            return f"to = {_name(value)}"
        case "from-storage":
            return "storage(from)"
        case "to-goal-row":
            return "goal(to)"
        case "same-column":
            return "same-column(from, to)"
        case _:
            aspect = feature.name.rpartition("-")[2]
            side = "from" if feature.name.startswith("origin") else "to"
            return f"{aspect}({side}) = {value}"


def _name(value: CellValue) -> str:
    return value.name if isinstance(value, Cell) else str(value)
