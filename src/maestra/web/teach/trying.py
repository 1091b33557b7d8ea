"""Trying what was taught: the caregiver plays and is told why not; Maestra plays and is judged."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, Final

from fastapi import APIRouter, Form
from fastapi.responses import HTMLResponse, Response

from maestra.coaching.examining import changes, truth
from maestra.coaching.referee import ExerciseReferee, Refused, Right
from maestra.core.state import Move
from maestra.core.tokens import Deck
from maestra.language import Language
from maestra.rules.answers import Reply, RowQuestion
from maestra.rules.exercise import Exercise, RuledExercise
from maestra.rules.position import Position
from maestra.web.board_press import CellText, TokenText
from maestra.web.board_view import BoardView
from maestra.web.teach.actions import (
    Action,
    BeginExam,
    CannotError,
    JudgePlay,
    LeaveExam,
    Take,
    Try,
    TryAgain,
    Why,
)
from maestra.web.teach.bench import AtBench, Bench, Seen, WhyNot, pressed
from maestra.web.teach.desk import Kept, new_seed
from maestra.web.teach.draft import Draft, Examined
from maestra.web.teach.showing import Touch
from maestra.web.teach.understanding import (
    exam_of,
    examined,
    exercise_of,
    teacher_of,
)

TRY: Final = "try"
EXAM: Final = "exam"
KEPT: Final = 4
"""Referees: each remembers what it has worked out of one exercise."""

router: Final = APIRouter(include_in_schema=False)


@dataclass(frozen=True, slots=True)
class TrialView:
    """What came of the moves so far."""

    board: BoardView
    said: str
    """Why the last move was refused; empty if it was not."""
    is_over: bool
    """Whether the row is complete and right."""
    begun: bool


# ---------------------------------------------------------------- the caregiver plays


@router.get("/teach/{draft}/try")
def try_it(bench: AtBench, draft: str, why: WhyNot = "") -> HTMLResponse:
    """A board on which each move is judged at once."""
    kept = bench.desk.find(draft)
    return bench.page("teach/try.html", kept, why, trial=_trial(bench, kept))


@router.post("/teach/{draft}/try/move")
def move(bench: AtBench, draft: str, cell: CellText, token: TokenText = "") -> Response:
    """A token is tried."""
    language = bench.pages.language
    return bench.change(draft, lambda now: _pressed(now, cell, token, language), TRY)


@router.post("/teach/{draft}/try/again")
def try_again(bench: AtBench, draft: str) -> Response:
    """From the start."""
    return bench.change(draft, lambda _: TryAgain(), TRY)


def _pressed(draft: Draft, cell: str, token: str, language: Language) -> Action:
    exercise = _exercise(draft)
    position = _position(draft)

    def tried(touch: Touch) -> Try:
        move = Move(touch.token, position.now.cells[touch.token], touch.cell)
        ruling = _referee(exercise, draft.deck, language).judge(position, move)
        return Try(touch, isinstance(ruling, Right))

    return pressed(draft, position.now, cell, token, tried)


def _trial(bench: Bench, kept: Kept) -> TrialView | None:
    """None while there is nothing to try."""
    draft = kept.draft
    exercise = exercise_of(draft)
    if exercise is None:
        return None
    position, views = _position(draft), bench.views(kept)
    referee = _referee(exercise, draft.deck, bench.pages.language)
    refused = draft.trial.refused
    said = ""
    if refused is not None and refused.cell not in position.now.tokens:
        tried = Move(refused.token, position.now.cells[refused.token], refused.cell)
        ruling = referee.judge(position, tried)
        said = ruling.reason if isinstance(ruling, Refused) else ""
    board = views.board(
        position.now,
        held=True,
        allowed=[touch.cell for touch in draft.trial.moves],
        wrong=[] if refused is None or not said else [refused.cell],
    )
    return TrialView(board, said, referee.may_end(position), bool(draft.trial.moves))


def _position(draft: Draft) -> Position:
    position = Position.begin(draft.showing.start)
    for touch in draft.trial.moves:
        move = Move(touch.token, position.now.cells[touch.token], touch.cell)
        position = position.after(move)
    return position


def _exercise(draft: Draft) -> Exercise:
    exercise = exercise_of(draft)
    if exercise is None:
        raise CannotError(Why.NOTHING_SHOWN)
    return exercise


@lru_cache(maxsize=KEPT)
def _made(exercise: RuledExercise, deck: Deck, language: Language) -> ExerciseReferee:
    return ExerciseReferee(exercise, deck, language)


def _referee(exercise: Exercise, deck: Deck, language: Language) -> ExerciseReferee:
    if isinstance(exercise, RuledExercise):
        return _made(exercise, deck, language)
    return ExerciseReferee(exercise, deck, language)


# ---------------------------------------------------------------- Maestra plays


@router.get("/teach/{draft}/exam")
def exam(bench: AtBench, draft: str, why: WhyNot = "") -> HTMLResponse:
    """The next play to judge, or what the last exam came to."""
    kept = bench.desk.find(draft)
    now = kept.draft
    exercise = exercise_of(now)
    plays = exam_of(now, exercise) if isinstance(exercise, RuledExercise) else ()
    number = 0 if now.exam is None else len(now.exam.replies)
    play = plays[number].play if number < len(plays) else None
    teacher = teacher_of(now, bench.pages.language)
    return bench.page(
        "teach/exam.html",
        kept,
        why,
        can=isinstance(exercise, RuledExercise),
        board_view=None if play is None else bench.views(kept).play(play),
        asked="" if play is None else teacher.question(RowQuestion(play)),
        number=number + 1,
        count=len(plays),
        nothing_to_show=now.exam is not None and not plays,
        truth=_truth(bench, now),
    )


@router.post("/teach/{draft}/exam/begin")
def begin(bench: AtBench, draft: str) -> Response:
    """Maestra draws what it will play."""
    return bench.change(draft, lambda now: BeginExam(_seed(now)), EXAM)


@router.post("/teach/{draft}/exam/judge")
def judge(bench: AtBench, draft: str, said: Annotated[Reply, Form()], at: Seen = None) -> Response:
    """What the caregiver says of the play; after the last one the exam is over."""
    date = bench.context.clock.utc().date().isoformat()
    return bench.change(draft, lambda now: _judged(now, said, date), EXAM, at)


@router.post("/teach/{draft}/exam/enough")
def enough(bench: AtBench, draft: str, at: Seen = None) -> Response:
    """No more plays: what was judged counts, if there was anything."""
    date = bench.context.clock.utc().date().isoformat()
    return bench.change(draft, lambda now: _ended(now, date), EXAM, at)


def _seed(draft: Draft) -> int:
    if not isinstance(exercise_of(draft), RuledExercise):
        raise CannotError(Why.NOTHING_SHOWN)
    return new_seed()


def _judged(draft: Draft, said: Reply, date: str) -> Action:
    exercise = exercise_of(draft)
    if draft.exam is None or not isinstance(exercise, RuledExercise):
        raise CannotError(Why.NO_EXAM)
    plays = exam_of(draft, exercise)
    replies = (*draft.exam.replies, said)
    if len(replies) < len(plays):
        return JudgePlay(said)
    return Take(examined(plays, replies, date))


def _ended(draft: Draft, date: str) -> Action:
    exercise = exercise_of(draft)
    if draft.exam is None or not isinstance(exercise, RuledExercise):
        raise CannotError(Why.NO_EXAM)
    if not draft.exam.replies:
        return LeaveExam()
    return Take(examined(exam_of(draft, exercise), draft.exam.replies, date))


@dataclass(frozen=True, slots=True)
class TruthView:
    """What an exam came to, in plain sentences."""

    sentences: tuple[str, ...]
    learned: bool
    """Whether something went back to learning."""
    added: tuple[str, ...]
    dropped: tuple[str, ...]


def _truth(bench: Bench, draft: Draft) -> TruthView | None:
    """Of the last step, if that was an exam."""
    if not draft.steps or not isinstance(draft.steps[-1], Examined) or draft.exam is not None:
        return None
    last = draft.steps[-1]
    teacher = teacher_of(draft, bench.pages.language)
    sentences = truth(last.exam, teacher)
    before = exercise_of(Draft(draft.deck, draft.showing, steps=draft.steps[:-1]))
    after = exercise_of(draft)
    if not (isinstance(before, RuledExercise) and isinstance(after, RuledExercise)):
        return TruthView(sentences, bool(last.objections), (), ())
    changed = changes(before, after)
    return TruthView(
        sentences,
        bool(last.objections),
        tuple(map(teacher.rule, changed.added)),
        tuple(map(teacher.rule, changed.dropped)),
    )
