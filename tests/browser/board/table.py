"""A tiny app of the tests' own: a board played by forms, and one played by a stream.

Templates, style and module are the real ones.
"""

from __future__ import annotations

import asyncio
import json
from dataclasses import dataclass, field
from functools import partial
from importlib.resources import files
from typing import Annotated, Any, Final

from babel.support import Format
from fastapi import FastAPI, Form, WebSocket, WebSocketDisconnect
from fastapi.responses import HTMLResponse, RedirectResponse, Response
from jinja2 import ChoiceLoader, DictLoader, Environment, PackageLoader, StrictUndefined
from starlette.requests import Request
from starlette.staticfiles import StaticFiles

from maestra.core.board import Board, Cell
from maestra.core.state import Move, State
from maestra.core.tokens import Deck, Token, TokenId
from maestra.language import Language
from maestra.web import language_choice
from maestra.web.access.visitor import Right
from maestra.web.board_press import (
    CellText,
    Held,
    Moved,
    Nothing,
    Released,
    TokenText,
    cell_of,
    outcome,
)
from maestra.web.board_view import board_view, tokens_by_id
from maestra.web.headers import SecurityHeaders
from maestra.web.translations import translate

BOARD: Final = Board(4, 5)
DECK: Final = Deck(
    tuple(
        Token(TokenId(f"n{value}"), (("value", value),))
        for value in (19, 23, 32, 34, 36, 46, 51, 57, 63, 77)
    )
)
START: Final = State(
    BOARD,
    {token.id: cell for token, cell in zip(DECK.tokens, BOARD.storage_cells, strict=False)},
)
COOKIES_LANGUAGE: Final = language_choice.COOKIE

PAGES: Final = {
    "forms.html": """
{% extends "base.html" %}
{% from "parts/board.html" import board %}
{% block body %}{% if patient %} class="patient"{% endif %}{% endblock %}
{% block main %}
<h1>{{ _("Board") }}</h1>
<div class="beside">
{{ board(view, _, action="/moves", scan=scan) }}
<section id="told" data-live>
  <p id="moves">{{ table.moves|length }}</p>
  <ul id="words">{% for word in table.words %}<li>{{ word }}</li>{% endfor %}</ul>
  <form method="post" action="/words" data-swap>
    <div class="field">
      <label for="word">{{ _("Teach") }}</label>
      <input id="word" name="word" value=""{% if fault %} aria-invalid="true"{% endif %}>
      {% if fault %}<p class="fault" id="fault">{{ fault }}</p>{% endif %}
    </div>
    <button>{{ _("Start") }}</button>
  </form>
</section>
</div>
<form method="post" action="/draft" data-draft="/draft">
  <div class="field">
    <label for="note">{{ _("Library") }}</label>
    <textarea id="note" name="note">{{ table.draft }}</textarea>
  </div>
  <label class="check"><input type="checkbox" id="tick" name="tick"> {{ _("Progress") }}</label>
  <p data-draft-saved hidden>✓</p>
</form>
<details id="more"><summary>{{ _("Help") }}</summary><p>…</p></details>
<form method="get" action="/" data-auto data-swap>
  <label for="search">{{ _("Sessions") }}</label>
  <input id="search" name="search" value="{{ search }}">
  <p id="found" data-live>{{ search }}</p>
</form>
<form method="post" action="/elsewhere" data-swap>
  <button id="leave">{{ _("Main") }}</button>
</form>
<div class="controls"><button type="button" id="control">{{ _("Help") }}</button></div>
{% endblock %}
""",
    "stream.html": """
{% extends "base.html" %}
{% from "parts/board.html" import board %}
{% from "parts/face.html" import face %}
{% block body %} class="patient"{% endblock %}
{% block main %}
<h1 class="sr">{{ _("Board") }}</h1>
<div class="robot">
  {{ face("neutral") }}
  <p class="said" data-show="sentence" aria-live="polite">{{ said }}</p>
</div>
{{ board(view, _, stream="/stream") }}
<p data-when="view-put-back" id="put-back" hidden>…</p>
<ul data-show="lines" class="plain"></ul>
<p data-when="question" hidden><span data-show="question"></span>
  <button data-event='{"event":"answered","reply":"yes"}' id="yes">{{ _("right") }}</button></p>
<div class="controls">
  <button data-event='{"event":"help-asked"}' id="help">{{ _("Help") }}</button>
  <button data-replay data-when="speech" hidden id="replay">{{ _("Start") }}</button>
</div>
{% endblock %}
""",
    "elsewhere.html": """
{% extends "base.html" %}
{% block main %}<h1>{{ _("Progress") }}</h1><input id="word" name="word" value="">{% endblock %}
""",
}


