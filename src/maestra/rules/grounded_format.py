"""Exercises as the paper learns them, as JSON: the kind "grounded" of `maestra.exercise/1`."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr

from maestra.core.demonstration import MAX_MOVES
from maestra.core.faults import Fault, InvalidError, attempt, refuse, shorten
from maestra.core.formats import BoardJson, encode_attributes, encode_deck
from maestra.core.json_faults import Expecting
from maestra.rules.exercise import Deletion, GroundedExercise, Provenance
from maestra.rules.features import Feature, labelled_feature
from maestra.rules.picture_format import PicturedJson
from maestra.rules.strips.actions import Action, ActionModel
from maestra.rules.strips.literal_format import (
    LiteralDecoder,
    LiteralJson,
    ShownJson,
    attributes_of,
    encode_literal,
)
from maestra.rules.strips.vocabulary import Level, Vocabulary

_Bits = Annotated[
    StrictStr,
    Field(pattern="^[1-9a-f][0-9a-f]*$"),
    Expecting("a hexadecimal number in small letters, without zeros before it"),
]
_Count = Annotated[StrictInt, Field(ge=1), Expecting("a whole number from 1")]
_Moves = Annotated[
    StrictInt, Field(ge=0, le=MAX_MOVES), Expecting(f"a whole number from 0 to {MAX_MOVES}")
]


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
            "the first: the features of the move's cells in the order of `features`, each with "
            "its values in the board's order; then for each cell of the goal row from the left "
            "(level C: for each cell, row by row) the relations, each before its converse, the "
            "features of one token, and what the tokens show, each different thing once in the "
            "order of their ids. Level A has relations only; `same` and `different` have no "
            "converse.",
            examples=["1f"],
        ),
    ]

    @property
    def bits(self) -> int:
        """The bit set."""
        return int(self.literals, 16)


class ActionJson(_Strict):
    """One action, move-v-t(from, to), and its precondition."""

    shown: Annotated[
        ShownJson,
        Field(
            description="What the moved token shows: all attributes of some token of `tokens`.",
            examples=[{"value": 19}],
        ),
    ]
    step: Annotated[
        _Count, Field(description="As which move of a play, counted from 1, up to the longest.")
    ]
    seen: Annotated[_Count, Field(description="In how many demonstrations it was shown.")]
    precondition: Annotated[
        tuple[LiteralJson, ...],
        Field(
            description="What must hold before it, besides that the token lies on its origin and "
            "that the destination is empty.",
            examples=[[{"feature": "destination", "value": [1, 1]}]],
        ),
    ]
    deletions: Annotated[
        tuple[DeletionJson, ...],
        Field(
            description="Which demonstration deleted which of the other literals of the "
            "vocabulary, in the order of the demonstrations; each literal once."
        ),
    ]

    def learned(self, about: _About) -> tuple[Action, int, Provenance]:
        """The action, its precondition as a bit set, and where that comes from.

        Raises:
            InvalidError: what does not fit the exercise or contradicts itself; with every fault.
        """
        action = Action(attributes_of(self.shown), self.step)
        faults: list[Fault] = []
        if action.shown not in about.vocabulary.index_of_shown:
            expected = "what a token of the exercise shows"
            faults.append(Fault("shown", shorten(self.shown), expected))
        if self.step > about.longest:
            expected = f"at most {about.longest}, the moves of the longest play"
            faults.append(Fault("step", str(self.step), expected))
        left = self._precondition(about, faults)
        faults += self._faults_of_deletions(about)
        refuse(faults)
        deletions = tuple(Deletion(one.demonstration, one.bits) for one in self.deletions)
        total = union = left
        for deletion in deletions:
            total, union = total + deletion.literals, union | deletion.literals
        # Sum and union are the same only of sets that share nothing.
        if not total == union == about.vocabulary.everything:
            expected = "each literal of the vocabulary there, or deleted once"
            refuse([Fault("", "its precondition and deletions do not add up", expected)])
        return action, left, Provenance(self.seen, deletions)

    def _precondition(self, about: _About, faults: list[Fault]) -> int:
        """The literals that are left; what is no literal of the exercise goes to `faults`."""
        left = 0
        for index, written in enumerate(self.precondition):
            where = f"precondition[{index}]"
            place = attempt(partial(about.decoder.place_of, written), faults, where)
            if place is not None and left >> place & 1:
                faults.append(Fault(where, "a literal twice", "each once"))
            elif place is not None:
                left |= 1 << place
        return left

    def _faults_of_deletions(self, about: _About) -> list[Fault]:
        faults: list[Fault] = []
        if self.seen > about.demonstrations:
            faults.append(Fault("seen", str(self.seen), f"at most {about.demonstrations}"))
        if len(self.deletions) > self.seen:
            found, expected = f"{len(self.deletions)} deletions", f"at most {self.seen}, `seen`"
            faults.append(Fault("deletions", found, expected))
        order = [one.demonstration for one in self.deletions]
        for index, (before, now) in enumerate(pairwise([0, *order])):
            if not before < now <= about.demonstrations:
                expected = f"a later demonstration than before, at most {about.demonstrations}"
                faults.append(Fault(f"deletions[{index}].demonstration", str(now), expected))
        return faults


class GroundedJson(PicturedJson):
    """An exercise as the paper learns it: an action for each token and step of a play."""

    format: Annotated[
        Literal["maestra.exercise/1"],
        Field(description="The name and version of this format."),
    ]
    kind: Annotated[
        Literal["grounded"],
        Field(description="How the exercise is described: here by single actions."),
    ]
    board: Annotated[BoardJson, Field(description="The board it is played on.")]
    level: Annotated[
        Literal["A", "B", "C"],
        Expecting("A, B or C"),
        Field(
            description="What preconditions may speak of: A the move's cells and relations to "
            "tokens in the goal row, B also what those tokens are, C the same over all cells."
        ),
    ]
    features: Annotated[
        tuple[StrictStr, ...],
        Field(
            description="The features that count, each with the attribute it is taken over.",
            examples=[["from-storage", "to-goal-row", "destination", "less-than:value"]],
        ),
    ]
    lengths: Annotated[
        tuple[_Moves, ...],
        Field(
            json_schema_extra={"minItems": 1},
            description="After how many moves a play may end.",
            examples=[[5]],
        ),
    ]
    demonstrations: Annotated[_Count, Field(description="How many were shown.")]
    actions: Annotated[
        tuple[ActionJson, ...],
        Field(description="Every action that can ever be applicable; there is no other."),
    ]

    def exercise(self) -> GroundedExercise:
        """The exercise these fields describe.

        Raises:
            InvalidError: they contradict each other; with every fault of the board, the deck and
                the features, or else every fault of the actions.
        """
        vocabulary = self._vocabulary()
        if not self.lengths:
            refuse([Fault("lengths", "nothing", "at least one length of a play")])
        longest = max(self.lengths)
        about = _About(vocabulary, LiteralDecoder(vocabulary), longest, self.demonstrations)
        faults: list[Fault] = []
        preconditions: dict[Action, int] = {}
        provenance: dict[Action, Provenance] = {}
        for index, written in enumerate(self.actions):
            where = f"actions[{index}]"
            learned = attempt(partial(written.learned, about), faults, where)
            if learned is None:
                continue
            action, bits, whence = learned
            if action in preconditions:
                faults.append(Fault(where, f"{action.name} twice", "each action once"))
            preconditions[action], provenance[action] = bits, whence
        refuse(faults)
        model = ActionModel(vocabulary, preconditions)
        return GroundedExercise(model, provenance, frozenset(self.lengths), self.demonstrations)

    def _vocabulary(self) -> Vocabulary:
        faults: list[Fault] = []
        board = attempt(self.board.board, faults, "board")
        deck = attempt(self.deck, faults)
        if board is None or deck is None:
            raise InvalidError(faults)
        features: list[Feature] = []
        for index, label in enumerate(self.features):
            where = f"features[{index}]"
            feature = attempt(partial(labelled_feature, deck, label), faults, where)
            if feature in features:
                faults.append(Fault(where, f"{shorten(label)} twice", "each feature once"))
            elif feature is not None:
                features.append(feature)
        refuse(faults)
        return Vocabulary(board, deck, Level(self.level), tuple(features))


def encode_grounded(exercise: GroundedExercise) -> str:
    """The exercise as JSON, an action a line."""
    vocabulary, board = exercise.model.vocabulary, exercise.board
    fields: dict[str, object] = {
        "format": "maestra.exercise/1",
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


@dataclass(frozen=True, slots=True)
class _About:
    """What an action of an exercise must fit."""

    vocabulary: Vocabulary
    decoder: LiteralDecoder
    longest: int
    """Moves of the longest play."""
    demonstrations: int


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


def _dump(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
