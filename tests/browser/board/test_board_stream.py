"""The page of a room: what the stream says is shown, what is done is told, cuts lose nothing."""

import re
from typing import Any

from playwright.sync_api import WebSocketRoute, expect

from maestra.core.board import Board, Cell, Column, Row
from maestra.core.state import Move, State
from maestra.core.tokens import TokenId
from maestra.language import Language
from tests.browser.board.conftest import Seat, TakeSeat
from tests.browser.board.table import START, Table
from tests.browser.watching import Watch


def events(table: Table) -> list[tuple[str, Any]]:
    return [(one["event"], one.get("token")) for one in table.told]


def connected(seat: Seat, table: Table) -> None:
    seat.until(lambda: bool(table.sockets))


def test_a_drag_is_told_as_a_real_board_tells_it(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    mouse = seat.page.mouse
    mouse.move(*seat.middle(2, 1))
    mouse.down()
    mouse.move(*seat.middle(1, 2), steps=3)
    mouse.up()
    seat.until(lambda: events(table) == [("lifted", "n19"), ("placed", "n19")])
    assert table.told[-1]["cell"] == [1, 2]
    assert seat.lies_on("n19") == "1,2"


def test_a_drag_that_ends_where_it_began_is_put_back(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    mouse = seat.page.mouse
    mouse.move(*seat.middle(2, 1))
    mouse.down()
    mouse.move(1270, 500, steps=3)
    mouse.up()
    seat.until(lambda: events(table) == [("lifted", "n19"), ("put-back", "n19")])


def test_two_taps_are_told_one_by_one(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    seat.cell(2, 1).click()
    seat.until(lambda: events(table) == [("lifted", "n19")])
    expect(seat.cell(2, 1)).to_have_attribute("data-held", "")
    seat.cell(2, 2).click()
    seat.until(lambda: events(table)[1:] == [("put-back", "n19"), ("lifted", "n23")])
    seat.cell(1, 1).click()
    seat.until(lambda: events(table)[3:] == [("placed", "n23")])


def test_what_others_move_glides_on_the_screen(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    token, goal = TokenId("n19"), Cell(Row(1), Column(5))
    table.state = table.state.after(Move(token, table.state.cells[token], goal))
    table.tell()
    expect(seat.cell(1, 5).locator(".token")).to_have_count(1)
    expect(seat.cell(1, 5)).to_have_attribute("aria-label", "row 1, column 5, token 19")
    expect(seat.cell(2, 1)).to_have_attribute("aria-label", "row 2, column 1, empty")
    assert seat.page.evaluate("document.getAnimations().length") == 1


def test_the_robot_speaks_shows_its_face_and_points(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    table.extra = {
        "said": {"number": 7, "text": "<b>Try the 23 & smile</b>", "speech": None},
        "expression": "happy",
        "pointed": [[2, 2]],
        "view": {"view": "put-back", "tokens": [], "lines": ["One <i>", "Two"]},
        "question": {"number": 3, "matter": "question", "text": "Is it right?", "tokens": []},
    }
    table.tell()
    # What comes from the stream is text, never HTML.
    expect(seat.page.locator('[data-show="sentence"]')).to_have_text("<b>Try the 23 & smile</b>")
    expect(seat.page.locator(".face .happy")).to_be_visible()
    expect(seat.page.locator(".face .neutral")).to_be_hidden()
    expect(seat.cell(2, 2)).to_have_attribute(
        "aria-label", "row 2, column 2, token 23, the robot points here"
    )
    expect(seat.page.locator("#put-back")).to_be_visible()
    expect(seat.page.locator('[data-show="lines"] li')).to_have_text(["One <i>", "Two"])
    expect(seat.page.locator('[data-show="question"]')).to_have_text("Is it right?")
    seat.page.click("#yes")
    seat.until(lambda: table.told == [{"event": "answered", "reply": "yes", "question": 3}])
    table.extra = {}
    table.tell()
    expect(seat.page.locator("#put-back")).to_be_hidden()
    expect(seat.page.locator("#yes")).to_be_hidden()
    expect(seat.page.locator("[data-pointed]")).to_have_count(0)


def test_a_button_tells_its_event(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    seat.page.click("#help")
    seat.until(lambda: events(table) == [("help-asked", None)])


def test_new_sentences_are_spoken_and_can_be_heard_again(
    sit: TakeSeat, table: Table, watch: Watch
) -> None:
    watch.tolerate("/speech/")
    old = {"number": 1, "text": "Before", "speech": "/speech/1"}
    table.extra = {"said": old}
    seat = sit("/watched")
    connected(seat, table)
    expect(seat.page.locator("#replay")).to_be_visible()
    seat.page.evaluate(
        "() => { window.played = []; HTMLMediaElement.prototype.play ="
        " async function () { window.played.push(this.src.split('/').at(-1)); } }"
    )
    table.extra = {"said": {"number": 2, "text": "Now", "speech": "/speech/2"}}
    table.tell()
    table.tell()
    expect(seat.page.locator('[data-show="sentence"]')).to_have_text("Now")
    # What was said before the page was opened is not said again, and nothing twice.
    assert seat.page.evaluate("window.played") == ["2"]
    seat.page.click("#replay")
    assert seat.page.evaluate("window.played") == ["2", "2"]


def test_what_is_done_while_the_connection_is_cut_arrives_once(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit("/watched")
    connected(seat, table)
    seat.page.evaluate("window.marked = true")
    table.cut()
    expect(seat.page.locator("html[data-lost]")).to_have_count(1)
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    assert seat.lies_on("n19") == "1,1"
    seat.until(lambda: len(table.told) == 2)
    expect(seat.page.locator("html[data-lost]")).to_have_count(0)
    assert events(table) == [("lifted", "n19"), ("placed", "n19")]
    assert seat.page.evaluate("window.marked") is True
    assert seat.lies_on("n19") == "1,1"


def test_what_was_sent_into_a_dead_connection_is_sent_again(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    table.answers = False
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    seat.page.wait_for_timeout(500)
    assert table.told == []
    table.answers = True
    # Another state meanwhile does not take back what is on its way.
    table.tell()
    seat.page.wait_for_timeout(200)
    assert seat.lies_on("n19") == "1,1"
    seat.until(lambda: events(table) == [("lifted", "n19"), ("placed", "n19")])


def test_an_older_state_is_not_shown(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    table.extra = {"said": {"number": 2, "text": "New", "speech": None}}
    table.sequence = 50
    table.tell()
    table.extra = {"said": {"number": 1, "text": "Old", "speech": None}}
    table.sequence = 10
    table.tell()
    table.sequence = 60
    table.extra = {"expression": "caring", "said": {"number": 2, "text": "New", "speech": None}}
    table.tell()
    expect(seat.page.locator(".face .caring")).to_be_visible()
    expect(seat.page.locator('[data-show="sentence"]')).to_have_text("New")


def test_a_held_token_is_held_on_every_page_of_the_room(sit: TakeSeat, table: Table) -> None:
    seat, other = sit("/watched"), sit("/watched")
    seat.until(lambda: len(table.sockets) == 2)
    seat.cell(2, 3).click()
    expect(other.cell(2, 3)).to_have_attribute("data-held", "")
    seat.page.reload()
    expect(seat.cell(2, 3)).to_have_attribute("data-held", "")


def test_another_language_of_the_session_is_another_page_without_a_reload(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit("/watched")
    connected(seat, table)
    seat.page.evaluate("window.marked = true")
    seat.page.context.add_cookies(
        [{"name": "maestra-language", "value": "es", "url": seat.page.url}]
    )
    table.language = Language.ES
    table.tell()
    expect(seat.page.locator("html")).to_have_attribute("lang", "es")
    expect(seat.cell(2, 1)).to_have_attribute("aria-label", "fila 2, columna 1, ficha 19")
    assert seat.page.evaluate("window.marked") is True


def test_tokens_that_left_the_board_are_gone(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    table.state = State(Board(4, 5), {TokenId("n19"): START.cells[TokenId("n19")]})
    table.tell()
    expect(seat.page.locator("[data-board] .token")).to_have_count(1)
    expect(seat.cell(2, 2)).to_have_attribute("aria-label", re.compile("empty"))


def test_what_the_server_refuses_is_taken_back(sit: TakeSeat, table: Table) -> None:
    seat = sit("/watched")
    connected(seat, table)
    table.refuses = True
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    expect(seat.cell(2, 1).locator(".token")).to_have_count(1)
    expect(seat.page.locator("[data-held]")).to_have_count(0)
    assert table.told == []


def test_a_connection_that_is_silent_for_long_is_made_anew(sit: TakeSeat, table: Table) -> None:
    seat = sit("/elsewhere")
    seat.page.clock.install()
    seat.page.goto("/watched")
    connected(seat, table)
    seat.page.clock.run_for(25_000)
    assert table.connected == 1
    seat.page.clock.run_for(10_000)
    seat.until(lambda: table.connected == 2)


def test_when_there_is_nothing_more_to_follow_the_page_is_asked_for_again(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit("/watched")
    connected(seat, table)
    seat.page.evaluate("window.marked = true")
    table.cut(4404)
    seat.until(lambda: table.opened == 2)
    assert seat.page.evaluate("window.marked") is True


def test_attempts_to_come_back_wait_longer_and_longer(sit: TakeSeat, table: Table) -> None:
    seat = sit("/elsewhere")
    seat.page.clock.install()
    tried: list[int] = []

    def refuse(route: WebSocketRoute) -> None:
        tried.append(1)
        route.close()

    seat.page.route_web_socket(re.compile("/stream$"), refuse)
    seat.page.goto("/watched")
    seat.until(lambda: len(tried) == 1)
    counts: list[int] = []
    for _ in range(4):
        before = len(tried)
        seat.page.clock.run_for(5_000)
        seat.page.wait_for_timeout(50)
        counts.append(len(tried) - before)
    # 0.25, 0.5, 1, 2 s make four or five in the first five seconds; then one each.
    assert counts[-1] <= 2
    assert sum(counts) >= 4
    assert table.connected == 0
