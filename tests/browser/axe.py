"""axe-core over a page: what keeps somebody from reading or using it."""

from functools import cache
from importlib.resources import files
from typing import TypedDict, cast

from playwright.sync_api import Page

# Contrast of 7:1 is asked of the text of every page, so AAA's rule for it is on.
_OPTIONS = {
    "resultTypes": ["violations"],
    "runOnly": [
        *("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"),
        "color-contrast-enhanced",
    ],
}
_RUN = """async (options) => {
    const tags = options.runOnly.filter((one) => one !== "color-contrast-enhanced");
    const found = await axe.run(document, {
        resultTypes: options.resultTypes,
        runOnly: {type: "tag", values: tags},
        rules: {"color-contrast-enhanced": {enabled: true}},
    });
    return found.violations.flatMap((rule) => rule.nodes.map(
        (node) => ({rule: rule.id, help: rule.help, html: node.html, why: node.failureSummary})));
}"""


class Finding(TypedDict):
    """One element that breaks one rule."""

    rule: str
    help: str
    html: str
    why: str


def findings(page: Page) -> list[Finding]:
    """What axe-core finds; nothing on a page that everybody can use."""
    page.evaluate(_script())
    return cast("list[Finding]", page.evaluate(_RUN, _OPTIONS))


@cache
def _script() -> str:
    return (files("axe_playwright_python") / "axe.min.js").read_text("utf-8")
