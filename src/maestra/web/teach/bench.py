"""What every page of teaching works with: the visitor's drafts, and how answers lead on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath
from typing import Annotated, Final
from urllib.parse import urlencode

from fastapi import Depends, Form, Query
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from maestra.core.state import State
from maestra.learning.dialogue import NotAskedError
from maestra.web import board_press
from maestra.web.access.guard import Teaching
from maestra.web.access.visitor import Visitor
from maestra.web.board_press import cell_of
from maestra.web.context import Context, Here
from maestra.web.pages import Page, Pages
from maestra.web.teach.actions import Action, CannotError, Hold, Why
from maestra.web.teach.desk import Desk, Kept, StaleError, Work
from maestra.web.teach.draft import Draft
from maestra.web.teach.showing import Touch
from maestra.web.teach.views import Views

FIRST: Final = "show"
"""The template of a draft's first page; the others are called as their addresses end."""
STALE: Final = "stale"

Seen = Annotated[str | None, Form(max_length=40)]
"""The draft's mark when the form was made."""
WhyNot = Annotated[str, Query(max_length=40)]
"""Why what was asked for before was not done; said at the top of the page."""


def path_of(draft: str, place: str = "") -> str:
    """Where a page of a draft is."""
    return f"/teach/{draft}/{place}" if place else f"/teach/{draft}"


def pressed(
    draft: Draft, now: State, cell: str, token: str, put: Callable[[Touch], Action]
) -> Action:
    """What a press on a board of a draft does.

    Args:
        draft: holds a token, or none.
        now: what lies where on that board.
        cell: the form's field.
        token: the form's field.
        put: what it is that a token is put on a cell there.

    Raises:
        CannotError: no board could do that.
    """
    match board_press.outcome(now, draft.held, cell_of(cell), token):
        case board_press.Held(taken):
            return Hold(taken)
        case board_press.Released():
            return Hold(None)
        case board_press.Moved(moved):
            return put(Touch(moved.token, moved.destination))
        case board_press.Nothing():
            raise CannotError(Why.CELL)


@dataclass(frozen=True, slots=True)
class Bench:
    """One request of somebody who teaches."""

    desk: Desk
    pages: Pages
    visitor: Visitor
    context: Context

    def change(
        self, draft: str, work: Work, place: str = "", at: str | None = None, then: str = ""
    ) -> Response:
        """Do something with a draft, and lead on to the page at `place`.

        Args:
            draft: which.
            work: what.
            place: a page of the draft; it says why nothing was done, if so.
            at: the mark of the draft that the form was made from.
            then: the page's query, if something was done.
        """
        why = ""
        try:
            self.desk.change(draft, work, at)
        except CannotError as error:
            why = error.why.value
        except (StaleError, NotAskedError):
            why = STALE
        query = urlencode({"why": why}) if why else then
        query = f"?{query}" if query else ""
        return RedirectResponse(f"{path_of(draft, place)}{query}", 303)

    def page(
        self, template: str, kept: Kept, why: str = "", status: int = 200, **parts: object
    ) -> HTMLResponse:
        """A page about a draft."""
        place = PurePath(template).stem
        text = self.pages.text(
            template,
            visitor=self.visitor,
            draft=kept.draft,
            kept=kept,
            root=path_of(kept.id),
            place="" if place == FIRST else f"/{place}",
            why=self.why(why),
            **parts,
        )
        return HTMLResponse(text, status)

    def views(self, kept: Kept) -> Views:
        """What is shown of a draft, in the visitor's language."""
        return Views(kept.draft, self.pages.language)

    def why(self, why: str) -> str:
        """Why something was not done, in a sentence; empty if nothing is known of it."""
        if why == STALE:
            return self.pages.say("This page was older than your exercise. Here it is as it is.")
        known = {one.value: one for one in Why}
        return self._because(known[why]) if why in known else ""

    def _because(self, why: Why) -> str:
        say = self.pages.say
        sentences = {
            Why.CELL: say("No token can be put there. Please choose an empty cell."),
            Why.NOTHING_SHOWN: say("Please move a token to the goal row first."),
            Why.NOTHING_TO_UNDO: say("There is nothing to undo."),
            Why.TOO_MUCH: say("This is as much as one exercise can hold. Please save it."),
            Why.NO_SUCH: say("That is so already."),
            Why.IN_USE: say("Your demonstrations need the tokens and the board as they are."),
            Why.NO_ROOM: say("There are more tokens than storage cells."),
            Why.NO_EXAM: say("The examples are over."),
            Why.NO_NAME: say("Please write a name, of at most 80 letters."),
            Why.NAME_TAKEN: say("The library has an exercise of this name. Please take another."),
            Why.TOO_MANY_DRAFTS: say("You have very many exercises begun. Please delete some."),
        }
        return sentences[why]


def _bench(context: Here, visitor: Teaching, pages: Page) -> Bench:
    return Bench(Desk(context, visitor), pages, visitor, context)


AtBench = Annotated[Bench, Depends(_bench)]