@dataclass
class Table:
    """What the app holds; tests look at it and change it."""

    state: State = START
    held: TokenId | None = None
    moves: list[Move] = field(default_factory=list[Move])
    presses: list[str] = field(default_factory=list[str])
    """The cell of each form of the board that came, and the token where one came along."""
    words: list[str] = field(default_factory=list[str])
    draft: str = ""
    puts_back: bool = False
    """Whether every move is refused: tokens stay where they were."""
    delay_s: float = 0.0
    """How long each move takes."""
    told: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    """Events that came by the stream, each id once."""
    heard: set[str] = field(default_factory=set[str])
    answers: bool = True
    """Whether events are acknowledged."""
    refuses: bool = False
    """Whether events are refused as faults."""
    opened: int = 0
    """How often a page of the room was asked for."""
    connected: int = 0
    """How often a page began to follow the stream."""
    sockets: list[tuple[asyncio.AbstractEventLoop, WebSocket]] = field(
        default_factory=list[tuple[asyncio.AbstractEventLoop, WebSocket]]
    )
    sequence: int = 0
    extra: dict[str, Any] = field(default_factory=dict[str, Any])
    """What the next states say besides."""
    language: Language = Language.EN

    def move(self, move: Move) -> None:
        """A move that was made on the page."""
        self.moves.append(move)
        self.held = None
        if not self.puts_back:
            self.state = self.state.after(move)

    def press(self, cell: Cell, token: str) -> None:
        """A cell was pressed, or a whole move made."""
        match outcome(self.state, self.held, cell, token):
            case Held(held):
                self.held = held
            case Released():
                self.held = None
            case Moved(move):
                self.move(move)
            case Nothing():
                pass

    def message(self) -> dict[str, Any]:
        """The state as the stream carries it."""
        self.sequence += 1
        board = self.state.board
        tokens = tokens_by_id(DECK, board, self.language)
        return {
            "type": "state",
            "sequence": self.sequence,
            "session": "one",
            "phase": "playing",
            "connected": True,
            "board": {"rows": board.rows, "columns": board.columns, "goal_row": 1},
            "cells": {t: [c.row, c.column] for t, c in self.state.cells.items()},
            "held": [] if self.held is None else [self.held],
            "tokens": {token: view.as_json() for token, view in tokens.items()},
            "said": None,
            "expression": "neutral",
            "pointed": [],
            "view": None,
            "question": None,
            "language": self.language.value,
            **self.extra,
        }

    def tell(self) -> None:
        """Send the state to all pages; from the test's thread."""
        text = json.dumps(self.message())
        for loop, socket in self.sockets:
            asyncio.run_coroutine_threadsafe(socket.send_text(text), loop).result(10)

    def cut(self, code: int = 1011) -> None:
        """Close every connection: as a broken network would, or as the server says."""
        for loop, socket in list(self.sockets):
            asyncio.run_coroutine_threadsafe(socket.close(code), loop).result(10)

    def happened(self, event: dict[str, Any]) -> None:
        """An event of the page."""
        self.told.append(event)
        if event["event"] == "lifted":
            self.held = TokenId(event["token"])
        elif event["event"] == "put-back":
            self.held = None
        elif event["event"] == "placed":
            token, (row, column) = TokenId(event["token"]), event["cell"]
            cell = Cell(row, column)
            self.move(Move(token, self.state.cells[token], cell))


