"""Takes a picture of every page: for docs/explanation/screens.md, and for the help.

Run by `make screenshots`. The pages are those of a house in which everything has happened once
(tests/browser/world.py); as WebP a page is some 20 kB.
"""

from __future__ import annotations

import base64
import tempfile
from dataclasses import dataclass
from http import HTTPStatus
from pathlib import Path
from typing import Any, Final

from playwright.sync_api import Browser, Page, sync_playwright

from maestra.language import Language
from maestra.web.access.visitor import Role
from tests.browser.conftest import ARGUMENTS, CHROMIUM
from tests.browser.roles import log_in
from tests.browser.serving import Served, serving
from tests.browser.sizes import Size
from tests.browser.world import PIN, World, populate

ROOT: Final = Path(__file__).parent.parent
DOCS: Final = ROOT / "docs" / "pictures"
HELP: Final = ROOT / "src" / "maestra" / "web" / "static" / "help"
SETTLED_MS: Final = 700
QUALITY: Final = 60
"""Of WebP: letters stay sharp, a page takes 20 kB."""
CAREGIVERS: Final = {
    "start": "/",
    "teach": "/teach",
    "teach-draft": "/teach/{draft}",
    "teach-tokens": "/teach/{draft}/tokens",
    "teach-words": "/teach/{draft}/words",
    "teach-try": "/teach/{draft}/try",
    "teach-exam": "/teach/{draft}/exam",
    "teach-features": "/teach/{draft}/features",
    "library": "/library",
    "exercise": "/library/{wanted}",
    "patients": "/patients",
    "new-patient": "/patients/new",
    "patient": "/patients/{pseudonym}",
    "settings": "/patients/{pseudonym}/settings",
    "preview": "/patients/{pseudonym}/preview",
    "erase": "/patients/{pseudonym}/erase",
    "sessions": "/sessions",
    "new-session": "/sessions/new-session?patient=heron",
    "session": "/sessions/{name}",
    "progress": "/progress",
    "progress-of-one": "/progress/{pseudonym}",
    "progress-in-one": "/progress/{pseudonym}/exercise?name=Five+numbers%2C+ascending",
    "print": "/progress/{pseudonym}/print",
    "replay": "/progress/{pseudonym}/sessions/{session}",
    "account": "/account",
    "devices": "/devices",
    "help": "/help",
}
ADMINISTRATORS: Final = {
    "accounts": "/accounts",
    "one-account": "/accounts/{account}",
    "audit": "/audit",
}
IN_THE_HELP: Final = {
    "teach": "/teach/{draft}",
    "patient": "/patients/{pseudonym}/settings",
    "session": "/sessions/{name}",
}


@dataclass(frozen=True, slots=True)
class Studio:
    """A browser before a server."""

    browser: Browser
    served: Served

    def page(self, size: Size = Size.DESKTOP, language: Language = Language.EN) -> Page:
        """A page in a browser of its own."""
        context = self.browser.new_context(
            base_url=self.served.url,
            viewport={"width": size.width, "height": size.height},
            has_touch=size.is_touched,
            is_mobile=size.is_touched,
            locale=language.value,
        )
        return context.new_page()


def main() -> None:
    """Take them all."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=[*ARGUMENTS])
        with tempfile.TemporaryDirectory() as folder, serving(Path(folder)) as served:
            _of_every_page(Studio(browser, served))
        for language in Language:
            with tempfile.TemporaryDirectory() as folder, serving(Path(folder)) as served:
                _for_the_help(Studio(browser, served), language)
        browser.close()


def _of_every_page(studio: Studio) -> None:
    new = studio.page()
    studio.served.context.doors.open_set_up()
    _take(new, "/set-up", DOCS / "set-up.webp")
    studio.served.context.doors.close_set_up()
    caregiver = studio.page()
    world = populate(studio.served, caregiver)
    _take(new, "/login", DOCS / "login.webp")
    _of_the_patient(studio, world)
    for name, path in CAREGIVERS.items():
        _take(caregiver, world.filled(path), DOCS / f"{name}.webp")
    administrator = log_in(studio.served, studio.page(), Role.ADMINISTRATOR)
    for name, path in ADMINISTRATORS.items():
        _take(administrator, world.filled(path), DOCS / f"{name}.webp")
    phone = log_in(studio.served, studio.page(Size.PHONE), Role.CAREGIVER)
    _take(phone, world.filled("/teach/{draft}"), DOCS / "teach-draft-phone.webp")
    _take(phone, "/library", DOCS / "library-phone.webp")


def _of_the_patient(studio: Studio, world: World) -> None:
    tablet = studio.page(Size.TABLET)
    _take(tablet, "/screen", DOCS / "screen.webp")
    tablet.locator("#code").fill(world.screen_code)
    tablet.locator("#pin").fill(PIN)
    tablet.locator("main form button").first.click()
    tablet.wait_for_url("**/patient")
    _take(tablet, "/patient", DOCS / "patient-ready.webp")
    tablet.get_by_role("button", name="Let us begin").click()
    tablet.wait_for_selector("form.board, .board")
    tablet.wait_for_timeout(1_000)
    _keep(tablet, DOCS / "patient-playing.webp")


def _for_the_help(studio: Studio, language: Language) -> None:
    caregiver = studio.page(language=language)
    world = populate(studio.served, caregiver, language)
    caregiver.request.post(world.filled("/sessions/{name}/do"), form={"do": "begin"})
    for name, path in IN_THE_HELP.items():
        _take(caregiver, world.filled(path), HELP / f"{name}-{language.value}.webp")


def _take(page: Page, path: str, file: Path) -> None:
    answer = page.goto(path)
    if answer is None or answer.status != HTTPStatus.OK:
        raise SystemExit(f"{path} is no page")
    # What is asked once the page is there: drawings further up, the state of a session.
    page.wait_for_timeout(SETTLED_MS)
    _keep(page, file)


def _keep(page: Page, file: Path) -> None:
    asking: Any = page.context.new_cdp_session(page)
    taken = asking.send("Page.captureScreenshot", {"format": "webp", "quality": QUALITY})
    asking.detach()
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(base64.b64decode(taken["data"]))
    print(f"{file.relative_to(ROOT)}: {file.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main()
