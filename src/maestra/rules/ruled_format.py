"""Exercises made of rules, as JSON: the kind "ruled" of `maestra.exercise/1`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from decimal import Decimal
from functools import partial
from typing import Annotated, Literal, cast

from pydantic import BaseModel, ConfigDict, Field, StrictStr
from pydantic.functional_validators import PlainValidator
from pydantic.json_schema import WithJsonSchema

from maestra.core.faults import Fault, InvalidError, attempt, refuse
from maestra.core.formats import BoardJson, encode_deck
from maestra.core.json_faults import AtMost, Expecting
from maestra.rules.evidence_format import EvidenceJson, encode_evidence, json_text, list_field
from maestra.rules.exercise import (
    MAX_ALTERNATIVES,
    MAX_SAFE_RULES,
    Alternative,
    LearnStatus,
    MeantRule,
    RuledExercise,
)
from maestra.rules.picture_format import PicturedJson
from maestra.rules.rule import MAX_RULES, Rule
from maestra.rules.rule_json import RuleJson, decode_rule, encode_rule


def _share(value: object) -> float:
    is_number = isinstance(value, int | Decimal) and not isinstance(value, bool)
    if not is_number:
        raise ValueError("a number from 0 to 1")
    return float(cast("int | Decimal", value))


_Share = Annotated[
    float,
    PlainValidator(_share),
    WithJsonSchema({"type": "number", "minimum": 0, "maximum": 1}),
]
_Rules = Annotated[
    tuple[RuleJson, ...],
    Field(max_length=MAX_RULES, description="A conjunction: all of them must hold."),
    AtMost(MAX_RULES),
]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class MeantRuleJson(_Strict):
    """One of the exercise's rules."""

    id: Annotated[
        StrictStr,
        Field(description="A stable name; unique in the file.", examples=["increasing-value"]),
    ]
    rule: Annotated[RuleJson, Field(description="The rule, as `maestra.rules/1` writes it.")]
    confidence: Annotated[_Share, Field(description="How likely it is that it is meant.")]

    def meant(self) -> MeantRule:
        """The rule.

        Raises:
            InvalidError: it is none; with every fault.
        """
        faults: list[Fault] = []
        rule = attempt(partial(decode_rule, self.rule), faults, "rule")
        if rule is None:
            raise InvalidError(faults)
        return MeantRule(self.id, rule, self.confidence)


class AlternativeJson(_Strict):
    """Other rules that may be meant instead."""

    rules: _Rules
    weight: Annotated[_Share, Field(description="How likely it is that just these are meant.")]

    def alternative(self) -> Alternative:
        """The alternative.

        Raises:
            InvalidError: it has something that is no rule; with every fault.
        """
        faults: list[Fault] = []
        rules = _rules(self.rules, faults, "rules")
        refuse(faults)
        return Alternative(rules, self.weight)


class RuledJson(PicturedJson):
    """An exercise made of rules: a play that keeps all of them is right."""

    format: Annotated[
        Literal["maestra.exercise/1"],
        Field(description="The name and version of this format."),
    ]
    kind: Annotated[
        Literal["ruled"], Field(description="How the exercise is described: here by rules.")
    ]
    board: Annotated[BoardJson, Field(description="The board it was taught on.")]
    status: Annotated[
        Literal["learned", "ambiguous", "outside", "contradictory", "told"],
        Expecting("one of learned, ambiguous, outside, contradictory, told"),
        Field(
            description="What learning came to: `learned`; `ambiguous`, several exercises explain "
            "what was shown; `outside`, no simple rule does; `contradictory`, nothing agrees with "
            "all that was shown and answered; `told`, the rules were said in words."
        ),
    ]
    confidence: Annotated[
        _Share, Field(description="How likely it is that just these rules are meant.")
    ]
    rules: Annotated[
        tuple[MeantRuleJson, ...],
        Field(max_length=MAX_RULES, description="All that a right play keeps."),
        AtMost(MAX_RULES),
    ]
    safe: Annotated[
        tuple[RuleJson, ...],
        Field(
            max_length=MAX_SAFE_RULES,
            description="Rules so strict that what keeps them is right whatever is meant.",
        ),
        AtMost(MAX_SAFE_RULES),
    ]
    alternatives: Annotated[
        tuple[AlternativeJson, ...],
        Field(
            max_length=MAX_ALTERNATIVES,
            description="Other exercises that may be meant, likeliest first.",
        ),
        AtMost(MAX_ALTERNATIVES),
    ] = ()
    evidence: Annotated[
        EvidenceJson, Field(description="The demonstrations, answers and exams it rests on.")
    ] = EvidenceJson()

    def exercise(self) -> RuledExercise:
        """The exercise these fields describe.

        Raises:
            InvalidError: they contradict each other; with every fault of the parts, or else
                every fault of the whole.
        """
        faults: list[Fault] = []
        board = attempt(self.board.board, faults, "board")
        deck = attempt(self.deck, faults)
        rules = [
            attempt(one.meant, faults, f"rules[{index}]") for index, one in enumerate(self.rules)
        ]
        safe = _rules(self.safe, faults, "safe")
        alternatives = [
            attempt(one.alternative, faults, f"alternatives[{index}]")
            for index, one in enumerate(self.alternatives)
        ]
        evidence = attempt(self.evidence.evidence, faults, "evidence")
        if board is None or deck is None or evidence is None or faults:
            raise InvalidError(faults)
        return RuledExercise(
            board,
            deck,
            tuple(one for one in rules if one is not None),
            self.confidence,
            LearnStatus(self.status),
            safe,
            tuple(one for one in alternatives if one is not None),
            evidence,
        )


def encode_ruled(exercise: RuledExercise) -> str:
    """The exercise as JSON, a rule, demonstration or answer a line."""
    board = exercise.board
    head: dict[str, object] = {
        "format": "maestra.exercise/1",
        "kind": "ruled",
        "board": {"rows": board.rows, "columns": board.columns, "goal_row": board.goal_row},
        **encode_deck(exercise.deck),
        "status": exercise.status.value,
        "confidence": exercise.confidence,
    }
    rules = [
        {"id": one.id, "rule": encode_rule(one.rule), "confidence": one.confidence}
        for one in exercise.rules
    ]
    alternatives = [
        {"rules": [encode_rule(rule) for rule in one.rules], "weight": one.weight}
        for one in exercise.alternatives
    ]
    lines = [f"{json.dumps(name)}: {json_text(value)}" for name, value in head.items()]
    lines += [
        list_field("rules", [json_text(one) for one in rules]),
        list_field("safe", [json_text(encode_rule(rule)) for rule in exercise.safe]),
        list_field("alternatives", [json_text(one) for one in alternatives]),
        f'"evidence": {encode_evidence(exercise.evidence)}',
    ]
    return "{" + ",\n ".join(lines) + "}\n"


def _rules(written: Sequence[object], faults: list[Fault], where: str) -> tuple[Rule, ...]:
    """The rules; what is none goes to `faults`."""
    rules = [
        attempt(partial(decode_rule, one), faults, f"{where}[{index}]")
        for index, one in enumerate(written)
    ]
    return tuple(rule for rule in rules if rule is not None)
