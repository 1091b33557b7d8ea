"""What may be done to the library; the pages and the interface for programs both do it here."""

from __future__ import annotations

from dataclasses import dataclass

from maestra.core.faults import Fault, refuse
from maestra.core.text import faults_of_name
from maestra.rules.exercise_format import encode_exercise
from maestra.storage.drafts import Drafts
from maestra.storage.shelf import Shelf, Source
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context
from maestra.web.library.collection import ExerciseId, exercise_id
from maestra.web.library.files import (
    MOST_TITLE,
    demonstrations_in,
    exercise_of,
    fresh,
    title_of,
)
from maestra.web.library.origin import Origin


def source(context: Context, visitor: Visitor, origin: Origin) -> Source:
    """That the visitor did it, so, now."""
    return Source(origin.value, visitor.account, context.clock.utc().isoformat("T", "seconds"))


@dataclass(frozen=True, slots=True)
class Changes:
    """Changes that a visitor makes."""

    context: Context
    visitor: Visitor

    @property
    def _shelf(self) -> Shelf:
        return Shelf(self.context.store)

    def bring_in(self, content: bytes, file: str, title: str = "") -> ExerciseId:
        """Keep the exercise that is in a file, under a title that nothing has yet.

        Raises:
            FormatError: there is none in it; with every fault.
        """
        exercise, pictures = exercise_of(content, file)
        wanted = title.strip() or title_of(file) or "exercise"
        name = fresh(wanted[:MOST_TITLE], self._taken())
        made_now = source(self.context, self.visitor, Origin.IMPORTED)
        drafts = Drafts(self.context.store)
        shown = {value: drafts.keep_picture(one) for value, one in pictures.items()}
        written, lines = encode_exercise(exercise), demonstrations_in(exercise)
        version = self._shelf.keep(name, written, lines, made_now)
        if shown:
            drafts.save_shown(name, version, shown)
        return exercise_id(name)

    def duplicate(self, name: str, title: str) -> ExerciseId:
        """Keep the latest version of an exercise once more, under a name of its own.

        Raises:
            KeyError: there is none.
        """
        latest = self._shelf.versions(name)[0]
        copy = fresh(title, self._taken())
        made_now = source(self.context, self.visitor, Origin.COPIED)
        version = self._shelf.keep(copy, latest.exercise, latest.demonstrations, made_now)
        self._keep_pictures((name, latest.version), (copy, version))
        return exercise_id(copy)

    def go_back(self, name: str, version: int) -> int:
        """Make an earlier version of an exercise its newest one; returns its number.

        Raises:
            KeyError: there is none.
        """
        stored = self.context.store.exercise(name, version)
        made_now = source(self.context, self.visitor, Origin.COPIED)
        newest = self._shelf.keep(name, stored.exercise, stored.demonstrations, made_now)
        self._keep_pictures((name, version), (name, newest))
        return newest

    def retitle(self, name: str, title: str) -> None:
        """Call an exercise so.

        Raises:
            KeyError: there is none.
            InvalidError: the title cannot be one, or another exercise has it.
        """
        title = title.strip()
        faults = faults_of_name("title", title)
        if len(title) > MOST_TITLE:
            faults.append(Fault("title", f"{len(title)} letters", f"at most {MOST_TITLE}"))
        refuse(faults)
        self._shelf.retitle(name, title)

    def remove(self, name: str) -> None:
        """Take an exercise from the library.

        Raises:
            KeyError: there is none.
        """
        self._shelf.remove(name, self.context.clock.utc().isoformat("T", "seconds"))

    def restore(self, name: str) -> None:
        """Put it back.

        Raises:
            KeyError: there is none.
        """
        self._shelf.restore(name)

    def _taken(self) -> frozenset[str]:
        """Names and titles that something has, also of what was removed."""
        shelf = self._shelf
        return shelf.names() | frozenset(shelf.titles().values())

    def _keep_pictures(self, before: tuple[str, int], after: tuple[str, int]) -> None:
        drafts = Drafts(self.context.store)
        shown = drafts.shown(*before)
        if shown and before != after:
            drafts.save_shown(*after, shown)
