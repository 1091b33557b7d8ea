"""Pages that are live: the answer is followed, and nothing typed is lost."""

import re
from itertools import pairwise
from typing import Any, cast

import pytest
from playwright.sync_api import Route, expect

from maestra.core.tokens import TokenId
from tests.browser.axe import findings
from tests.browser.board.conftest import Seat, TakeSeat
from tests.browser.board.table import Table
from tests.browser.lint import Reader, lint, too_wide
from tests.browser.watching import Watch

GLIDE_MS = 400


def loads(seat: Seat) -> int:
    """How often the page was loaded since it was marked."""
    return 0 if seat.page.evaluate("window.marked === true") else 1


def mark(seat: Seat) -> None:
    seat.page.evaluate("window.marked = true")


def test_a_form_is_sent_without_a_reload_and_its_region_follows(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit()
    mark(seat)
    seat.page.fill("#note", "typed elsewhere")
    seat.page.fill("#word", "odd")
    seat.page.keyboard.press("Enter")
    expect(seat.page.locator("#words li")).to_have_text(["odd"])
    expect(seat.page.locator("#word")).to_have_value("")
    expect(seat.page.locator("#word")).to_be_focused()
    expect(seat.page.locator("#note")).to_have_value("typed elsewhere")
    assert loads(seat) == 0
    assert table.words == ["odd"]


def test_a_fault_is_shown_at_its_field_and_the_address_stays(sit: TakeSeat) -> None:
    seat = sit()
    address = seat.page.url
    seat.page.click("#told button")
    expect(seat.page.locator("#fault")).to_be_visible()
    expect(seat.page.locator("#word")).to_be_focused()
    assert seat.page.url == address


def test_what_is_typed_while_an_answer_is_on_its_way_stays(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    table.delay_s = 0.3
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    seat.page.fill("#word", "half a wo")
    seat.until(lambda: len(table.moves) == 1)
    expect(seat.page.locator("#moves")).to_have_text("1")
    expect(seat.page.locator("#word")).to_have_value("half a wo")
    expect(seat.page.locator("#word")).to_be_focused()


def test_an_answer_that_leads_elsewhere_is_another_page(sit: TakeSeat) -> None:
    seat = sit()
    mark(seat)
    seat.page.fill("#word", "left behind")
    seat.page.click("#leave")
    expect(seat.page.get_by_role("heading", level=1)).to_have_text("Progress")
    expect(seat.page).to_have_url(re.compile("/elsewhere$"))
    # Its field is another one, though it has the same name.
    expect(seat.page.locator("#word")).to_have_value("")
    assert loads(seat) == 0
    seat.page.go_back()
    expect(seat.page.get_by_role("heading", level=1)).to_have_text("Board")


def test_a_search_is_sent_when_typing_rests_and_the_address_follows(sit: TakeSeat) -> None:
    seat = sit()
    seat.page.locator("#search").press_sequentially("odd", delay=30)
    expect(seat.page.locator("#found")).to_have_text("odd")
    expect(seat.page.locator("#search")).to_have_value("odd")
    expect(seat.page.locator("#search")).to_be_focused()
    expect(seat.page).to_have_url(re.compile(r"\?search=odd$"))


def test_the_language_changes_without_a_reload_and_nothing_typed_is_lost(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit()
    mark(seat)
    seat.page.fill("#word", "word")
    seat.page.fill("#note", "note")
    seat.page.check("#tick")
    seat.page.click("#more summary")
    seat.cell(2, 1).click()
    seat.until(lambda: table.held == TokenId("n19"))
    seat.page.get_by_role("button", name="Català").click()
    expect(seat.page.locator("html")).to_have_attribute("lang", "ca")
    expect(seat.page.get_by_role("heading", level=1)).to_have_text("Tauler")
    expect(seat.cell(2, 1)).to_have_attribute(
        "aria-label", "fila 2, columna 1, fitxa 19, a la seva mà"
    )
    expect(seat.page.locator("#word")).to_have_value("word")
    expect(seat.page.locator("#note")).to_have_value("note")
    expect(seat.page.locator("#tick")).to_be_checked()
    expect(seat.page.locator("#more")).to_have_attribute("open", "")
    expect(seat.page.get_by_role("button", name="Català")).to_be_focused()
    assert loads(seat) == 0
    # Words of the board are in the new language too.
    seat.cell(1, 1).click()
    expect(seat.page.locator("#announcer")).to_have_text("La fitxa 19 és a la fila 1, columna 1.")


def test_what_is_typed_is_kept_as_it_is_typed(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.page.locator("#note").press_sequentially("half a sentence", delay=10)
    expect(seat.page.locator("[data-draft-saved]")).to_be_visible()
    assert table.draft == "half a sentence"
    seat.page.reload()
    expect(seat.page.locator("#note")).to_have_value("half a sentence")


def test_what_is_typed_just_before_leaving_is_kept(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.page.fill("#note", "last words")
    seat.page.goto("/elsewhere")
    seat.until(lambda: table.draft == "last words")


def test_a_draft_that_could_not_be_sent_is_sent_again(
    sit: TakeSeat, table: Table, watch: Watch
) -> None:
    watch.tolerate("500 for POST")
    seat = sit()
    failed: list[str] = []

    def fail_once(route: Route) -> None:
        if failed:
            route.continue_()
        else:
            failed.append("once")
            route.fulfill(status=500)

    seat.page.route("**/draft", fail_once)
    seat.page.fill("#note", "again")
    seat.until(lambda: table.draft == "again")
    assert failed == ["once"]


def test_a_server_that_does_not_answer_loses_nothing(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.page.route("**/words", lambda route: route.abort())
    seat.page.route("**/moves", lambda route: route.abort())
    seat.page.fill("#word", "kept")
    seat.page.keyboard.press("Enter")
    expect(seat.page.locator("#unsent")).to_be_visible()
    expect(seat.page.locator("#word")).to_have_value("kept")
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    # A move that was not heard of is taken back.
    expect(seat.cell(2, 1).locator(".token")).to_have_count(1)
    seat.page.unroute("**/words")
    seat.page.fill("#word", "kept")
    seat.page.locator("#word").press("Enter")
    expect(seat.page.locator("#words li")).to_have_text(["kept"])
    expect(seat.page.locator("#unsent")).to_be_hidden()
    assert table.words == ["kept"]


@pytest.mark.parametrize(
    ("status", "kind"), [(500, "text/html"), (429, "application/problem+json")]
)
def test_an_answer_that_is_no_page_leaves_the_page_as_it_is(
    sit: TakeSeat, watch: Watch, status: int, kind: str
) -> None:
    watch.tolerate("500 for POST")
    seat = sit()
    seat.page.route(
        "**/words", lambda route: route.fulfill(status=status, content_type=kind, body="no")
    )
    seat.page.fill("#word", "kept")
    seat.page.keyboard.press("Enter")
    expect(seat.page.locator("#unsent")).to_be_visible()
    expect(seat.page.locator("#word")).to_have_value("kept")
    expect(seat.page.get_by_role("heading", level=1)).to_have_text("Board")


def test_a_draft_that_waits_is_not_kept_after_the_form_was_sent(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit()
    seat.page.evaluate(
        "() => { const form = document.getElementById('told').querySelector('form');"
        " form.dataset.draft = '/draft'; form.word.name = 'note'; }"
    )
    seat.page.fill("#word", "sent")
    seat.page.keyboard.press("Enter")
    expect(seat.page.locator("#fault")).to_be_visible()
    seat.page.wait_for_timeout(800)
    assert table.draft == ""


def test_a_form_that_is_pressed_twice_is_sent_once(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    table.delay_s = 0.2
    seat.page.fill("#word", "once")
    seat.page.locator("#told button").dblclick()
    expect(seat.page.locator("#words li")).to_have_text(["once"])
    assert table.words == ["once"]


def test_moves_made_faster_than_the_server_answers_all_arrive(sit: TakeSeat, table: Table) -> None:
    seat = sit(still=True)
    table.delay_s = 0.15
    for column in range(1, 6):
        seat.cell(2, column).click()
        seat.cell(1, column).click()
        # Shown at once, and not taken back by an answer to an earlier move.
        expect(seat.cell(1, column).locator(".token")).to_have_count(1, timeout=1000)
    seat.until(lambda: len(table.moves) == 5)
    expect(seat.page.locator("#moves")).to_have_text("5")
    for column in range(1, 6):
        assert table.state.cells[TokenId(f"n{(19, 23, 32, 34, 36)[column - 1]}")].row == 1


def test_the_held_token_stays_held_over_a_reload(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.cell(3, 2).click()
    seat.until(lambda: table.held == TokenId("n51"))
    seat.page.reload()
    expect(seat.cell(3, 2)).to_have_attribute("data-held", "")
    seat.cell(1, 1).click()
    expect(seat.cell(1, 1).locator(".token")).to_have_count(1)


def test_another_token_can_be_taken_up_instead(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.cell(2, 1).click()
    seat.cell(2, 2).click()
    expect(seat.cell(2, 2)).to_have_attribute("data-held", "")
    expect(seat.page.locator(".cell[data-held]")).to_have_count(1)
    seat.cell(1, 1).click()
    seat.until(lambda: [move.token for move in table.moves] == ["n23"])


# ---------------------------------------------------------------- motion


def glides(seat: Seat) -> list[dict[str, Any]]:
    """The motions under way."""
    script = """() => document.getAnimations().map((one) => one.effect.getComputedTiming())
        .map((timing) => ({duration: timing.duration, iterations: timing.iterations}))"""
    return cast("list[dict[str, Any]]", seat.page.evaluate(script))


def test_a_token_that_is_put_back_glides_for_a_moment(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    table.puts_back = True
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    seat.until(lambda: len(table.moves) == 1)
    seen: list[dict[str, Any]] = []
    for _ in range(40):
        seen += glides(seat)
        seat.page.wait_for_timeout(20)
    assert seat.lies_on("n19") == "2,1"
    assert seen
    assert all(one["duration"] <= GLIDE_MS and one["iterations"] == 1 for one in seen)


def test_nothing_moves_for_who_wants_no_motion(sit: TakeSeat, table: Table) -> None:
    seat = sit(still=True)
    table.puts_back = True
    seat.page.evaluate(
        "() => { window.animated = 0; const own = Element.prototype.animate;"
        "Element.prototype.animate = function (...all) {"
        " window.animated += 1; return own.apply(this, all); } }"
    )
    seat.cell(2, 1).click()
    seat.cell(1, 1).click()
    seat.until(lambda: len(table.moves) == 1)
    seat.page.wait_for_timeout(300)
    assert seat.lies_on("n19") == "2,1"
    assert seat.page.evaluate("window.animated") == 0
    assert glides(seat) == []


# ---------------------------------------------------------------- for everybody


@pytest.mark.parametrize("size", [(1280, 1000), (820, 1180), (360, 740)])
@pytest.mark.parametrize("reader", Reader)
def test_everybody_can_read_and_press_the_board(
    sit: TakeSeat, reader: Reader, size: tuple[int, int]
) -> None:
    seat = sit("/?patient" if reader is Reader.PATIENT else "/", size=size)
    faults = lint(seat.page, reader)
    # The page has a head, and forms of all kinds to be tried: more than a patient is given.
    others = r"controls:|a control of|another control|brand"
    own = [one for one in faults if not re.search(others, one)]
    assert own == []
    assert findings(seat.page) == []
    assert too_wide(seat.page) == []


def test_a_page_is_light(sit: TakeSeat) -> None:
    seat = sit()
    asked: list[str] = []
    sizes: list[int] = []
    seat.page.on("request", lambda request: asked.append(request.url))
    seat.page.on("response", lambda response: sizes.append(len(response.body())))
    seat.page.reload()
    seat.page.wait_for_selector("html[data-ready]")
    own = [url for url in asked if not url.endswith(".svg")]
    assert len(own) <= 3
    # Before they are made smaller on their way.
    assert sum(sizes) < 120_000


def test_focus_goes_round_the_board_only_by_arrows(sit: TakeSeat) -> None:
    seat = sit()
    seat.cell(2, 2).focus()
    seen = [seat.page.evaluate("document.activeElement.value")]
    for key in ("ArrowUp", "ArrowUp", "ArrowLeft", "ArrowLeft", "ArrowDown"):
        seat.page.keyboard.press(key)
        seen.append(seat.page.evaluate("document.activeElement.value"))
    # At the edge it stays.
    assert seen == ["2,2", "1,2", "1,2", "1,1", "1,1", "2,1"]
    assert all(abs(int(a[0]) - int(b[0])) <= 1 for a, b in pairwise(seen))
