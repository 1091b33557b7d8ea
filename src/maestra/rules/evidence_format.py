"""What an exercise rests on, as JSON: demonstrations, answers to questions, exams."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Annotated, Final, Literal, assert_never, cast

from pydantic import BaseModel, ConfigDict, Field, StrictInt, StrictStr
from pydantic.config import JsonDict

from maestra.core.board import MAX_SIDE
from maestra.core.demonstration import Demonstration
from maestra.core.faults import Fault, InvalidError, attempt, refuse
from maestra.core.formats import (
    DeckJson,
    DemonstrationJson,
    MoveJson,
    encode_demonstration,
    encode_move,
)
from maestra.core.json_faults import AtMost, Expecting
from maestra.core.tokens import TokenId
from maestra.rules.answers import (
    Answer,
    MoveQuestion,
    Question,
    Reply,
    RowQuestion,
    RuleQuestion,
)
from maestra.rules.exercise import Evidence, Exam
from maestra.rules.rule_json import RuleJson, decode_rule, encode_rule
from maestra.rules.setting import Play, Setting, play_of

MAX_KEPT: Final = 10_000
"""Demonstrations, answers or exams: teaching takes some of each."""


_Count = Annotated[StrictInt, Field(ge=0), Expecting("a whole number from 0")]
_Side = Annotated[StrictInt, Field(ge=1, le=MAX_SIDE)]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class ExamJson(_Strict):
    """What came of an exam."""

    date: Annotated[StrictStr, Field(description="When.", examples=["2026-11-22"])]
    plays: Annotated[_Count, Field(description="Shown plays that the exercise holds for right.")]
    agreed: Annotated[_Count, Field(description="How many of them the caregiver called right.")]
    near_misses: Annotated[
        _Count, Field(description="Shown plays that the exercise holds for wrong.")
    ] = 0
    near_misses_agreed: Annotated[
        _Count, Field(description="How many of them the caregiver called wrong.")
    ] = 0

    def exam(self) -> Exam:
        """The exam.

        Raises:
            InvalidError: its numbers cannot be.
        """
        return Exam(self.date, self.plays, self.agreed, self.near_misses, self.near_misses_agreed)


_PARTS: Final = {"row": ("position",), "move": ("position", "move"), "rule": ("rule",)}
"""What a question of each kind is made of."""


def _describe_parts(schema: JsonDict) -> None:
    """Say in the JSON Schema which fields each kind has; no field has a default then."""
    for described in cast("dict[str, JsonDict]", schema["properties"]).values():
        described.pop("default", None)
    schema["oneOf"] = [
        {"properties": _only(kind), "required": [*parts]} for kind, parts in _PARTS.items()
    ]


def _only(kind: str) -> JsonDict:
    """That the kind is this one, and that there is no field of another."""
    own = {*_PARTS[kind], *(("wrong",) if kind == "row" else ())}
    others = [name for name in ("position", "move", "rule", "wrong") if name not in own]
    return {"kind": {"const": kind}, **dict.fromkeys(others, False)}


class AnswerJson(_Strict):
    """A question that a caregiver was asked, and what was said to it.

    A `row` has a finished `position`: is it right? A `move` a position and a `move`: is it right
    here? A `rule` has a `rule`: is it meant?
    """

    model_config = ConfigDict(extra="forbid", frozen=True, json_schema_extra=_describe_parts)

    kind: Annotated[
        Literal["row", "move", "rule"],
        Expecting("row, move or rule"),
        Field(description="What was asked about."),
    ]
    answer: Annotated[
        Literal["yes", "no", "unsure"],
        Expecting("yes, no or unsure"),
        Field(description="What was said."),
    ]
    position: Annotated[
        DemonstrationJson | None, Field(description="The play, or the moves so far.")
    ] = None
    move: Annotated[MoveJson | None, Field(description="The move that goes on from there.")] = None
    rule: Annotated[RuleJson, Field(description="The rule, as `maestra.rules/1` writes it.")] = (
        None
    )
    wrong: Annotated[
        Annotated[tuple[_Side, _Side], Expecting("a cell, [row, column]")] | None,
        Field(description='After a "no" to a row: the goal cell that is said to be wrong.'),
    ] = None

    def answered(self, settings: _Settings) -> Answer:
        """The answer.

        Raises:
            InvalidError: its fields do not go together; with every fault.
        """
        faults: list[Fault] = []
        parts = _PARTS[self.kind]
        for name in ("position", "move", "rule"):
            there = getattr(self, name) is not None
            if there and name not in parts:
                faults.append(Fault(name, "a field", f"none in a question of kind {self.kind}"))
            if name in parts and not there:
                faults.append(Fault(name, "missing", "a field of this name"))
        refuse(faults)
        question = self._question(settings)
        reply = Reply(self.answer)
        return Answer(question, reply, self._wrong(question))

    def _question(self, settings: _Settings) -> Question:
        faults: list[Fault] = []
        question: Question | None
        if self.position is None:
            question = attempt(lambda: RuleQuestion(decode_rule(self.rule)), faults, "rule")
        else:
            position = attempt(partial(settings.play, self.position), faults, "position")
            question = None
            if position is not None and self.move is None:
                question = RowQuestion(position)
            elif position is not None and self.move is not None:
                question = attempt(partial(_move_asked, position, self.move), faults, "move")
        if question is None:
            raise InvalidError(faults)
        return question

    def _wrong(self, question: Question) -> int | None:
        if self.wrong is None:
            return None
        row, column = self.wrong
        if isinstance(question, RowQuestion):
            board = question.play.setting.start.board
            if row != board.goal_row or column > board.columns:
                expected = f"a cell of the goal row, {board.goal_row}"
                refuse([Fault("wrong", str([row, column]), expected)])
        return column - 1


class EvidenceJson(_Strict):
    """What the exercise rests on; teaching goes on from it."""

    demonstrations: Annotated[
        tuple[DemonstrationJson, ...],
        Field(max_length=MAX_KEPT, description="What was shown."),
        AtMost(MAX_KEPT),
    ] = ()
    answers: Annotated[
        tuple[AnswerJson, ...],
        Field(max_length=MAX_KEPT, description="What was asked and answered, in order."),
        AtMost(MAX_KEPT),
    ] = ()
    exams: Annotated[
        tuple[ExamJson, ...],
        Field(max_length=MAX_KEPT, description="How the exercise did when it was examined."),
        AtMost(MAX_KEPT),
    ] = ()

    def evidence(self) -> Evidence:
        """The evidence.

        Raises:
            InvalidError: a part of it cannot be; with every fault.
        """
        faults: list[Fault] = []
        settings = _Settings()
        shown = [
            attempt(partial(settings.demonstration, one), faults, f"demonstrations[{index}]")
            for index, one in enumerate(self.demonstrations)
        ]
        answers = [
            attempt(partial(one.answered, settings), faults, f"answers[{index}]")
            for index, one in enumerate(self.answers)
        ]
        exams = [
            attempt(one.exam, faults, f"exams[{index}]") for index, one in enumerate(self.exams)
        ]
        refuse(faults)
        return Evidence(
            tuple(one for one in shown if one is not None),
            tuple(one for one in answers if one is not None),
            tuple(one for one in exams if one is not None),
        )


def encode_evidence(evidence: Evidence) -> str:
    """The evidence as JSON, a demonstration or answer a line."""
    exams = [
        {
            "date": exam.date,
            "plays": exam.plays,
            "agreed": exam.agreed,
            "near_misses": exam.near_misses,
            "near_misses_agreed": exam.near_misses_agreed,
        }
        for exam in evidence.exams
    ]
    lists = (
        list_field(
            "demonstrations", [encode_demonstration(one) for one in evidence.demonstrations]
        ),
        list_field("answers", [json_text(_encode_answer(one)) for one in evidence.answers]),
        list_field("exams", [json_text(one) for one in exams]),
    )
    return "{" + ",\n ".join(lists) + "}"


def _encode_answer(answer: Answer) -> dict[str, object]:
    question = answer.question
    match question:
        case RowQuestion(play):
            written: dict[str, object] = {"kind": "row", "position": _encode_position(play)}
            if answer.wrong is not None:
                goal_row = play.setting.start.board.goal_row
                written["wrong"] = [goal_row, answer.wrong + 1]
        case MoveQuestion(position, token, cell):
            move = position.after(token, cell).moves()[-1]
            asked = {"position": _encode_position(position), "move": encode_move(move)}
            written = {"kind": "move", **asked}
        case RuleQuestion(rule):
            written = {"kind": "rule", "rule": encode_rule(rule)}
        case _:
            assert_never(question)
    return {**written, "answer": answer.reply.value}


def _encode_position(play: Play) -> object:
    setting = play.setting
    return json.loads(
        encode_demonstration(Demonstration(setting.deck, setting.start, play.moves()))
    )


@dataclass(frozen=True, slots=True)
class _Settings:
    """The starts of the plays of a file: plays from the same one share what is known of it."""

    known: dict[Setting, Setting] = field(default_factory=dict[Setting, Setting])

    def play(self, written: DemonstrationJson) -> Play:
        """The play as the rules see it."""
        shown = written.played(Demonstration, DeckJson.deck)
        setting = Setting(shown.deck, shown.start)
        return play_of(shown, self.known.setdefault(setting, setting))

    def demonstration(self, written: DemonstrationJson) -> Demonstration:
        """The demonstration; one that the rules can see."""
        shown = written.played(Demonstration, DeckJson.deck)
        play_of(shown)
        return shown


def _move_asked(position: Play, written: MoveJson) -> MoveQuestion:
    """The question about a move, if a board could make it."""
    setting = position.setting
    number = setting.number_of.get(TokenId(written.token))
    faults: list[Fault] = []
    if number is None or not position.left >> number & 1:
        faults.append(Fault("token", written.token, "a token that lies in storage"))
    elif written.origin != _pair(setting, number):
        expected = f"{list(_pair(setting, number))}, where it lies"
        faults.append(Fault("origin", str(list(written.origin)), expected))
    row, column = written.destination
    if row != setting.start.board.goal_row or column - 1 not in position.free:
        faults.append(Fault("destination", str([row, column]), "an empty goal cell"))
    if number is None or faults:
        raise InvalidError(faults)
    return MoveQuestion(position, number, column - 1)


def _pair(setting: Setting, token: int) -> tuple[int, int]:
    cell = setting.start.cells[setting.deck.tokens[token].id]
    return (cell.row, cell.column)


def list_field(name: str, written: Sequence[str]) -> str:
    """A field that is a list, an entry a line."""
    if not written:
        return f"{json.dumps(name)}: []"
    entries = ",\n  ".join(written)
    return f"{json.dumps(name)}: [\n  {entries}\n ]"


def json_text(value: object) -> str:
    """A value on one line, its letters as they are."""
    return json.dumps(value, ensure_ascii=False)
