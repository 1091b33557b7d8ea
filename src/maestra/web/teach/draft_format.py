"""Drafts as JSON, for the store: `maestra.draft/1`.

Answers and exams are written once each, as exercises write them; steps name them by number.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Annotated, Final, Literal, TypeAlias, assert_never

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.formats import BoardJson, DeckJson, encode_deck
from maestra.core.json_faults import faults_of_validation
from maestra.core.json_lines import FormatError, decode_object
from maestra.core.state import State
from maestra.core.tokens import TokenId
from maestra.learning.dialogue import CellIsWrong, Counts, Enough, Side, SlipReplied, SlipReply
from maestra.learning.dialogue import Replied as Answered
from maestra.rules.answers import Answer
from maestra.rules.answers import Reply as Word
from maestra.rules.evidence_format import EvidenceJson, encode_evidence
from maestra.rules.exercise import Evidence, Exam
from maestra.rules.rule_json import RuleJson, decode_rule, encode_rule
from maestra.storage.drafts import Digest
from maestra.web.teach.draft import (
    BroughtBack,
    Draft,
    Examined,
    ExamUnderWay,
    Recalled,
    Replied,
    Reply,
    Shown,
    Step,
    TakenBack,
    Told,
    Trial,
)
from maestra.web.teach.showing import Showing, Touch

DRAFT_FORMAT: Final = "maestra.draft/1"

_Place: TypeAlias = tuple[int, int]
_TouchJson: TypeAlias = tuple[str, _Place]


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class _ShowingJson(_Strict):
    dealt: dict[str, _Place]
    touches: tuple[_TouchJson, ...] = ()

    def showing(self, board: Board) -> Showing:
        cells = {TokenId(token): _cell(at) for token, at in self.dealt.items()}
        return Showing(State(board, cells), tuple(map(_touch, self.touches)))


class _ReplyJson(_Strict):
    kind: Literal["answer", "cell", "slip", "side", "enough"]
    word: str = ""
    cell: int | None = None

    def reply(self) -> Reply:
        match self.kind:
            case "answer":
                return Answered(Word(self.word))
            case "cell":
                return CellIsWrong(self.cell)
            case "slip":
                return SlipReplied(SlipReply(self.word))
            case "side":
                return Counts(Side(self.word))
            case "enough":
                return Enough()
            case _:
                assert_never(self.kind)


class _Shown(_Strict):
    step: Literal["shown"] = "shown"
    showing: _ShowingJson


class _Number(_Strict):
    step: Literal["taken-back", "brought-back"]
    number: int


class _Replied(_Strict):
    step: Literal["replied"] = "replied"
    reply: _ReplyJson
    answers: tuple[int, ...]
    out: tuple[int, ...]


class _Told(_Strict):
    step: Literal["told"] = "told"
    rules: tuple[RuleJson, ...] | None


class _Examined(_Strict):
    step: Literal["examined"] = "examined"
    exam: int
    objections: tuple[int, ...]


class _Recalled(_Strict):
    step: Literal["recalled"] = "recalled"
    answers: tuple[int, ...]
    exams: tuple[int, ...]


_Written: TypeAlias = _Shown | _Number | _Replied | _Told | _Examined | _Recalled
_StepJson: TypeAlias = Annotated[_Written, Field(discriminator="step")]


class _TrialJson(_Strict):
    moves: tuple[_TouchJson, ...] = ()
    refused: _TouchJson | None = None


class _ExamJson(_Strict):
    seed: int
    replies: tuple[Word, ...] = ()


class _DraftJson(_Strict):
    format: Literal["maestra.draft/1"]
    deck: DeckJson
    board: BoardJson
    showing: _ShowingJson
    seed: int
    evidence: EvidenceJson
    steps: tuple[_StepJson, ...]
    features: tuple[str, ...] | None = None
    pictures: dict[str, str] = {}
    name: str = ""
    saved: tuple[str, int] | None = None
    held: str | None = None
    trial: _TrialJson = _TrialJson()
    exam: _ExamJson | None = None

    def draft(self) -> Draft:
        board, evidence = self.board.board(), self.evidence.evidence()
        refused, exam = self.trial.refused, self.exam
        return Draft(
            self.deck.deck(),
            self.showing.showing(board),
            self.seed,
            tuple(_step(one, board, evidence) for one in self.steps),
            self.features,
            {value: Digest(digest) for value, digest in self.pictures.items()},
            self.name,
            self.saved,
            None if self.held is None else TokenId(self.held),
            Trial(
                tuple(map(_touch, self.trial.moves)), None if refused is None else _touch(refused)
            ),
            None if exam is None else ExamUnderWay(exam.seed, exam.replies),
        )


def decode_draft(content: str) -> Draft:
    """The draft that was written.

    Raises:
        FormatError: it is none, or a newer Maestra's.
    """
    fields = decode_object(content.encode(), "draft", 1, DRAFT_FORMAT)
    try:
        return _DraftJson.model_validate(fields).draft()
    except ValidationError as error:
        faults = faults_of_validation(error, _DraftJson)
        raise FormatError("draft", 1, faults) from None


def encode_draft(draft: Draft) -> str:
    """The draft as JSON."""
    board, trial, exam = draft.board, draft.trial, draft.exam
    pool = _Pool()
    steps = [pool.step(one) for one in draft.steps]
    fields: dict[str, object] = {
        "format": DRAFT_FORMAT,
        "deck": encode_deck(draft.deck),
        "board": {"rows": board.rows, "columns": board.columns, "goal_row": board.goal_row},
        "showing": _encode_showing(draft.showing),
        "seed": draft.seed,
        "evidence": json.loads(encode_evidence(Evidence((), pool.answers, pool.exams))),
        "steps": steps,
        "features": draft.features,
        "pictures": dict(draft.pictures),
        "name": draft.name,
        "saved": draft.saved,
        "held": draft.held,
        "trial": {
            "moves": _encode_touches(trial.moves),
            "refused": None if trial.refused is None else _encode_touches([trial.refused])[0],
        },
        "exam": None
        if exam is None
        else {"seed": exam.seed, "replies": [one.value for one in exam.replies]},
    }
    return json.dumps(fields, ensure_ascii=False)


class _Pool:
    """The answers and exams that steps speak of, each once."""

    def __init__(self) -> None:
        self._answers: dict[Answer, int] = {}
        self._exams: dict[Exam, int] = {}

    @property
    def answers(self) -> tuple[Answer, ...]:
        return tuple(self._answers)

    @property
    def exams(self) -> tuple[Exam, ...]:
        return tuple(self._exams)

    def step(self, step: Step) -> dict[str, object]:
        match step:
            case Shown(showing):
                return {"step": "shown", "showing": _encode_showing(showing)}
            case TakenBack(number):
                return {"step": "taken-back", "number": number}
            case BroughtBack(number):
                return {"step": "brought-back", "number": number}
            case Replied(said, answers, out):
                return {
                    "step": "replied",
                    "reply": _encode_reply(said),
                    "answers": self._numbers(answers),
                    "out": sorted(out),
                }
            case Told(rules):
                written = None if rules is None else [encode_rule(rule) for rule in rules]
                return {"step": "told", "rules": written}
            case Examined(exam, objections):
                return {
                    "step": "examined",
                    "exam": self._exam(exam),
                    "objections": self._numbers(objections),
                }
            case Recalled(answers, exams):
                return {
                    "step": "recalled",
                    "answers": self._numbers(answers),
                    "exams": [self._exam(one) for one in exams],
                }
            case _:
                assert_never(step)

    def _exam(self, exam: Exam) -> int:
        return self._exams.setdefault(exam, len(self._exams))

    def _numbers(self, answers: Sequence[Answer]) -> list[int]:
        return [self._answers.setdefault(one, len(self._answers)) for one in answers]


def _step(written: _Written, board: Board, pool: Evidence) -> Step:
    match written:
        case _Shown():
            return Shown(written.showing.showing(board))
        case _Number(step="taken-back"):
            return TakenBack(written.number)
        case _Number():
            return BroughtBack(written.number)
        case _Replied():
            answers = tuple(pool.answers[k] for k in written.answers)
            return Replied(written.reply.reply(), answers, frozenset(written.out))
        case _Told():
            rules = written.rules
            return Told(None if rules is None else tuple(map(decode_rule, rules)))
        case _Examined():
            objections = tuple(pool.answers[k] for k in written.objections)
            return Examined(pool.exams[written.exam], objections)
        case _Recalled():
            answers = tuple(pool.answers[k] for k in written.answers)
            return Recalled(answers, tuple(pool.exams[k] for k in written.exams))
        case _:
            assert_never(written)


def _encode_reply(reply: Reply) -> dict[str, object]:
    match reply:
        case Answered(word):
            return {"kind": "answer", "word": word.value}
        case CellIsWrong(cell):
            return {"kind": "cell", "cell": cell}
        case SlipReplied(word):
            return {"kind": "slip", "word": word.value}
        case Counts(side):
            return {"kind": "side", "word": side.value}
        case Enough():
            return {"kind": "enough"}
        case _:
            assert_never(reply)


def _encode_showing(showing: Showing) -> dict[str, object]:
    dealt = {token: (cell.row, cell.column) for token, cell in showing.dealt.cells.items()}
    return {"dealt": dealt, "touches": _encode_touches(showing.touches)}


def _encode_touches(touches: Sequence[Touch]) -> list[object]:
    return [[one.token, [one.cell.row, one.cell.column]] for one in touches]


def _cell(place: _Place) -> Cell:
    return Cell(Row(place[0]), Column(place[1]))


def _touch(written: _TouchJson) -> Touch:
    token, place = written
    return Touch(TokenId(token), _cell(place))
