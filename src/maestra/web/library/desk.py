"""What each page of the library works with: the visitor, their changes, and the exercises."""

from __future__ import annotations

from dataclasses import dataclass
from http import HTTPStatus
from typing import Annotated

from fastapi import Depends, HTTPException
from fastapi.responses import HTMLResponse

from maestra.storage.shelf import Shelf
from maestra.web.access.guard import Teaching
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context, Here
from maestra.web.library.changes import Changes
from maestra.web.library.collection import Collection, ExerciseId, Item
from maestra.web.library.files import file_of
from maestra.web.library.thumbnails import rule_names
from maestra.web.pages import Page, Pages


@dataclass(frozen=True, slots=True)
class Desk:
    """The library as a visitor sees it."""

    visitor: Visitor
    context: Context
    pages: Pages

    @property
    def collection(self) -> Collection:
        """The exercises, said in the visitor's language."""
        return Collection(self.context.store, self.pages.language)

    @property
    def changes(self) -> Changes:
        """What the visitor may do."""
        return Changes(self.context, self.visitor)

    def name(self, wanted: str) -> str:
        """What the record calls the exercise with this id.

        Raises:
            HTTPException: 404, there is none.
        """
        try:
            return self.collection.name(ExerciseId(wanted))
        except KeyError:
            raise HTTPException(HTTPStatus.NOT_FOUND, "no such exercise") from None

    def versions(self, wanted: str) -> tuple[Item, ...]:
        """All versions of it, the newest first.

        Raises:
            HTTPException: 404, there is none.
        """
        self.name(wanted)
        return self.collection.versions(ExerciseId(wanted))

    def item(self, wanted: str, version: int | None = None) -> Item:
        """A version of it, the newest if none is named.

        Raises:
            HTTPException: 404, there is none.
        """
        for one in self.versions(wanted):
            if version in (None, one.version):
                return one
        raise HTTPException(HTTPStatus.NOT_FOUND, "no such version")

    def text(self, item: Item) -> str:
        """The exercise as it is kept."""
        return self.context.store.exercise(item.name, item.version).exercise

    def file(self, item: Item) -> str:
        """The exercise as a file to be shared, with its pictures."""
        return file_of(self.context.store, item)

    def list(self, search: str = "", removed: str = "", **parts: object) -> HTMLResponse:
        """The page of all exercises that match."""
        gone = self.collection.removed()
        shown: dict[str, object] = {
            "items": self.collection.items(search),
            "search": search,
            "gone": gone,
            "just_gone": next((one for one in gone if one.id == removed), None),
            "file": "",
            "faults": (),
        }
        return self.pages.page("library/list.html", self.visitor, **shown | parts)

    def one(self, wanted: str, version: int | None = None, **parts: object) -> HTMLResponse:
        """The page of one exercise."""
        item = self.item(wanted, version)
        shown: dict[str, object] = {
            "item": item,
            "versions": self.versions(wanted),
            "drawn": rule_names(self.text(item)),
            "is_removed": item.name in Shelf(self.context.store).removed(),
            "typed": item.title,
            "fault": "",
            "no_pddl": (),
        }
        return self.pages.page("library/exercise.html", self.visitor, **shown | parts)


def _desk(visitor: Teaching, context: Here, pages: Page) -> Desk:
    return Desk(visitor, context, pages)


AtDesk = Annotated[Desk, Depends(_desk)]
