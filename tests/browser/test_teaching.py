"""A newcomer teaches "ascending" to the end: by drag, by tap, by keyboard, without JavaScript."""

import re
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise

from playwright.sync_api import Browser, Locator, Page

from maestra.rules.exercise import LearnStatus, RuledExercise
from maestra.rules.exercise_format import decode_exercise
from maestra.rules.forms.order import Ordered
from maestra.rules.paper import NUMBERS
from maestra.web.access.visitor import Role
from tests.browser.axe import findings
from tests.browser.conftest import OpenBrowser
from tests.browser.lint import Reader, lint
from tests.browser.roles import log_in
from tests.browser.serving import Served
from tests.browser.sizes import Size

MOST_CLICKS = 12
LONGEST_S = 120
ROWS = (("19", "32", "46", "57", "68"), ("23", "34", "36", "51", "63"))


@dataclass
class Newcomer:
    """Somebody who has never seen it; what they press is counted, but for moves."""

    page: Page
    served: Served
    moves: Callable[["Newcomer", str, int], None]
    press: Callable[[Locator], None] = field(default=lambda one: one.click())
    clicks: int = 0

    def choose(self, button: Locator) -> None:
        """Press something that is no move."""
        self.press(button)
        self.clicks += 1

    def cell(self, row: int, column: int) -> Locator:
        return self.page.locator(f'#board button.cell[value="{row},{column}"]')

    def cell_of(self, token: str) -> Locator:
        return self.page.locator("#board button.cell").filter(
            has=self.page.locator(f'[data-token="{token}"]')
        )

    def show(self, row: Sequence[str]) -> None:
        """Make a row on the board; it is done once it is full."""
        for column, token in enumerate(row, start=1):
            self.moves(self, token, column)
            if column < len(row):
                self.cell(1, column).locator(f'[data-token="{token}"]').wait_for()
        self.page.locator("#understood .rules").wait_for()

    def asked(self) -> bool:
        return self.page.locator("#asked").count() > 0

    def answer(self) -> None:
        """Say what is true of ascending numbers."""
        goal = self.page.locator("#asked-board .row.goal .cell")
        shown = [one.locator("[data-token]") for one in goal.all()]
        values = [
            int(one.get_attribute("data-token") or "") if one.count() else None for one in shown
        ]
        before = self.page.locator("#asked").inner_text()
        name = "Yes" if rises(values) else "No"
        self.choose(self.page.get_by_role("button", name=name, exact=True))
        self.page.wait_for_function(
            "(before) => document.querySelector('#asked')?.innerText !== before", arg=before
        )

    def teach(self) -> None:
        """From the first page to the library."""
        self.choose(self.page.get_by_role("link", name="Teach an exercise"))
        self.choose(self.page.get_by_role("button", name="Numbers"))
        self.page.locator("#board").wait_for()
        for row in ROWS:
            self.show(row)
            while self.asked() and self.page.get_by_role("button", name="Yes", exact=True).count():
                self.answer()
            if self.page.locator(".verdict.good").count():
                break
        name = self.page.get_by_label("Name of the exercise")
        self.choose(name)
        name.fill("My ascending row")
        self.choose(self.page.get_by_role("button", name="Save in the library"))
        self.page.get_by_text("Saved as “My ascending row”, version 1.").wait_for()


def rises(values: Sequence[int | None]) -> bool:
    """Whether the row is ascending, or can still be filled so."""
    return any(
        all(shown is None or shown == wanted for shown, wanted in zip(values, row, strict=True))
        for row in combinations(NUMBERS, len(values))
        if all(one < other for one, other in pairwise(row))
    )


def saved(served: Served) -> RuledExercise:
    exercise = decode_exercise(served.context.store.exercise("My ascending row").exercise.encode())
    assert isinstance(exercise, RuledExercise)
    return exercise


def is_ascending(exercise: RuledExercise) -> bool:
    return exercise.status is LearnStatus.LEARNED and any(
        isinstance(rule, Ordered) and rule.attribute == "value" for rule in exercise.conjunction
    )


def by_drag(newcomer: Newcomer, token: str, column: int) -> None:
    newcomer.cell_of(token).drag_to(newcomer.cell(1, column))


def by_press(newcomer: Newcomer, token: str, column: int) -> None:
    newcomer.press(newcomer.cell_of(token))
    newcomer.page.locator(f'#board[data-held="{token}"]').wait_for()
    newcomer.press(newcomer.cell(1, column))


def by_keyboard(newcomer: Newcomer, token: str, column: int) -> None:
    newcomer.cell_of(token).focus()
    newcomer.page.keyboard.press("Enter")
    newcomer.page.locator(f'#board[data-held="{token}"]').wait_for()
    newcomer.cell(1, column).focus()
    newcomer.page.keyboard.press("Enter")


def entered(button: Locator) -> None:
    button.focus()
    if button.evaluate("(one) => one.matches('a, button')"):
        button.press("Enter")


def test_a_newcomer_teaches_ascending_by_drag_in_twelve_clicks_and_two_minutes(
    page: Page, served: Served
) -> None:
    newcomer = Newcomer(log_in(served, page, Role.CAREGIVER), served, by_drag)
    began = time.monotonic()
    newcomer.teach()
    assert time.monotonic() - began < LONGEST_S
    assert newcomer.clicks <= MOST_CLICKS
    assert is_ascending(saved(served))


