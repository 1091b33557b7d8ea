"""Every move of the board by drag, by two taps, by keyboard, with one switch, without script."""

from collections.abc import Callable
from itertools import pairwise
from typing import Final

import pytest
from playwright.sync_api import CDPSession, expect

from maestra.core.board import Board, Cell
from maestra.core.state import State
from maestra.core.tokens import TokenId
from tests.browser.board.conftest import Seat, TakeSeat
from tests.browser.board.table import BOARD, DECK, START, Table

SCAN_MS: Final = 800
"""Long enough for a test on a busy computer to press in time."""


def cells_of(table: Table) -> list[Cell]:
    return [move.destination for move in table.moves]


def drag(seat: Seat, origin: Cell, destination: Cell) -> None:
    mouse = seat.page.mouse
    mouse.move(*seat.middle(origin.row, origin.column))
    mouse.down()
    mouse.move(*seat.middle(destination.row, destination.column), steps=4)
    mouse.up()


def tap_tap(seat: Seat, origin: Cell, destination: Cell) -> None:
    seat.cell(origin.row, origin.column).click()
    seat.cell(destination.row, destination.column).click()


def by_keyboard(seat: Seat, origin: Cell, destination: Cell) -> None:
    keyboard = seat.page.keyboard

    def go_to(wanted: Cell) -> None:
        at = seat.page.evaluate("document.activeElement.value").split(",")
        row, column = int(at[0]), int(at[1])
        for _ in range(abs(wanted.row - row)):
            keyboard.press("ArrowDown" if wanted.row > row else "ArrowUp")
        for _ in range(abs(wanted.column - column)):
            keyboard.press("ArrowRight" if wanted.column > column else "ArrowLeft")

    seat.page.locator('button.cell[tabindex="0"]').focus()
    go_to(origin)
    keyboard.press("Enter")
    go_to(destination)
    keyboard.press("Enter")


PLAYERS: Final[dict[str, Callable[[Seat, Cell, Cell], None]]] = {
    "drag": drag,
    "tap": tap_tap,
    "keyboard": by_keyboard,
}


@pytest.mark.parametrize("path", ["/", "/watched"])
@pytest.mark.parametrize("player", PLAYERS.values(), ids=PLAYERS)
def test_a_token_can_be_moved_from_each_cell_to_each_other(
    player: Callable[[Seat, Cell, Cell], None], path: str, sit: TakeSeat, table: Table
) -> None:
    # One token goes round the board, so that every cell is left and reached once; the others
    # are out of its way.
    first = TokenId("n19")
    table.state = type(START)(BOARD, {first: Cell(BOARD.cells[0].row, BOARD.cells[0].column)})
    seat = sit(path, still=True)
    way = [*BOARD.cells, BOARD.cells[0]]
    for origin, destination in pairwise(way):
        player(seat, origin, destination)
        expect(seat.cell(destination.row, destination.column)).to_have_attribute(
            "aria-label", f"row {destination.row}, column {destination.column}, token 19"
        )
    expect(seat.token("n19")).to_have_count(1)
    seat.until(lambda: len(table.moves) == len(way) - 1)
    assert cells_of(table) == way[1:]


