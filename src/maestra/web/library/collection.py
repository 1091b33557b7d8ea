"""What the library's pages show of exercises: their words, and where they come from.

What follows from an exercise's text alone is worked out once and kept, for the text never
changes: a new version has another one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime
from functools import lru_cache
from hashlib import sha256
from typing import Final, NewType

from maestra.coaching.ports import StoredExercise
from maestra.core.json_lines import FormatError
from maestra.core.text import without_accents
from maestra.language import Language, Sentence, rule_sentences
from maestra.rules.account import account_of
from maestra.rules.exercise import Evidence, Exercise, GroundedExercise, LearnStatus
from maestra.rules.exercise_format import decode_exercise
from maestra.storage.shelf import Shelf, Source
from maestra.storage.store import SqlStore
from maestra.web.library.included import INCLUDED_NAMES
from maestra.web.library.origin import Origin
from maestra.web.translations import translate

ExerciseId = NewType("ExerciseId", str)
"""What addresses call an exercise, whatever letters its name has."""

KEPT_TEXTS: Final = 500
"""Exercises whose sentences are kept in memory: a few megabytes."""
MOST_SEARCHED: Final = 200
"""Letters of a search: longer ones find nothing anyway."""


@dataclass(frozen=True, slots=True)
class Learned:
    """What an exercise rests on."""

    demonstrations: int
    answers: int
    exam: tuple[int, int] | None
    """Of the last one: in how many plays the caregiver and Maestra agreed, of how many."""


@dataclass(frozen=True, slots=True)
class Item:
    """An exercise of the library, said in the visitor's language."""

    id: ExerciseId
    name: str
    """What the record knows it by."""
    title: str
    version: int
    exercise: Exercise | None
    """None if this Maestra cannot read it: another one wrote it."""
    sentences: tuple[Sentence, ...]
    learned: Learned
    origin: Origin | None
    """None if nobody noted it, as for what was taught in the terminal."""
    by: str | None
    """Whose doing it was, if they still have an account."""
    at: datetime | None

    @property
    def is_sure(self) -> bool:
        """Whether teaching it came to an end: nothing else may be meant."""
        match self.exercise:
            case None:
                return False
            case GroundedExercise():
                return True
            case _:
                return self.exercise.status in {LearnStatus.LEARNED, LearnStatus.TOLD}

    def matches(self, search: str) -> bool:
        """Whether each word of `search` is within a word of what is said of the exercise."""
        said = [self.title, self.by or "", *(one.text for one in self.sentences)]
        words = _plain(" ".join(said)).split()
        return all(any(wanted in word for word in words) for wanted in _plain(search).split())


class Collection:
    """The exercises of a store, as one language says them."""

    def __init__(self, store: SqlStore, language: Language) -> None:
        """Read from `store`."""
        self._store = store
        self._shelf = Shelf(store)
        self._language = language

    def items(self, search: str = "") -> tuple[Item, ...]:
        """What is in the library and matches: people's own by title, then what came along."""
        found = (one for one in self._items(self._store.exercises()) if one.matches(search))
        return tuple(sorted(found, key=lambda one: (_place(one.name), one.title)))

    def removed(self) -> tuple[Item, ...]:
        """What was taken from the library, the last first."""
        when = self._shelf.removed()
        latest = [self._shelf.versions(name)[0] for name in when]
        items = self._items(latest)
        return tuple(sorted(items, key=lambda one: when[one.name], reverse=True))

    def versions(self, wanted: ExerciseId) -> tuple[Item, ...]:
        """All versions of an exercise, the newest first, also of one that was removed.

        Raises:
            KeyError: there is none.
        """
        return tuple(self._items(self._shelf.versions(self.name(wanted))))

    def name(self, wanted: ExerciseId) -> str:
        """The name of the exercise with this id.

        Raises:
            KeyError: there is none.
        """
        for name in self._shelf.names():
            if exercise_id(name) == wanted:
                return name
        raise KeyError(wanted)

    def _items(self, stored: Iterable[StoredExercise]) -> Iterator[Item]:
        titles, sources = self._shelf.titles(), self._shelf.sources()
        names = _Names(self._store)
        for one in stored:
            source = sources.get((one.name, one.version))
            exercise = exercise_in(one.exercise)
            yield Item(
                exercise_id(one.name),
                one.name,
                titles.get(one.name) or shown_name(one.name, self._language),
                one.version,
                exercise,
                sentences_of(one.exercise, self._language),
                _learned(exercise),
                Origin(source.origin) if source else None,
                names.of(source),
                datetime.fromisoformat(source.utc) if source else None,
            )


class _Names:
    """Who accounts are, each asked for once."""

    def __init__(self, store: SqlStore) -> None:
        self._store = store
        self._known: dict[str, str | None] = {}

    def of(self, source: Source | None) -> str | None:
        account = source.account if source else None
        if account is None:
            return None
        if account not in self._known:
            self._known[account] = self._asked(account)
        return self._known[account]

    def _asked(self, account: str) -> str | None:
        try:
            return self._store.access.account(account).name
        except KeyError:
            return None


def _place(name: str) -> int:
    """Where what came along stands: after people's own, as it was meant to be found."""
    return INCLUDED_NAMES.index(name) + 1 if name in INCLUDED_NAMES else 0


def exercise_id(name: str) -> ExerciseId:
    """What addresses call the exercise of this name."""
    return ExerciseId(sha256(name.encode()).hexdigest()[:16])


def shown_name(name: str, language: Language) -> str:
    """What an exercise of this name is called unless somebody gave it a title."""
    return translate(language, name) if name in INCLUDED_NAMES else name


def titles(store: SqlStore, language: Language) -> Mapping[str, str]:
    """What to call each exercise of the library, by its name."""
    given = Shelf(store).titles()
    return {
        one.name: given.get(one.name) or shown_name(one.name, language)
        for one in store.exercises()
    }


@lru_cache(maxsize=KEPT_TEXTS)
def exercise_in(text: str) -> Exercise | None:
    """The exercise that is written so; None if this Maestra cannot read it."""
    try:
        return decode_exercise(text.encode())
    except FormatError:
        return None


@lru_cache(maxsize=KEPT_TEXTS)
def sentences_of(text: str, language: Language) -> tuple[Sentence, ...]:
    """What the exercise that is written so asks for, in words."""
    exercise = exercise_in(text)
    return () if exercise is None else rule_sentences(account_of(exercise), language)


def _learned(exercise: Exercise | None) -> Learned:
    match exercise:
        case None:
            return Learned(0, 0, None)
        case GroundedExercise():
            return Learned(exercise.demonstrations, 0, None)
        case _:
            return _rests_on(exercise.evidence)


def _rests_on(evidence: Evidence) -> Learned:
    exam = None
    if evidence.exams:
        last = evidence.exams[-1]
        exam = (last.agreed + last.near_misses_agreed, last.plays + last.near_misses)
    return Learned(len(evidence.demonstrations), len(evidence.answers), exam)


def _plain(text: str) -> str:
    return without_accents(text).casefold()
