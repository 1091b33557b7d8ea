"""Teaching for programs: begin, show, answer, read what is understood, save."""

from __future__ import annotations

import json
from datetime import datetime
from decimal import Decimal
from http import HTTPStatus
from typing import Annotated, Final, Literal, TypeAlias, cast

from fastapi import APIRouter, Body, HTTPException, Path
from pydantic import BaseModel, ConfigDict, Field, field_validator

from maestra.coaching.asking import as_demonstration, asked_play
from maestra.core.board import MAX_SIDE, Cell, Column, Row
from maestra.core.demonstration import Demonstration
from maestra.core.formats import BoardJson, DeckJson, encode_demonstration, encode_move
from maestra.core.state import State
from maestra.core.text import MAX_TEXT, PLAIN
from maestra.core.tokens import TokenId
from maestra.learning.dialogue import (
    AskAgain,
    AskCell,
    AskQuestion,
    CellIsWrong,
    Dialogue,
    NotAskedError,
)
from maestra.rules.answers import MoveQuestion, Question, RuleQuestion
from maestra.rules.exercise import RuledExercise
from maestra.rules.rule_json import encode_rule
from maestra.web.problems import problems
from maestra.web.teach import decks
from maestra.web.teach.actions import (
    Action,
    CannotError,
    Show,
    Take,
    Undo,
    new_draft,
)
from maestra.web.teach.bench import AtBench, Bench
from maestra.web.teach.desk import MAX_SEED, Kept, StaleError, Work, new_seed
from maestra.web.teach.draft import BroughtBack, Draft, TakenBack
from maestra.web.teach.routes import SAYINGS
from maestra.web.teach.saving import MOST_OF_NAME
from maestra.web.teach.saving import save as save_exercise
from maestra.web.teach.showing import MAX_TOUCHES, CannotTouchError, Showing, Touch
from maestra.web.teach.understanding import dialogue_of, exercise_of, reply_to, slip_of

router: Final = APIRouter(prefix="/api/drafts", tags=["teaching"])

_STRICT: Final = ConfigDict(extra="forbid", frozen=True)
_ID: Final = r"^[0-9a-f]{32}$"
WhichDraft = Annotated[
    str, Path(pattern=_ID, description="The draft's `id`.", examples=["0123456789abcdef" * 2])
]
WhichShown = Annotated[
    int, Path(ge=1, le=1000, description="A demonstration, counted from 1 as they were shown.")
]
_Side = Annotated[int, Field(ge=1, le=MAX_SIDE)]
_Place: TypeAlias = Annotated[tuple[_Side, _Side], Field(description="A cell: [row, column].")]
_Id = Annotated[str, Field(min_length=1, max_length=MAX_TEXT, pattern=PLAIN)]
_CONFLICT: Final = problems(409)
"""It cannot be done now: nothing is asked, something else is, or the draft is full."""


class DeckSent(DeckJson):
    """Tokens and what their attributes mean, as in a file of demonstrations."""

    @field_validator("tokens", mode="before")
    @classmethod
    def _exact(cls, tokens: object) -> object:
        """Numbers with a fraction as they were written."""
        if not isinstance(tokens, dict):
            return tokens
        return {
            token: {k: _exact(v) for k, v in cast("dict[object, object]", shown).items()}
            if isinstance(shown, dict)
            else shown
            for token, shown in cast("dict[object, object]", tokens).items()
        }


class NewDraft(BaseModel):
    """What a new exercise is taught with."""

    model_config = _STRICT

    ready: Annotated[
        decks.Ready | None, Field(description="A deck that is ready; or give `deck`.")
    ] = None
    deck: Annotated[DeckSent | None, Field(description="Tokens of your own.")] = None
    board: Annotated[
        BoardJson | None,
        Field(
            description=f"At most {decks.MOST_ROWS} rows and {decks.MOST_COLUMNS} columns, with a "
            "storage cell for each token; the paper's board, or a larger one, if it is left out."
        ),
    ] = None
    seed: Annotated[
        int | None, Field(ge=0, lt=MAX_SEED, description="Of how the tokens are dealt.")
    ] = None
    name: Annotated[str, Field(max_length=MOST_OF_NAME, pattern=PLAIN)] = ""