def test_the_same_by_tap_on_a_phone(open_browser: OpenBrowser, served: Served) -> None:
    page = log_in(served, open_browser(Size.PHONE).new_page(), Role.CAREGIVER)
    newcomer = Newcomer(page, served, by_press, lambda one: one.tap())
    newcomer.teach()
    assert newcomer.clicks <= MOST_CLICKS
    assert is_ascending(saved(served))


def test_the_same_by_keyboard_alone(page: Page, served: Served) -> None:
    newcomer = Newcomer(log_in(served, page, Role.CAREGIVER), served, by_keyboard, entered)
    newcomer.teach()
    assert newcomer.clicks <= MOST_CLICKS
    assert is_ascending(saved(served))


def test_the_same_without_script(browser: Browser, served: Served) -> None:
    context = browser.new_context(base_url=served.url, java_script_enabled=False, locale="en")
    page = log_in(served, context.new_page(), Role.CAREGIVER)
    page.get_by_role("link", name="Teach an exercise").click()
    page.get_by_role("button", name="Numbers").click()
    newcomer = Newcomer(page, served, by_press)
    for column, token in enumerate(ROWS[0], start=1):
        newcomer.cell_of(token).click()
        newcomer.cell(1, column).click()
    while page.locator("#asked").count():
        goal = page.locator("#asked-board .row.goal .cell").all()
        values = [
            int(one.locator("[data-token]").get_attribute("data-token") or "")
            if one.locator("[data-token]").count()
            else None
            for one in goal
        ]
        name = "Yes" if rises(values) else "No"
        page.get_by_role("button", name=name, exact=True).click()
    page.get_by_label("Name of the exercise").fill("My ascending row")
    page.get_by_role("button", name="Save in the library").click()
    assert page.get_by_text("Saved as “My ascending row”, version 1.").count() == 1
    context.close()


PLACES = ("", "/tokens", "/features", "/words", "/try", "/exam")


def test_each_page_of_teaching_keeps_the_limits(caregiver_at: Page, served: Served) -> None:
    page = caregiver_at
    page.goto("/teach")
    page.get_by_role("button", name="Numbers").click()
    page.locator("#board").wait_for()
    root = page.url
    found: list[object] = []
    for place in PLACES:
        page.goto(f"{root}{place}")
        found += [*findings(page), *lint(page, Reader.CAREGIVER)]
    page.goto(root)
    Newcomer(page, served, by_press).show(ROWS[0])
    for place in PLACES:
        page.goto(f"{root}{place}")
        if place == "/exam":
            page.get_by_role("button", name="Show me examples").click()
            page.locator("#asked").wait_for()
        found += [*findings(page), *lint(page, Reader.CAREGIVER)]
    assert found == []


def test_a_move_is_tried_and_refused_with_the_reason(page: Page, served: Served) -> None:
    log_in(served, page, Role.CAREGIVER)
    newcomer = Newcomer(page, served, by_drag)
    newcomer.teach()
    page.get_by_role("link", name="Try it yourself").click()
    page.locator("#try-head").wait_for()
    by_drag(newcomer, "46", 1)
    page.get_by_text("Allowed.", exact=True).wait_for()
    by_drag(newcomer, "19", 2)
    page.get_by_text("19 is not larger than 46 on its left.").wait_for()
    assert re.search(r"^[2-4],", newcomer.cell_of("19").get_attribute("value") or "")


def test_the_exam_is_held_to_its_end(page: Page, served: Served) -> None:
    log_in(served, page, Role.CAREGIVER)
    newcomer = Newcomer(page, served, by_drag)
    newcomer.teach()
    page.get_by_role("link", name="Let Maestra show you examples").click()
    page.get_by_role("button", name="Show me examples").click()
    for number in range(1, 11):
        page.get_by_text(f"Example {number} of 10").wait_for()
        goal = page.locator("#asked-board .row.goal [data-token]").all()
        values = [int(one.get_attribute("data-token") or "") for one in goal]
        order = page.locator("#asked").inner_text()
        # A row may be right and have been filled in another order; that is right here, too.
        right = len(values) == 5 and rises(values)
        assert order.startswith("Is this row right")
        page.get_by_role("button", name="Right" if right else "Wrong", exact=True).click()
    page.get_by_text("You agreed with 5 of 5 plays.").wait_for()
    page.get_by_text("Of 5 rows that I hold for wrong you called 5 wrong too.").wait_for()


def test_what_is_typed_as_a_name_is_there_after_a_reload(page: Page, served: Served) -> None:
    log_in(served, page, Role.CAREGIVER)
    newcomer = Newcomer(page, served, by_press)
    page.goto("/teach")
    page.get_by_role("button", name="Numbers").click()
    page.locator("#board").wait_for()
    newcomer.show(ROWS[0])
    with page.expect_response(re.compile("/name$")):
        page.get_by_label("Name of the exercise").fill("Half a na")
    page.reload()
    assert page.get_by_label("Name of the exercise").input_value() == "Half a na"
