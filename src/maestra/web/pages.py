"""A page: a template, filled in the visitor's language."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Annotated, Final

from babel.support import Format
from fastapi import Depends, Request
from fastapi.responses import HTMLResponse
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from maestra.language import Language
from maestra.web.access.visitor import Right, Visitor
from maestra.web.language_choice import language_of
from maestra.web.translations import translate

_ENVIRONMENT: Final = Environment(
    loader=PackageLoader("maestra.web", "templates"),
    autoescape=select_autoescape(default=True),
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
)


@dataclass(frozen=True, slots=True)
class Pages:
    """Makes pages for one request."""

    request: Request
    language: Language

    def page(self, template: str, visitor: Visitor | None = None, **parts: object) -> HTMLResponse:
        """The page that `template` makes of `parts`; status 200."""
        return HTMLResponse(self.text(template, visitor=visitor, **parts))

    def refusal(self, status: int, template: str, **parts: object) -> HTMLResponse:
        """The same with another status."""
        return HTMLResponse(self.text(template, **parts), status)

    def text(self, template: str, **parts: object) -> str:
        """What `template` makes of `parts`.

        Every template also has: `_` (a text in the visitor's language), `language`, `languages`,
        `visitor` (None before login), `Right`, `path`, and `localised` (`.date(x)`,
        `.datetime(x)`, `.decimal(x)`, `.percent(x)` as the language writes them).
        """
        return _ENVIRONMENT.get_template(template).render(
            _=partial(translate, self.language),
            language=self.language,
            languages=tuple(Language),
            Right=Right,
            path=self.request.url.path,
            localised=Format(self.language.value),
            **{"visitor": None, **parts},
        )

    def say(self, sentence: str, **parts: object) -> str:
        """A text of the catalogues in the visitor's language."""
        return translate(self.language, sentence, **parts)


def _pages(request: Request) -> Pages:
    return Pages(request, language_of(request))


Page = Annotated[Pages, Depends(_pages)]
