"""The pages to teach on: all that was begun, a new exercise, the board with its questions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated, Final

from fastapi import APIRouter, Form, HTTPException, Query
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.learning.dialogue import (
    CellIsWrong,
    Counts,
    Enough,
    Side,
    SlipReplied,
    SlipReply,
)
from maestra.learning.dialogue import Replied as Answered
from maestra.rules.answers import Reply as Word
from maestra.web.board_press import CellText, TokenText, cell_of
from maestra.web.board_view import BoardView
from maestra.web.teach import decks, pictures
from maestra.web.teach.actions import (
    Action,
    CannotError,
    Deal,
    Finish,
    Put,
    Rename,
    Take,
    Undo,
    Why,
    new_draft,
)
from maestra.web.teach.bench import AtBench, Bench, Seen, WhyNot, path_of, pressed
from maestra.web.teach.desk import Kept, new_seed
from maestra.web.teach.draft import BroughtBack, Draft, Reply, TakenBack
from maestra.web.teach.saving import MOST_OF_NAME, from_exercise, save
from maestra.web.teach.understanding import reply_to
from maestra.web.teach.views import Views

AGAIN: Final = "again"
"""A likely slip is taken back, and the board is there to show it again."""
MORE: Final = "more=yes"

router: Final = APIRouter(include_in_schema=False)


@dataclass(frozen=True, slots=True)
class Row:
    """A draft in the list."""

    id: str
    name: str
    board: BoardView
    shown: int
    changed: datetime


# ---------------------------------------------------------------- all of them, and a new one


@router.get("/teach")
def drafts(bench: AtBench, why: WhyNot = "") -> HTMLResponse:
    """What was begun, and what a new exercise can be taught with."""
    return all_drafts(bench, why)


def all_drafts(bench: Bench, why: str = "", fault: str = "") -> HTMLResponse:
    """What was begun; with `fault`, what is wrong with pictures that were sent."""
    rows = [_row(one, bench) for one in bench.desk.all()]
    text = bench.pages.text(
        "teach/list.html",
        visitor=bench.visitor,
        rows=rows,
        why=bench.why(why),
        fault=fault,
        megabytes=pictures.MOST_BYTES // 2**20,
    )
    return HTMLResponse(text, 422 if fault else 200)


@router.post("/teach")
def begin(bench: AtBench, deck: Annotated[decks.Ready, Form()]) -> Response:
    """A new exercise with a deck that is ready."""
    chosen = decks.ready_deck(deck, bench.pages.say)
    try:
        kept = bench.desk.add(new_draft(chosen, decks.board_for(chosen), new_seed()))
    except CannotError as error:
        return RedirectResponse(f"/teach?why={error.why.value}", 303)
    return RedirectResponse(path_of(kept.id), 303)


@router.post("/teach/from")
def go_on(
    bench: AtBench,
    name: Annotated[str, Form(max_length=200)],
    version: Annotated[int | None, Form(ge=1)] = None,
) -> Response:
    """Go on teaching an exercise of the library."""
    try:
        kept = bench.desk.add(from_exercise(bench.context, name, version))
    except KeyError:
        raise HTTPException(404, "no such exercise") from None
    except CannotError as error:
        return RedirectResponse(f"/teach?why={error.why.value}", 303)
    return RedirectResponse(path_of(kept.id), 303)


@router.post("/teach/{draft}/delete")
def delete(bench: AtBench, draft: str) -> Response:
    """Forget a draft; what was saved of it stays in the library."""
    bench.desk.delete(draft)
    return RedirectResponse("/teach", 303)


# ---------------------------------------------------------------- the board


@router.get("/teach/{draft}")
def show(
    bench: AtBench,
    draft: str,
    why: WhyNot = "",
    more: Annotated[str, Query(max_length=10)] = "",
) -> HTMLResponse:
    """The board to play on, what is understood, and what is asked.

    While something is asked the board waits, unless the caregiver wants to show `more`.
    """
    return _shown(bench, bench.desk.find(draft), why, more=bool(more))


@router.post("/teach/{draft}/move")
def move(bench: AtBench, draft: str, cell: CellText, token: TokenText = "") -> Response:
    """A cell was pressed, or a token dropped on it."""
    return bench.change(draft, lambda now: pressed(now, now.showing.now, cell, token, Put))


@router.post("/teach/{draft}/done")
def done(bench: AtBench, draft: str, at: Seen = None) -> Response:
    """This demonstration is done."""
    return bench.change(draft, lambda _: Finish(), at=at)


@router.post("/teach/{draft}/undo")
def undo(bench: AtBench, draft: str, at: Seen = None) -> Response:
    """As if the last move or answer had not been."""
    return bench.change(draft, lambda _: Undo(), at=at)


@router.post("/teach/{draft}/deal")
def deal(bench: AtBench, draft: str) -> Response:
    """Other places for the tokens."""
    return bench.change(draft, lambda _: Deal())


@router.post("/teach/{draft}/take-back")
def take_back(
    bench: AtBench, draft: str, number: Annotated[int, Form(ge=1, le=1000)], at: Seen = None
) -> Response:
    """A demonstration counts no more."""
    return bench.change(draft, lambda _: Take(TakenBack(number - 1)), at=at)


@router.post("/teach/{draft}/bring-back")
def bring_back(
    bench: AtBench, draft: str, number: Annotated[int, Form(ge=1, le=1000)], at: Seen = None
) -> Response:
    """It counts again."""
    return bench.change(draft, lambda _: Take(BroughtBack(number - 1)), at=at)


# ---------------------------------------------------------------- questions


SAYINGS: Final[Mapping[str, Reply]] = {
    **{word.value: Answered(word) for word in Word},
    **{word.value: SlipReplied(word) for word in SlipReply},
    **{side.value: Counts(side) for side in Side},
    "enough": Enough(),
    "unknown-cell": CellIsWrong(None),
    AGAIN: SlipReplied(SlipReply.TAKEN_BACK),
}
"""What the buttons say."""


@router.post("/teach/{draft}/reply")
def reply(
    bench: AtBench, draft: str, said: Annotated[str, Form(max_length=40)], at: Seen = None
) -> Response:
    """What was said to what is asked."""
    if said not in SAYINGS:
        raise HTTPException(422, "no such answer")
    then = MORE if said == AGAIN else ""
    return bench.change(draft, lambda now: Take(reply_to(now, SAYINGS[said])), at=at, then=then)


@router.post("/teach/{draft}/wrong")
def wrong(bench: AtBench, draft: str, cell: CellText, at: Seen = None) -> Response:
    """Which token of the row that was asked about is wrong."""
    place = cell_of(cell)

    def work(now: Draft) -> Action:
        if place not in now.board.goal_cells:
            raise CannotError(Why.CELL)
        return Take(reply_to(now, CellIsWrong(place.column - 1)))

    return bench.change(draft, work, at=at)


# ---------------------------------------------------------------- keeping it


@router.post("/teach/{draft}/name")
def name(
    bench: AtBench, draft: str, name: Annotated[str, Form(max_length=MOST_OF_NAME)] = ""
) -> Response:
    """What is typed as its name, while it is typed."""
    kept = bench.desk.change(draft, lambda _: Rename(name))
    return RedirectResponse(path_of(kept.id), 303)


@router.post("/teach/{draft}/save")
def save_it(bench: AtBench, draft: str, name: Annotated[str, Form()] = "") -> Response:
    """Keep it in the library under a name."""
    wanted = name.strip()
    try:
        bench.desk.change(draft, lambda now: save(bench.context, bench.visitor, now, wanted))
    except CannotError as error:
        kept = bench.desk.find(draft)
        if error.why in {Why.NO_NAME, Why.NAME_TAKEN}:
            return _shown(bench, kept, typed=_Typed(name, bench.why(error.why.value)))
        return RedirectResponse(f"{path_of(draft)}?why={error.why.value}", 303)
    return RedirectResponse(path_of(draft), 303)


@dataclass(frozen=True, slots=True)
class _Typed:
    """What was typed as a name, and what is wrong with it."""

    name: str
    fault: str


def _shown(
    bench: Bench, kept: Kept, why: str = "", *, more: bool = False, typed: _Typed | None = None
) -> HTMLResponse:
    views = bench.views(kept)
    question = views.question()
    return bench.page(
        "teach/show.html",
        kept,
        why,
        200 if typed is None else 422,
        board_view=views.showing(),
        question=question,
        waits=question is not None and not more and not kept.draft.showing.touches,
        understood=views.understanding(),
        shown=views.demonstrations(),
        name=kept.draft.name if typed is None else typed.name,
        fault="" if typed is None else typed.fault,
    )


def _row(kept: Kept, bench: Bench) -> Row:
    views = Views(kept.draft, bench.pages.language)
    shown = kept.draft.demonstrations
    state = shown[-1].end if shown else kept.draft.showing.now
    when = datetime.fromisoformat(kept.changed_utc)
    return Row(kept.id, kept.draft.name, views.board(state), len(shown), when)
