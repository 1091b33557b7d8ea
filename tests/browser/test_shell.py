from playwright.sync_api import Page, expect

from tests.browser.axe import findings
from tests.browser.lint import Reader, lint


def test_the_first_page_is_readable_by_everybody(caregiver_at: Page) -> None:
    expect(caregiver_at.get_by_role("heading", level=1)).to_be_visible()
    assert findings(caregiver_at) == []
    assert lint(caregiver_at, Reader.CAREGIVER) == []
