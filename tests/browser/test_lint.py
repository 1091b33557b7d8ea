"""The lint itself: pages with one fault each, of which it must say just that one."""

import pytest
from playwright.sync_api import Page

from tests.browser.lint import Reader, lint, too_wide

RING = "outline: 3px solid #0a4f5c; outline-offset: 3px"


def page_with(style: str, body: str = "") -> str:
    inside = body or '<p><button id="it">Go</button></p>'
    return f"""<!doctype html><html lang="en"><style>
        * {{ font-size: 24px; background: #fff; margin: 10px }}
        button {{ min-height: 64px }} :focus-visible {{ {RING} }} {style}
        </style><header><a href="/help">Help</a></header><h1>One</h1>{inside}"""


@pytest.mark.parametrize(
    ("style", "fault"),
    [
        ("", None),
        ("#it:focus-visible { outline: none }", "a focus ring of 0 px"),
        ("#it:focus-visible { outline-width: 1px }", "a focus ring of 1 px"),
        ("#it:focus-visible { outline-color: #aaa }", "a focus ring with a contrast of 2.3"),
        ("#it:focus-visible { outline-color: #767676 }", None),
        ("p { background: #06343d }", "a focus ring with a contrast of 1.5"),
        (
            "#it { background: #06343d } #it:focus-visible { outline-offset: -6px }",
            "a focus ring with a contrast of 1.5",
        ),
        ("p { overflow: auto } #it { margin: 0 }", "0.0 px of room for a focus ring"),
        ("p { overflow: auto; padding: 6px } #it { margin: 0 }", None),
    ],
)
def test_a_focus_ring_that_is_hard_to_see_is_found(
    page: Page, style: str, fault: str | None
) -> None:
    page.set_content(page_with(style))
    found = [one.partition(": <")[0] for one in lint(page, Reader.CAREGIVER)]
    assert found == ([] if fault is None else [fault])


def test_the_focus_is_where_it_was_after_the_lint(page: Page) -> None:
    page.set_content(page_with(""))
    page.locator("#it").focus()
    lint(page, Reader.CAREGIVER)
    assert page.evaluate("document.activeElement.id") == "it"


@pytest.mark.parametrize(
    ("width", "faults"), [(300, []), (500, ["in 320 px"]), (700, ["in 640 px", "in 320 px"])]
)
def test_a_page_that_scrolls_sideways_when_it_is_zoomed_is_found(
    page: Page, width: int, faults: list[str]
) -> None:
    body = f'<div style="width: {width}px; margin: 0">wide</div>'
    page.set_content(page_with("body { margin: 0 }", body))
    found = [one for one in too_wide(page) if "px wide" in one]
    assert [one[one.index("in ") :] for one in found] == faults
