"""How soon each page can be used on a computer six times slower: `make bench`.

    python -m benchmarks.pages

The server runs in this process, the browser is Debian's Chromium with its processor slowed down
by DevTools, nothing cached. A page can be used when its module has made the board and the forms
live, which it says by `data-ready`. Prints the median of five visits a page; exits with 1 where
it is more than was wanted.
"""

from __future__ import annotations

import statistics
import tempfile
from pathlib import Path
from typing import Any, Final

from playwright.sync_api import Page, sync_playwright

from tests.browser.conftest import ARGUMENTS, CHROMIUM
from tests.browser.serving import serving
from tests.browser.world import populate

SLOWER: Final = 6
WANTED_MS: Final = 1_500
VISITS: Final = 5
PAGES: Final = (
    *("/", "/teach", "/teach/{draft}", "/teach/{draft}/try", "/library", "/library/{wanted}"),
    *("/patients/{pseudonym}/settings", "/sessions/{name}", "/rooms/{name}"),
    "/progress/{pseudonym}",
)
NOTE_WHEN: Final = """
new MutationObserver((_, observer) => {
    if ("ready" in document.documentElement.dataset) {
        window.readyAt = performance.now();
        observer.disconnect();
    }
}).observe(document, {subtree: true, attributes: true, childList: true});
"""


def main() -> int:
    """Measure them all."""
    slow = False
    with (
        tempfile.TemporaryDirectory() as folder,
        serving(Path(folder)) as served,
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=[*ARGUMENTS])
        context = browser.new_context(base_url=served.url, locale="en")
        page = context.new_page()
        world = populate(served, page)
        tools: Any = context.new_cdp_session(page)
        tools.send("Network.enable")
        tools.send("Network.setCacheDisabled", {"cacheDisabled": True})
        tools.send("Emulation.setCPUThrottlingRate", {"rate": SLOWER})
        page.add_init_script(NOTE_WHEN)
        for path in PAGES:
            times = [visit(page, world.filled(path)) for _ in range(VISITS)]
            taken = statistics.median(times)
            slow = slow or taken > WANTED_MS
            print(f"{path:34} {taken:6.0f} ms  {'ok' if taken <= WANTED_MS else 'TOO SLOW'}")
        browser.close()
    return int(slow)


def visit(page: Page, path: str) -> float:
    """Milliseconds from asking for the page until it can be used."""
    page.goto(path)
    page.wait_for_function("() => window.readyAt !== undefined")
    return float(page.evaluate("() => window.readyAt"))


if __name__ == "__main__":
    raise SystemExit(main())