def test_without_script_the_first_press_takes_up_and_the_second_puts_down(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit(script=False)
    for token, column in (("n19", 1), ("n23", 2), ("n77", 5)):
        origin = table.state.cells[TokenId(token)]
        seat.cell(origin.row, origin.column).click()
        expect(seat.cell(origin.row, origin.column)).to_have_attribute("data-held", "")
        seat.cell(1, column).click()
        assert seat.lies_on(token) == f"1,{column}"
    assert len(table.moves) == 3


class Switch:
    """Somebody with one key, who presses it when the right thing is offered."""

    def __init__(self, seat: Seat) -> None:
        self.seat = seat

    def press(self) -> None:
        self.seat.page.keyboard.press("Space")

    def choose(self, selector: str) -> None:
        """Press once this is offered."""
        self.seat.page.locator(f"{selector}.scanned").wait_for()
        self.press()


def test_one_key_moves_tokens_by_row_and_then_by_cell(sit: TakeSeat, table: Table) -> None:
    seat = sit(f"/?scan={SCAN_MS}", still=True)
    switch = Switch(seat)
    for token, cell in (("n46", "1,1"), ("n23", "1,5")):
        origin = table.state.cells[TokenId(token)]
        row, column = cell.split(",")
        switch.press()
        switch.choose(f".row:nth-child({origin.row})")
        switch.choose(f'.cell[value="{origin.row},{origin.column}"]')
        # What was taken up has to go somewhere: rows are offered by themselves.
        switch.choose(f".row:nth-child({row})")
        switch.choose(f'.cell[value="{row},{column}"]')
        expect(seat.cell(int(row), int(column)).locator(".token")).to_have_count(1)
        expect(seat.page.locator(".scanned")).to_have_count(0)
    assert [move.token for move in table.moves] == ["n46", "n23"]


def test_one_touch_anywhere_is_a_switch(sit: TakeSeat, table: Table) -> None:
    seat = sit(f"/?scan={SCAN_MS}", still=True, touch=True)
    touch = seat.page.touchscreen
    for wanted in (
        ".row:nth-child(2)",
        '.cell[value="2,1"]',
        ".row:nth-child(1)",
        '.cell[value="1,3"]',
    ):
        if wanted == ".row:nth-child(2)":
            touch.tap(5, 400)
        seat.page.locator(f"{wanted}.scanned").wait_for()
        touch.tap(5, 400)
    expect(seat.cell(1, 3).locator(".token")).to_have_count(1)
    seat.until(lambda: bool(table.moves))
    assert cells_of(table) == [Cell(BOARD.goal_row, BOARD.cells[2].column)]


def test_one_switch_reaches_the_controls_after_the_rows(sit: TakeSeat) -> None:
    seat = sit(f"/?scan={SCAN_MS}", still=True)
    seat.page.evaluate(
        "document.getElementById('control').addEventListener('click',"
        " () => document.body.setAttribute('data-clicked', ''))"
    )
    switch = Switch(seat)
    switch.press()
    switch.choose(".controls")
    expect(seat.page.locator("body[data-clicked]")).to_have_count(1)


def test_nobody_at_the_switch_ends_the_offers(sit: TakeSeat) -> None:
    seat = sit("/?scan=40", still=True)
    Switch(seat).press()
    expect(seat.page.locator(".scanned")).to_have_count(1)
    expect(seat.page.locator(".scanned")).to_have_count(0)


# ---------------------------------------------------------------- shaking hands


def test_a_press_that_slips_a_little_is_a_tap(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    mouse = seat.page.mouse
    x, y = seat.middle(2, 1)
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 11, y)
    expect(seat.page.locator(".carried")).to_have_count(0)
    mouse.up()
    expect(seat.cell(2, 1)).to_have_attribute("data-held", "")
    expect(seat.page.locator("#announcer")).to_contain_text("19")
    assert table.moves == []


def test_a_press_that_moves_more_than_that_carries_the_token(sit: TakeSeat) -> None:
    seat = sit()
    mouse = seat.page.mouse
    x, y = seat.middle(2, 1)
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 14, y)
    expect(seat.page.locator(".carried")).to_have_count(1)
    mouse.up()
    # Let go over its own cell it stays, and is in nobody's hand.
    expect(seat.page.locator(".carried")).to_have_count(0)
    expect(seat.page.locator("[data-held]")).to_have_count(0)


def test_a_tap_beside_a_cell_is_meant_for_the_cell(sit: TakeSeat) -> None:
    seat = sit()
    box = seat.cell(2, 1).bounding_box()
    assert box is not None
    seat.page.mouse.click(box["x"] - 8, box["y"] + box["height"] / 2)
    expect(seat.cell(2, 1)).to_have_attribute("data-held", "")


