"""From a draft to the library, and back to go on teaching."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, assert_never

from maestra.core.demonstration import Demonstration
from maestra.core.faults import InvalidError
from maestra.core.formats import encode_demonstration, read_demonstrations
from maestra.core.state import State
from maestra.core.text import faults_of_name
from maestra.rules.exercise import Exercise, GroundedExercise, LearnStatus, RuledExercise
from maestra.rules.exercise_format import decode_exercise, encode_exercise
from maestra.rules.features import FRAME
from maestra.rules.telling import dealt
from maestra.storage.drafts import Drafts
from maestra.storage.shelf import Shelf, Source
from maestra.web.access.audit import Act, audit
from maestra.web.access.visitor import Visitor
from maestra.web.context import Context
from maestra.web.library.origin import Origin
from maestra.web.teach.actions import MAX_SHOWN, CannotError, Keep, Why
from maestra.web.teach.desk import new_seed
from maestra.web.teach.draft import Draft, Recalled, Shown, Step, Told
from maestra.web.teach.showing import Showing, Touch
from maestra.web.teach.understanding import exercise_of

MOST_OF_NAME: Final = 80
"""Letters of an exercise's name: it stands on buttons."""


def save(context: Context, visitor: Visitor, draft: Draft, name: str) -> Keep:
    """Keep what the draft comes to as a new version of `name`; that is what was done then.

    Raises:
        CannotError: the name is none, or that of another exercise; nothing was shown or told.
    """
    if faults_of_name("name", name) or len(name) > MOST_OF_NAME:
        raise CannotError(Why.NO_NAME)
    exercise = exercise_of(draft)
    if exercise is None:
        raise CannotError(Why.NOTHING_SHOWN)
    shelf = Shelf(context.store)
    own = None if draft.saved is None else draft.saved[0]
    if name != own and name in {*shelf.names(), *shelf.titles().values()}:
        raise CannotError(Why.NAME_TAKEN)
    counting = (draft.demonstrations[k] for k in draft.taught.counting)
    lines = "".join(f"{encode_demonstration(one)}\n" for one in counting)
    source = Source(Origin.TAUGHT.value, visitor.account, context.clock.utc().isoformat())
    version = shelf.keep(name, encode_exercise(exercise), lines, source)
    Drafts(context.store).save_shown(name, version, draft.pictures)
    audit(context, visitor, Act.CHANGED, None, "exercise")
    return Keep(name, version)


def from_exercise(context: Context, name: str, version: int | None) -> Draft:
    """A draft that goes on where an exercise of the library is.

    Demonstrations with other tokens than the exercise's are left behind; what was learned from
    them is in the answers and rules.

    Raises:
        KeyError: there is no such exercise or version.
        CannotError: there is no room for its tokens.
    """
    stored = context.store.exercise(name, version)
    exercise = decode_exercise(stored.exercise.encode())
    shown = _shown(exercise, stored.demonstrations)
    start = shown[0].start if shown else _laid(exercise)
    steps: list[Step] = [Shown(_showing(one)) for one in shown[:MAX_SHOWN]]
    features: tuple[str, ...] | None = None
    match exercise:
        case RuledExercise():
            evidence = exercise.evidence
            if evidence.answers or evidence.exams:
                steps.append(Recalled(evidence.answers, evidence.exams))
            if exercise.status is LearnStatus.TOLD or not shown:
                steps.append(Told(exercise.conjunction))
        case GroundedExercise():
            chosen = exercise.model.vocabulary.features
            features = tuple(one.label for one in chosen if one not in FRAME)
        case _:
            assert_never(exercise)
    return Draft(
        exercise.deck,
        Showing(start),
        new_seed(),
        tuple(steps),
        features,
        Drafts(context.store).shown(name, stored.version),
        name,
        (name, stored.version),
    )


def _shown(exercise: Exercise, lines: str) -> list[Demonstration]:
    """The demonstrations that an exercise keeps, or that are kept beside it."""
    shown: Sequence[Demonstration] = ()
    if isinstance(exercise, RuledExercise):
        shown = exercise.evidence.demonstrations
    elif lines.strip():
        shown = tuple(read_demonstrations([lines.encode()], "demonstrations"))
    return [one for one in shown if one.deck == exercise.deck and one.board == exercise.board]


def _showing(shown: Demonstration) -> Showing:
    return Showing(shown.start, tuple(Touch(one.token, one.destination) for one in shown.moves))


def _laid(exercise: Exercise) -> State:
    try:
        return dealt(exercise.deck, exercise.board)
    except InvalidError:
        raise CannotError(Why.NO_ROOM) from None
