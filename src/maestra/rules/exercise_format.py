"""Exercises as JSON files: what docs/schemas/exercise-1.schema.json says, and no more."""

import json
from typing import Annotated, Any, Final, Literal, assert_never, cast

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr, ValidationError

from maestra.core.board import Board, Cell, Row
from maestra.core.faults import Fault, InvalidError, refuse
from maestra.core.formats import BoardJson, DeckJson, encode_attributes, encode_deck
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object
from maestra.core.tokens import Attributes, Value
from maestra.rules.exercise import Deletion, GroundedExercise, Provenance
from maestra.rules.features import select_features
from maestra.rules.literals import Contains, Placed, Related, Shows
from maestra.rules.literals import Literal as Condition
from maestra.rules.strips import Action, ActionModel
from maestra.rules.vocabulary import Level, Vocabulary

EXERCISE_FORMAT: Final = "maestra.exercise/1"

_Shown = dict[StrictStr, Any]
_Bits = Annotated[StrictStr, Field(pattern="^[0-9a-f]+$")]
_Count = Annotated[StrictInt, Field(ge=1)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class DeletionJson(_Strict):
    """Literals that one demonstration showed not to be needed."""

    demonstration: Annotated[
        _Count, Field(description="Which one, counted from 1 in the order they were shown.")
    ]
    literals: Annotated[
        _Bits,
        Field(
            description="A hexadecimal bit set over the vocabulary's literals, the lowest bit "
            "the first: the cell features in the order of `features`, then for each goal cell "
            "(level C: each cell) from left to right the relations with their converses, the "
            "features of one token, and what tokens show."
        ),
    ]


class ActionJson(_Strict):
    """One action, move-v-t(from, to), and its precondition."""

    shown: Annotated[_Shown, Field(description="What the moved token shows: its attributes.")]
    step: Annotated[_Count, Field(description="As which move of a play, counted from 1.")]
    seen: Annotated[_Count, Field(description="In how many demonstrations it was shown.")]
    precondition: Annotated[
        tuple[dict[StrictStr, Any], ...],
        Field(
            description="The literals that must hold before it, besides that the token lies on "
            "its origin and the destination is empty. Each is one of: `feature` and `value` "
            "(of the move's cells), `cell` and `relation` and `converse` (some token on the cell "
            "stands in the relation to the moved one, or the moved one to it), `cell` and "
            "`feature` (some token on the cell has it), `cell` and `shown`.",
            examples=[[{"feature": "destination", "value": [1, 1]}]],
        ),
    ]
    deletions: Annotated[
        tuple[DeletionJson, ...],
        Field(description="Which demonstration deleted the other literals of the vocabulary."),
    ]


class ExerciseJson(DeckJson):
    """An exercise as the paper learns it."""

    format: Literal["maestra.exercise/1"]
    kind: Literal["grounded"]
    board: BoardJson
    level: Annotated[
        Literal["A", "B", "C"],
        Field(
            description="What preconditions may speak of: A the move's cells and relations to "
            "tokens in the goal row, B also what those tokens are, C the same over all cells."
        ),
    ]
    features: Annotated[
        tuple[StrictStr, ...],
        Field(description="The features that count, each with the attribute it is taken over."),
    ]
    lengths: Annotated[
        tuple[Annotated[StrictInt, Field(ge=0)], ...],
        Field(min_length=1, description="After how many moves a play may end."),
    ]
    demonstrations: Annotated[_Count, Field(description="How many were shown.")]
    actions: Annotated[
        tuple[ActionJson, ...],
        Field(description="Every action that can ever be applicable; there is no other."),
    ]

    def exercise(self) -> GroundedExercise:
        """The exercise these fields describe.

        Raises:
            InvalidError: they contradict each other; with every fault.
        """
        board = Board(self.board.rows, self.board.columns, Row(self.board.goal_row))
        deck = self.deck()
        vocabulary = Vocabulary(
            board, deck, Level(self.level), select_features(deck, self.features)
        )
        known = {_key(encode_literal(literal)): literal for literal in vocabulary.literals}
        faults: list[Fault] = []
        preconditions: dict[Action, int] = {}
        provenance: dict[Action, Provenance] = {}
        for index, written in enumerate(self.actions):
            where = f"actions[{index}]"
            action = Action(_attributes(written.shown), written.step)
            if action.shown not in vocabulary.index_of_shown:
                expected = "what a token of the deck shows"
                faults.append(Fault(f"{where}.shown", _key(written.shown), expected))
            if action in preconditions:
                faults.append(Fault(where, f"{action.name} twice", "each action once"))
            unknown = [
                Fault(f"{where}.precondition[{place}]", _key(literal), "a literal of its features")
                for place, literal in enumerate(written.precondition)
                if _key(literal) not in known
            ]
            if unknown:
                faults.extend(unknown)
                continue
            literals = [known[_key(literal)] for literal in written.precondition]
            preconditions[action] = vocabulary.bits(literals)
            provenance[action] = Provenance(
                written.seen,
                tuple(
                    Deletion(one.demonstration, int(one.literals, 16)) for one in written.deletions
                ),
            )
        refuse(faults)
        model = ActionModel(vocabulary, preconditions)
        return GroundedExercise(model, provenance, frozenset(self.lengths), self.demonstrations)


def decode_exercise(text: bytes, file: str = "-") -> GroundedExercise:
    """The exercise in a file's bytes.

    Raises:
        FormatError: it is none; with every fault.
    """
    fields = decode_object(text, file, 1, EXERCISE_FORMAT)
    try:
        return ExerciseJson.model_validate(fields).exercise()
    except ValidationError as error:
        raise FormatError(file, 1, faults_of_validation(error, ExerciseJson)) from None
    except InvalidError as error:
        raise FormatError(file, 1, error.faults) from None


def encode_exercise(exercise: GroundedExercise) -> str:
    """The exercise as JSON, an action a line."""
    vocabulary, board = exercise.model.vocabulary, exercise.board
    fields: dict[str, object] = {
        "format": EXERCISE_FORMAT,
        "kind": "grounded",
        "board": {"rows": board.rows, "columns": board.columns, "goal_row": board.goal_row},
        **encode_deck(exercise.deck),
        "level": vocabulary.level.value,
        "features": [feature.label for feature in vocabulary.features],
        "lengths": sorted(exercise.lengths),
        "demonstrations": exercise.demonstrations,
    }
    lines = [f"{json.dumps(name)}: {_dump(value)}" for name, value in fields.items()]
    actions = ",\n  ".join(
        _dump(_encode_action(exercise, action)) for action in exercise.provenance
    )
    lines.append(f'"actions": [\n  {actions}\n ]')
    return "{" + ",\n ".join(lines) + "}\n"


def encode_literal(literal: Condition) -> dict[str, object]:
    """A literal as exercises write it."""
    match literal:
        case Placed(feature, value):
            written = _pair(value) if isinstance(value, Cell) else value
            return {"feature": feature.label, "value": written}
        case Related(cell, feature, converse):
            return {"cell": _pair(cell), "relation": feature.label, "converse": converse}
        case Shows(cell, feature):
            return {"cell": _pair(cell), "feature": feature.label}
        case Contains(cell, shown):
            return {"cell": _pair(cell), "shown": encode_attributes(shown)}
        case _:
            assert_never(literal)


def _encode_action(exercise: GroundedExercise, action: Action) -> dict[str, object]:
    provenance = exercise.provenance[action]
    return {
        "shown": encode_attributes(action.shown),
        "step": action.step,
        "seen": provenance.seen,
        "precondition": [encode_literal(one) for one in exercise.model.precondition(action)],
        "deletions": [
            {"demonstration": one.demonstration, "literals": f"{one.literals:x}"}
            for one in provenance.deletions
        ],
    }


def _attributes(shown: dict[str, object]) -> Attributes:
    return tuple(sorted((name, cast("Value", value)) for name, value in shown.items()))


def _pair(cell: Cell) -> list[int]:
    return [cell.row, cell.column]


def _key(written: object) -> str:
    """The same text for the same JSON, however it was written."""
    return json.dumps(written, sort_keys=True, ensure_ascii=False, default=float)


def _dump(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
