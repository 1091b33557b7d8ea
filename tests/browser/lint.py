"""The limits of the screens, measured in the browser: sizes, gaps, text, controls, focus, motion.

Sources: WCAG 2.2 AA, COGA; where a number is stricter than these it is the project's own.
"""

from enum import Enum
from pathlib import Path
from typing import Final, cast

from playwright.sync_api import Page

_MEASURE: Final = (Path(__file__).parent / "lint.js").read_text("utf-8")


class Reader(Enum):
    """Whom a page is for."""

    CAREGIVER = "caregiver"
    PATIENT = "patient"


LEAST_TEXT_PX: Final = {Reader.CAREGIVER: 18, Reader.PATIENT: 24}
LEAST_CELL_PX: Final = 88
LEAST_CELL_ON_A_PHONE_PX: Final = 44
"""Five cells of 88 px are wider than a phone; there a finger's width is what is left."""
LEAST_BUTTON_PX: Final = {Reader.CAREGIVER: 24, Reader.PATIENT: 64}
"""24: WCAG 2.2, target size."""
LEAST_GAP_PX: Final = 10
"""Between the patient's buttons."""
MOST_CONTROLS: Final = 3
"""Of the patient besides the board."""
LEAST_RING_PX: Final = 2
LEAST_FOCUS_CONTRAST: Final = 3
"""Of the ring around what has the focus, to what it lies on: WCAG 1.4.11 and 2.4.13."""
LONGEST_MOTION_MS: Final = 400
WIDE_ENOUGH_FOR_A_BOARD_PX: Final = 560
"""Five cells of 88 px, their gaps and margins."""


def lint(page: Page, reader: Reader) -> list[str]:
    """What of the page is beyond the limits for its reader; nothing on a page that keeps them."""
    viewport = page.viewport_size
    assert viewport is not None
    wide = viewport["width"] >= WIDE_ENOUGH_FOR_A_BOARD_PX
    limits = {
        "patient": reader is Reader.PATIENT,
        "text": LEAST_TEXT_PX[reader],
        "cell": LEAST_CELL_PX if wide else LEAST_CELL_ON_A_PHONE_PX,
        "button": LEAST_BUTTON_PX[reader],
        "gap": LEAST_GAP_PX,
        "controls": MOST_CONTROLS,
        "ring": LEAST_RING_PX,
        "focus": LEAST_FOCUS_CONTRAST,
        "motion": LONGEST_MOTION_MS,
    }
    return cast("list[str]", page.evaluate(_MEASURE, limits))


NARROW: Final = ({"width": 640, "height": 400}, {"width": 320, "height": 740})
"""A desktop's page at 200 %, and at 400 %: WCAG 1.4.4, resize text, and 1.4.10, reflow."""


def too_wide(page: Page) -> list[str]:
    """What sticks out to the right where the page is as narrow as zooming in makes it."""
    before = page.viewport_size
    assert before is not None
    found: list[str] = []
    for narrow in NARROW:
        page.set_viewport_size({"width": narrow["width"], "height": narrow["height"]})
        found += cast("list[str]", page.evaluate(_STICKING_OUT))
    page.set_viewport_size(before)
    return found


_STICKING_OUT: Final = """() => {
    const width = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth <= width) return [];
    // What scrolls in a box of its own, as a board or a wide table may, does not count.
    const scrolls = (element) => element !== document.documentElement
        && element !== document.body
        && ["auto", "scroll", "hidden", "clip"].includes(getComputedStyle(element).overflowX);
    const inside = (element) => {
        for (let one = element.parentElement; one; one = one.parentElement) {
            if (scrolls(one)) return true;
        }
        return false;
    };
    const out = [...document.querySelectorAll("body *")].filter((element) =>
        element.getBoundingClientRect().right > width + 1 && !inside(element));
    return [`${document.documentElement.scrollWidth} px wide in ${width} px`,
        ...out.map((one) => one.outerHTML.slice(0, 120))];
}"""