class Placement(BaseModel):
    """A token that is put into the goal row."""

    model_config = _STRICT

    token: _Id
    destination: _Place


class NewDemonstration(BaseModel):
    """A right row, as it is made."""

    model_config = _STRICT

    moves: Annotated[list[Placement], Field(min_length=1, max_length=MAX_TOUCHES)]
    start: Annotated[
        dict[_Id, _Place] | None,
        Field(description="Where each token lies before; as in the draft if it is left out."),
    ] = None


class AnswerSent(BaseModel):
    """What is said to what is asked."""

    model_config = _STRICT

    answer: Annotated[
        Literal[
            "yes",
            "no",
            "unsure",
            "confirmed",
            "taken-back",
            "earlier",
            "later",
            "neither",
            "unknown-cell",
            "wrong-cell",
            "enough",
        ],
        Field(
            description="`yes`, `no`, `unsure` to a question; `confirmed` or `taken-back` to a "
            "probable slip; `earlier`, `later` or `neither` to two moments that do not go "
            "together; `wrong-cell` with `column`, or `unknown-cell`, to which token is wrong; "
            "`enough` to anything."
        ),
    ]
    column: Annotated[
        int | None, Field(ge=1, le=MAX_SIDE, description="Of the wrong token, from 1.")
    ] = None
    mark: Annotated[
        str | None,
        Field(max_length=40, description="The draft's `mark` that was read; 409 if it changed."),
    ] = None


class NewName(BaseModel):
    """Under which name it is saved."""

    model_config = _STRICT

    name: Annotated[str, Field(min_length=1, max_length=MOST_OF_NAME, pattern=PLAIN)]


class RuleSaid(BaseModel):
    """A rule in words."""

    id: str
    text: str
    confidence: Annotated[float | None, Field(description="`null` where it was told.")]


class Asked(BaseModel):
    """What is asked now."""

    kind: Literal["row", "move", "rule", "cell", "slip", "contradiction"]
    text: str
    position: Annotated[
        dict[str, object] | None,
        Field(description="The row or position that is asked about, as a demonstration's line."),
    ] = None
    move: Annotated[dict[str, object] | None, Field(description="Of a question of kind move.")] = (
        None
    )
    rule: Annotated[dict[str, object] | None, Field(description="Of a question of kind rule.")] = (
        None
    )
    demonstration: Annotated[int | None, Field(description="Of a slip: which, from 1.")] = None
    step: Annotated[int | None, Field(description="Of a slip: which move, from 1.")] = None
    moments: Annotated[
        list[str], Field(description="Of a contradiction: the earlier and the later, in words.")
    ] = []


class DraftSaid(BaseModel):
    """An exercise that is being taught, and what is understood of it."""

    id: Annotated[str, Field(pattern=_ID)]
    mark: Annotated[str, Field(description="How far teaching is; send it with an answer.")]
    name: str
    changed: datetime
    start: Annotated[
        dict[str, tuple[int, int]], Field(description="Where the tokens lie: [row, column].")
    ]
    tokens: dict[str, dict[str, int | float | str]]
    demonstrations: Annotated[int, Field(description="How many were shown.")]
    counting: Annotated[list[int], Field(description="Those that count, from 1.")]
    status: Annotated[
        str | None, Field(description="What learning came to; `null` before anything was shown.")
    ]
    confidence: float | None
    rules: list[RuleSaid]
    others: Annotated[list[str], Field(description="What else may be meant, or is not clear yet.")]
    asked: Annotated[Asked | None, Field(description="`null` where nothing is asked.")]


class DraftListed(BaseModel):
    """A draft in the list; what is understood of it is worked out when it is read."""

    id: Annotated[str, Field(pattern=_ID)]
    name: str
    changed: datetime
    demonstrations: Annotated[int, Field(description="How many were shown.")]


class DraftsSaid(BaseModel):
    """What is being taught."""

    drafts: list[DraftListed]


class Saved(BaseModel):
    """What was kept in the library."""

    name: str
    version: int


@router.get("")
def drafts(bench: AtBench) -> DraftsSaid:
    """Your drafts, the one that was changed last first; nobody else sees them."""
    return DraftsSaid(
        drafts=[
            DraftListed(
                id=one.id,
                name=one.draft.name,
                changed=datetime.fromisoformat(one.changed_utc),
                demonstrations=len(one.draft.taught.showings),
            )
            for one in bench.desk.all()
        ]
    )