@pytest.mark.parametrize(("right", "down"), [(0.4, 0.0), (0.0, -0.45), (-0.3, 0.3), (0.0, -0.9)])
def test_a_token_let_go_beside_a_cell_goes_onto_the_nearest(
    right: float, down: float, sit: TakeSeat, table: Table
) -> None:
    seat = sit()
    x, y = seat.middle(1, 3)
    box = seat.cell(1, 3).bounding_box()
    assert box is not None
    mouse = seat.page.mouse
    mouse.move(*seat.middle(3, 3))
    mouse.down()
    mouse.move(x + right * box["width"], y + down * box["height"], steps=3)
    mouse.up()
    expect(seat.cell(1, 3).locator(".token")).to_have_count(1)
    seat.until(lambda: bool(table.moves))
    assert [(move.token, move.destination.column) for move in table.moves] == [("n57", 3)]


def test_a_token_let_go_far_from_the_board_goes_back(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    mouse = seat.page.mouse
    mouse.move(*seat.middle(2, 1))
    mouse.down()
    mouse.move(1200, 900, steps=3)
    mouse.up()
    seat.page.wait_for_timeout(500)
    assert seat.lies_on("n19") == "2,1"
    assert table.presses == []


def test_a_token_let_go_on_another_one_goes_back(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    drag(seat, BOARD.storage_cells[0], BOARD.storage_cells[1])
    expect(seat.page.locator("#announcer")).to_have_text("This cell is taken.")
    seat.page.wait_for_timeout(500)
    assert seat.lies_on("n19") == "2,1"
    assert table.presses == []


class Fingers:
    """Touches as the screen tells them."""

    def __init__(self, seat: Seat) -> None:
        self.devtools: CDPSession = seat.page.context.new_cdp_session(seat.page)

    def tell(self, what: str, *points: tuple[int, float, float]) -> None:
        """The fingers that are down, each with its number and place."""
        self.devtools.send(  # pyright: ignore[reportUnknownMemberType] - Playwright's dict is bare
            "Input.dispatchTouchEvent",
            {"type": what, "touchPoints": [{"id": n, "x": x, "y": y} for n, x, y in points]},
        )


def test_a_finger_drags_a_token(sit: TakeSeat, table: Table) -> None:
    seat = sit(touch=True)
    fingers = Fingers(seat)
    (x, y), (to_x, to_y) = seat.middle(2, 2), seat.middle(1, 2)
    fingers.tell("touchStart", (0, x, y))
    for step in range(1, 5):
        fingers.tell("touchMove", (0, x + (to_x - x) * step / 4, y + (to_y - y) * step / 4))
    fingers.tell("touchEnd")
    expect(seat.cell(1, 2).locator(".token")).to_have_count(1)
    seat.until(lambda: bool(table.moves))
    assert [move.token for move in table.moves] == ["n23"]


def test_a_second_finger_is_ignored(sit: TakeSeat, table: Table) -> None:
    seat = sit(touch=True)
    fingers = Fingers(seat)
    (x, y), (to_x, to_y), other = seat.middle(2, 2), seat.middle(1, 2), seat.middle(3, 4)
    fingers.tell("touchStart", (0, x, y))
    fingers.tell("touchMove", (0, x, y - 40))
    fingers.tell("touchStart", (0, x, y - 40), (1, *other))
    fingers.tell("touchMove", (0, to_x, to_y), (1, other[0] + 60, other[1]))
    expect(seat.page.locator(".carried")).to_have_count(1)
    fingers.tell("touchMove", (0, to_x, to_y))
    expect(seat.page.locator(".carried")).to_have_count(1)
    fingers.tell("touchEnd")
    expect(seat.cell(1, 2).locator(".token")).to_have_count(1)
    seat.until(lambda: bool(table.moves))
    assert [move.token for move in table.moves] == ["n23"]
    expect(seat.page.locator("[data-held]")).to_have_count(0)


def test_a_touch_that_the_system_takes_away_puts_the_token_back(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit(touch=True)
    fingers = Fingers(seat)
    x, y = seat.middle(2, 2)
    fingers.tell("touchStart", (0, x, y))
    fingers.tell("touchMove", (0, x, y - 60))
    expect(seat.page.locator(".carried")).to_have_count(1)
    fingers.tell("touchCancel")
    expect(seat.page.locator(".carried")).to_have_count(0)
    assert seat.lies_on("n23") == "2,2"
    tap_tap(seat, Cell(BOARD.storage_cells[1].row, BOARD.storage_cells[1].column), BOARD.cells[0])
    expect(seat.cell(1, 1).locator(".token")).to_have_count(1)
    seat.until(lambda: bool(table.moves))
    assert [move.token for move in table.moves] == ["n23"]


def test_a_press_of_a_screen_reader_counts_though_no_finger_was_seen(
    sit: TakeSeat, table: Table
) -> None:
    seat = sit()
    for cell in ("2,1", "1,4"):
        seat.page.evaluate(
            """value => document.querySelector(`.cell[value="${value}"]`).dispatchEvent(
                new MouseEvent("click", {bubbles: true, cancelable: true, detail: 1}))""",
            cell,
        )
    expect(seat.cell(1, 4).locator(".token")).to_have_count(1)
    seat.until(lambda: [move.token for move in table.moves] == ["n19"])


def test_escape_ends_a_drag(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    mouse = seat.page.mouse
    mouse.move(*seat.middle(2, 1))
    mouse.down()
    mouse.move(*seat.middle(1, 1), steps=3)
    seat.page.keyboard.press("Escape")
    expect(seat.page.locator(".carried")).to_have_count(0)
    mouse.up()
    seat.page.wait_for_timeout(300)
    assert seat.lies_on("n19") == "2,1"
    assert table.presses == []


def test_a_board_wider_than_the_screen_comes_along_with_the_token(
    sit: TakeSeat, table: Table
) -> None:
    wide = Board(2, 12)
    cells = zip(DECK.by_id, wide.storage_cells, strict=False)
    table.state = State(wide, dict(cells))
    seat = sit(size=(360, 740))
    expect(seat.cell(1, 12)).not_to_be_in_viewport()
    mouse = seat.page.mouse
    x, y = seat.middle(2, 1)
    mouse.move(x, y)
    mouse.down()
    mouse.move(345, y, steps=3)
    expect(seat.cell(1, 12)).to_be_in_viewport(ratio=0.9)
    mouse.move(*seat.middle(1, 12), steps=3)
    mouse.up()
    seat.until(lambda: [move.destination.column for move in table.moves] == [12])
    assert seat.page.evaluate("document.documentElement.scrollWidth") == 360


def test_escape_puts_down_what_was_taken_up(sit: TakeSeat, table: Table) -> None:
    seat = sit()
    seat.cell(2, 1).click()
    expect(seat.cell(2, 1)).to_have_attribute("data-held", "")
    seat.page.keyboard.press("Escape")
    expect(seat.page.locator("[data-held]")).to_have_count(0)
    expect(seat.page.locator("#announcer")).to_have_text("Token 19 stays where it was.")
    seat.until(lambda: table.presses == ["2,1", "2,1"])
    assert table.held is None


def test_only_one_cell_is_in_the_order_of_the_tab_key(sit: TakeSeat) -> None:
    seat = sit()
    expect(seat.page.locator('button.cell[tabindex="0"]')).to_have_count(1)
    seat.cell(3, 2).focus()
    seat.page.keyboard.press("End")
    expect(seat.cell(3, 5)).to_be_focused()
    expect(seat.cell(3, 5)).to_have_attribute("tabindex", "0")
    expect(seat.page.locator('button.cell[tabindex="0"]')).to_have_count(1)
    seat.page.keyboard.press("Home")
    expect(seat.cell(3, 1)).to_be_focused()
