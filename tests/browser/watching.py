"""What goes wrong in a page without a test asking: errors, refused content, foreign requests."""

import re
from dataclasses import dataclass, field

from playwright.sync_api import BrowserContext, ConsoleMessage, Page, Request, Response

# Chromium says this of every refused request; `_answered` knows which of them are faults.
_OF_A_REQUEST = "Failed to load resource"
_OWN_SCHEMES = ("data:", "blob:", "about:")


@dataclass
class Watch:
    """Listens to every page of a context."""

    origin: str
    faults: list[str] = field(default_factory=list[str])
    tolerated: list[str] = field(default_factory=list[str])
    """Patterns of faults that the test provokes."""

    def over(self, context: BrowserContext) -> None:
        """Listen from now on."""
        context.on("console", self._said)
        context.on("weberror", lambda error: self._fault(f"page error: {error.error}"))
        context.on("request", self._asked)
        context.on("response", self._answered)
        # Told by the page itself, for Chromium's console words may change.
        context.add_init_script(
            "document.addEventListener('securitypolicyviolation', (event) => console.error("
            "`refused by the policy: ${event.effectiveDirective} ${event.blockedURI}`));"
        )
        context.on("page", self._opened)

    def tolerate(self, pattern: str) -> None:
        """Take what matches for no fault: the test provokes it."""
        self.tolerated.append(pattern)

    def found(self) -> list[str]:
        """The faults so far that no test provoked."""
        return [
            fault
            for fault in self.faults
            if not any(re.search(pattern, fault) for pattern in self.tolerated)
        ]

    def _fault(self, text: str) -> None:
        self.faults.append(text)

    def _opened(self, page: Page) -> None:
        page.on("crash", lambda _: self._fault("the page crashed"))

    def _said(self, message: ConsoleMessage) -> None:
        if message.type in {"error", "warning"} and _OF_A_REQUEST not in message.text:
            self._fault(f"console {message.type}: {message.text}")

    def _asked(self, request: Request) -> None:
        if not request.url.startswith((self.origin, *_OWN_SCHEMES)):
            self._fault(f"asked elsewhere: {request.url}")

    def _answered(self, response: Response) -> None:
        of_a_page = response.request.resource_type in {"document", "fetch", "xhr"}
        # A page may be refused; what a page is made of must be there.
        worst = 500 if of_a_page else 400
        if response.status >= worst:
            self._fault(f"{response.status} for {response.request.method} {response.url}")