@router.post("", status_code=HTTPStatus.CREATED, responses=_CONFLICT)
def begin(bench: AtBench, new: Annotated[NewDraft, Body()]) -> DraftSaid:
    """Begin to teach a new exercise."""
    if (new.ready is None) == (new.deck is None):
        raise HTTPException(HTTPStatus.UNPROCESSABLE_ENTITY, "either ready or deck")
    deck = (
        decks.ready_deck(new.ready, bench.pages.say)
        if new.ready is not None
        else cast("DeckSent", new.deck).deck()
    )
    decks.demand_few(deck)
    board = decks.board_for(deck) if new.board is None else decks.fit(new.board.board())
    seed = new_seed() if new.seed is None else new.seed
    try:
        fresh = new_draft(deck, board, seed)
        kept = bench.desk.add(Draft(deck, fresh.showing, seed, name=new.name))
    except CannotError as error:
        raise _conflict(error) from None
    return _said(bench, kept)


@router.get("/{draft}")
def read(bench: AtBench, draft: WhichDraft) -> DraftSaid:
    """A draft: what is understood, and what is asked."""
    return _said(bench, bench.desk.find(draft))


@router.delete("/{draft}", status_code=HTTPStatus.NO_CONTENT)
def forget(bench: AtBench, draft: WhichDraft) -> None:
    """Forget a draft; what was saved of it stays in the library."""
    bench.desk.delete(draft)


@router.post("/{draft}/demonstrations", responses=_CONFLICT)
def show(
    bench: AtBench, draft: WhichDraft, shown: Annotated[NewDemonstration, Body()]
) -> DraftSaid:
    """Show a right row; it is learned from at once."""
    return _changed(bench, draft, lambda now: Show(_showing(now, shown)))


@router.delete("/{draft}/demonstrations/{number}", responses=_CONFLICT)
def take_back(bench: AtBench, draft: WhichDraft, number: WhichShown) -> DraftSaid:
    """A demonstration counts no more."""
    return _changed(bench, draft, lambda _: Take(TakenBack(number - 1)))


@router.put("/{draft}/demonstrations/{number}", responses=_CONFLICT)
def bring_back(bench: AtBench, draft: WhichDraft, number: WhichShown) -> DraftSaid:
    """It counts again."""
    return _changed(bench, draft, lambda _: Take(BroughtBack(number - 1)))


@router.post("/{draft}/answers", responses=_CONFLICT)
def answer(bench: AtBench, draft: WhichDraft, said: Annotated[AnswerSent, Body()]) -> DraftSaid:
    """Answer what is asked."""
    if (said.answer == "wrong-cell") == (said.column is None):
        expected = "column with wrong-cell, and with nothing else"
        raise HTTPException(HTTPStatus.UNPROCESSABLE_ENTITY, expected)
    reply = SAYINGS[said.answer] if said.column is None else CellIsWrong(said.column - 1)
    return _changed(bench, draft, lambda now: Take(reply_to(now, reply)), said.mark)


@router.post("/{draft}/undo", responses=_CONFLICT)
def undo(bench: AtBench, draft: WhichDraft) -> DraftSaid:
    """As if the last demonstration or answer had not been."""
    return _changed(bench, draft, lambda _: Undo(whole=True))


@router.post("/{draft}/save", responses=_CONFLICT)
def save(bench: AtBench, draft: WhichDraft, under: Annotated[NewName, Body()]) -> Saved:
    """Keep it in the library, as a new version of the exercise of this name."""

    def work(now: Draft) -> Action:
        return save_exercise(bench.context, bench.visitor, now, under.name)

    kept = _done(bench, draft, work)
    name, version = kept.draft.saved or (under.name, 1)
    return Saved(name=name, version=version)


def _changed(bench: Bench, draft: str, work: Work, at: str | None = None) -> DraftSaid:
    return _said(bench, _done(bench, draft, work, at))