class _Site:
    """The pages of one table."""

    def __init__(self, table: Table) -> None:
        self.table = table
        self.pages = Environment(
            loader=ChoiceLoader([DictLoader(PAGES), PackageLoader("maestra.web", "templates")]),
            autoescape=True,
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
        )

    def page(self, request: Request, name: str, status: int = 200, **parts: object) -> Response:
        language = language_choice.language_of(request)
        table = self.table
        text = self.pages.get_template(name).render(
            _=partial(translate, language),
            language=language,
            languages=tuple(Language),
            Right=Right,
            path=request.url.path,
            localised=Format(language.value),
            visitor=None,
            table=table,
            view=board_view(
                table.state.board, DECK, table.state.cells, held=table.held, language=language
            ),
            **parts,
        )
        return HTMLResponse(text, status)

    def forms(self, request: Request, fault: str = "", status: int = 200) -> Response:
        query = request.query_params
        return self.page(
            request,
            "forms.html",
            status,
            scan=int(query.get("scan", "0")),
            patient="patient" in query,
            search=query.get("search", ""),
            fault=fault,
        )


def _add_forms(app: FastAPI, site: _Site) -> None:
    table = site.table

    @app.get("/")
    def read(request: Request) -> Response:
        return site.forms(request)

    @app.post("/moves")
    async def press(request: Request, cell: CellText, token: TokenText = "") -> Response:
        await asyncio.sleep(table.delay_s)
        table.presses.append(f"{token} {cell}".strip())
        table.press(cell_of(cell), token)
        query = request.headers.get("referer", "").partition("?")[2]
        return RedirectResponse(f"/?{query}" if query else "/", 303)

    @app.post("/words")
    def add(request: Request, word: Annotated[str, Form()] = "") -> Response:
        if not word:
            return site.forms(request, fault="?", status=422)
        table.words.append(word)
        return RedirectResponse("/", 303)

    @app.post("/draft", status_code=204)
    def keep(note: Annotated[str, Form()] = "") -> None:
        table.draft = note

    @app.post("/elsewhere")
    def leave() -> Response:
        return RedirectResponse("/elsewhere", 303)

    @app.get("/elsewhere")
    def elsewhere(request: Request) -> Response:
        return site.page(request, "elsewhere.html")


def _add_stream(app: FastAPI, site: _Site) -> None:
    table = site.table

    @app.get("/watched")
    def watched(request: Request) -> Response:
        table.opened += 1
        return site.page(request, "stream.html", said="")

    @app.websocket("/stream")
    async def stream(socket: WebSocket) -> None:
        await socket.accept()
        mine = (asyncio.get_running_loop(), socket)
        table.sockets.append(mine)
        table.connected += 1
        await socket.send_text(json.dumps(table.message()))
        try:
            while True:
                message = json.loads(await socket.receive_text())
                if not table.answers:
                    continue
                if table.refuses:
                    fault: dict[str, Any] = {"type": "fault", "id": message["id"], "faults": []}
                    await socket.send_text(json.dumps(fault))
                    continue
                if message["id"] not in table.heard:
                    table.heard.add(message["id"])
                    table.happened(message["event"])
                await socket.send_text(json.dumps({"type": "ack", "id": message["id"]}))
                text = json.dumps(table.message())
                for _, each in table.sockets:
                    await each.send_text(text)
        except (WebSocketDisconnect, RuntimeError):
            pass
        finally:
            table.sockets.remove(mine)


def table_app(table: Table) -> FastAPI:
    """The app over `table`."""
    app, site = FastAPI(), _Site(table)
    _add_forms(app, site)
    _add_stream(app, site)
    app.include_router(language_choice.router)
    app.mount("/static", StaticFiles(directory=str(files("maestra.web") / "static")), "static")
    app.add_middleware(SecurityHeaders, over_tls=False)
    return app
