"""How tests come to be logged in: by an account, and the page where one logs in."""

from playwright.sync_api import Page

from maestra.web.access.visitor import Role
from tests.browser.serving import Served
from tests.web.people import PASSWORD, add_account

NAMES = {Role.CAREGIVER: "Ana", Role.RESEARCHER: "Rosa", Role.ADMINISTRATOR: "Alba"}


def log_in(served: Served, page: Page, role: Role) -> Page:
    """The page, on the first page of somebody with this role; their account is made if need be."""
    name = NAMES[role]
    if name not in {one.name for one in served.context.store.access.accounts()}:
        add_account(served.context, name, role)
    page.goto("/login")
    page.locator("#name").fill(name)
    page.locator("#password").fill(PASSWORD)
    page.locator("main form button").click()
    page.wait_for_url(f"{served.url}/")
    return page