def _done(bench: Bench, draft: str, work: Work, at: str | None = None) -> Kept:
    try:
        return bench.desk.change(draft, work, at)
    except CannotError as error:
        raise _conflict(error) from None
    except StaleError:
        raise HTTPException(HTTPStatus.CONFLICT, "the draft has changed since") from None
    except NotAskedError:
        raise HTTPException(HTTPStatus.CONFLICT, "that is not asked") from None


def _conflict(error: CannotError) -> HTTPException:
    return HTTPException(HTTPStatus.CONFLICT, error.why.value)


def _showing(draft: Draft, shown: NewDemonstration) -> Showing:
    """The demonstration that was sent.

    Raises:
        InvalidError: tokens or cells that are not there.
        HTTPException: 422, a move that no board could make.
    """
    start = draft.showing.start
    if shown.start is not None:
        cells = {TokenId(token): _cell(place) for token, place in shown.start.items()}
        start = State(draft.board, cells)
        # Each token once, and all of them.
        Demonstration(draft.deck, start, ())
    touches = tuple(Touch(TokenId(one.token), _cell(one.destination)) for one in shown.moves)
    for touch in touches:
        if touch.cell.row != draft.board.goal_row:
            raise HTTPException(HTTPStatus.UNPROCESSABLE_ENTITY, "only moves to the goal row")
    try:
        return Showing(start, touches)
    except CannotTouchError:
        refusal = "a move that no board could make"
        raise HTTPException(HTTPStatus.UNPROCESSABLE_ENTITY, refusal) from None


def _said(bench: Bench, kept: Kept) -> DraftSaid:
    draft = kept.draft
    understood = bench.views(kept).understanding()
    exercise = exercise_of(draft)
    is_ruled = isinstance(exercise, RuledExercise)
    rules = () if understood is None else understood.rules
    return DraftSaid(
        id=kept.id,
        mark=draft.mark,
        name=draft.name,
        changed=datetime.fromisoformat(kept.changed_utc),
        start={t: (c.row, c.column) for t, c in draft.showing.start.cells.items()},
        tokens={
            token.id: {k: float(v) if isinstance(v, Decimal) else v for k, v in token.attributes}
            for token in draft.deck.tokens
        },
        demonstrations=len(draft.taught.showings),
        counting=[k + 1 for k in draft.taught.counting],
        status=exercise.status.value if isinstance(exercise, RuledExercise) else None,
        confidence=exercise.confidence if isinstance(exercise, RuledExercise) else None,
        rules=[
            RuleSaid(
                id=one.id,
                text=one.text,
                confidence=None if one.percent is None or not is_ruled else one.percent / 100,
            )
            for one in rules
        ],
        others=[] if understood is None else list(understood.others),
        asked=_asked(bench, kept),
    )


def _asked(bench: Bench, kept: Kept) -> Asked | None:
    draft = kept.draft
    view, dialogue = bench.views(kept).question(), dialogue_of(draft)
    if view is None or dialogue is None:
        return None
    question = _question(dialogue)
    slip = slip_of(draft, dialogue)
    if slip is not None:
        number, move = slip
        return Asked(kind="slip", text=view.text, demonstration=number + 1, step=move + 1)
    if question is None:
        texts = [side.text for side in view.sides]
        return Asked(kind="contradiction", text=view.text, moments=texts)
    play = asked_play(question)
    position = None if play is None else json.loads(encode_demonstration(as_demonstration(play)))
    kind: Literal["row", "move", "rule", "cell"] = "cell" if view.kind == "cell" else "row"
    moved: dict[str, object] | None = None
    rule: dict[str, object] | None = None
    match question:
        case MoveQuestion(before, token, cell):
            kind, moved = "move", encode_move(before.after(token, cell).moves()[-1])
        case RuleQuestion(meant):
            kind, rule = "rule", encode_rule(meant)
        case _:
            pass
    return Asked(kind=kind, text=view.text, position=position, move=moved, rule=rule)


def _question(dialogue: Dialogue) -> Question | None:
    match dialogue.ask:
        case AskQuestion(question) | AskAgain(_, question):
            return question
        case AskCell(number):
            return dialogue.answers[number].question
        case _:
            return None


def _exact(value: object) -> object:
    return Decimal(repr(value)) if isinstance(value, float) else value


def _cell(place: tuple[int, int]) -> Cell:
    return Cell(Row(place[0]), Column(place[1]))
