"""What was judged otherwise in a session goes back to the exercise: a draft to look at and save.

Nothing changes by itself. The draft holds what the exercise rests on and the caregiver's verdicts
besides; what Maestra understands then is shown there, and becomes a new version when it is saved.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from maestra.coaching.events import VerdictOverridden, decode_event
from maestra.coaching.overrides import Override, overrides
from maestra.coaching.ports import Entry, StoredSession
from maestra.coaching.recording import Start, decode_start, replay
from maestra.coaching.session import Ending, Session
from maestra.core.faults import InvalidError
from maestra.rules.answers import Answer, Reply, RuleQuestion
from maestra.rules.exercise import RuledExercise
from maestra.rules.rule import Rule
from maestra.web.context import Context
from maestra.web.teach.draft import Draft, Recalled, Shown, Told
from maestra.web.teach.saving import from_exercise
from maestra.web.teach.showing import Showing, Touch


@dataclass(frozen=True, slots=True)
class Said:
    """The verdicts that were changed in one session."""

    start: Start
    end: Session
    overrides: tuple[Override, ...]
    """Those that rules can speak of."""

    @property
    def is_whole(self) -> bool:
        """Whether what was played can be shown as a right play: completed, or the row is full.

        With a move that the rules forbid they hold no play for completed.
        """
        now = self.end.position.now
        is_full = all(cell in now.tokens for cell in now.board.goal_cells)
        return is_full or self.end.ending is Ending.COMPLETE


def said_in(entries: Iterable[Entry]) -> Said | None:
    """What was judged otherwise in the session of these entries; None if nothing was.

    Only rules can learn of it: an exercise made of actions is taught by demonstrations alone.
    """
    found = iter(entries)
    first = next(found, None)
    if first is None:
        return None
    try:
        events = [decode_event(json.loads(one.payload)) for one in found if one.kind == "event"]
        if not any(isinstance(one.what, VerdictOverridden) for one in events):
            return None
        start = decode_start(first.payload.encode())
        judged = tuple(one for one in overrides(start, events) if one.answer is not None)
        *_, (end, _) = replay(start.session(), events)
    except InvalidError:
        return None
    can_learn = isinstance(start.exercise, RuledExercise)
    return Said(start, end, judged) if judged and can_learn else None


def draft_of(context: Context, stored: StoredSession, said: Said) -> Draft:
    """A draft of the exercise as it is now, with the verdicts as further evidence.

    What was told in words is evidence from then on too, but for the rules that forbade what the
    caregiver granted. An exercise that was only told has the session itself as its demonstration,
    if that is a whole play; if not, the verdicts count once something is shown.

    Raises:
        KeyError: the exercise is gone.
        CannotError: there is no room for its tokens.
    """
    draft = from_exercise(context, stored.exercise, None)
    answers = tuple(one.answer for one in said.overrides if one.answer is not None)
    told = draft.taught.told
    if told is None:
        return replace(draft, steps=(*draft.steps, Recalled(answers, ())))
    meant = Recalled((*_meant(told, said), *answers), ())
    if draft.taught.counting:
        kept = (step for step in draft.steps if not isinstance(step, Told))
        return replace(draft, steps=(*kept, meant))
    if not said.is_whole:
        return replace(draft, steps=(*draft.steps, Recalled(answers, ())))
    position = said.end.position
    played = tuple(Touch(one.token, one.destination) for one in position.moves)
    shown = Shown(Showing(position.start, played))
    laid = Showing(position.start)
    return replace(draft, deck=said.start.deck, showing=laid, steps=(shown, meant))


def _meant(rules: Sequence[Rule], said: Said) -> tuple[Answer, ...]:
    """That these rules are meant, but for those that forbade what the caregiver granted."""
    exercise = said.start.exercise
    broken = {name for one in said.overrides for name in one.broken}
    known = exercise.rules if isinstance(exercise, RuledExercise) else ()
    forbade = {one.rule for one in known if one.id in broken}
    return tuple(Answer(RuleQuestion(one), Reply.YES) for one in rules if one not in forbade)
